// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/orbifold.hpp"

#include "angle_data.hpp"
#include "least_norm.hpp"
#include "signed_path.hpp"
#include "structure_volume.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetrarch::hyperbolic {
namespace {

constexpr std::array<const char*, orbifold_outcome_count> orbifold_outcome_names{
    "geometric",   "turned_over", "bad_vertex",     "null_edge",
    "low_valence", "not_found",   "boundary_faces", "invalid"};

/// Sums of fractions 1 - 1/n that differ by less are equal.
constexpr double same_euler = 1e-9;
/// A tetrahedron whose t, at vectors of length 1, is below this is flat.
constexpr double flat_root = 1e-6;
/// The divisors of cone angles at which the homotopy starts: of the marked edges alone, then of all.
constexpr double first_divisor = 1.5;

VertexType type_of(double euler) {
  if (euler > same_euler) return VertexType::finite;
  return euler < -same_euler ? VertexType::hyperideal : VertexType::ideal;
}

/// The orders of the marked ends at each vertex.
Table<VertexId, std::vector<double>> cone_points(const Skeleton& skeleton, const EdgeOrders& orders) {
  Table<VertexId, std::vector<double>> at(skeleton.vertex_count());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (orders[e] == 1) continue;
    const auto [a, b] = skeleton.ends(e);
    at[a].push_back(orders[e]);
    at[b].push_back(orders[e]);
  }
  return at;
}

/// A sphere with one cone point, or with two of different angles.
bool is_bad(const SurfaceType& link, const std::vector<double>& points) {
  return link.is_sphere() && (points.size() == 1 || (points.size() == 2 && points[0] != points[1]));
}

OrbifoldStructure orbifold_obstructed(OrbifoldOutcome outcome, EdgeId edge, VertexId vertex = VertexId()) {
  OrbifoldStructure result;
  result.outcome = outcome;
  result.edge = edge;
  result.vertex = vertex;
  return result;
}

Table<VertexId, VertexType> types_of(const Table<VertexId, double>& euler) {
  Table<VertexId, VertexType> types(euler.size());
  for (const VertexId v : all<VertexId>(euler.size())) types[v] = type_of(euler[v]);
  return types;
}

bool has_finite(const Table<VertexId, VertexType>& types) {
  return std::find(types.begin(), types.end(), VertexType::finite) != types.end();
}

class OrbifoldSolver {
public:
  OrbifoldSolver(const Skeleton& skeleton, const EdgeOrders& orders, const OrbifoldOptions& options,
                 const Progress& progress)
      : skeleton_(skeleton), options_(options), progress_(progress),
        types_(types_of(orbifold_euler(skeleton, orders))),
        problem_(skeleton, types_, orders), goals_{options.tolerance, options.step_tolerance,
                                                   options.length_limit, 100} {
    result_.orders = orders;
    result_.types = types_;
    result_.outcome = OrbifoldOutcome::not_found;
  }

  OrbifoldStructure run() {
    std::vector<double> start(static_cast<std::size_t>(problem_.edges()), 1.0);
    for (int e = 0; e < problem_.edges(); ++e)
      if (problem_.is_null(e)) start[e] = 0;
    if (options_.use_newton && accept(solved_from(start))) return std::move(result_);
    if (!options_.use_homotopy) return std::move(result_);
    result_.method = OrbifoldMethod::homotopy;
    const SignedSystem system(problem_, types_.size());
    for (const bool all_edges : {false, true})
      if (try_path(system, all_edges)) return std::move(result_);
    return std::move(result_);
  }

private:
  Run<double> solved_from(std::vector<double> start) const {
    const bool convex =
        !has_finite(types_) && std::all_of(problem_.tets.begin(), problem_.tets.end(),
                                           [](const Problem::Tet& tet) { return tet.orientation > 0; });
    if (!convex) return least_norm_newton(problem_, std::move(start), goals_, progress_.silent());
    Run<double> run = newton(problem_, std::move(start), goals_, progress_);
    if (run.stopped) throw Stopped();
    return run;
  }

  /// Takes a solution over. False where it is none.
  bool accept(const Run<double>& run) {
    result_.iterations += run.iterations;
    result_.residual = run.state.residual();
    result_.last_step = run.last_step;
    result_.edge = EdgeId(run.state.longest_edge());
    const bool solved = result_.residual <= goals_.tolerance && run.last_step <= goals_.step_tolerance &&
                        run.state.longest() <= goals_.length_limit && run.state.first_missing < 0;
    result_.lengths = Metric<double>(run.state.lengths);
    result_.dihedral_angles = run.state.angles;
    if (!solved) return false;
    const Estimate<double> volume = structure_volume(problem_, run.state, run.last_step);
    if (!std::isfinite(volume.error)) return false; // truncating planes that meet
    result_.volume = volume.value;
    result_.volume_error = volume.error;
    result_.orientation.clear();
    for (const Problem::Tet& tet : problem_.tets) result_.orientation.push_back(tet.orientation);
    result_.outcome = result_.negative() == 0 ? OrbifoldOutcome::geometric : OrbifoldOutcome::turned_over;
    return true;
  }

