// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The table of commands, told from the command line that is made of it: for the verb `help`, and through
/// `help --json` for man pages, completions and tests.

#include "command.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tetrarch::program {

/// Stands before the example at the end of a help page.
inline constexpr const char* example_heading = "Example:\n  ";

/// The subcommand of this name; null if there is none.
CLI::App* child(const CLI::App& app, const std::string& name);

/// "--threads", "-o": every spelling of every option of one command.
std::vector<std::string> option_names(const CLI::App& app);

/// The command that words name, and how many of them do.
struct Named {
  const CLI::App* app;
  std::string name; ///< "census list"
  std::size_t words = 0;
};
/// Stops at the first option, and where a command has no further ones below it. Throws InputError for a word
/// that is none of the commands expected.
Named named_command(const CLI::App& app, const std::vector<std::string>& words);

/// {"program", "version", "summary", "commands": [{"name", "summary", "example", "arguments", "options"}],
/// "common": the options that every command has, "exit_status"}.
Json describe(const CLI::App& app);

/// "info", "census": what a command line can begin with.
std::vector<std::string> first_words(const std::vector<Command>& table);

} // namespace tetrarch::program
