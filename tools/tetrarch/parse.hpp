// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From words to a job: the command line of the program and the lines of the shell alike. The library that
/// parses words is included in parse.cpp and nowhere else.

#include "command.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::program {

/// A command with its options, ready to run.
struct Job {
  Common common;
  Run run;
};

/// Either a job, or what was asked for is a text: a help page, the version.
struct Parsed {
  std::optional<Job> job;
  std::string text;
};

/// Without an option for it: as many threads as the machine has.
Common usual_options();

/// Usage lines and examples begin with `program`; in the shell it is empty. Throws InputError of one line;
/// what is no command or option gets the nearest one suggested. The job refers to `table`.
Parsed parse(const std::vector<std::string>& words, const std::vector<Command>& table,
             const std::string& program, const Common& defaults);

/// The help page of one command.
std::string help_page(const Command& command, const std::string& program);

} // namespace tetrarch::program
