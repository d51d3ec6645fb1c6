// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The table of commands, told: for the verb `help`, for completions, and through `help --json` for manual
/// pages and tests.

#include "command.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tetrarch::program {

/// The command that words name, and how many of them do.
struct Named {
  const Command* command = nullptr; ///< null: the words name all of them, or a group
  std::string name;                 ///< "census list"; of a group "census"; of all, empty
  std::size_t words = 0;
};
/// Stops at the first option, and where a command has no further ones below it. Throws InputError for a word
/// that is none of the commands expected.
Named named_command(const std::vector<Command>& table, const std::vector<std::string>& words);

/// A command with its options, the common ones included.
struct Declared {
  const Command* command;
  OptionTable options;
  Run run; ///< owns what the options write to
};
/// All commands; they refer to `table`.
std::vector<Declared> declared(const std::vector<Command>& table);

/// "--json", "--quiet", "--seed", "--threads", in a group of their own.
void declare_common(OptionTable& table, Common& common);

/// The commands by group with a line each; with a `name` ("census"), those that begin with it.
std::string overview(const std::vector<Command>& table, const std::string& name, const std::string& program);

/// {"program", "version", "summary", "commands": [{"name", "group", "summary", "example", "arguments",
/// "options", "result": the fields of what --json prints}], "common": the options that every command has,
/// "common_result", "exit_status"}. Examples begin with `program`, which is empty in a session.
Json describe(const std::vector<Command>& table, const std::string& program);

/// "info", "census": what a command line can begin with.
std::vector<std::string> first_words(const std::vector<Command>& table);

} // namespace tetrarch::program
