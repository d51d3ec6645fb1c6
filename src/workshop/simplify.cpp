// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/simplify.hpp"

#include "move_run.hpp"
#include "with_info.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"

#include <functional>
#include <utility>

namespace tetrarch::workshop {
namespace {

/// Compares a Complex with what is computed from nothing: the numbers of classes, and the homology.
std::function<void(const moves::Complex&)> auditor(const Triangulation& input) {
  const auto homology = [](const Triangulation& tri, const Skeleton& skeleton) {
    return algebra::homology(tri, skeleton, 1).str();
  };
  const std::string before = homology(input, Skeleton(input));
  return [before, homology](const moves::Complex& complex) {
    const Triangulation tri = complex.triangulation();
    const Skeleton skeleton(tri);
    if (!is_valid(skeleton) || skeleton.vertex_count() != complex.vertex_count() ||
        skeleton.edge_count() != complex.edge_count() ||
        skeleton.boundary_face_count() != complex.boundary_face_count() || homology(tri, skeleton) != before)
      throw PreconditionError("the audit found a fault in the complex at " + std::to_string(complex.size()) +
                              " tetrahedra");
  };
}

} // namespace

moves::SimplifyOptions moves_for(const Triangulation& tri, const MoveOptions& options,
                                 Simplification& result) {
  result.input_tetrahedra = tri.size();
  moves::SimplifyOptions how;
  how.seed = options.seed;
  if (options.keep_log) how.log = &result.log;
  if (options.audit) how.audit = auditor(tri);
  return how;
}

Simplification simplify(const Triangulation& tri, const SimplifyOptions& options, const Progress& progress) {
  Simplification found;
  moves::SimplifyOptions how = moves_for(tri, options, found);
  how.change_boundary = !options.keep_boundary;
  found.triangulation = timed(found, [&] { return moves::simplified(tri, how, progress); });
  found.info = info(found.triangulation, options.name, false, progress);
  return found;
}

Rows rows_of(const Simplification& found, const std::string& signature) {
  return rows_of(found.info, signature);
}

template <>
const FieldList<Simplification>& fields_of<Simplification>() {
  static const auto run = fields_of_run<Simplification>();
  static const FieldList<Simplification> fields(run.begin(), run.end());
  return fields;
}

template <>
Tree tree_of<Simplification>(const Simplification& found) {
  return tree_with_info(found);
}

template <>
std::vector<FieldNote> notes_of<Simplification>() {
  return notes_with_info<Simplification>();
}

} // namespace tetrarch::workshop
