// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The cotangent Laplacian of a solid: how much of a function flows along each edge.
///
///            l             Linear on each tetrahedron, f has the Dirichlet energy sum k_ij (f(i) - f(j))^2
///           /|\            over all edges, halved. The weight k_ij is 1/6 sum of l_kl cot(theta_kl) over the
///          / | \           tetrahedra at ij, kl the edge opposite to it and theta_kl the dihedral angle at
///         i--|--j          kl: where the faces that meet there enclose more than a right angle, the part is
///          \ | /           negative. (The dissertation takes the length of ij, which is wrong.)
///           \|/
///            k
///
/// (L f)(i) = sum of k_ij (f(i) - f(j)) is what flows out of vertex i: 0 where f is harmonic.

#include "tetrarch/solid/tet_mesh.hpp"

#include <vector>

namespace tetrarch::solid {

struct WeightedEdge {
  int from = 0; ///< the lesser vertex
  int to = 0;
  double weight = 0;
};

/// All edges in increasing order of (from, to). Tetrahedra must be positively handed; one without volume
/// makes weights that are not finite. O(n), and the sorting of the edges at each vertex.
std::vector<WeightedEdge> edge_weights(const TetMesh& mesh);

/// L f. O(edges).
std::vector<double> fluxes(const std::vector<WeightedEdge>& edges, const std::vector<double>& f);

} // namespace tetrarch::solid
