// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The harmonic one-forms of a sphere with holes. They are kept, which makes every choice of an outer and an
/// inner loop cheap.
///
///      .-----------.      potential(k): harmonic, 1 on loop k, 0 on the others; eta(k) is its differential.
///     /  .-.   .-.  \     tau(k): closed and harmonic, tangent to the boundary, with period 1 around loop k
///    |   |1|   |2|   |    and -1 around loop 0: a jump of 1 across a strip of triangles from loop 0 to
///     \  '-'   '-' 0/     loop k, smoothed by the differential of a function, lag(k). tau(0) is 0.
///      '-----------'
///
/// Loops are those of `surface::boundary_loops`; along each the surface lies to the left, so periods around
/// all of them add up to 0. Source: Yin, section 2.3.1. The jump is made across triangles and not along a
/// path of edges, which comes to the same and leaves integers that vanish modulo full turns.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/slit/one_form.hpp"
#include "tetrarch/surface/boundary_loops.hpp"
#include "tetrarch/surface/intrinsic_delaunay.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetrarch::slit {

/// The triangles on which functions are linear: those of the mesh, or those of its intrinsic Delaunay
/// triangulation, whose angles are not too obtuse. Both have the same vertices and the same surface.
enum class Edges : std::uint8_t { own, intrinsic_delaunay };

class OneForms {
public:
  /// Throws InputError unless the mesh is an oriented sphere with at least two holes, where triangles are too
  /// thin (`surface::half_cotangents`), or if the functions would take more than 16 GB. For n + 1 loops: two
  /// sparse factorizations with one analysis (the lags are held at one vertex, the potentials on all loops)
  /// and n right-hand sides for either. One factorization with the loops eliminated last would serve both,
  /// but counting operations it is dearer.
  explicit OneForms(surface::TriangleMesh mesh, const Progress& progress = {}, Edges edges = Edges::own);

  const surface::TriangleMesh& mesh() const { return mesh_; }
  const std::vector<surface::BoundaryLoop>& loops() const { return loops_; }
  int loop_count() const { return static_cast<int>(loops_.size()); }
  /// The triangles on which the functions are linear, and of each of its sides half the cotangent of the
  /// angle opposite. Everything else with a value for each side, such as a one-form, belongs to the sides of
  /// the mesh.
  const surface::Surface& solved_on() const { return intrinsic_ ? intrinsic_->surface : mesh_.surface; }
  const std::vector<double>& weight() const { return weight_; }

  /// Of each vertex. All together add up to 1.
  const std::vector<double>& potential(int loop) const { return potential_[static_cast<std::size_t>(loop)]; }
  const std::vector<double>& lag(int loop) const { return lag_[static_cast<std::size_t>(loop)]; }
  OneForm eta(int loop) const { return differential(mesh_.surface, potential(loop)); }
  OneForm tau(int loop) const;

  /// The flux of potential k out of the surface through loop j: the period of *eta(k) around it. Symmetric,
  /// rows add up to 0. It is an energy too, <eta(j), eta(k)>, so it converges at order h^2.
  double flux(int j, int k) const { return flux_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]; }
  /// <tau(j), tau(k)>.
  double tau_product(int j, int k) const {
    return tau_product_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
  }

  /// The integral of *eta(loop) along its own loop, at the starts of its sides and once round: how much of
  /// potential(loop) flows out up to there. O(length of the loop * loops).
  std::vector<double> conjugate_along(int loop) const;

  /// The harmonic functions with given values at the vertices of the loops; `values[k][v]` is not read where
  /// v is on no loop. The factor for that is kept, so it costs what solving costs, about O(n log n) each.
  surface::LaplaceSolver::Columns extended(const surface::LaplaceSolver::Columns& values) const;
  /// The same for one complex function.
  std::vector<std::complex<double>> extended(const std::vector<std::complex<double>>& values) const;

private:
  /// Where the strips start.
  surface::Side start() const { return loops_[0].sides.front().side; }

  surface::TriangleMesh mesh_;
  std::vector<surface::BoundaryLoop> loops_;
  std::vector<double> weight_;
  std::optional<surface::IntrinsicTriangulation> intrinsic_;
  std::optional<surface::LaplaceSolver> solver_; ///< the loops are held
  /// Of each loop but 0, the sides by which the strip from loop 0 leaves its triangles, the last one first.
  std::vector<std::vector<surface::Side>> strip_;
  std::vector<std::vector<double>> potential_;
  std::vector<std::vector<double>> lag_;
  std::vector<std::vector<double>> flux_;
  std::vector<std::vector<double>> tau_product_;
};

} // namespace tetrarch::slit
