// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include "solvers.hpp"
#include "structure_volume.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

/// A curvature below this is fading where lengths run off (there it behaves like exp(-l) or faster, and the
/// limit is 12); one above it stays.
constexpr double fading_curvature = 1e-3;
/// A Newton step beyond this, where the curvature has faded, points to a solution far away: at infinity.
constexpr double long_step = 0.5;
/// A flat tetrahedron has some angles pi, and rounding leaves them within sqrt(1e-16) or so; angles closer to
/// pi than this are taken for that.
constexpr double flat_angle = 1e-6;

constexpr std::array<const char*, 11> outcome_names{
    "geometric",       "edge_runs_off",  "unbounded", "degenerate",       "low_valence", "projective_plane",
    "finite_vertices", "boundary_faces", "invalid",   "budget_exhausted", "stopped"};

/// The first tetrahedron that does not exist, or only by rounding; -1 if there is none.
template <class Scalar>
int first_degenerate(const State<Scalar>& state) {
  if (state.first_missing >= 0) return state.first_missing;
  for (std::size_t t = 0; t < state.angles.size(); ++t)
    for (const Scalar& theta : state.angles[t])
      if (theta > numeric::pi<Scalar>() - flat_angle) return static_cast<int>(t);
  return -1;
}

template <class Scalar>
Outcome judge(const Run<Scalar>& run, const Goals<Scalar>& goals) {
  if (run.stopped) return Outcome::stopped;
  const Scalar residual = run.state.residual();
  const bool fading = residual < fading_curvature;
  if (run.state.longest() > goals.length_limit) return fading ? Outcome::edge_runs_off : Outcome::unbounded;
  if (residual <= goals.tolerance && run.last_step <= goals.step_tolerance)
    return first_degenerate(run.state) < 0 ? Outcome::geometric : Outcome::degenerate;
  return fading && run.last_step > long_step ? Outcome::edge_runs_off : Outcome::budget_exhausted;
}

template <class Scalar>
Hyperbolization<Scalar> conclude(const Problem& problem, Run<Scalar> run, const Goals<Scalar>& goals) {
  Hyperbolization<Scalar> result;
  result.outcome = judge(run, goals);
  if (result.outcome == Outcome::geometric) {
    const Estimate<Scalar> volume = structure_volume(problem, run.state, run.last_step);
    result.volume = volume.value;
    result.volume_error = volume.error;
  }
  result.residual = run.state.residual();
  result.last_step = run.last_step;
  result.iterations = run.iterations;
  result.edge = EdgeId(run.state.longest_edge());
  result.tet = first_degenerate(run.state);
  result.lengths = Metric<Scalar>(std::move(run.state.lengths));
  result.dihedral_angles = std::move(run.state.angles);
  result.history = std::move(run.history);
  return result;
}

Goals<double> goals_of(const HyperbolizeOptions& options) {
  const int usual = options.method == Method::newton ? 100 : 20'000;
  return {options.tolerance, options.step_tolerance, options.length_limit,
          options.max_iterations > 0 ? options.max_iterations : usual};
}

Hyperbolization<double> obstructed(const Obstacle& obstacle) {
  Hyperbolization<double> result;
  result.outcome = obstacle.outcome;
  result.edge = obstacle.edge;
  result.vertex = obstacle.vertex;
  return result;
}

/// Every vertex is a point: then there are none to remove.
bool is_closed_manifold(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (!skeleton.link(v).is_sphere()) return false;
  return true;
}

} // namespace

const char* to_string(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)];
}

bool undecided(Outcome outcome) {
  return outcome == Outcome::budget_exhausted || outcome == Outcome::stopped ||
         outcome == Outcome::finite_vertices || outcome == Outcome::boundary_faces;
}

std::optional<Obstacle> why_not_hyperbolize(const Skeleton& skeleton) {
  if (skeleton.tetrahedron_count() == 0) return Obstacle{Outcome::invalid, EdgeId(), VertexId()};
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (skeleton.is_reversed(e)) return Obstacle{Outcome::invalid, e, VertexId()};
  if (skeleton.has_boundary_faces()) return Obstacle{Outcome::boundary_faces, EdgeId(), VertexId()};
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).euler == 1) return Obstacle{Outcome::projective_plane, EdgeId(), v};
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).is_sphere()) return Obstacle{Outcome::finite_vertices, EdgeId(), v};
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (skeleton.valence(e) < 3) return Obstacle{Outcome::low_valence, e, VertexId()};
  return std::nullopt;
}

