// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Finite pieces of the universal cover: many copies of a domain, each once ("multiple periods").
///
/// Copies are isometries, found breadth first from the identity: the neighbors of a copy g are g P for the
/// pairings P. Two words may lead to the same copy. A hash of cells holds the isometries, by the images of
/// the base point under the isometry and its inverse, both seen from the base point (as directions, so that
/// rounding stays relative however far the copy is); a look-up probes neighboring cells too. Two isometries
/// are equal if their matrices differ by less than 1e-6 relatively. Distinct copies differ by much more;
/// `closest` gives the least difference. Source: Yin, section 4.4.4.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/embed/domain.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace tetrarch::embed {

/// Bounds of a piece; at least one is needed. 0 stands for no bound.
struct PieceBounds {
  std::int64_t copies = 0;
  int word_length = 0;
  /// Greatest distance of a center from the center of the first copy; copies on the walk to such a copy are
  /// included.
  double radius = 0;
};

/// Copies of a fundamental domain: a finite piece of the universal cover.
struct Piece {
  std::vector<Matrix4<double>> copies; ///< the first is the identity; by word length
  std::vector<int> parent;             ///< -1 for the first
  std::vector<int> letter;             ///< the pairing P by which the parent g was left: the copy is g P
  std::vector<int> length;             ///< word length
  std::vector<double> distance;        ///< of its center from the first one's
  bool complete = true;                ///< nothing within the other bounds was cut off by `copies`
  double largest_duplicate = 0;        ///< largest relative difference of two words taken for the same copy
  double closest = 2;                  ///< smallest of two copies in one cell taken for different
};

/// Memory for making a piece of this many copies, in bytes.
std::int64_t piece_bytes(std::int64_t copies);

/// Throws PreconditionError without a bound or with a negative one. About 2 microseconds a copy. The walk to
/// a radius crosses every face that comes within it, so it misses no copy.
Piece universal_cover(const Domain<double>& domain, const PieceBounds& bounds, const Progress& progress = {});

/// The same for any discrete group of isometries without fixed points in hyperbolic space, by generators: the
/// tiling by a polygon around the base point, all of which lies within `size` of it. `letters` must contain
/// with every isometry its inverse.
Piece group_piece(std::span<const Matrix4<double>> letters, double size, const PieceBounds& bounds,
                  const Progress& progress = {});

/// The word of copy `c` in the letters, from the first copy on. O(length).
std::vector<int> word_to(const Piece& piece, int c);

} // namespace tetrarch::embed
