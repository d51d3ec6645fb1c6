// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Every defect that keeps a gluing from being a 3-manifold (with ideal vertices), as a list.

#include "tetrarch/core/skeleton.hpp"

#include <string>
#include <vector>

namespace tetrarch {

/// One thing that is wrong, and where.
struct Defect {
  enum class Kind {
    edge_reversed,   ///< an edge class is identified with itself backwards
    bad_vertex_link, ///< a vertex link with boundary that is no disk
  };
  Kind kind;
  EdgeId edge;     ///< of an edge_reversed
  VertexId vertex; ///< of a bad_vertex_link

  /// The name of the kind, as JSON shows it: "edge_reversed", "bad_vertex_link".
  std::string name() const;
};

/// The defects by kind, then by class number. Closed links of any type are allowed: a sphere makes a finite
/// vertex, any other surface an ideal one. O(n).
std::vector<Defect> check(const Skeleton& skeleton);

/// No defects.
bool is_valid(const Skeleton& skeleton);

/// A sentence that names the defect, where it is and what was expected.
std::string describe(const Defect& defect, const Skeleton& skeleton);

} // namespace tetrarch
