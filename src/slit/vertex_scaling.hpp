// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Newton's method for vertex scaling: what slit/ricci.hpp is built on, kept from one problem to the next.
///
/// A round hole is filled in with isosceles triangles about a centre,
///
///       v---w      whose legs are all e^s. The base angles make up for what the surface lacks to 2 pi at
///        \ /       the vertices, the angles at the centre add up to 2 pi. s is one more unknown, and the
///         c        function is convex still. Source: Bobenko, Pinkall and Springborn (2015).

#include "tetrarch/numeric/sparse_cholesky.hpp"
#include "tetrarch/slit/ricci.hpp"

#include <optional>
#include <vector>

namespace tetrarch::slit {

/// The angle opposite a side; pi or 0 where the triangle inequality fails.
double angle_opposite(const std::vector<double>& length, surface::Side s);

/// Of each vertex the boundary side that starts there; none inside.
std::vector<surface::Side> boundary_sides(const surface::Surface& surface);

/// 2 pi less the angles, on the boundary pi less them. O(n).
std::vector<double> curvatures_of(const surface::IntrinsicTriangulation& metric);

class VertexScaling {
public:
  /// `round_holes` as in `Curvatures`. At least one vertex is held.
  VertexScaling(surface::IntrinsicTriangulation start, std::vector<char> held,
                const std::vector<int>& round_holes = {});

  struct Outcome {
    double residual = 0;
    int steps = 0;
    bool found = false;
  };
  /// From where the last problem ended.
  Outcome solve(const std::vector<double>& curvature, const RicciOptions& options, const Progress& progress);

  /// How the numbers change with the curvatures, to first order: a column for each given one. One
  /// factorisation.
  std::vector<std::vector<double>> responses(std::vector<std::vector<double>> curvature_changes);

  const surface::IntrinsicTriangulation& metric() const { return metric_; }
  const std::vector<double>& log_scale() const { return u_; }
  /// Back to these numbers, or on to others.
  void move_to(const std::vector<double>& log_scale);
  /// The lengths that these numbers would give this triangulation.
  std::vector<double> lengths(const std::vector<double>& log_scale) const;

private:
  void make_delaunay();
  bool should_flip(surface::Side s) const;
  void flip(surface::Side s);
  bool is_metric() const; ///< whether no triangle has broken down
  std::vector<double> defects(const std::vector<double>& curvature) const;
  numeric::SymmetricMatrix hessian(double shift) const;
  void factor();
  std::vector<double> solved(std::vector<double> right) const;

  surface::IntrinsicTriangulation metric_;
  std::vector<double> unscaled_;                    ///< lengths of the sides for u = 0
  std::vector<char> held_;                          ///< of each unknown
  std::vector<std::vector<int>> round_;             ///< the vertices of the round holes, in order
  std::vector<double> u_;                           ///< of the vertices, then s of the round holes
  std::optional<numeric::SparseCholesky> cholesky_; ///< for the pattern after so many flips:
  long long analysed_at_ = -1;
};

} // namespace tetrarch::slit