  bool try_path(const SignedSystem& system, bool all_edges) {
    std::vector<bool> divided(static_cast<std::size_t>(problem_.edges()), all_edges);
    if (!all_edges)
      for (int e = 0; e < problem_.edges(); ++e) divided[e] = problem_.order[e] != 1;
    const SignedPath path =
        follow_path(problem_, system, divided, first_divisor, options_.most_steps, progress_);
    result_.iterations += path.steps;
    return path.arrived && take(system, path.state);
  }

  /// Reads lengths and orientations off, and solves once more in lengths.
  bool take(const SignedSystem& system, const SignedState& state) {
    std::vector<double> scale;
    for (const VertexId v : all<VertexId>(types_.size())) {
      const double norm = system.norm(state, v.value);
      if (types_[v] != VertexType::ideal && norm * hyperbolic::norm(types_[v]) <= 0) return false;
      scale.push_back(types_[v] == VertexType::ideal ? 1 : 1 / std::sqrt(std::abs(norm)));
    }
    std::vector<double> lengths(static_cast<std::size_t>(problem_.edges()), 0.0);
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      if (problem_.is_null(e.value)) continue;
      const auto [a, b] = skeleton_.ends(e);
      const double w = system.w(state, e.value) * scale[a.value] * scale[b.value];
      const bool signed_case = hyperbolic::norm(types_[a]) * hyperbolic::norm(types_[b]) < 0;
      if (!signed_case && !(w < 0)) return false;
      lengths[e.value] = signed_length(types_[a], types_[b], w);
    }
    std::vector<double> roots;
    for (int t = 0; t < skeleton_.tetrahedron_count(); ++t) {
      Problem::Tet& tet = problem_.tets[t];
      double root = system.root(state, t);
      for (const int v : tet.vertex) root *= scale[v];
      roots.push_back(root);
      tet.orientation = root < 0 ? -1 : 1;
    }
    const bool flat =
        std::any_of(roots.begin(), roots.end(), [](double r) { return std::abs(r) < flat_root; });
    const bool good = flat ? accept_flat(state, lengths, roots) : accept(solved_from(std::move(lengths)));
    if (!good)
      for (Problem::Tet& tet : problem_.tets) tet.orientation = 1;
    return good;
  }

  /// A solution with flat tetrahedra, at which lengths are no coordinates to solve in.
  bool accept_flat(const SignedState& state, const std::vector<double>& lengths,
                   const std::vector<double>& roots) {
    double volume = 0;
    double error = 0;
    result_.orientation.clear();
    for (std::size_t t = 0; t < roots.size(); ++t) {
      const bool flat = std::abs(roots[t]) < flat_root;
      result_.orientation.push_back(flat ? 0 : problem_.tets[t].orientation);
      SixNumbers<double> six;
      if (flat) { // its volume is the integral of sum l d theta / 2 from where its angles are 0 and pi
        for (int e = 0; e < 6; ++e)
          error +=
              std::abs(lengths[problem_.tets[t].edge[e]]) * (std::abs(std::sin(state.angles[t][e])) + 1e-14);
        continue;
      }
      std::array<kernel::EdgeForm<double>, 6> form;
      const kernel::NullEdges null = problem_.null_edges(problem_.tets[t]);
      for (int e = 0; e < 6; ++e) {
        six[e] = lengths[problem_.tets[t].edge[e]];
        const auto [i, j] = edge_vertex[e];
        const VertexTypes& types = problem_.tets[t].types;
        form[e] = null[e] ? kernel::null_form<double>(types[i], types[j])
                          : kernel::edge_form(types[i], types[j], six[e]);
      }
      const auto part = volume_part(six, problem_.tets[t].types, form, null);
      if (!part) return false;
      volume += problem_.tets[t].orientation * part->value;
      error += part->error;
      for (int e = 0; e < 6; ++e) error += std::abs(six[e]) * part->data.rest_error[e];
    }
    const Eigen::Index edges = state.defects.size() - static_cast<Eigen::Index>(roots.size());
    result_.residual = edges > 0 ? state.defects.head(edges).lpNorm<Eigen::Infinity>() : 0;
    if (!(result_.residual <= goals_.tolerance)) return false;
    result_.lengths = Metric<double>(lengths);
    result_.dihedral_angles = state.angles;
    result_.volume = volume;
    result_.volume_error = error;
    result_.outcome = OrbifoldOutcome::turned_over;
    return true;
  }

  const Skeleton& skeleton_;
  const OrbifoldOptions& options_;
  const Progress& progress_;
  Table<VertexId, VertexType> types_;
  Problem problem_;
  Goals<double> goals_;
  OrbifoldStructure result_;
};

} // namespace

