// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Flattening: some tetrahedra are pressed flat, and their faces, edges and vertices meet in pairs.
///
/// What a vertex merge, a 2-0 move and the closing of a boundary have in common. Each removed tetrahedron
/// brings pairs of faces that come to lie on one another; what is glued outside them is then glued together,
/// however long the chain of flat pieces in between. The manifold stays the same if nothing closes up: the
/// graph whose nodes are face classes and whose arcs are the pairs has no cycle when all boundary faces count
/// as one node, and the same holds for edges (all boundary and all reversed edges are one node).

#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <cstdint>

namespace tetrarch::moves {

struct Flattening {
  /// Face a comes to lie on face b, vertex v of a's tetrahedron on vertex map[v] of b's, and map[a.face] ==
  /// b.face. Every face of a removed tetrahedron that has no pair is glued to another such face, or free.
  struct FacePair {
    TetFace a;
    TetFace b;
    Perm4 map;
  };
  struct EdgePair {
    EdgeId a;
    EdgeId b;
  };
  /// Most stars have fewer tetrahedra than this; larger ones take the heap.
  static constexpr std::size_t usual = 32;
  boost::container::small_vector<int, usual> tets; ///< all different
  boost::container::small_vector<FacePair, usual> faces;
  boost::container::small_vector<EdgePair, usual> edges;
};

/// The last six bits of a number, as one bit of a word: numbers that differ there differ.
inline std::uint64_t last_bits(int number) {
  return std::uint64_t{1} << (static_cast<unsigned>(number) % 64U);
}

/// The obstacle among edges or faces, if there is one. O(k log k) for k pairs.
MaybeObstacle why_not_flatten(const Complex& complex, const Flattening& flat);

/// Does it; the caller has asked. Vertices, and classes of edges that vanish altogether, are the caller's.
void flatten(Complex& complex, const Flattening& flat);

} // namespace tetrarch::moves
