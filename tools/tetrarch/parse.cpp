// SPDX-License-Identifier: GPL-2.0-or-later
#include "parse.hpp"

#include "describe.hpp"
#include "input.hpp"
#include "output.hpp"
#include "version.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/nearest.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <thread>

namespace tetrarch::program {
namespace {

constexpr const char* example_heading = "Example:\n  ";

void check_range(CLI::Option& made, const Option& option) {
  const auto [least, most] = *option.range;
  if (most == std::numeric_limits<double>::max())
    made.check(least > 0 ? static_cast<const CLI::Validator&>(CLI::PositiveNumber) : CLI::NonNegativeNumber);
  else if (std::holds_alternative<double*>(option.target))
    made.check(CLI::Range(least, most));
  else
    made.check(CLI::Range(static_cast<int>(least), static_cast<int>(most)));
}

/// Tries the files that a command is to write, before the job rather than after it.
void require_good_outputs(const OptionTable& options) {
  for (const Option& option : options.options()) {
    if (!option.is_output) continue;
    const auto require = [&option](const std::string& path) {
      if (path.empty()) return;
      format::require_writable(path);
      if (option.require_name) option.require_name(path);
    };
    if (const auto* const path = std::get_if<std::string*>(&option.target)) require(**path);
    if (const auto* const paths = std::get_if<std::vector<std::string>*>(&option.target))
      for (const std::string& path : **paths) require(path);
  }
}

std::string spelled(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

bool takes_numbers(const Option& option) {
  return std::holds_alternative<double*>(option.target) ||
         std::holds_alternative<std::optional<double>*>(option.target) ||
         std::holds_alternative<std::vector<double>*>(option.target);
}

/// The library takes "nan" and "inf" for numbers.
CLI::Validator finite_number() {
  return CLI::Validator(
      [](const std::string& word) {
        double value = 0;
        const bool bad = CLI::detail::lexical_cast(word, value) && !std::isfinite(value);
        return bad ? in_quotes(word) + " is no finite number" : std::string();
      },
      "");
}

void add(CLI::App& app, const Option& option) {
  CLI::Option* made = std::visit(
      [&](auto* variable) {
        if constexpr (std::is_same_v<decltype(variable), bool*>)
          return app.add_flag(spelled(option.names), *variable, option.help);
        else
          return app.add_option(spelled(option.names), *variable, option.help);
      },
      option.target);
  if (takes_numbers(option)) made->check(finite_number());
  if (!option.value.empty()) made->type_name(option.value);
  if (!option.choices.empty()) made->check(CLI::IsMember(option.choices));
  if (option.range) check_range(*made, option);
  if (option.is_argument())
    made->type_name(""); // its name says what it is
  else if (option.words > 1)
    made->expected(option.words);
  else if (option.repeats())
    made->allow_extra_args(false);
  if (!option.excluded.empty()) made->excludes(app.get_option(option.excluded));
  if (!option.group.empty()) made->group(option.group);
  if (option.shows_default) made->capture_default_str();
  made->required(option.is_required);
}

/// The words of one command, and what they are written to.
struct CommandLine {
  CLI::App app;
  Common common;
  OptionTable options;
  Run run;

  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  CommandLine(const Command& command, const std::string& program, const Common& defaults)
      : app(command.summary, (program.empty() ? "" : program + " ") + command.name), common(defaults),
        run(command.declare(options)) {
    declare_common(options, common);
    for (const Option& option : options.options()) add(app, option);
    app.footer(example_heading + (program.empty() ? "" : program + " ") + command.example);
  }
};

/// An option as it is typed: no number and no signature.
bool looks_like_option(const std::string& word) {
  if (word.size() < 2 || word[0] != '-' || shielded(word) != word) return false;
  const char second = word[1];
  return second != '.' && !(second >= '0' && second <= '9');
}

[[noreturn]] void refuse_option(const std::string& word, const std::string& command,
                                const std::vector<std::string>& known) {
  const bool is_long = word[1] == '-';
  const std::string name = is_long ? word.substr(0, word.find('=')) : word.substr(0, 2);
  throw InputError("unknown option '" + name + "'" + (command.empty() ? "" : " of '" + command + "'") +
                       workshop::did_you_mean(name, known),
                   Cause::option);
}

void require_known_options(const Named& command, const std::vector<std::string>& words,
                           const OptionTable& options) {
  std::vector<std::string> known{"-h", "--help"};
  for (const Option& option : options.options())
    if (!option.is_argument()) known.insert(known.end(), option.names.begin(), option.names.end());
  for (std::size_t k = command.words; k < words.size() && words[k] != "--"; ++k) {
    if (!looks_like_option(words[k])) continue;
    const bool is_long = words[k][1] == '-';
    const std::string name = is_long ? words[k].substr(0, words[k].find('=')) : words[k].substr(0, 2);
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse_option(name, command.name, known);
  }
}

/// Puts the implied value behind an option that stands without its number.
std::vector<std::string> with_implied_values(std::vector<std::string> words, const OptionTable& options) {
  for (std::size_t k = 0; k < words.size() && words[k] != "--"; ++k) {
    const Option* const option = words[k].starts_with('-') ? options.find(words[k]) : nullptr;
    if (option == nullptr || option->implied.empty()) continue;
    if (k + 1 < words.size() && format::parse_double(words[k + 1])) continue;
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, option->implied);
  }
  return words;
}

/// What words say that name no command: everything, or a group such as `census`.
std::string text_without_command(const Named& named, const std::vector<std::string>& words,
                                 const std::vector<Command>& table, const std::string& program) {
  if (named.words == words.size()) return overview(table, named.name, program);
  const std::string& word = words[named.words];
  if (word == "-h" || word == "--help") return overview(table, named.name, program);
  if (!named.name.empty() || word != "--version")
    refuse_option(word, named.name, {"-h", "--help", "--version"});
  return version_text() + "\n";
}

} // namespace

Common usual_options() {
  Common common;
  common.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return common;
}

Parsed parse(const std::vector<std::string>& words, const std::vector<Command>& table,
             const std::string& program, const Common& defaults) {
  const Named named = named_command(table, words);
  if (named.command == nullptr) return {std::nullopt, text_without_command(named, words, table, program)};
  const auto line = std::make_shared<CommandLine>(*named.command, program, defaults);
  require_known_options(named, words, line->options);
  try {
    const std::vector<std::string> all = with_implied_values(words, line->options);
    std::vector<std::string> reversed; // words are taken from the back
    std::transform(all.rbegin(), all.rend() - static_cast<std::ptrdiff_t>(named.words),
                   std::back_inserter(reversed), shielded);
    line->app.parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, line->app.help()};
  } catch (const CLI::ParseError& e) {
    const std::string message = e.what();
    throw InputError(named.name + ": " + message.substr(0, message.find('\n')), Cause::option);
  }
  const auto run = [line, program, &table](Context context) {
    context.commands = &table;
    context.program = program;
    require_good_outputs(line->options);
    return line->run(context);
  };
  return {Job{line->common, run}, {}};
}

std::string help_page(const Command& command, const std::string& program) {
  return CommandLine(command, program, {}).app.help();
}

} // namespace tetrarch::program
