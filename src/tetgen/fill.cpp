// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/tetgen/fill.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/closed_surface.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/surface_files.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace tetrarch::tetgen {
namespace {

namespace fs = std::filesystem;

/// A new directory that disappears with its owner.
class TemporaryDirectory {
public:
  TemporaryDirectory() {
    std::error_code failed;
    const fs::path all = fs::temp_directory_path(failed);
    if (failed)
      throw InputError(Place{}, "there is no folder for temporary files (TMPDIR): " + failed.message());
    std::string pattern = (all / "tetrarch-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw InputError(Place{pattern, 0}, "cannot be made: " + std::generic_category().message(errno));
    path_ = pattern;
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

/// A child process that does not outlive its owner.
class Child {
public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  /// Whether it ended; then `succeeded` tells how.
  bool has_ended() {
    const pid_t ended = ::waitpid(pid_, &status_, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
    pid_ = 0;
    return true;
  }
  bool succeeded() const { return WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }
  bool used_up_its_time() const { return WIFSIGNALED(status_) && WTERMSIG(status_) == SIGXCPU; }

private:
  pid_t pid_;
  int status_ = 0;
};

/// What a child does with its files before it starts.
class FileActions {
public:
  explicit FileActions(const std::string& output) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT, 0600);
    ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

std::string last_line(const std::string& text) {
  const std::string_view all = format::trimmed(text);
  return std::string(all.substr(all.rfind('\n') + 1)); // npos + 1 is 0
}

/// Runs the program on `input`, its output going to `log`. Throws InputError about `source`.
void run_tetgen(Options options, std::string input, const std::string& log, const std::string& source,
                const Progress& progress) {
  std::string flags = "-pYQ"; // a surface, which stays as it is; quietly
  const std::array<char*, 4> arguments{options.program.data(), flags.data(), input.data(), nullptr};
  const FileActions actions(log);
  const std::string name = "the program " + in_quotes(options.program);
  pid_t pid = 0;
  const int error =
      ::posix_spawnp(&pid, options.program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (error == ENOENT)
    throw InputError(Place{source, 0},
                     "a surface is filled by " + name + ", which is not installed (Debian package tetgen)");
  if (error != 0)
    throw InputError(Place{source, 0}, name + " cannot be run: " + std::generic_category().message(error));
  Child child(pid);
  const auto seconds = static_cast<rlim_t>(options.seconds);
  const rlimit limit{seconds, seconds + 1};
  ::prlimit(pid, RLIMIT_CPU, &limit, nullptr); // fails only if it has ended already
  constexpr std::chrono::milliseconds pause(5);
  while (!child.has_ended()) {
    progress.step("tetgen");
    std::this_thread::sleep_for(pause);
  }
  if (child.used_up_its_time())
    throw InputError(Place{source, 0}, name + " did not end within " + std::to_string(options.seconds) +
                                           " s: the surface may meet itself");
  if (!child.succeeded())
    throw InputError(Place{source, 0}, name + " failed on the surface, which may meet itself: " +
                                           in_quotes(last_line(format::read_file(log))));
}

} // namespace

int budget(std::size_t triangles) {
  constexpr std::size_t least = 30;
  constexpr std::size_t triangles_a_second = 500;
  constexpr std::size_t most = 86400;
  return static_cast<int>(std::min(least + triangles / triangles_a_second, most));
}

format::Soup fill(const format::Soup& surface, const Progress& progress, const Options& options) {
  doctor::require_closed_surface(surface);
  const TemporaryDirectory directory;
  const std::string input = directory / "surface.off";
  format::write_file_atomically(input, format::write_off(surface));
  Options used = options;
  if (used.seconds == 0) used.seconds = budget(surface.triangles.size());
  run_tetgen(used, input, directory / "log", surface.source, progress);
  std::error_code unreadable;
  if (!fs::exists(directory / "surface.1.ele", unreadable))
    throw InputError(Place{surface.source, 0},
                     "the program " + in_quotes(options.program) + " gave no tetrahedra: " +
                         in_quotes(last_line(format::read_file(directory / "log"))));
  format::Soup solid = format::read_soup_file(directory / "surface.1.ele");
  solid.source = surface.source;
  solid.point_source.clear();
  solid.passed_over = surface.passed_over;
  solid.triangles.clear(); // the surface again, with markers that nobody gave
  solid.triangle_labels = {};
  solid.triangle_tags.clear();
  return solid;
}

} // namespace tetrarch::tetgen
