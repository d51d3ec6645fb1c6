// SPDX-License-Identifier: GPL-2.0-or-later
// Reading and writing whole files, by POSIX calls.
#include "descriptor.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/text.hpp"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace tetrarch::format {
namespace {

namespace fs = std::filesystem;
using detail::Descriptor;
using detail::fail;
using detail::reason;
using detail::write_all;

void write_directly(const std::string& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) fail(path, "cannot be written: " + reason(errno));
  const int error = write_all(file.get(), content);
  if (error != 0) fail(path, "cannot be written: " + reason(error));
}

/// The files that lie beside their targets just now.
struct Unfinished {
  std::mutex mutex;
  std::set<std::string> names;
};
Unfinished& unfinished() {
  static auto* const all = new Unfinished; // outlives every thread
  return *all;
}

/// Removes what lies beside the target unless it was renamed into place.
class Beside {
public:
  explicit Beside(const std::string& target) {
    static std::atomic<unsigned> count{0};
    name_ = target + "." + std::to_string(::getpid()) + "-" + std::to_string(++count) + ".part";
    const std::lock_guard lock(unfinished().mutex);
    unfinished().names.insert(name_);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() {
    if (!kept_) ::unlink(name_.c_str());
    const std::lock_guard lock(unfinished().mutex);
    unfinished().names.erase(name_);
  }
  const std::string& name() const { return name_; }
  void keep() { kept_ = true; }

private:
  std::string name_;
  bool kept_ = false;
};

/// What is written and renamed: behind a link, what it leads to. Empty: a link that leads nowhere.
std::string behind_links(const std::string& path) {
  std::error_code ignored;
  // Behind a link that dangles there is nothing to resolve yet; weakly_canonical still follows it.
  const bool is_link = fs::is_symlink(fs::symlink_status(path, ignored));
  return is_link ? fs::weakly_canonical(path, ignored).string() : path;
}

/// Whether something is there that is written to directly. Throws InputError of a directory.
bool is_device(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, "is a directory, expected a file to write");
  return fs::exists(status) && !fs::is_regular_file(status);
}

/// What is in the folder survives a loss of power. Some file systems cannot do that, and none is asked twice.
void keep_folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  const Descriptor opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() >= 0) ::fsync(opened.get());
}

/// The new content of a file, written beside it; then put in its place, and taken back if others fail.
class Replacement {
public:
  explicit Replacement(const std::string& path)
      : path_(path), target_(target_of(path)), beside_(target_), old_(target_),
        opened_(::open(beside_.name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (opened_.get() < 0) fail(path_, "cannot be written: " + reason(errno));
    struct stat about {};
    existed_ = ::stat(target_.c_str(), &about) == 0;
    if (existed_) ::fchmod(opened_.get(), about.st_mode & 07777U);
  }

  void write(std::string_view content) { require(write_all(opened_.get(), content)); }

  /// Nothing is written any more; the disk has it all.
  void finish() {
    const int error = ::fsync(opened_.get()) != 0 ? errno : 0;
    const int close_error = opened_.close();
    require(error != 0 ? error : close_error);
  }

  /// 0 or an errno. With `can_go_back` the old file stays beside the new one as long as this lives.
  int put_in_place(bool can_go_back) {
    kept_old_ = can_go_back && existed_ && ::link(target_.c_str(), old_.name().c_str()) == 0;
    if (::rename(beside_.name().c_str(), target_.c_str()) != 0) return errno;
    beside_.keep();
    keep_folder_of(target_);
    return 0;
  }

  void take_back() {
    if (kept_old_ && ::rename(old_.name().c_str(), target_.c_str()) == 0) old_.keep();
    if (!existed_) ::unlink(target_.c_str());
  }

  const std::string& path() const { return path_; }

private:
  void require(int error) const {
    if (error != 0) fail(path_, "cannot be written: " + reason(error));
  }

  static std::string target_of(const std::string& path) {
    std::string target = behind_links(path);
    if (target.empty()) fail(path, "cannot be written: the link leads nowhere");
    return target;
  }

  std::string path_;
  std::string target_;
  Beside beside_;
  Beside old_;
  Descriptor opened_;
  bool existed_ = false;
  bool kept_old_ = false;
};

} // namespace

