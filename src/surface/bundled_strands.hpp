// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Four strands along each way of a tree of triangles, side by side, and around the point of a handle.
///
///         e2                   The point o has the ends e1, ..., e4 of two loops. Four strands come in by
///          |                   its gate, at the bottom. The outer ones turn off first and lead to the
///     ,----|----.              neighbors of o on e1 and e4; the inner ones cross these edges, which are
///     | ,--|--. |              no longer marked, and lead to those on e2 and e3.
///  e3-|-|--o--|-|-e1           (Drawn: e1 and e4 off their strands; e4 points to the lower left.)
///     | | /   | |
///     | |/    | |
///
/// On an edge at o, what turns around o is nearer to it than any other way.

#include "strands.hpp"

#include <vector>

namespace tetrarch::surface {

/// `start`: the corners of the triangles at the base where ways may start, from right to left. `entered`: the
/// side by which a way comes into each triangle, seen from before it; none: it is at the base. `gates`: the
/// side by which a way goes into the triangle at the point of each handle, seen from inside. Moves the ends
/// of the loops at these points to the base. Returns the number of new vertices. O((n + result) log n).
int lay_bundled_strands(MarkedSurface& surface, const std::vector<SideEnd>& start,
                        const std::vector<Side>& entered, const std::vector<Side>& gates);

} // namespace tetrarch::surface
