// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The proof that cells are the canonical ones.
///
/// Given balls that hold the edge lengths of the structure, every tilt is a ball. A face whose tilt is
/// certainly positive is convex, and faces that are convex everywhere are those of the canonical
/// decomposition. A face that is only drawn, inside a cell, has tilt 0, which no ball can tell: its cell is
/// proved flat, that is, its vertex vectors lie in one affine hyperplane, or 1 = (1, ..., 1) is in the column
/// space of their Gram matrix G.
///
/// Symmetry proves that. Let sigma permute the cells and their corners so that walls go to walls, partners
/// of walls to partners, and classes of edges to classes. Carry the subdivision of the cells back by sigma:
/// it is another triangulation of the same manifold, and sigma carries the structure to one on it, since
/// angles around classes add up as before. The structure is unique (Mostow, Prasad), so both are the same,
/// and G is invariant under the group H of all sigma that keep the cell.
///
///   R  The matrix (sum of G_ij over i in orbit a, j in orbit b) is regular: then G x = 1 has a solution that
///      is constant on orbits.
///   F  All vectors that H fixes are multiples of one (the mean trace of H on R^{3,1} is 1), and for some j
///      the means of G_ij over the orbits are equal since the lengths are the same ones: then the orbits'
///      barycentres are equal, and the kernel of G is orthogonal to 1.
///
///   B  Where lengths of different classes look equal, they may be so without a symmetry that says it. Make
///      them equal: a block of such classes gets one length and one equation, the sum of their curvatures.
///      If that system has one zero near by, symmetries that keep blocks keep the zero, and dihedral angles
///      are equal along the orbits of edges. If all classes of a block have equally many edges in each orbit,
///      their curvatures are equal, and so they vanish: the zero is the structure. Then R or F, with the
///      larger group.
///
///   L  G is a matrix of symbols: a class of edges, or an orbit of diagonals, is one. If u is an eigenvector
///      whatever the symbols are (v_A + v_B - v_C - v_D, say), its eigenvalue may be 0; and if G has rank 4
///      on the complement of u, it is 0, for 4 is the rank of G. That is a linear relation of the symbols. If
///      there are enough such u, they are the kernel. Or some rational w makes all entries of G w equal, up
///      to such relations, and not 0: then 1 is G w over that number.
///
///   E  The inner products are algebraic numbers. Guess a field and the numbers in it, and prove the guess:
///      tetrahedra with these products exist, across each face the far vertex has the right norm and lies on
///      the other side, laid out around an edge they come back exactly, with an angle near 2 pi, and all
///      cusps have one area. That is a hyperbolic structure, hence the structure. Then a face is flat if the
///      far vertex is a_0 v_0 + ... + a_3 v_3 with the sum of a exactly 1.
///
/// More digits never prove flatness. Source: ours; Kojima 1990 for the cells.

#include "tetrarch/canonical/cells.hpp"
#include "tetrarch/canonical/cells_proof.hpp"
#include "tetrarch/hyperbolic/metric.hpp"
#include "tetrarch/numeric/ball.hpp"

#include <functional>
#include <optional>

namespace tetrarch::canonical {

/// Solves for lengths that are equal in each block, with certainty, as `verified::solve_merged` does.
using MergedSolver = std::function<std::optional<hyperbolic::Metric<numeric::Ball>>(
    const Table<EdgeId, int>& block, double reach)>;

/// The structure's lengths in balls of so many bits.
using PreciseSolver = std::function<std::optional<hyperbolic::Metric<numeric::Ball>>(int bits)>;

/// What B and E need; without it they are not tried.
struct Solvers {
  MergedSolver merged;
  PreciseSolver precise;
  std::function<void()> still_wanted; ///< called now and then; may throw to end the search
};

/// `lengths` hold those of the structure; faces marked `flat` are inside cells. O(n) where no face is flat;
/// else the search for symmetries may take longer, within a budget, and E some tenths of a second.
[[nodiscard]] CellsProof certify_cells(const Triangulation& tri, const Skeleton& skeleton,
                                       const hyperbolic::Metric<numeric::Ball>& lengths,
                                       const FlatFaces& flat, const Solvers& solvers = {});

} // namespace tetrarch::canonical