const char* to_string(OrbifoldOutcome outcome) {
  return orbifold_outcome_names[static_cast<std::size_t>(outcome)];
}

const char* to_string(OrbifoldMethod method) {
  return method == OrbifoldMethod::newton ? "newton" : "homotopy";
}

int OrbifoldStructure::flat() const {
  return static_cast<int>(std::count(orientation.begin(), orientation.end(), 0));
}

int OrbifoldStructure::negative() const {
  return static_cast<int>(std::count(orientation.begin(), orientation.end(), -1));
}

Table<VertexId, double> orbifold_euler(const Skeleton& skeleton, const EdgeOrders& orders) {
  const auto points = cone_points(skeleton, orders);
  Table<VertexId, double> euler(skeleton.vertex_count());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    euler[v] = skeleton.link(v).euler;
    for (const double order : points[v]) euler[v] -= order == 0 ? 1 : 1 - 1 / order;
  }
  return euler;
}

std::optional<OrbifoldStructure> why_no_orbifold(const Skeleton& skeleton, const EdgeOrders& orders) {
  if (skeleton.tetrahedron_count() == 0) return orbifold_obstructed(OrbifoldOutcome::invalid, EdgeId());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (skeleton.is_reversed(e)) return orbifold_obstructed(OrbifoldOutcome::invalid, e);
  if (skeleton.has_boundary_faces()) return orbifold_obstructed(OrbifoldOutcome::boundary_faces, EdgeId());
  const auto points = cone_points(skeleton, orders);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (is_bad(skeleton.link(v), points[v]))
      return orbifold_obstructed(OrbifoldOutcome::bad_vertex, EdgeId(), v);
  const Table<VertexId, double> euler = orbifold_euler(skeleton, orders);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const auto [a, b] = skeleton.ends(e);
    if (orders[e] == 0) {
      if (type_of(euler[a]) == VertexType::ideal && type_of(euler[b]) == VertexType::ideal)
        return orbifold_obstructed(OrbifoldOutcome::null_edge, e);
    } else if (skeleton.valence(e) * orders[e] <= 1) {
      return orbifold_obstructed(OrbifoldOutcome::low_valence, e);
    }
  }
  return std::nullopt;
}

OrbifoldStructure solve_orbifold(const Triangulation& tri, const Skeleton& skeleton, const EdgeOrders& orders,
                                 const OrbifoldOptions& options, const Progress& progress) {
  skeleton.require_current(tri);
  if (orders.size() != skeleton.edge_count())
    throw PreconditionError("solve_orbifold: needs one order per edge class");
  for (const double order : orders)
    if (!is_edge_order(order)) throw PreconditionError("solve_orbifold: an order is 0, 1, or above 1");
  if (std::optional<OrbifoldStructure> obstacle = why_no_orbifold(skeleton, orders)) return *obstacle;
  return OrbifoldSolver(skeleton, orders, options, progress).run();
}

std::string describe(const OrbifoldStructure& result, const Skeleton& skeleton) {
  const std::string edge = "edge " + std::to_string(result.edge.value);
  const std::string vertex = "vertex " + std::to_string(result.vertex.value);
  switch (result.outcome) {
  case OrbifoldOutcome::geometric:
    return std::string("a hyperbolic structure was found") +
           (result.method == OrbifoldMethod::homotopy ? ", by the homotopy" : "");
  case OrbifoldOutcome::turned_over:
    return "the equations are solved, with " + std::to_string(result.negative()) +
           " tetrahedra turned over and " + std::to_string(result.flat()) + " flat";
  case OrbifoldOutcome::bad_vertex:
    return "not hyperbolic: the marks at " + vertex +
           " leave it a sphere with one cone point, or with two different ones";
  case OrbifoldOutcome::null_edge:
    return "undecided: the null " + edge + " joins two cusps; drill or contract it first";
  case OrbifoldOutcome::low_valence:
    return "no structure on this triangulation: " + edge + " has valence " +
           std::to_string(skeleton.valence(result.edge)) + ", too few for its cone angle";
  case OrbifoldOutcome::not_found:
    return "undecided: neither Newton's method nor the homotopy arrived, in " +
           std::to_string(result.iterations) + " steps";
  case OrbifoldOutcome::boundary_faces:
    return "undecided: " + std::to_string(skeleton.boundary_face_count()) +
           " faces are not glued; close or truncate the boundary first";
  case OrbifoldOutcome::invalid:
    return result.edge.value < 0 ? "there is no tetrahedron" : edge + " is identified with itself reversed";
  }
  return {};
}

} // namespace tetrarch::hyperbolic
