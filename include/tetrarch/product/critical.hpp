// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Critical points of a field: fibers part or end there, and the field makes no product of the solid.
///
///        + + -         A vertex is regular if those of its link that are lower hang together, and so do
///       -  o  +        those that are higher; on a wall, both also in the link on the wall. Elsewhere there
///        - + +         is an extremum or, as here, a saddle. Of vertices with equal w the one of lesser
///                      number is lower, which makes no critical vertices of its own.
///
/// A field without critical points proves that the solid is a product, floor x interval. Critical points
/// prove nothing: another mesh, another partition or other weights may have none. Source: Banchoff, "Critical
/// points and curvature for embedded polyhedra" (1967).

#include "tetrarch/product/partition.hpp"

#include <vector>

namespace tetrarch::product {

struct CriticalVertex {
  int vertex = 0;
  int lower = 0; ///< parts of the link below
  int upper = 0; ///< parts of the link above
  bool on_wall = false;
};

struct CriticalPlaces {
  std::vector<int> flat; ///< tetrahedra where w is constant, up to rounding
  std::vector<CriticalVertex> vertices;
  bool none() const { return flat.empty() && vertices.empty(); }
};

/// `w`: of each vertex, 0 on the floor and greatest on the ceiling. O(n).
CriticalPlaces critical_places(const Solid& solid, const Partition& partition, const std::vector<double>& w);

} // namespace tetrarch::product
