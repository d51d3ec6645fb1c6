// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One table of commands. Each is a function from options to a result value; printing that value as text or
/// as JSON, writing its files and choosing the exit status happen in one place (main.cpp), and a shell can do
/// it otherwise.

#include "tetrarch/core/progress.hpp"

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tetrarch::program {

using Json = nlohmann::ordered_json;

/// Exit statuses, as documented for the program.
enum class Status { done = 0, proved_no = 1, bad_input = 2, fault = 3, undecided = 4, interrupted = 130 };

struct Result {
  std::string text; ///< for people; ends with a newline
  Json json;        ///< for programs; null: `text` is already what programs read
  Status status = Status::done;
  std::vector<std::string> warnings; ///< one line each, for standard error
  struct File {
    std::string path;
    std::string content;
  };
  std::vector<File> files; ///< written only after everything else went well
};

/// What every command is given besides its own options.
struct Context {
  std::uint64_t seed = 1;
  int threads = 1;
  Progress progress;
};

using Run = std::function<Result(const Context&)>;

struct Command {
  const char* name; ///< "info", "census list"
  const char* summary;
  const char* example; ///< works as typed
  /// Declares the command's own options; what it returns is called after they have been parsed.
  std::function<Run(CLI::App&)> declare;
};

/// All commands, in the order of the help page.
const std::vector<Command>& commands();

Run declare_info(CLI::App& app);
Run declare_convert(CLI::App& app);
Run declare_check(CLI::App& app);
Run declare_simplify(CLI::App& app);
Run declare_truncate(CLI::App& app);
Run declare_subdivide(CLI::App& app);
Run declare_hyperbolize(CLI::App& app);
Run declare_canonize(CLI::App& app);
Run declare_isometric(CLI::App& app);
Run declare_embed(CLI::App& app);
Run declare_view(CLI::App& app);
Run declare_bundle(CLI::App& app);
Run declare_slit(CLI::App& app);
Run declare_register(CLI::App& app);
Run declare_product(CLI::App& app);
Run declare_census_gluings(CLI::App& app);
Run declare_census_enumerate(CLI::App& app);
Run declare_census_validate(CLI::App& app);
Run declare_census_list(CLI::App& app);
Run declare_census_show(CLI::App& app);
Run declare_census_identify(CLI::App& app);

} // namespace tetrarch::program
