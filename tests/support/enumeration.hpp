// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every labelled gluing of a few tetrahedra, boundary allowed.
///
/// A labelled gluing is a partial matching of the 4n faces with one of 6 maps for every matched pair. By
/// hand: of one tetrahedron there are 1 + 6*6 + 3*36 = 145, of two 1 + 28*6 + 210*36 + 420*216 + 105*1296 =
/// 234,529. Laws that hold for all of these hold for every local accident that a gluing can have: edges
/// reversed, faces of one tetrahedron glued to each other, vertex links of any type, several components.

#include "tetrarch/core/triangulation.hpp"

#include <array>

namespace tetrarch::support {

inline constexpr long one_tetrahedron_gluings = 145;
inline constexpr long two_tetrahedra_gluings = 234529;

/// The six maps that take face f of one tetrahedron to face g of another, by rank.
inline std::array<Perm4, 6> face_maps(int f, int g) {
  std::array<Perm4, 6> maps;
  int count = 0;
  for (int rank = 0; rank < Perm4::count; ++rank)
    if (Perm4::from_rank(rank)[f] == g) maps[count++] = Perm4::from_rank(rank);
  return maps;
}

namespace detail {

/// Decides face number `at` and all later ones in every way. The triangulation comes back as it was.
template <class Visit>
void decide_faces(Triangulation& tri, int at, Visit& visit) {
  if (at == 4 * tri.size()) {
    visit(static_cast<const Triangulation&>(tri));
    return;
  }
  decide_faces(tri, at + 1, visit); // as it is: glued from an earlier face, or left on the boundary
  const TetFace here{at / 4, at % 4};
  if (!tri.is_boundary(here)) return;
  for (int other = at + 1; other < 4 * tri.size(); ++other) {
    if (!tri.is_boundary({other / 4, other % 4})) continue;
    for (const Perm4 p : face_maps(here.face, other % 4)) {
      tri.glue(here, other / 4, p);
      decide_faces(tri, at + 1, visit);
      tri.unglue(here);
    }
  }
}

} // namespace detail

/// Calls `visit(const Triangulation&)` once for every labelled gluing of `tets` tetrahedra. The triangulation
/// passed is one and the same object each time; a visitor that keeps it must copy it.
template <class Visit>
void for_each_gluing(int tets, Visit visit) {
  Triangulation tri(tets);
  detail::decide_faces(tri, 0, visit);
}

/// All 234,674 gluings of one and of two tetrahedra.
template <class Visit>
void for_each_small_gluing(Visit visit) {
  for_each_gluing<Visit&>(1, visit);
  for_each_gluing<Visit&>(2, visit);
}

} // namespace tetrarch::support
