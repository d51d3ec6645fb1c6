// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra that fill a solid: made, measured and described in one call.
///
///     const FilledSolid found = filled_solid(solid_of(open_mesh("part.off")));
///     if (found.verdict() == Verdict::yes) use(found.search.best->mesh);
///
/// They begin as cells of a grid, or as cubes of a polycube that is made for the solid.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/fill.hpp"
#include "tetrarch/polycube/polycube.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {
struct MeshDocument;
struct Soup;
} // namespace tetrarch::format

namespace tetrarch::workshop {

/// The solid that a mesh of tetrahedra is, or that a closed surface encloses, which TetGen fills. Throws
/// InputError if a tetrahedron has no volume or the boundary is not one closed surface (product/solid.hpp),
/// or if TetGen is missing or fails; Stopped. Near-linear, but for TetGen.
product::Solid solid_of(format::Soup soup, const Progress& progress = {});

/// The polycube from which hexahedra began.
struct SolidPolycube {
  polycube::Labeling labeling; ///< of the solid's boundary
  polycube::Polycube polycube; ///< its map
  double edge = 0;             ///< the length that became about 1
  int labelings = 0;           ///< that there were to choose from
};

/// The hexahedra, or none where no grid fits or no polycube is found. It owns all that it speaks of.
struct FilledSolid {
  hex::Search search;
  hex::FillOptions options;
  double seconds = 0;
  bool is_from_polycube = false;
  bool has_stuck_folds = false;            ///< at two scales, so that no more were tried
  std::optional<SolidPolycube> polycube{}; ///< that of the best result, else of the last try

  /// Undecided unless there are no doubts.
  Verdict verdict() const;
  /// What is wrong with the hexahedra, with places; empty: nothing.
  std::vector<std::string> doubts() const;
};

/// Seconds for thousands of hexahedra. Throws Stopped.
FilledSolid filled_solid(const product::Solid& solid, const hex::FillOptions& options = {},
                         const Progress& progress = {});

/// The length of edges with which about so many cubes of a polycube have the volume of a solid. There is no
/// layer, so that edges are shorter than `hex::edge_for` says.
double polycube_edge_for(const product::Solid& solid, std::int64_t cells);

/// The same from a polycube made for the solid; two scales at most are tried at which the map stays folded.
/// Where no length of edges is wanted, it is `polycube_edge_for`.
FilledSolid polycube_filled_solid(const product::Solid& solid, const hex::FillOptions& options = {},
                                  const Progress& progress = {});

Rows rows_of(const FilledSolid& found);

/// The hexahedra with their scaled Jacobians, as a file keeps them. Throws PreconditionError if there are
/// none. O(n).
format::MeshDocument document_of(const FilledSolid& found);

/// The polycube as a file keeps it: tetrahedra where the map puts them, triangles of the boundary with the
/// tags 1 to 6 for +x, -x, ... -z, and the field `solid`, each vertex's place in the solid. O(n).
format::MeshDocument document_of(const SolidPolycube& polycube);

template <>
const FieldList<FilledSolid>& fields_of<FilledSolid>();

} // namespace tetrarch::workshop
