// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The hyperbolic structure of a gluing: edge lengths for which the dihedral angles close up around every
/// edge.
///
/// F(l) = sum over tetrahedra of the integral of theta dl, minus 2 pi times the sum of the lengths, is convex
/// (no finite vertices allowed), its gradient is -K and its Hessian the sum of the matrices d theta / d l. A
/// structure is a minimum at which every tetrahedron exists, and there is at most one (Mostow rigidity; up to
/// the choice of horospheres). Luo's flow walks down its gradient, Newton jumps.
///
/// False convergence: on more than half of the small gluings without a structure, one length runs to infinity
/// while K fades like exp(-l), so that a small K alone proves nothing. A result is called geometric only if K
/// is below `tolerance`, the Newton step from there (an estimate of the distance to the true solution) is
/// below `step_tolerance`, all lengths are within `length_limit`, and every tetrahedron exists.
/// Sources: Yin, section 4.3.3; Luo, "A combinatorial curvature flow for compact 3-manifolds with boundary",
/// 2005; Luo-Yang 2018 (convexity of the extension).

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/flow_history.hpp"
#include "tetrarch/hyperbolic/metric.hpp"

#include <string>

namespace tetrarch::hyperbolic {

/// What came of it. The first is a yes; `undecided` tells which of the others are proved noes.
enum class Outcome {
  geometric,        ///< a structure was found
  edge_runs_off,    ///< a length runs to infinity while the curvature fades: false convergence
  unbounded,        ///< a length passed the limit and the curvature has not faded
  degenerate,       ///< F has its minimum where some tetrahedron does not exist, or is flat
  low_valence,      ///< an edge of valence 1 or 2: its angles can never add up to 2 pi
  projective_plane, ///< a vertex link is a projective plane: no hyperbolic manifold has one
  finite_vertices,  ///< a vertex link is a sphere: F is not convex; remove such vertices first
                    ///< (a closed manifold has no others: see orbifold.hpp)
  boundary_faces,   ///< the triangulation is not closed
  invalid,          ///< empty, or an edge is identified with itself reversed
  budget_exhausted, ///< `max_iterations` were not enough
  stopped,          ///< on request; lengths and history are those reached
};
inline constexpr int outcome_count = 11;
/// The name as spelt above; stable, for JSON.
const char* to_string(Outcome outcome);
/// Neither a structure nor a proof (rounding aside) that this triangulation has none. Note that a no is about
/// the triangulation: the manifold may have a structure on another one.
bool undecided(Outcome outcome);

enum class Method { newton, flow };

struct HyperbolizeOptions {
  Method method = Method::newton;
  /// max |K_e| of an accepted structure. Newton leaves 1e-13 behind on a true structure; false convergence
  /// stays above exp(-length_limit) or is caught by `step_tolerance`.
  double tolerance = 1e-10;
  /// Largest component of the Newton step at an accepted structure. It is of the size of K on a true one (the
  /// Hessian's eigenvalues are of order 1), and of order 1 where a length runs off.
  double step_tolerance = 1e-6;
  /// Largest |length| of an accepted structure. Those of up to four tetrahedra stay below 4.4.
  double length_limit = 12;
  /// 0: 100 Newton steps (4 to 9 are usual) or 20,000 steps of the flow (20 to 600 are usual).
  int max_iterations = 0;
  /// Keep one entry per step of the flow.
  bool keep_history = true;
};

/// The metric that was found, or how far the search came.
template <class Scalar>
struct Hyperbolization {
  Outcome outcome = Outcome::invalid;
  Metric<Scalar> lengths;             ///< as far as they were reached, also without success
  AngleTable<Scalar> dihedral_angles; ///< at these lengths
  Scalar volume = Scalar(0);          ///< 0 unless geometric
  /// The structure's volume is within this of `volume`, whatever was rounded. That there is a structure
  /// within two Newton steps of the lengths is taken for granted here; `tolerance` and `step_tolerance` are
  /// what speaks for it.
  Scalar volume_error = Scalar(0);
  Scalar residual = Scalar(0);  ///< max |K_e|
  Scalar last_step = Scalar(0); ///< largest component of the Newton step at these lengths
  int iterations = 0;
  EdgeId edge;         ///< the edge that is the reason: of low valence, reversed, or the longest
  VertexId vertex;     ///< the vertex that is the reason: finite, or with a projective plane for a link
  int tet = -1;        ///< the first tetrahedron that does not exist or is flat, if there is one
  FlowHistory history; ///< of the flow, if kept
};

/// What can be said without computing: an outcome from low_valence to invalid with its culprit, or nothing.
struct Obstacle {
  Outcome outcome;
  EdgeId edge;
  VertexId vertex;
};
std::optional<Obstacle> why_not_hyperbolize(const Skeleton& skeleton);

/// From all lengths 1. Throws PreconditionError if the skeleton is stale. Newton: per step O(n) plus a
/// factorisation (dense up to 100 edge classes, sparse above); about 10 microseconds in all for three
/// tetrahedra.
[[nodiscard]] Hyperbolization<double> hyperbolize(const Triangulation& tri, const Skeleton& skeleton,
                                                  const HyperbolizeOptions& options = {},
                                                  const Progress& progress = {});

/// The same from given lengths (one per edge class), for instance after a Pachner move. Throws
/// PreconditionError if their number is wrong or one is not finite.
[[nodiscard]] Hyperbolization<double> hyperbolize_from(const Metric<double>& start, const Skeleton& skeleton,
                                                       const HyperbolizeOptions& options = {},
                                                       const Progress& progress = {});

/// A geometric solution carried to the precision of Scalar by a few more Newton steps; the residual is then
/// below 1e-45 for Real50 (include real50.hpp). The Newton systems are solved densely in Scalar: O(E^3).
/// Throws PreconditionError unless `found` is geometric and fits the skeleton.
template <class Scalar>
[[nodiscard]] Hyperbolization<Scalar> refine(const Skeleton& skeleton, const Hyperbolization<double>& found,
                                             const Progress& progress = {});

/// A sentence that says what came of it and where.
std::string describe(const Hyperbolization<double>& result, const Skeleton& skeleton);

} // namespace tetrarch::hyperbolic
