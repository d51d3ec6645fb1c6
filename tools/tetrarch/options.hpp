// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The options and arguments of a command, as plain data.
///
///     table.add("X", input, "a triangulation").required();          an argument: no dashes
///     table.add("--repair", repair, "mend orientation first");      a flag: the variable is a bool
///     table.add("-o,--output", path, "the file to write").output_file();
///     table.add("--cells", cells, "hexahedra along a step").in_range(1, 1000).with_default();
///
/// The parser, help pages, manual pages, completions, `help --json` and the shell are all made from this
/// list. Nothing here knows of a library that parses words.

#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetrarch::program {

/// Where the value goes. The variable's type is the option's type, and what it holds at first is the default;
/// a vector collects the values of an option that is repeated, or all the words of an argument.
using Target = std::variant<bool*, int*, std::int64_t*, std::uint64_t*, double*, std::string*,
                            std::optional<int>*, std::optional<std::int64_t>*, std::optional<double>*,
                            std::vector<std::string>*, std::vector<double>*>;

/// Both ends are allowed.
struct Range {
  double least = 0;
  double most = 0;
};

/// One option or argument. The functions that change it give it back, so that they can be chained.
struct Option {
  std::vector<std::string> names; ///< "-o", "--output"; of an argument its one name, "X"
  Target target;
  std::string help;
  std::string value; ///< "FILE", "LOOP"; empty: as the type is called
  std::vector<std::string> choices;
  std::optional<Range> range;
  std::string excluded; ///< the option that must not be given besides; empty: none
  std::string group;    ///< the heading under which help lists it; empty: the command's own options
  int words = 1;        ///< that follow the option each time
  std::string implied;  ///< the value where none follows that is a number; empty: one must follow
  bool is_required = false;
  bool is_output = false; ///< a file that is written, or several: the parser tries whether that can be
  std::function<void(const std::string&)> require_name; ///< asked of such a file; throws what is wrong
  bool shows_default = false;

  Option& required(bool yes = true);
  Option& with_default();
  Option& value_name(std::string name);
  /// Its value is a file to write, whose name passes `require`, which throws InputError otherwise.
  Option& output_file(std::function<void(const std::string&)> require = {});
  Option& one_of(std::initializer_list<const char*> allowed);
  Option& in_range(double least, double most);
  Option& not_negative();
  Option& positive();
  Option& excludes(std::string other);
  Option& takes(int count);
  /// The option may stand without its number; then the value is this.
  Option& may_stand_alone(std::string value_alone);

  bool is_argument() const { return !names.front().starts_with('-'); }
  bool is_flag() const { return std::holds_alternative<bool*>(target); }
  /// The same option may be given several times, or the argument be several words.
  bool repeats() const;
  bool has_name(std::string_view name) const;
  /// "INT", "UINT", "FLOAT", "TEXT", or what `value_name` said; of a flag, empty.
  std::string type() const;
  /// The default as help shows it; empty where none is shown.
  std::string default_text() const;
};

/// A command's options, in the order of its help page.
class OptionTable {
public:
  /// Names are separated by commas. The variable must live as long as the parsed command does.
  Option& add(std::string_view names, Target target, std::string help);
  const std::deque<Option>& options() const { return options_; }
  /// The option of that name; null if there is none.
  const Option* find(std::string_view name) const;

  template <class T>
  Option& add(std::string_view names, T& variable, std::string help) {
    return add(names, Target(&variable), std::move(help));
  }

private:
  std::deque<Option> options_; ///< whose elements stay where they are
};

} // namespace tetrarch::program
