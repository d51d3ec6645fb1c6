// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One table of commands. Each is a function from options to a result value; printing that value as text or
/// as JSON, writing its files and choosing the exit status happen in one place (job.cpp). The program and the
/// shell are two faces of the table.

#include "value.hpp"

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/ledger.hpp"

#include <cstdint>
#include <functional>
#include <memory>
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
  ValuePointer value;      ///< what `NAME = ...` gives a name to in a session; null: nothing
};

/// The options that every command shares.
struct Common {
  bool json = false;
  bool quiet = false;
  std::uint64_t seed = 1;
  int threads = 1;
};

/// What a command has read so far.
struct Reads {
  bool any = false;
  format::Ledger passed_over;
};

/// What every command is given besides its own options.
struct Context : Common {
  Progress progress;
  const Values* values = nullptr; ///< what names mean; null outside a session
  /// Whoever reads an input notes here what was passed over; it is printed with the result.
  std::shared_ptr<Reads> reads = std::make_shared<Reads>();
};

using Run = std::function<Result(const Context&)>;

struct Command {
  const char* name; ///< "info", "census list"
  const char* summary;
  const char* example; ///< works as typed after the program's name
  /// Declares the command's own options; what it returns is called after they have been parsed.
  std::function<Run(CLI::App&)> declare;
  /// In a session, what it makes of a named value takes the name.
  bool changes = false;
};

/// All commands, in the order of the help page.
const std::vector<Command>& commands();

Run declare_help(CLI::App& app);
Run declare_shell(CLI::App& app);
Run declare_group(CLI::App& app);
Run declare_move(CLI::App& app);
Run declare_skeleton(CLI::App& app);
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
