// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "../value.hpp"

#include <string>

namespace tetrarch::program {

/// "triangulation of 2 tetrahedra, with its metric": a few words.
std::string summary(const Value& value);

/// Whether one line can hold it: all but meshes of more than a thousand vertices.
bool can_be_spelled(const Value& value);

/// One line that means the same value where a value is expected: a signature if it gives exactly the same
/// gluings, else JSON; for a group, its presentation if that is all. Throws InputError if it cannot be
/// spelled.
std::string spelled(const Value& value);

} // namespace tetrarch::program
