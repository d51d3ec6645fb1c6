// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Combinatorial isomorphisms: relabelings of tetrahedra and of their vertices that carry gluings to
/// gluings.

#include "tetrarch/core/triangulation.hpp"

#include <optional>
#include <vector>

namespace tetrarch {

/// Tetrahedron t goes to tet[t], its vertex v to perm[t][v].
struct Isomorphism {
  std::vector<int> tet;
  std::vector<Perm4> perm;
  friend bool operator==(const Isomorphism&, const Isomorphism&) = default;
};

inline Triangulation relabelled(const Triangulation& tri, const Isomorphism& iso) {
  return relabelled(tri, iso.tet, iso.perm);
}

/// Some isomorphism from a to b, or nothing if there is none. The image of one tetrahedron determines an
/// isomorphism of connected triangulations, so at most 24n candidates are followed, each up to its first
/// mismatch: O(n^2) at worst.
std::optional<Isomorphism> find_isomorphism(const Triangulation& a, const Triangulation& b);

/// All isomorphisms from a connected triangulation to itself, ordered by the image of tetrahedron 0; the
/// identity is among them. Throws PreconditionError if tri is empty or not connected. O(n^2) at worst.
std::vector<Isomorphism> automorphisms(const Triangulation& tri);

/// All isomorphisms between two connected triangulations, ordered by the image of tetrahedron 0.
std::vector<Isomorphism> isomorphisms(const Triangulation& a, const Triangulation& b);

} // namespace tetrarch
