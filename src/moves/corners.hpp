// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The corners of a ball that a move changes.

#include "tetrarch/moves/ball.hpp"

namespace tetrarch::moves {

/// The three corners of a face of a tetrahedron of the ball, as a set of bits.
inline unsigned face_key(const Corners& corners, int face) {
  unsigned key = 0;
  for (const int v : face_vertex[face]) key |= 1U << static_cast<unsigned>(corners[v]);
  return key;
}

} // namespace tetrarch::moves