std::string source_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string read_file(const std::string& path, std::size_t limit) {
  const bool standard_input = path == "-";
  const Descriptor file(standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    if (errno == ENOENT) fail(path, "there is no such file");
    fail(path, "cannot be read: " + reason(errno));
  }
  struct stat about {};
  if (::fstat(file.get(), &about) == 0 && S_ISDIR(about.st_mode))
    fail(path, "is a directory, expected a file");
  std::string content;
  constexpr std::size_t chunk = std::size_t{1} << 20;
  if (about.st_size > 0 && static_cast<std::size_t>(about.st_size) <= limit)
    content.reserve(static_cast<std::size_t>(about.st_size) + chunk); // the last read finds the end
  std::size_t size = 0;
  for (;;) {
    content.resize(size + chunk);
    const ssize_t got = ::read(file.get(), content.data() + size, chunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "cannot be read: " + reason(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > limit) fail(path, "is longer than " + std::to_string(limit) + " bytes");
  }
  content.resize(size);
  static std::atomic<bool> was_read = false;
  if (standard_input && was_read.exchange(true) && content.empty())
    fail(path, "was read already, and it can be read once");
  return content;
}

void remove_unfinished_files() {
  unfinished().mutex.lock(); // for good: no other one is begun
  for (const std::string& name : unfinished().names) ::unlink(name.c_str());
}

void require_writable(const std::string& path) {
  if (is_device(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be written: " + reason(errno));
    return;
  }
  const std::string target = behind_links(path);
  if (target.empty()) fail(path, "cannot be written: the link leads nowhere");
  const Beside beside(target);
  const Descriptor file(::open(beside.name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.get() < 0 && (errno == ENOENT || errno == ENOTDIR)) fail(path, "there is no such folder");
  if (file.get() < 0) fail(path, "cannot be written: " + reason(errno));
}

void write_files_atomically(std::span<const NewFile> files) {
  std::vector<std::unique_ptr<Replacement>> replacements;
  for (const NewFile& file : files) {
    if (is_device(file.path)) continue;
    replacements.push_back(std::make_unique<Replacement>(file.path));
    replacements.back()->write(file.content);
    replacements.back()->finish();
  }
  for (const NewFile& file : files)
    if (is_device(file.path)) write_directly(file.path, file.content);
  const bool can_go_back = replacements.size() > 1;
  for (std::size_t k = 0; k < replacements.size(); ++k) {
    const int error = replacements[k]->put_in_place(can_go_back);
    if (error == 0) continue;
    for (std::size_t done = k; done-- > 0;) replacements[done]->take_back();
    fail(replacements[k]->path(), "cannot be written: " + reason(error));
  }
}

struct GrowingFile::State {
  std::optional<Replacement> beside; ///< nothing: a device
  std::optional<Descriptor> device;
};

GrowingFile::GrowingFile(std::string path) : path_(std::move(path)), state_(std::make_unique<State>()) {
  if (!is_device(path_)) {
    state_->beside.emplace(path_);
    return;
  }
  state_->device.emplace(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
  if (state_->device->get() < 0) fail(path_, "cannot be written: " + reason(errno));
}
GrowingFile::~GrowingFile() = default;

void GrowingFile::add(std::string_view content) {
  if (state_->beside) return state_->beside->write(content);
  const int error = write_all(state_->device->get(), content);
  if (error != 0) fail(path_, "cannot be written: " + reason(error));
}

void GrowingFile::keep() {
  if (!state_->beside) return;
  state_->beside->finish();
  const int error = state_->beside->put_in_place(false);
  if (error != 0) fail(path_, "cannot be written: " + reason(error));
}

void write_file_atomically(const std::string& path, std::string_view content) {
  const NewFile file{path, content};
  write_files_atomically({&file, 1});
}

} // namespace tetrarch::format
