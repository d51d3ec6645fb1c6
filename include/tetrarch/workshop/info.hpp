// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a triangulation is: sizes, validity, boundary, homology, fundamental group, signature.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/workshop/fields.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

/// The fundamental group of a component, and where the loops of its generators are.
struct ComponentGroup {
  algebra::Presentation group;
  /// Of each generator the face that its loop crosses once, out of this tetrahedron; the rest of the loop
  /// runs through faces that no generator crosses or that generators now gone did.
  std::vector<TetFace> faces;
};

/// The group of each component of a valid triangulation, in the order of their first tetrahedra; simplified
/// unless `as_read` is true. Simplification is near-linear on the average of what was tried.
std::vector<ComponentGroup> fundamental_groups(const Triangulation& tri, bool as_read,
                                               const Progress& progress = {});

/// The facts about one triangulation. It owns all that it speaks of.
struct Info {
  std::string name; ///< empty: none
  int tetrahedra = 0;
  int faces = 0;
  int edges = 0;
  int vertices = 0;
  int components = 1;
  bool orientable = true;
  struct Defect {
    std::string name;
    std::string where;
  };
  std::vector<Defect> defects; ///< empty: a manifold with ideal vertices
  std::vector<BoundaryComponent> boundary;
  std::string homology;                      ///< H1 of a valid one
  std::vector<algebra::Presentation> groups; ///< of the components of a valid one
  std::string signature;                     ///< empty in brief

  bool valid() const { return defects.empty(); }
};

/// O(n) but for the signature and the group, which are left out of a brief one.
Info info(const Triangulation& tri, const std::string& name = {}, bool brief = false,
          const Progress& progress = {});

/// `signature` is what stands for the signature: a long one may be cut.
Rows rows_of(const Info& info, const std::string& signature);

template <>
const FieldList<Info>& fields_of<Info>();

} // namespace tetrarch::workshop
