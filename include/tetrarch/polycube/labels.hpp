// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The six axes as labels of the triangles of a solid's boundary.
///
///         _____          Each triangle gets the axis, out of +x -x +y -y +z -z, that it is to face on the
///       .'  +z '.        polycube. The labeling has the least energy that alpha expansion finds: area times
///      (---------)       the deviation of the normal from the axis, and lengths of edges between different
///      |-x | +x  |       labels, which cost little at ridges and double between opposite axes.
///       '._____.'
///
/// Sources: Boykov, Veksler and Zabih, "Fast approximate energy minimization via graph cuts" (2001), for
/// alpha expansion; Dumery, Protais, Mestrallet, Bourcier and Ledoux, "Evocube" (2022), for the two terms.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/solid.hpp"

#include <array>
#include <vector>

namespace tetrarch::polycube {

using numeric::Point;
using numeric::Vector;

/// 0 to 5: +x, -x, +y, -y, +z, -z.
using Label = int;
inline constexpr int labels = 6;

inline std::size_t axis_of(Label label) {
  return static_cast<std::size_t>(label / 2);
}
inline double sign_of(Label label) {
  return label % 2 == 0 ? 1 : -1;
}
/// The axis itself.
Vector direction_of(Label label);
inline bool are_opposite(Label a, Label b) {
  return a != b && axis_of(a) == axis_of(b);
}

/// The unit normals of the boundary's triangles, and their areas.
struct Facets {
  explicit Facets(const product::Solid& solid);

  std::vector<Vector> normal; ///< zero where a triangle has no area
  std::vector<double> area;
  double total = 0;
};

/// The label of least energy of each triangle of the boundary. `smoothness` is how much edges between labels
/// cost, as a length in terms of the root of the area of the boundary. O(n) maximal flows, a few in practice;
/// throws Stopped between them.
std::vector<Label> labeled(const product::Solid& solid, const Facets& facets, double smoothness,
                           const Progress& progress = {});

} // namespace tetrarch::polycube
