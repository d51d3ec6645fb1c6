// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Joining points that lie in one place, and choosing a component.
///
///     .---.  .---.        .---.---.
///     |   |  |   |   ->   |   |   |       Pieces of a mesh that were written apart have points of their own
///     '---'  '---'        '---'---'       along their common faces.

#include "tetrarch/doctor/repair.hpp"

namespace tetrarch::doctor {

/// Points at most `tolerance` apart become the first of them, in the order of the soup; with tolerance 0
/// those of equal coordinates. A point joins the first representative within the tolerance, so that no chain
/// of points collapses. Elements that lose a corner by it are removed. Points that are not finite stay as
/// they are. Throws PreconditionError for a tolerance that is negative or no number. O(n) expected, unless
/// many points lie within one tolerance.
Repaired weld(format::Soup soup, double tolerance);

/// The number of components: of tetrahedra connected through faces, or of triangles connected through edges.
int component_count(const format::Soup& soup);

/// The k-th component, counted from 0 by its first element; of a solid with the triangles on its faces.
/// Points that no element names then are removed. Throws InputError if there are not so many.
format::Soup component(format::Soup soup, int k);

} // namespace tetrarch::doctor
