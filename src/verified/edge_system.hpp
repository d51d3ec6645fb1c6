// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The equations of a structure in balls, and which of them are left where there are cusps.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/metric.hpp"
#include "tetrarch/numeric/ball.hpp"

#include <optional>
#include <vector>

namespace tetrarch::verified {

/// A square matrix, of each row the places that are not 0, in increasing order: some thirty, however large it
/// is, for an edge has six tetrahedra on the average.
template <class Scalar>
struct SparseRows {
  struct Entry {
    int column;
    Scalar value;
  };
  std::vector<std::vector<Entry>> rows;

  int size() const { return static_cast<int>(rows.size()); }
};

/// A closed gluing. Each unknown is the length of one edge, or of several that are to be equal; its equation
/// is the sum of their curvatures.
class EdgeSystem {
public:
  /// Chooses what is fixed by the ends in cusps; without finite vertices.
  explicit EdgeSystem(const Skeleton& skeleton);
  /// With these lengths fixed, in increasing order (gauge.hpp).
  EdgeSystem(const Skeleton& skeleton, std::vector<EdgeId> fixed);
  /// One unknown for each block of edges: those of equal number, from 0 on. No length is fixed.
  EdgeSystem(const Skeleton& skeleton, const Table<EdgeId, int>& block);

  const std::vector<EdgeId>& fixed() const { return fixed_; }
  int unknowns() const { return unknowns_; }
  /// The unknown that is the length of this edge; -1 where it is fixed.
  int unknown(EdgeId e) const { return place_[e]; }
  /// Horospheres, or finite vertices, may move.
  bool is_free() const { return freedom_ > 0; }
  /// The identities are independent; of cusps it has never been otherwise.
  bool is_square() const { return static_cast<int>(fixed_.size()) == freedom_; }

  /// K of every edge; nothing unless every tetrahedron exists at all of these lengths, its finite vertices
  /// inside of what truncates the others.
  template <class Scalar>
  std::optional<hyperbolic::Metric<Scalar>> curvature(const hyperbolic::Metric<Scalar>& lengths) const;
  /// The left sides: curvatures of the edges that are not fixed, those of one unknown added up.
  template <class Scalar>
  std::vector<Scalar> equations(const hyperbolic::Metric<Scalar>& curvature) const;
  /// Minus the derivatives of the left sides by the unknowns, of tetrahedra that exist.
  template <class Scalar>
  SparseRows<Scalar> hessian(const hyperbolic::Metric<Scalar>& lengths) const;
  /// The sum of the tetrahedra's volumes; nothing unless they exist.
  std::optional<numeric::Ball> volume(const hyperbolic::Metric<numeric::Ball>& lengths,
                                      const Progress& progress) const;

private:
  void choose_fixed();
  void number_unknowns();

  const Skeleton& skeleton_;
  Table<VertexId, hyperbolic::VertexType> types_;
  int freedom_ = 0; ///< dimensions: one for each cusp, three for each finite vertex
  std::vector<EdgeId> fixed_;
  int unknowns_ = 0;
  Table<EdgeId, int> place_;
};

} // namespace tetrarch::verified
