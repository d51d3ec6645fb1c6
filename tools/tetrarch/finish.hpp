// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is done with every result before anybody sees it: by the program, by a session, by Python.

#include "command.hpp"

#include "tetrarch/workshop/fields.hpp"

#include <filesystem>
#include <set>
#include <vector>

namespace tetrarch::program {

/// The one member that every object of --json may have.
inline constexpr workshop::FieldNote passed_over_note{
    "passed_over", "", "where something was read: what was passed over, a list of objects what, count"};

/// Adds what was passed over by those who read for it. A result that holds a number that is none is
/// undecided.
void finish(Result& result, const Reads& reads);

/// One file cannot hold two results: throws InputError. `paths` are those of earlier ones, to which these are
/// added.
void require_different(const std::vector<Result::File>& files, std::set<std::filesystem::path>& paths);

} // namespace tetrarch::program
