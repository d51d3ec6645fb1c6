// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is done with every result before anybody sees it: by the program, by a session, by Python.

#include "command.hpp"

#include <filesystem>
#include <set>
#include <vector>

namespace tetrarch::program {

/// Adds what was passed over by those who read for it. A result that holds a number that is none is
/// undecided.
void finish(Result& result, const Reads& reads);

/// One file cannot hold two results: throws InputError. `paths` are those of earlier ones, to which these are
/// added.
void require_different(const std::vector<Result::File>& files, std::set<std::filesystem::path>& paths);

} // namespace tetrarch::program
