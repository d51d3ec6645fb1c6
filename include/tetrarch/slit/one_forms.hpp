// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The harmonic one-forms of a sphere with holes, kept so that every choice of an outer and an inner loop is
/// cheap.
///
///      .-----------.      potential(k): harmonic, 1 on loop k, 0 on the others; eta(k) is its differential.
///     /  .-.   .-.  \     tau(k): closed and harmonic, tangent to the boundary, with period 1 around loop k
///    |   |1|   |2|   |    and -1 around loop 0: a jump of 1 across a strip of triangles from loop 0 to loop
///    k,
///     \  '-'   '-' 0/     smoothed by the differential of a function, lag(k). tau(0) is 0.
///      '-----------'
///
/// Loops are those of `mesh::boundary_loops`; along each the surface lies to the left, so periods around all
/// of them add up to 0. Source: Yin, section 2.3.1. The jump is made across triangles and not along a path of
/// edges, which comes to the same and leaves integers that vanish modulo full turns.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/mesh/boundary_loops.hpp"
#include "tetrarch/slit/one_form.hpp"

#include <vector>

namespace tetrarch::slit {

class OneForms {
public:
  /// Throws InputError unless the mesh is an oriented sphere with at least two holes, or where triangles are
  /// too thin (`mesh::half_cotangents`). For n + 1 loops: two sparse factorisations (the potentials are held
  /// on all loops, the lags at one vertex) and n right-hand sides for either.
  explicit OneForms(mesh::TriangleMesh mesh, const Progress& progress = {});

  const mesh::TriangleMesh& mesh() const { return mesh_; }
  const std::vector<mesh::BoundaryLoop>& loops() const { return loops_; }
  int loop_count() const { return static_cast<int>(loops_.size()); }
  /// Of each side, half the cotangent of the angle opposite.
  const std::vector<double>& weight() const { return weight_; }

  /// Of each vertex. All together add up to 1.
  const std::vector<double>& potential(int loop) const { return potential_[static_cast<std::size_t>(loop)]; }
  const std::vector<double>& lag(int loop) const { return lag_[static_cast<std::size_t>(loop)]; }
  OneForm eta(int loop) const { return differential(mesh_.surface, potential(loop)); }
  OneForm tau(int loop) const;

  /// The flux of potential k out of the surface through loop j: the period of *eta(k) around it. Symmetric,
  /// rows add up to 0. It is an energy too, <eta(j), eta(k)>, so it converges at order h^2.
  double flux(int j, int k) const { return flux_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]; }

private:
  void find_strips();
  void solve_potentials();
  void solve_lags();

  mesh::TriangleMesh mesh_;
  std::vector<mesh::BoundaryLoop> loops_;
  std::vector<double> weight_;
  /// Of each loop but 0, the sides by which the strip from loop 0 leaves its triangles, the last one first.
  std::vector<std::vector<mesh::Side>> strip_;
  std::vector<std::vector<double>> potential_;
  std::vector<std::vector<double>> lag_;
  std::vector<std::vector<double>> flux_;
};

} // namespace tetrarch::slit
