// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/certify.hpp"

#include "cell_shapes.hpp"
#include "flatness.hpp"
#include "tetrarch/canonical/decorated.hpp"

#include <array>

namespace tetrarch::canonical {

using numeric::Ball;

const char* to_string(Criterion criterion) {
  constexpr std::array<const char*, 3> names{"tetrahedron", "R", "F"};
  return names[static_cast<std::size_t>(criterion)];
}

CellsProof certify_cells(const Triangulation& tri, const Skeleton& skeleton,
                         const hyperbolic::Metric<Ball>& lengths, const FlatFaces& flat) {
  CellsProof proof;
  const Decorated<Ball> m = decorate(tri, skeleton, lengths);
  bool any = false;
  bool any_flat = false;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      any_flat |= flat[t][f];
      if (flat[t][f]) continue;
      const Ball tilt = look_across(m, {t, f}).tilt;
      if (!(tilt > 0)) {
        proof.why_not =
            "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + " is not certainly convex";
        return proof;
      }
      if (!any || tilt < proof.least_tilt) proof.least_tilt = tilt;
      any = true;
    }
  if (!any_flat) {
    proof.criteria.assign(static_cast<std::size_t>(tri.size()), Criterion::tetrahedron);
    proof.certified = true;
    return proof;
  }
  const CellShapes shapes = cell_shapes(tri, skeleton, flat);
  for (int cell = 0; cell < static_cast<int>(shapes.cells.size()); ++cell) {
    const auto criterion = prove_flat(m, flat, shapes, cell);
    if (!criterion) {
      proof.why_not = "cell " + std::to_string(cell) + " is flat to all digits, which is no proof";
      return proof;
    }
    proof.criteria.push_back(*criterion);
  }
  proof.certified = true;
  return proof;
}

} // namespace tetrarch::canonical
