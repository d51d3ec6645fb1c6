// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Edges as they are typed: "5" is the class of this number, "3:01" that of the edge 01 of tetrahedron 3.

#include "tetrarch/core/skeleton.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

/// Throws InputError that begins with `what`, as "EDGES", if there is no such edge or it is reversed.
EdgeId edge_named(const std::string& word, const Skeleton& skeleton, const std::string& what);

/// Of each class whether it is named. Words are separated by commas or given one by one.
Table<EdgeId, bool> edges_named(const std::vector<std::string>& words, const Skeleton& skeleton,
                                const std::string& what);

} // namespace tetrarch::program
