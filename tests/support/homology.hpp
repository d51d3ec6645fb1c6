// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What no change of triangulation may change, homology included, as text.

#include "support/laws.hpp"
#include "tetrarch/algebra/homology.hpp"

#include <string>

namespace tetrarch::support {

inline std::string first_homology(const Triangulation& tri) {
  return algebra::homology(tri, Skeleton(tri), 1).str();
}

/// H0 to H3; empty of what is no manifold.
inline std::string homology_text(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  std::string text;
  for (int k = 0; is_valid(skeleton) && k <= 3; ++k)
    text += "H" + std::to_string(k) + " = " + algebra::homology(tri, skeleton, k).str() + "; ";
  return text;
}

inline std::string topology_and_homology(const Triangulation& tri) {
  return topology_text(tri) + "; " + homology_text(tri);
}

} // namespace tetrarch::support
