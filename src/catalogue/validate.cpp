// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/validate.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tetrarch::catalogue {
namespace {

using numeric::Real50;

constexpr std::array<Published, 3> publications{
    {{2, 8, 1, 8, 0, "Frigerio-Martelli-Petronio 2004"},
     {3, 151, 18, 74, 1, "Frigerio-Martelli-Petronio 2004"},
     {4, 5033, 261, 2340, 31, "Frigerio-Martelli-Petronio 2004"}}};

/// The dissertation's bound on the flow's angles (4.3.4), and what Newton's must meet.
constexpr double flow_angle_bound = 1e-6;
constexpr double newton_angle_bound = 1e-10;

void count_manifolds(const std::vector<Manifold>& manifolds, Validation& out) {
  out.manifolds = static_cast<int>(manifolds.size());
  out.volumes = count_volumes(manifolds);
  std::map<std::string, int> boundaries;
  for (const Manifold& m : manifolds) {
    out.single_edge += m.edges == 1;
    out.cusped += m.cusps > 0;
    ++boundaries[m.boundary_text()];
  }
  out.by_boundary.assign(boundaries.begin(), boundaries.end());
}

void compare_with(const Published& paper, Validation& out) {
  const auto expect = [&](const char* what, int found, int wanted) {
    if (found != wanted)
      out.failures.push_back(std::string(what) + ": " + std::to_string(found) + ", but " + paper.source +
                             " has " + std::to_string(wanted));
  };
  expect("manifolds", out.manifolds, paper.manifolds);
  expect("distinct volumes", static_cast<int>(out.volumes.size()), paper.distinct_volumes);
  expect("manifolds with one edge class", out.single_edge, paper.single_edge);
  expect("manifolds with a cusp", out.cusped, paper.cusped);
}

struct Errors {
  double angle = 0;
  double volume = 0;
};

/// Solves a stored gluing from length 1 and measures the distance from its stored digits.
std::optional<Errors> solve_again(const Manifold& m, hyperbolic::Method method) {
  const Triangulation tri = from_signature(m.signature);
  hyperbolic::HyperbolizeOptions options;
  options.method = method;
  const auto structure = hyperbolic::hyperbolize(tri, Skeleton(tri), options);
  if (structure.outcome != hyperbolic::Outcome::geometric) return std::nullopt;
  Errors errors;
  for (std::size_t t = 0; t < m.dihedral_angles.size(); ++t)
    for (int e = 0; e < 6; ++e) {
      const Real50 difference = Real50(structure.dihedral_angles[t][e]) - Real50(m.dihedral_angles[t][e]);
      errors.angle = numeric::maximum(errors.angle, std::abs(difference.convert_to<double>()));
    }
  errors.volume = std::abs((Real50(structure.volume) - Real50(m.volume)).convert_to<double>());
  return errors;
}

void solve_all_again(const std::vector<Manifold>& table, Validation& out, const Progress& progress) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Manifold& m = table[k];
    progress.step("re-solving", static_cast<double>(k) / static_cast<double>(table.size()));
    const auto newton = solve_again(m, hyperbolic::Method::newton);
    const auto flow = solve_again(m, hyperbolic::Method::flow);
    if (!newton || !(newton->angle <= newton_angle_bound))
      out.failures.push_back(m.name + ": Newton from length 1");
    if (!flow || !(flow->angle <= flow_angle_bound))
      out.failures.push_back(m.name + ": Luo's flow from length 1");
    if (newton) {
      out.max_angle_error = numeric::maximum(out.max_angle_error, newton->angle);
      out.max_volume_error = numeric::maximum(out.max_volume_error, newton->volume);
    }
    if (flow) {
      out.max_angle_error_flow = numeric::maximum(out.max_angle_error_flow, flow->angle);
      out.max_volume_error_flow = numeric::maximum(out.max_volume_error_flow, flow->volume);
    }
  }
}

} // namespace

std::optional<Published> published(TableKey table) {
  for (const Published& paper : publications)
    if (table == TableKey(paper.tetrahedra)) return paper;
  return std::nullopt;
}

Validation validate(TableKey key, int threads, const Progress& progress) {
  const std::vector<Manifold>& table = require_table(key);
  Validation out;
  out.tetrahedra = key.tetrahedra;
  const Classification fresh = classify_manifolds(key, threads, progress);
  out.tally = fresh.tally;
  const bool brief = table.front().dihedral_angles.empty();
  out.rebuilt =
      write_table(key, brief ? without_angles(fresh.manifolds) : fresh.manifolds) == stored_table_text(key);
  if (!out.rebuilt) out.failures.emplace_back("the stored table did not come out again");
  if (out.tally.stuck > 0)
    out.failures.push_back(std::to_string(out.tally.stuck) + " structures without a canonical decomposition");
  count_manifolds(fresh.manifolds, out);
  if (const auto paper = published(key)) compare_with(*paper, out);
  solve_all_again(out.rebuilt ? fresh.manifolds : table, out,
                  progress); // where angles are not stored, the fresh ones
  return out;
}

} // namespace tetrarch::catalogue
