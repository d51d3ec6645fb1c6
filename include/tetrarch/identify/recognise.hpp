// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Names for the simplest manifolds: S^3, B^3, handlebodies, S^2 bundles over S^1, lens spaces, the 3-torus.
///
/// There are two ways, and the answer names its way. By the triangulation: a closed triangulation that is a
/// layered lens space carries the two meridians in plain sight. Flatten its first tetrahedron onto the torus:
/// a parallelogram, whose two lower faces are folded onto each other and thereby kill one slope. Each next
/// tetrahedron lies on the parallelogram and changes its diagonal, until the last one's upper faces are
/// folded in turn. By the group: where the simplified presentation is visibly free, cyclic or Z^3, theorems
/// tell the manifold. What is proved is stated with the name. Sources: Jaco and Rubinstein,
/// "Layered-triangulations of 3-manifolds" (2006); Hempel, "3-Manifolds" (1976), theorem 5.2, for free
/// groups; the Poincare conjecture and geometrization (Perelman); Waldhausen (1968) for T^3.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <string>

namespace tetrarch::identify {

/// The name of a manifold, and by what it was found.
struct Recognition {
  enum class By { nothing, triangulation, group };

  /// "S^3", "B^3", "solid torus", "genus 3 handlebody", "solid Klein bottle", "S^2 x S^1", "S^2 x~ S^1",
  /// "RP^3", "L(7,2)", "T^3". Of a lens space whose group is all that is known, "L(7,?)". Empty if not
  /// recognized.
  std::string name;
  By by = By::nothing;
  /// Why this is the name; or what was tried.
  std::string because;

  explicit operator bool() const { return by != By::nothing; }
};

/// Names the manifold, with its ideal vertices truncated. Lens spaces L(p,q) are named up to orientation, q
/// the smallest of +-q and +-1/q modulo p. A failure proves nothing; the reason describes what was seen. A
/// layered lens space costs O(n) operations on integers that may reach n bits; the group costs what
/// `algebra::simplified` does: a second at most, and a few milliseconds for a few hundred tetrahedra.
[[nodiscard]] Recognition recognise(const Triangulation& tri, const Progress& progress = {});

} // namespace tetrarch::identify
