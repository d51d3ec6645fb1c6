// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the solvers need of a gluing, laid out flat; and the state they move through.

#include "kernel.hpp"
#include "tetrarch/core/marks.hpp"
#include "tetrarch/hyperbolic/metric.hpp"

#include <vector>

namespace tetrarch::hyperbolic {

/// A closed gluing as equations K_e(l) = 0. Null edges (order 0) have no equation; their length is no
/// unknown, and is kept at 0.
struct Problem {
  struct Tet {
    std::array<int, 6> edge;
    std::array<int, 4> vertex;
    VertexTypes types;
    /// -1: turned over; its angles count negatively, and those beyond a right angle as 2 pi less that.
    int orientation = 1;
  };
  std::vector<Tet> tets;
  std::vector<double> order;                   ///< of each edge class: its angle is to be 2 pi / order
  std::vector<std::array<VertexType, 2>> ends; ///< the vertex types at the ends of each edge class
  /// ends_at_cusp[c][e]: how many ends of edge e lie in cusp c. Moving the horosphere of cusp c adds a
  /// multiple of this vector to the lengths and changes no angle.
  std::vector<std::vector<int>> ends_at_cusp;

  explicit Problem(const Skeleton& skeleton);
  Problem(const Skeleton& skeleton, const Table<VertexId, VertexType>& types, const EdgeOrders& orders);
  bool is_null(int e) const { return order[e] == 0; }
  kernel::NullEdges null_edges(const Tet& tet) const;
  int edges() const { return static_cast<int>(ends.size()); }
};

/// Lengths and everything that follows from them. Made once, overwritten by each evaluation.
template <class Scalar>
struct State {
  std::vector<Scalar> lengths;
  std::vector<Scalar> curvature;
  AngleTable<Scalar> angles;
  std::vector<std::array<SixNumbers<Scalar>, 6>> jacobian; ///< per tetrahedron, d theta / d l
  int first_missing = -1;                                  ///< the first tetrahedron that does not exist
  std::vector<kernel::EdgeForm<Scalar>> form;

  State(const Problem& problem, std::vector<Scalar> start);
  /// Angles and curvature at `lengths`, and the Jacobians if asked for. O(n), allocates nothing.
  void evaluate(const Problem& problem, bool with_jacobian);
  Scalar residual() const;
  Scalar squared_curvature() const;
  /// The edge of largest |length|, and that length.
  int longest_edge() const;
  Scalar longest() const;
};

} // namespace tetrarch::hyperbolic
