// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From names back to manifolds: what `identify` and `recognise` call a manifold, this makes.
///
///     fmp3_17                                             the tables' manifolds
///     m125, s776, v2000, x101, y200                       the cusped census's
///     m004, 4_1, figure-eight knot complement (m004)      cusped manifolds of fame, by any of their names
///     S^3, RP^3, L(7,2), S^2 x S^1, S^2 x~ S^1, T^3       closed ones
///     B^3, solid torus, genus 3 handlebody, ...           handlebodies, with real boundary
///
/// Lens spaces are made of layers: a solid torus of one tetrahedron, whose meridian meets the edges of its
/// boundary 1, 2 and 3 times; each further tetrahedron lies on one of these edges and so replaces its number
/// by another; at last the boundary is folded over an edge.
/// Source: Jaco and Rubinstein, "Layered-triangulations of 3-manifolds" (2006).

#include "tetrarch/core/triangulation.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::identify {

struct Named {
  std::string name; ///< as `identify` prints it
  Triangulation triangulation = Triangulation();
};

/// The manifold of that name; nothing if it names none. Throws InputError for a name that could be read but
/// has no one meaning, such as "L(6,2)" and "L(7,?)", or would take more than `most_named` tetrahedra. O(n)
/// in the tetrahedra made; that many are looked for where p is large, see `lens_space`.
std::optional<Named> find_named(std::string_view name);

/// The names there is a list of: the tables', the famous ones, the closed ones without parameters.
std::vector<std::string> listed_names();

/// A layered triangulation of L(p,q), p >= 3 and 0 < q < p prime to it, or nothing where it would take more
/// than `most_named` tetrahedra: about the sum of the partial quotients of p/q.
std::optional<Triangulation> lens_space(long long p, long long q);

/// 50 handles are enough for a name.
inline constexpr int most_handles = 50;
inline constexpr int most_named = 10'000;

} // namespace tetrarch::identify
