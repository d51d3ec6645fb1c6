// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hyperbolic structures with marked edges: orbifolds, cone manifolds, parabolic meridians; and those with
/// finite vertices, closed manifolds among them.
///
/// An edge of order n > 1 has the angle 2 pi / n around it. A null edge (order 0) lies at infinity: the
/// planes that truncate its two ends touch, its length is 0, the angles at it are 0, and it has no equation.
/// A vertex is what its link is with the marks as cone points: with
///
///   chi(v) = chi(link of v) - sum over the marked ends of edges at v of (1 - 1/n), a null end counting 1,
///
/// it is hyperideal, ideal or finite as chi(v) < 0, = 0, > 0. So three null edges that meet make a totally
/// geodesic sphere with three cusps, and the orders 2, 3, 6 a cusp that is a Euclidean orbifold.
///
/// Newton's method solves the equations from all lengths 1 where every tetrahedron keeps its orientation.
/// Where some turn over, a homotopy does: its unknowns are all inner products of vertex vectors and for each
/// tetrahedron a signed square root t of -det W, so that nothing happens as a tetrahedron passes through flat
/// ones; it starts from smaller cone angles, where everything is hyperideal. The volume is then the sum of
/// signed volumes: of the true structure where there is one that these tetrahedra cover with degree 1, which
/// is not proved. Sources: Heard, "Orb" and its documentation, 2007; Casson's and Manning's ways to closed
/// manifolds.

#include "tetrarch/core/marks.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::hyperbolic {

/// chi(v) of the link with its marks. O(edge ends at v).
Table<VertexId, double> orbifold_euler(const Skeleton& skeleton, const EdgeOrders& orders);

enum class OrbifoldOutcome {
  geometric,   ///< a structure, every tetrahedron positively oriented
  turned_over, ///< the equations hold, but some tetrahedra are flat or negatively oriented
  bad_vertex, ///< the marks at a vertex make a link that no cone manifold has: one cone point on a sphere, or
              ///< two of different angles
  null_edge,  ///< a null edge joins two cusps; it has to be contracted or drilled first
  low_valence,    ///< angles below pi around an edge cannot add up to its cone angle
  not_found,      ///< neither method arrived
  boundary_faces, ///< the triangulation is not closed
  invalid,        ///< empty, or an edge is identified with itself reversed
};
inline constexpr int orbifold_outcome_count = 8;
/// The name as spelt above; stable, for JSON.
const char* to_string(OrbifoldOutcome outcome);

enum class OrbifoldMethod { newton, homotopy };
/// "newton", "homotopy".
const char* to_string(OrbifoldMethod method);

struct OrbifoldOptions {
  /// max |K_e| of an accepted solution.
  double tolerance = 1e-10;
  double step_tolerance = 1e-6;
  /// Largest |length| of an accepted solution, horospheres apart.
  double length_limit = 12;
  /// The two ways, in this order.
  bool use_newton = true;
  bool use_homotopy = true;
  /// Steps of Newton's method along the homotopy, in all.
  int most_steps = 600;
};

struct OrbifoldStructure {
  OrbifoldOutcome outcome = OrbifoldOutcome::invalid;
  OrbifoldMethod method = OrbifoldMethod::newton;
  EdgeOrders orders;
  Table<VertexId, VertexType> types;
  /// Signed lengths; 0 for null edges; where a tetrahedron is flat, as read from inner products.
  Metric<double> lengths;
  /// Of a tetrahedron that is turned over, negative, or above pi, as they are counted in K.
  AngleTable<double> dihedral_angles;
  /// 1, 0 (flat) or -1 for each tetrahedron.
  std::vector<int> orientation;
  double volume = 0;       ///< the sum of signed volumes
  double volume_error = 0; ///< a bound of its distance to that of the exact solution close by
  double residual = 0;     ///< max |K_e|
  double last_step = 0;    ///< largest component of Newton's step at the solution
  int iterations = 0;
  EdgeId edge;     ///< the culprit, where an edge is one
  VertexId vertex; ///< or a vertex

  bool solved() const {
    return outcome == OrbifoldOutcome::geometric || outcome == OrbifoldOutcome::turned_over;
  }
  int flat() const;     ///< number of flat tetrahedra
  int negative() const; ///< number of those turned over
};

/// What can be said without computing: outcome and culprit, or nothing.
std::optional<OrbifoldStructure> why_no_orbifold(const Skeleton& skeleton, const EdgeOrders& orders);

/// Throws PreconditionError if the skeleton is stale, or `orders` has not one order per edge class. Newton:
/// O(E^3) a step. The homotopy: O((E + n)^3) a step, some dozens of steps: a millisecond for two tetrahedra,
/// a second for fifty. A stop is thrown as `Stopped`. Deterministic.
[[nodiscard]] OrbifoldStructure solve_orbifold(const Triangulation& tri, const Skeleton& skeleton,
                                               const EdgeOrders& orders, const OrbifoldOptions& options = {},
                                               const Progress& progress = {});

/// A sentence that says what came of it and where.
std::string describe(const OrbifoldStructure& result, const Skeleton& skeleton);

} // namespace tetrarch::hyperbolic
