// SPDX-License-Identifier: GPL-2.0-or-later

/// All orientable gluings of three and four tetrahedra with a vertex of genus >= 2, none that is a sphere and
/// no edge of valence below 3, as Regina lists them (tests/oracle/false_convergence_record.py).

#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <set>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;

namespace {

std::vector<Triangulation> recorded(int tetrahedra) {
  std::ifstream in(std::string(TETRARCH_SOURCE_DIR) + "/tests/oracle/false_convergence_" +
                   std::to_string(tetrahedra) + ".txt");
  std::vector<Triangulation> list;
  for (std::string line; std::getline(in, line);) list.push_back(from_signature(line));
  return list;
}

bool has_cusp(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).euler == 0) return true;
  return false;
}

/// Decided in 60 digits: with one length of 14 the determinant drowns in the rounding of doubles.
bool all_exist(const Skeleton& skeleton, const Metric<double>& metric) {
  const auto types = vertex_types(skeleton);
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t) {
    SixNumbers<numeric::Real50> lengths;
    for (int e = 0; e < 6; ++e) lengths[e] = metric[skeleton.edge({t, e})];
    if (!exists(lengths, types_at(skeleton, types, t))) return false;
  }
  return true;
}

/// Whether Newton passes a metric with max |K| < 1e-6, the dissertation's tolerance, at which every
/// tetrahedron exists, when nothing stops a length from growing.
bool would_be_accepted_at_1e_6(const Triangulation& tri, const Skeleton& skeleton) {
  HyperbolizeOptions lax;
  lax.tolerance = 1e-6;
  lax.step_tolerance = HUGE_VAL;
  lax.length_limit = 40;
  for (lax.max_iterations = 1; lax.max_iterations < 200; ++lax.max_iterations) {
    const auto result = hyperbolize(tri, skeleton, lax);
    if (result.residual < 1e-6 && all_exist(skeleton, result.lengths)) return true;
    if (result.iterations < lax.max_iterations) return false;
  }
  return false;
}

struct Count {
  int geometric = 0;
  int compact_failures = 0;
  int cusped_failures = 0;
  int falsely_convergent = 0;
  int most_steps = 0;
  double longest = 0;
  double worst_residual = 0;
  std::multiset<long> volumes; ///< in units of 1e-9
};

Count count(const std::vector<Triangulation>& list) {
  Count n;
  for (const Triangulation& tri : list) {
    const Skeleton skeleton(tri);
    const auto result = hyperbolize(tri, skeleton);
    if (result.outcome == Outcome::geometric) {
      ++n.geometric;
      n.most_steps = std::max(n.most_steps, result.iterations);
      n.worst_residual = std::max(n.worst_residual, result.residual);
      n.longest = std::max(n.longest, std::abs(result.lengths[result.edge]));
      n.volumes.insert(std::lround(result.volume * 1e9));
    } else {
      ++(has_cusp(skeleton) ? n.cusped_failures : n.compact_failures);
      n.falsely_convergent += would_be_accepted_at_1e_6(tri, skeleton);
    }
  }
  return n;
}

/// How many clusters there are, with gaps above 1e-8.
int distinct(const std::multiset<long>& volumes) {
  int clusters = 0;
  long previous = -1000;
  for (const long v : volumes) {
    clusters += v - previous > 10;
    previous = v;
  }
  return clusters;
}

} // namespace

TEST_CASE("dLQacccjcog converges falsely and is not accepted", "[false_convergence]") {
  // Found by a prototype of the same mathematics; its Newton steps stay of length 1 while K goes to 0.
  const Triangulation tri = from_signature("dLQacccjcog");
  const Skeleton skeleton(tri);
  for (const Method method : {Method::newton, Method::flow}) {
    HyperbolizeOptions options;
    options.method = method;
    const auto result = hyperbolize(tri, skeleton, options);
    CHECK(result.outcome == Outcome::edge_runs_off);
    CHECK(result.residual < 1e-3);
    CHECK(result.last_step > 0.5);
  }
  CHECK(would_be_accepted_at_1e_6(tri, skeleton));
  // At a laxer length limit the Newton step alone still tells.
  HyperbolizeOptions long_edges;
  long_edges.length_limit = 18;
  CHECK(hyperbolize(tri, skeleton, long_edges).outcome == Outcome::edge_runs_off);
}

TEST_CASE("three tetrahedra: the volumes of Frigerio, Martelli and Petronio", "[false_convergence]") {
  const Count n = count(recorded(3));
  // Table 2 of their paper (Experimental Math. 13, 2004): 151 manifolds with 18 volumes, 74 of which have a
  // single edge class and the volume 10.428602. A manifold may have several such gluings (so at least 151),
  // and those of two tetrahedra may appear again, with their only volume 6.451990: one more value. What 74
  // manifolds with one edge class tell about gluings: each has just one, as its cells are regular.
  CHECK(n.geometric >= 151);
  CHECK(distinct(n.volumes) == 18 + 1);
  CHECK(n.volumes.count(10428601580) == 74);
  CHECK(n.compact_failures + n.cusped_failures == 3);
  CHECK(n.falsely_convergent == 3);
  CHECK(n.most_steps <= 6);
  CHECK(n.longest < 4.4);
  CHECK(n.worst_residual < 1e-13);
}

TEST_CASE("Newton and the flow find the same structures on three tetrahedra", "[flow]") {
  HyperbolizeOptions flow;
  flow.method = Method::flow;
  flow.keep_history = false;
  double worst = 0;
  for (const Triangulation& tri : recorded(3)) {
    const Skeleton skeleton(tri);
    const auto by_newton = hyperbolize(tri, skeleton);
    const auto by_flow = hyperbolize(tri, skeleton, flow);
    CHECK(by_newton.outcome == by_flow.outcome);
    if (by_newton.outcome != Outcome::geometric) continue;
    CHECK(by_flow.residual < 1e-11);
    for (std::size_t t = 0; t < by_newton.dihedral_angles.size(); ++t)
      for (int e = 0; e < 6; ++e)
        worst = std::max(worst, std::abs(by_newton.dihedral_angles[t][e] - by_flow.dihedral_angles[t][e]));
  }
  CHECK(worst < 1e-10);
}

TEST_CASE("four tetrahedra: how many gluings converge falsely", "[false_convergence][slow]") {
  const Count n = count(recorded(4));
  // A prototype in another language counted 202 gluings of three or four tetrahedra without a structure, 120
  // of which reach max |K| < 1e-6 with every tetrahedron existing. The 202 turn out to be those without
  // cusps; one more has a cusp. The three of three tetrahedra are counted above. Whether all exist is decided
  // here in 60 digits, which gives 119; decided in doubles it is 117, as the prototype had it: two stand
  // within rounding of the border.
  CHECK(n.compact_failures == 202 - 3);
  CHECK(n.cusped_failures == 1);
  CHECK(n.falsely_convergent >= 120 - 3);
  CHECK(n.falsely_convergent <= 119);
  CHECK(n.geometric == 6060 - 200);
  // True structures have lengths up to 4.4 and take at most nine steps (the same prototype).
  CHECK(n.longest < 4.4);
  CHECK(n.most_steps <= 9);
  // The prototype counts 252 volumes of compact and 10 of cusped manifolds with one in common; gluings of
  // four tetrahedra that can do with fewer add at most the 19 volumes of two and three tetrahedra.
  CHECK(distinct(n.volumes) >= 261);
  CHECK(distinct(n.volumes) <= 261 + 19);
}
