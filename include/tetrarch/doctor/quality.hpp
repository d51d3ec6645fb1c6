// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Size and quality of a mesh: what one looks at before computing on it.
///
///          3         Six dihedral angles; 70.5 degrees each if the tetrahedron is regular, near 0 and 180
///        / | .       if it is a sliver. The scaled Jacobian is
///       0--|--2
///        . | /           sqrt(2) det / the greatest product of the lengths of the edges at a corner:
///          1
///                     1 if regular, 0 if flat, negative if inverted.
///
/// For a triangle: its angles, and sin(least angle) / sin(60 degrees) in place of the Jacobian. Angles are in
/// degrees. Sources: Shewchuk, "What is a good linear finite element?" (2002); Knupp et al., "The Verdict
/// geometric quality library" (2007).

#include "tetrarch/format/soup.hpp"

#include <array>
#include <vector>

namespace tetrarch::doctor {

/// A bad element.
struct ElementQuality {
  int element = 0; ///< index in the soup
  double least_angle = 0;
  double greatest_angle = 0;
  double scaled_jacobian = 0;
};

struct Quality {
  double least_angle = 0; ///< of all elements
  double greatest_angle = 0;
  double least_scaled_jacobian = 0;
  /// By increasing scaled Jacobian, then by index; at most as many as asked for.
  std::vector<ElementQuality> worst;
};

/// Of one element.
ElementQuality quality_of(const std::array<std::array<double, 3>, 4>& tetrahedron);
ElementQuality quality_of(const std::array<std::array<double, 3>, 3>& triangle);

/// Of the tetrahedra, or of a surface's triangles. All zeros if there are none. Indices must be in range and
/// points finite. O(n log worst).
Quality quality(const format::Soup& soup, int worst = 10);

/// How large a mesh is.
struct Extent {
  std::array<double, 3> least{}; ///< of the used points
  std::array<double, 3> greatest{};
  double volume = 0; ///< signed, of the tetrahedra; of a surface, what it encloses if it is closed
  double area = 0;   ///< of a surface
};

/// As `quality`. O(n).
Extent extent(const format::Soup& soup);

} // namespace tetrarch::doctor
