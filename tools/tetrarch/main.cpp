// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "progress_bar.hpp"
#include "version.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <semaphore.h>
#include <set>
#include <thread>

namespace {

using namespace tetrarch;
using namespace tetrarch::program;

/// The options that every command shares.
struct Common {
  bool json = false;
  bool quiet = false;
  std::uint64_t seed = 1;
  int threads = 1;
};

void declare_common(CLI::App& app, Common& common) {
  constexpr int most_threads = 256;
  app.add_flag("--json", common.json, "one JSON object on standard output and nothing else");
  app.add_flag("--quiet", common.quiet, "no warnings and no progress on standard error");
  app.add_option("--seed", common.seed, "for every random choice")->capture_default_str();
  app.add_option("--threads", common.threads, "how many; the results do not depend on it")
      ->check(CLI::Range(1, most_threads))
      ->capture_default_str();
}

/// The subcommand for a name of one or two words, with the group made on the way.
CLI::App& subcommand(CLI::App& app, const Command& command) {
  const std::string name = command.name;
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return *app.add_subcommand(name, command.summary);
  const std::string group = name.substr(0, space);
  const auto groups = app.get_subcommands([&group](const CLI::App* sub) { return sub->get_name() == group; });
  CLI::App* parent = groups.empty() ? nullptr : groups.front();
  if (parent == nullptr) {
    parent = app.add_subcommand(group, "the classified manifolds, and how they were found");
    parent->require_subcommand(1);
  }
  return *parent->add_subcommand(name.substr(space + 1), command.summary);
}

/// Ctrl-C asks the job to stop instead of killing it. A thread waits for the signal by way of a semaphore:
/// libraries have threads of their own, older than `main`, to which a signal that is only blocked would go.
class InterruptWatch {
public:
  InterruptWatch() {
    sem_init(&came_, 0, 0);
    struct sigaction action {};
    action.sa_handler = [](int) { sem_post(&came_); };
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::thread([source = source_]() mutable {
      wait();
      source.request_stop();
      wait(); // a second one: the job does not listen
      std::_Exit(static_cast<int>(Status::interrupted));
    }).detach();
  }
  std::stop_token token() const { return source_.get_token(); }

private:
  static void wait() {
    while (sem_wait(&came_) != 0) {
    }
  }

  inline static sem_t came_{};
  std::stop_source source_;
};

/// One file cannot hold two results.
void require_different(const std::vector<Result::File>& files) {
  std::set<std::filesystem::path> paths;
  for (const Result::File& file : files)
    if (!paths.insert(std::filesystem::weakly_canonical(std::filesystem::absolute(file.path))).second)
      throw InputError({file.path, 0}, "two results are to be written to this file; nothing was");
}

void deliver(const Result& result, const Common& common) {
  require_different(result.files);
  for (const Result::File& file : result.files) format::write_file_atomically(file.path, file.content);
  if (!common.quiet)
    for (const std::string& warning : result.warnings) std::cerr << "tetrarch: warning: " << warning << '\n';
  if (common.json && !result.json.is_null())
    std::cout << result.json.dump(2) << '\n';
  else
    std::cout << result.text;
  std::cout.flush();
  if (!std::cout) throw InputError("standard output cannot be written to");
}

int complain(const std::string& message, Status status) {
  std::string line = message.substr(0, message.find('\n'));
  std::cerr << "tetrarch: " << line << '\n';
  return static_cast<int>(status);
}

int run(const Run& job, const Common& common) {
  static InterruptWatch watch; // static: its thread outlives this function
  try {
    const ProgressBar bar(!common.quiet);
    const Context context{common.seed, common.threads, Progress(bar.report(), watch.token())};
    const Result result = job(context);
    bar.clear();
    deliver(result, common);
    return static_cast<int>(result.status);
  } catch (const Stopped&) {
    return complain("interrupted; nothing was written", Status::interrupted);
  } catch (const InputError& e) {
    return complain(e.what(), Status::bad_input);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", Status::fault);
  } catch (const std::exception& e) {
    return complain(std::string("internal error, please report it: ") + e.what(), Status::fault);
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Tetrarch: a combinatorial topology engine for triangulated 3-manifolds.", "tetrarch");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(
      "A triangulation is a file, - for standard input, an isomorphism signature, or a census name.\n"
      "Exit status: 0 done, 1 proved no, 2 bad usage or input, 3 our fault, 4 undecided, 130 interrupted.");
  Common common;
  common.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Run chosen;
  for (const Command& command : commands()) {
    CLI::App& sub = subcommand(app, command);
    const Run job = command.declare(sub);
    declare_common(sub, common);
    sub.footer(std::string("Example:\n  ") + command.example);
    sub.callback([&chosen, job] { chosen = job; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    return complain(e.what(), Status::bad_input);
  }
  return run(chosen, common);
}

} // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& e) {
    return complain(e.what(), Status::fault);
  }
}