Hyperbolization<double> hyperbolize(const Triangulation& tri, const Skeleton& skeleton,
                                    const HyperbolizeOptions& options, const Progress& progress) {
  skeleton.require_current(tri);
  return hyperbolize_from(Metric<double>(skeleton.edge_count(), 1.0), skeleton, options, progress);
}

Hyperbolization<double> hyperbolize_from(const Metric<double>& start, const Skeleton& skeleton,
                                         const HyperbolizeOptions& options, const Progress& progress) {
  if (start.size() != skeleton.edge_count())
    throw PreconditionError("hyperbolize_from: a metric needs one length per edge class");
  for (const double length : start)
    if (!std::isfinite(length)) throw PreconditionError("hyperbolize_from: a length is not finite");
  if (const std::optional<Obstacle> obstacle = why_not_hyperbolize(skeleton)) return obstructed(*obstacle);
  const Problem problem(skeleton);
  const Goals<double> goals = goals_of(options);
  if (options.method == Method::newton)
    return conclude(problem, newton(problem, start.values(), goals, progress), goals);
  return conclude(problem, flow(problem, start.values(), goals, options.keep_history, progress), goals);
}

template <class Scalar>
Hyperbolization<Scalar> refine(const Skeleton& skeleton, const Hyperbolization<double>& found,
                               const Progress& progress) {
  if (found.outcome != Outcome::geometric || found.lengths.size() != skeleton.edge_count())
    throw PreconditionError("refine: needs a geometric structure of this triangulation");
  using std::pow;
  // A quarter of the digits is left to rounding: 1e-45 of 60.
  const Scalar small = pow(std::numeric_limits<Scalar>::epsilon(), Scalar(0.75));
  const Goals<Scalar> goals{small, small, 2 * HyperbolizeOptions{}.length_limit, 20};
  const std::vector<Scalar> start(found.lengths.begin(), found.lengths.end());
  const Problem problem(skeleton);
  return conclude(problem, newton(problem, start, goals, progress), goals);
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Hyperbolization<Scalar> refine(const Skeleton&, const Hyperbolization<double>&, const Progress&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

std::string describe(const Hyperbolization<double>& result, const Skeleton& skeleton) {
  const std::string edge = "edge " + std::to_string(result.edge.value);
  const std::string vertex = "vertex " + std::to_string(result.vertex.value);
  switch (result.outcome) {
  case Outcome::geometric:
    return "a hyperbolic structure was found";
  case Outcome::edge_runs_off:
    return "no structure on this triangulation: the length of " + edge +
           " runs to infinity while the curvature fades";
  case Outcome::unbounded:
    return "no structure on this triangulation: the length of " + edge + " grows without bound";
  case Outcome::degenerate:
    return "no structure on this triangulation: the curvature vanishes only where tetrahedron " +
           std::to_string(result.tet) + " degenerates";
  case Outcome::low_valence:
    return "no structure on this triangulation: " + edge + " has valence " +
           std::to_string(skeleton.valence(result.edge)) + ", and its angles cannot add up to 2 pi";
  case Outcome::projective_plane:
    return "not hyperbolic: the link of " + vertex + " is a projective plane";
  case Outcome::finite_vertices:
    return is_closed_manifold(skeleton)
               ? "undecided: the manifold is closed, and has no vertex to remove (solve_orbifold serves it)"
               : "undecided: the link of " + vertex + " is a sphere; remove such vertices first";
  case Outcome::boundary_faces:
    return "undecided: " + std::to_string(skeleton.boundary_face_count()) +
           " faces are not glued; close or truncate the boundary first";
  case Outcome::invalid:
    return result.edge.value < 0 ? "there is no tetrahedron" : edge + " is identified with itself reversed";
  case Outcome::budget_exhausted:
    return "undecided: no structure was found in " + std::to_string(result.iterations) + " steps";
  case Outcome::stopped:
    return "stopped after " + std::to_string(result.iterations) + " steps";
  }
  return {};
}

} // namespace tetrarch::hyperbolic
