// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One table of commands. Each is a function from options to a result value; printing that value as text or
/// as JSON, writing its files and choosing the exit status happen in one place (job.cpp). The program and the
/// shell are two faces of the table.

#include "json.hpp"
#include "options.hpp"
#include "value.hpp"

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/ledger.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::program {

/// Exit statuses, as documented for the program.
enum class Status { done = 0, proved_no = 1, bad_input = 2, fault = 3, undecided = 4, interrupted = 130 };

/// Done; a proved no; undecided.
Status status_of(workshop::Verdict verdict);

struct Result {
  std::string text;     ///< for people; ends with a newline
  bool is_file = false; ///< `text` is what a file would hold, and goes out byte by byte but to a terminal
  Json json;            ///< for programs; null: `text` is already what programs read
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
  std::optional<double> memory; ///< gigabytes that a job may take
};

/// For what is estimated before it is begun: gigabytes that are allowed.
inline double allowed_gigabytes(const Common& common) {
  constexpr double usual = 4;
  return common.memory.value_or(usual);
}

struct Command;
/// What a command has read so far.
struct Reads {
  bool any = false;
  format::Ledger passed_over;
};

/// What every command is given besides its own options.
struct Context : Common {
  Progress progress;
  const Values* values = nullptr; ///< what names mean; null outside a session
  /// Values that nobody else needs: who reads a mesh takes it, so that there is no second one while the long
  /// work is done. Null: none.
  std::map<std::string, std::shared_ptr<Value>, std::less<>>* passing = nullptr;
  const std::vector<Command>* commands = nullptr; ///< the table that the command stands in
  std::string program;                            ///< what usage lines begin with; empty in a session
  /// Prints a part of the text now, of results that are long; null where they are wanted whole.
  std::function<void(const std::string&)> print;
  /// Whoever reads an input notes here what was passed over; it is printed with the result.
  std::shared_ptr<Reads> reads = std::make_shared<Reads>();
};

using Run = std::function<Result(const Context&)>;

struct Command {
  const char* group; ///< the heading under which `help` lists it
  const char* name;  ///< "info", "census list"
  const char* summary;
  const char* example; ///< works as typed after the program's name
  /// Declares the command's own options; what it returns owns their variables, and is called after they have
  /// been parsed.
  std::function<Run(OptionTable&)> declare;
  /// In a session, what it makes of a named value takes the name.
  bool changes = false;
  /// The members of its JSON, where a typed result lists them; null: not listed.
  std::vector<workshop::FieldNote> (*fields)() = nullptr;
};

/// The fields of those results that the program itself makes, each listed beside what makes it.
namespace fields {
using List = std::vector<workshop::FieldNote>;
List of_skeleton();
List of_group();
List of_convert();
List of_move();
List of_subdivide();
List of_drill();
List of_view();
List of_census_gluings();
List of_census_enumerate();
List of_census_merge();
List of_census_validate();
List of_census_list();
List of_census_show();
List of_census_table();
} // namespace fields

/// All commands, in the order of the help page.
const std::vector<Command>& commands();

Run declare_help(OptionTable& table);
Run declare_shell(OptionTable& table);
Run declare_group(OptionTable& table);
Run declare_move(OptionTable& table);
Run declare_skeleton(OptionTable& table);
Run declare_info(OptionTable& table);
Run declare_convert(OptionTable& table);
Run declare_check(OptionTable& table);
Run declare_simplify(OptionTable& table);
Run declare_truncate(OptionTable& table);
Run declare_subdivide(OptionTable& table);
Run declare_drill(OptionTable& table);
Run declare_diagram(OptionTable& table);
Run declare_exterior(OptionTable& table);
Run declare_hyperbolize(OptionTable& table);
Run declare_verify(OptionTable& table);
Run declare_canonize(OptionTable& table);
Run declare_isometric(OptionTable& table);
Run declare_embed(OptionTable& table);
Run declare_view(OptionTable& table);
Run declare_bundle(OptionTable& table);
Run declare_slit(OptionTable& table);
Run declare_register(OptionTable& table);
Run declare_hex(OptionTable& table);
Run declare_product(OptionTable& table);
Run declare_census_gluings(OptionTable& table);
Run declare_census_enumerate(OptionTable& table);
Run declare_census_merge(OptionTable& table);
Run declare_census_validate(OptionTable& table);
Run declare_census_list(OptionTable& table);
Run declare_census_show(OptionTable& table);
Run declare_census_table(OptionTable& table);
Run declare_census_identify(OptionTable& table);

} // namespace tetrarch::program
