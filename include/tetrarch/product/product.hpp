// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Direct product parameterization: coordinates (u, v, w) of a handlebody in (a disk with holes) x (an
/// interval).
///
///        solid                     domain            (u, v): conformal on the floor, constant along fibers.
///       .-------.                 .--------.         w: harmonic. Orthogonal to u and v, if the mesh is fine
///      /  ,-.  / \     ----->    /  ,-.   /|         enough; u to v on the floor, elsewhere only where the
///     |  '-'  |  |              /--------/ |         solid is a product itself.
///      \_____/|_/               |________|/
///
/// The way there: `prepared`, `floor_map`, `harmonic_field`, `critical_places`, `FiberField`, `coordinates`.
/// Source: Yin, chapter 3.

#include "tetrarch/product/fibers.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/floor_map.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// A solid in which no edge is a short cut between two vertices of the same base.
struct SplitSolid {
  Solid solid;
  Partition partition;
  int splits = 0;
};

/// Splits, in the middle, all edges that join two vertices of the same base but are not on this base. Without
/// this, a tetrahedron with all vertices on one base would leave the field no room to rise. Old vertices keep
/// their numbers. O(n log n).
SplitSolid split_shortcuts(Solid solid, Partition partition);

/// The height that keeps the floor's aspect ratio: h d' / d for walls of mean height h, and a floor whose rim
/// has diameter d in space and d' in its map; 1 where the map was not found and has none. (The dissertation
/// has d / d'.) O(n + (length of the rim)^2).
double natural_height(const Solid& solid, const Partition& partition, const FloorMap& floor);

/// A fiber that failed to reach the floor.
struct StuckFiber {
  int vertex = 0; ///< where it started
  FiberEnd end = FiberEnd::stuck;
  Point at{}; ///< where it ended
};

struct Coordinates {
  std::vector<Point> uvw; ///< of each vertex; of stuck ones, u and v are means of those around
  std::vector<StuckFiber> stuck;
  int by_gradient = 0; ///< fibers for which smoothed vectors led nowhere, so that the gradient was followed
};

/// Traces a fiber from each vertex down to the floor. The same whatever the number of threads. O(n^1.33).
Coordinates coordinates(const FiberField& field, const FloorMap& floor, int threads = 1,
                        const Progress& progress = {});

struct Quality {
  std::vector<int> flipped; ///< tetrahedra whose image has no positive volume, decided exactly
  /// The cosine of the angle between grad w and grad u or grad v, whichever is greater: its mean by volume,
  /// and the greatest, over tetrahedra that are not flipped.
  double mean_orthogonality_error = 0;
  double max_orthogonality_error = 0;
  double mean_uv = 0; ///< the same of grad u against grad v
  double max_uv = 0;
};
/// O(n).
Quality quality(const Solid& solid, const std::vector<Point>& uvw);

/// Confirmation of the coordinates by the way back: from the point where the fiber of a vertex meets the
/// floor, up to the w of the vertex.
struct Confirmation {
  double mean_distance = 0; ///< between the vertex and the point found, in terms of the mean edge length
  double max_distance = 0;
  int worst = -1;      ///< a vertex at the greatest distance
  int off = 0;         ///< vertices farther than one mean edge
  int not_arrived = 0; ///< fibers that ended before
};
Confirmation confirm(const FiberField& field, int threads = 1, const Progress& progress = {});

} // namespace tetrarch::product
