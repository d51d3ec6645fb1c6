// SPDX-License-Identifier: GPL-2.0-or-later
#include "parse.hpp"

#include "describe.hpp"
#include "input.hpp"
#include "nearest.hpp"
#include "version.hpp"

#include "tetrarch/core/error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>
#include <thread>

namespace tetrarch::program {
namespace {

void declare_common(CLI::App& app, Common& common) {
  constexpr int most_threads = 256;
  app.add_flag("--json", common.json, "one JSON object on standard output and nothing else");
  app.add_flag("--quiet", common.quiet, "no warnings and no progress on standard error");
  app.add_option("--seed", common.seed, "for every random choice")->capture_default_str();
  app.add_option("--threads", common.threads,
                 "how many (default: all cores); the results do not depend on it")
      ->check(CLI::Range(1, most_threads));
}

/// The subcommand for a name of one or two words, with the group made on the way.
CLI::App& subcommand(CLI::App& app, const Command& command) {
  const std::string name = command.name;
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return *app.add_subcommand(name, command.summary);
  const std::string group = name.substr(0, space);
  CLI::App* parent = child(app, group);
  if (parent == nullptr) {
    parent = app.add_subcommand(group, "the classified manifolds, and how they were found");
    parent->require_subcommand(1);
  }
  return *parent->add_subcommand(name.substr(space + 1), command.summary);
}

/// An option as it is typed: no number and no signature.
bool looks_like_option(const std::string& word) {
  if (word.size() < 2 || word[0] != '-' || shielded(word) != word) return false;
  const char second = word[1];
  return second != '.' && !(second >= '0' && second <= '9');
}

void require_known_options(const Named& command, const std::vector<std::string>& words) {
  const std::vector<std::string> known = option_names(*command.app);
  for (std::size_t k = command.words; k < words.size() && words[k] != "--"; ++k) {
    if (!looks_like_option(words[k])) continue;
    const bool is_long = words[k][1] == '-';
    const std::string name = is_long ? words[k].substr(0, words[k].find('=')) : words[k].substr(0, 2);
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError("unknown option '" + name + "'" +
                     (command.name.empty() ? "" : " of '" + command.name + "'") + did_you_mean(name, known));
  }
}

/// A command line and what its callbacks write to.
struct CommandLine {
  CLI::App app;
  Common common;
  Run chosen;

  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  CommandLine(const std::vector<Command>& table, const std::string& program, const Common& defaults)
      : app("Tetrarch: a combinatorial topology engine for triangulated 3-manifolds.", program),
        common(defaults) {
    app.require_subcommand(1);
    app.set_version_flag("--version", version_text());
    app.footer(
        "A triangulation is a file, - for standard input, an isomorphism signature, or a census name.\n"
        "Exit status: 0 done, 1 proved no, 2 bad usage or input, 3 our fault, 4 undecided, 130 interrupted.");
    for (const Command& command : table) {
      CLI::App& sub = subcommand(app, command);
      Run run = command.declare(sub);
      declare_common(sub, common);
      for (CLI::Option* option : sub.get_options())
        if (option->get_positional()) option->type_name(""); // its name says what it is
      sub.footer(example_heading + (program.empty() ? "" : program + " ") + command.example);
      sub.callback([this, run = std::move(run)] { chosen = run; });
    }
  }
};

} // namespace

Common usual_options() {
  Common common;
  common.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return common;
}

Parsed parse(const std::vector<std::string>& words, const std::vector<Command>& table,
             const std::string& program, const Common& defaults) {
  const auto line = std::make_shared<CommandLine>(table, program, defaults);
  const Named command = named_command(line->app, words);
  require_known_options(command, words);
  try {
    std::vector<std::string> reversed; // words are taken from the back
    std::transform(words.rbegin(), words.rend(), std::back_inserter(reversed), shielded);
    line->app.parse(std::move(reversed));
  } catch (const CLI::Success& e) { // help or version
    std::ostringstream text;
    line->app.exit(e, text, text);
    return {std::nullopt, text.str()};
  } catch (const CLI::ParseError& e) {
    const std::string message = e.what();
    throw InputError((command.name.empty() ? "" : command.name + ": ") +
                     message.substr(0, message.find('\n')));
  }
  // `help` looks at the command line when it runs.
  return {Job{line->common, [line](const Context& context) { return line->chosen(context); }}, {}};
}

Json described(const std::vector<Command>& table) {
  return describe(CommandLine(table, "", {}).app);
}

} // namespace tetrarch::program
