// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/certify.hpp"

#include "cell_shapes.hpp"
#include "exact.hpp"
#include "flatness.hpp"
#include "merged.hpp"
#include "tetrarch/canonical/decorated.hpp"

#include <array>

namespace tetrarch::canonical {

using numeric::Ball;

const char* to_string(Criterion criterion) {
  constexpr std::array<const char*, 6> names{"tetrahedron", "R", "F", "B", "E", "L"};
  return names[static_cast<std::size_t>(criterion)];
}

namespace {

/// R or F for every cell, or L if that is allowed; -1 if all are proved, else the first that is not.
int prove_each(const Decorated<Ball>& m, const FlatFaces& flat, const CellShapes& shapes,
               std::vector<Criterion>& criteria, bool relations = false) {
  criteria.clear();
  for (int cell = 0; cell < static_cast<int>(shapes.cells.size()); ++cell) {
    const auto criterion = prove_flat(m, flat, shapes, cell, relations);
    if (!criterion) return cell;
    criteria.push_back(*criterion);
  }
  return -1;
}

/// With merged lengths: B for every cell that is no tetrahedron.
bool prove_merged(const Triangulation& tri, const Skeleton& skeleton, const hyperbolic::Metric<Ball>& lengths,
                  const FlatFaces& flat, const CellShapes& shapes, const MergedSolver& solver,
                  std::vector<Criterion>& criteria) {
  const auto merged = merge_equal_lengths(tri, skeleton, lengths, flat, shapes, solver);
  if (!merged || prove_each(merged->m, flat, merged->shapes, criteria) >= 0) return false;
  for (Criterion& criterion : criteria)
    if (criterion != Criterion::tetrahedron) criterion = Criterion::blocks;
  return true;
}

/// E for every cell that is no tetrahedron.
bool prove_exactly(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat,
                   const CellShapes& shapes, const Solvers& solvers, CellsProof& proof) {
  const auto field = prove_flat_exactly(tri, skeleton, flat, solvers.precise, solvers.still_wanted);
  if (!field) return false;
  proof.field = *field;
  proof.criteria.clear();
  for (const CellShape& cell : shapes.cells)
    proof.criteria.push_back(cell.tets.size() == 1 ? Criterion::tetrahedron : Criterion::exact);
  return true;
}

} // namespace

CellsProof certify_cells(const Triangulation& tri, const Skeleton& skeleton,
                         const hyperbolic::Metric<Ball>& lengths, const FlatFaces& flat,
                         const Solvers& solvers) {
  CellsProof proof;
  const Decorated<Ball> m = decorate(tri, skeleton, lengths);
  std::optional<Ball> least_tilt;
  bool any_flat = false;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      any_flat |= flat[t][f];
      const Ball tilt = look_across(m, {t, f}).tilt;
      if (flat[t][f]) {
        if (!(abs(tilt) > 0)) continue;
        proof.why_not =
            "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + " is certainly not flat";
        return proof;
      }
      if (!(tilt > 0)) {
        proof.why_not =
            "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + " is not certainly convex";
        return proof;
      }
      if (!least_tilt || tilt < *least_tilt) least_tilt = tilt;
    }
  if (least_tilt) proof.least_tilt = numeric::to_double(*least_tilt);
  if (!any_flat) {
    proof.criteria.assign(static_cast<std::size_t>(tri.size()), Criterion::tetrahedron);
    proof.certified = true;
    return proof;
  }
  const CellShapes shapes = cell_shapes(tri, skeleton, flat);
  const int doubtful = prove_each(m, flat, shapes, proof.criteria);
  proof.certified = doubtful < 0 ||
                    (solvers.merged &&
                     prove_merged(tri, skeleton, lengths, flat, shapes, solvers.merged, proof.criteria)) ||
                    prove_each(m, flat, shapes, proof.criteria, true) < 0 ||
                    (solvers.precise && prove_exactly(tri, skeleton, flat, shapes, solvers, proof));
  if (!proof.certified) {
    proof.criteria.clear();
    proof.why_not = "cell " + std::to_string(doubtful) + " is flat to all digits, which is no proof";
  }
  return proof;
}

} // namespace tetrarch::canonical
