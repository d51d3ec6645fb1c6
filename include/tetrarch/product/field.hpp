// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The harmonic field of a product: 0 on the floor, the height on the ceiling, no flow through the walls.
///
///     height  =========      Linear on each tetrahedron, of least Dirichlet energy. The weight of an edge ij
///              | | | |       is 1/6 sum of l_kl cot(theta_kl) over its tetrahedra, kl the edge opposite and
///              | | | |       theta_kl the dihedral angle there. (The dissertation has the length of ij.)
///     0       =========
///
/// Obtuse dihedral angles make weights negative, and then the field may have extrema inside; weights clamped
/// at 0 exclude that, but the field converges to another one than the harmonic. Source: Yin, sections 3.3.3
/// and 3.4.3.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/partition.hpp"

#include <cstdint>
#include <vector>

namespace tetrarch::product {

struct FieldOptions {
  double height = 1;
  bool clamped = false; ///< negative weights become 0
  enum class Solver : std::uint8_t { automatic, direct, iterative } solver = Solver::automatic;
  double tolerance = 1e-12; ///< of the residual of conjugate gradients, in terms of the right-hand side
};

/// The harmonic function w, and how well it solves its equations.
struct HarmonicField {
  std::vector<double> w;    ///< of each vertex
  double residual = 0;      ///< the greatest flow that is left at a free vertex, in terms of the whole flow
  double flow = 0;          ///< from ceiling to floor: the energy divided by the height
  int iterations = 0;       ///< of conjugate gradients; 0 for the direct solver
  int negative_weights = 0; ///< edges with a negative weight, clamped or not
};

/// Throws InputError if the matrix is not positive definite, where a factorization is asked for. Conjugate
/// gradients with an incomplete Cholesky factor from 20,000 free vertices on, in practice some O(n^1.33);
/// below that, one sparse factorization.
HarmonicField harmonic_field(const Solid& solid, const Partition& partition, const FieldOptions& options = {},
                             const Progress& progress = {});

} // namespace tetrarch::product
