// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/orbifold_search.hpp"

#include "marked_samples.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stop_token>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;

namespace {

constexpr double pi = std::numbers::pi;

OrbifoldStructure solved(const Triangulation& tri, const Marks& marks, const OrbifoldOptions& options = {}) {
  const Skeleton skeleton(tri);
  return solve_orbifold(tri, skeleton, edge_orders(skeleton, marks), options);
}

OrbifoldStructure solved(const std::string& gluings, const std::string& marks,
                         const OrbifoldOptions& options = {}) {
  return solved(samples::gluings(gluings), samples::marks(marks), options);
}

OrbifoldOptions by(OrbifoldMethod method) {
  OrbifoldOptions options;
  options.use_newton = method == OrbifoldMethod::newton;
  options.use_homotopy = method == OrbifoldMethod::homotopy;
  return options;
}

std::string k4_orders(const std::vector<std::string>& orders) {
  const std::array<const char*, 6> edge{"01", "02", "03", "12", "13", "23"};
  std::string text;
  for (std::size_t e = 0; e < 6; ++e) text += std::string("0-") + edge[e] + ":" + orders[e] + " ";
  return text;
}

const char* const finite_vertices =
    "3:1230 1:0132 3:1230 1:0132 2:1203 0:0132 0:0132 2:1203 3:0123 1:2013 3:0123 1:2013 2:0123 0:3012 "
    "2:0123 0:3012";
const char* const finite_orders = "0-02:3 0-03:2 0-12:5 0-13:2 1-12:2 2-13:2";

struct Known {
  std::string gluings;
  std::string marks;
  double volume;
};

// Volumes of these gluings by a solver that was written apart from this one, and which agrees with the angles
// in Orb's example files; 3.663862376709 is that of the regular ideal octahedron, 7.327724753418 of two.
const std::vector<Known>& known() {
  static const std::vector<Known> list{
      {"0:1023 0:1023 0:0132 0:0132", "0-01:0 0-02:0 0-23:0", 3.663862376709},
      {samples::k4, k4_orders({"0", "0", "0", "0", "0", "0"}), 7.327724753418},
      {samples::k4, k4_orders({"2", "2", "3", "3", "6", "3"}), 0.923164366693},
      {samples::k4, k4_orders({"2", "0", "0", "2", "0", "0"}), 3.663862376709},
      {samples::theta, "0-01:0 0-12:0 1-23:0", 5.333489566898},
      {samples::theta, "0-01:3 0-12:0 1-23:4", 3.204510891726},
      {samples::theta, "0-01:3 0-12:3 1-23:3", 1.353255475213},
      {"2:3012 0:0213 0:0213 2:3012 2:0123 1:0213 1:0213 2:3021 1:0123 1:1320 0:1230 0:1230",
       "0-03:0 0-12:0 1-03:0", 7.327724753418},
      {finite_vertices, finite_orders, 0.039050285615}};
  return list;
}

/// An Orb file of these lines of edges.
std::string orb(const std::string& edges) {
  return "% orb\nname\nSolutionType not_attempted\nvertices_known\n\n" + edges;
}

// Lines of edges of Orb's example files 1_1^2.20, 1_1^2.1 and honours3. The first two have one volume (their
// orders differ: 2, 2, 3 and 2, 3, 4); Orb calls the second partially flat and the third not geometric.
const char* const positive = "  1  3 2.000  2  2  2xv  1vw  3xv\n"
                             "  2  1 3.000  1  1  4wv\n"
                             "  3  0 1.000  2  1  1xu  4vu  4uw  1vx  3wv\n"
                             "  4  0 1.000  2  2  2vu  3ux  4ux  1wx  2wx  2wu\n"
                             "  5  2 2.000  1  2  1vu  3uv  4vx  4xw  3wu\n"
                             "  6  0 1.000  2  2  2xu  1uw  3xw  2wv\n";
const char* const flat = "  1  2 3.000  1  2  1vu\n"
                         "  2  1 2.000  2  1  2wv\n"
                         "  3  3 4.000  2  1  2vu  2uw  1vx  1xu\n"
                         "  4  0 1.000  2  2  2xv  1vw  1wu  2ux  1wx  2wx\n";
const char* const honours3 =
    "  1  1 2.000  1  1  5wv\n"
    "  2  0 1.000  1  1  2xw  1xw  5wu  5uv  1vx\n"
    "  3  0 1.000  1  1  2xu  1uw  3wx  4wx\n"
    "  4  0 1.000  1  1  2xv  1vw  2vw  4wu  2wu  1uv  3vx  3xu  1xu  5xu  4xv  3vw  3wu  4ux\n"
    "  5  0 1.000  1  1  2vu  4vu  5wx  5xv  4wv\n"
    "  6  2 2.000  1  1  3vu\n";

} // namespace

TEST_CASE("structures with marked edges have the known volumes", "[orbifold]") {
  for (const Known& k : known()) {
    INFO(k.gluings << " | " << k.marks);
    const OrbifoldStructure s = solved(k.gluings, k.marks);
    REQUIRE(s.outcome == OrbifoldOutcome::geometric);
    CHECK(s.method == OrbifoldMethod::newton);
    CHECK(std::abs(s.volume - k.volume) < 5e-13 + s.volume_error);
    CHECK(s.volume_error < 1e-12);
    CHECK(s.residual < 1e-12);
  }
}

TEST_CASE("the homotopy arrives where Newton's method does", "[orbifold][homotopy]") {
  for (const Known& k : known()) {
    INFO(k.gluings << " | " << k.marks);
    const OrbifoldStructure newton = solved(k.gluings, k.marks, by(OrbifoldMethod::newton));
    const OrbifoldStructure path = solved(k.gluings, k.marks, by(OrbifoldMethod::homotopy));
    REQUIRE(path.outcome == OrbifoldOutcome::geometric);
    CHECK(path.method == OrbifoldMethod::homotopy);
    CHECK(std::abs(path.volume - newton.volume) <= 1e-13 + path.volume_error + newton.volume_error);
    for (std::size_t t = 0; t < path.dihedral_angles.size(); ++t)
      for (int e = 0; e < 6; ++e)
        CHECK(path.dihedral_angles[t][e] == Approx(newton.dihedral_angles[t][e]).margin(1e-10));
  }
}

TEST_CASE("the types of vertices follow from the marks", "[orbifold]") {
  const Triangulation tri = samples::gluings(samples::k4);
  const Skeleton skeleton(tri);
  const auto types = [&](const std::vector<std::string>& orders) {
    std::string text;
    const auto s = solved(tri, samples::marks(k4_orders(orders)));
    for (int v = 0; v < 4; ++v) text += to_string(s.types[skeleton.vertex({0, v})])[0];
    return text;
  };
  // At vertex 0 meet 01, 02, 03; at 1 01, 12, 13; at 2 02, 12, 23; at 3 03, 13, 23.
  CHECK(types({"0", "0", "0", "0", "0", "0"}) == "hhhh");
  CHECK(types({"2", "2", "3", "3", "6", "3"}) == "fifh"); // 2,2,3; 2,3,6; 2,3,3; 3,6,3
  CHECK(types({"2", "0", "0", "2", "0", "0"}) == "hihh"); // 2,0,0; 2,2,0; 0,2,0; 0,0,0
  CHECK(types({"3", "3", "3", "3", "3", "3"}) == "iiii");
  const auto euler = orbifold_euler(
      skeleton, edge_orders(skeleton, samples::marks(k4_orders({"2", "2", "3", "3", "6", "3"}))));
  CHECK(euler[skeleton.vertex({0, 0})] == Approx(1.0 / 3));  // 2 - 1/2 - 1/2 - 2/3
  CHECK(euler[skeleton.vertex({0, 3})] == Approx(-1.0 / 6)); // 2 - 2/3 - 5/6 - 2/3
}

// Gauss-Bonnet: a truncation triangle has the area pi less its angles, and a boundary component -2 pi chi.
TEST_CASE("boundary components have the area that their marks say", "[orbifold]") {
  for (const Known& k : known()) {
    INFO(k.gluings << " | " << k.marks);
    const Triangulation tri = samples::gluings(k.gluings);
    const Skeleton skeleton(tri);
    const OrbifoldStructure s = solved(tri, samples::marks(k.marks));
    const auto euler = orbifold_euler(skeleton, s.orders);
    for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
      double area = 0;
      for (const TetVertex at : skeleton.preimages(v)) {
        area += pi;
        for (int w = 0; w < 4; ++w)
          if (w != at.vertex) area -= s.dihedral_angles[at.tet][edge_number[at.vertex][w]];
      }
      CHECK(area == Approx(-2 * pi * euler[v]).margin(1e-11));
    }
  }
}

// dV = - 1/2 (sum of l d(cone angle)), by differences.
TEST_CASE("Schlaefli's formula holds with cone angles", "[orbifold]") {
  const Triangulation tri = samples::gluings(samples::theta);
  const Skeleton skeleton(tri);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    EdgeOrders orders = edge_orders(skeleton, samples::marks("0-01:3 0-12:3.5 1-23:4"));
    if (orders[e] == 1) continue;
    const double angle = 2 * pi / orders[e];
    const auto at = [&](double change) {
      orders[e] = 2 * pi / (angle + change);
      return solve_orbifold(tri, skeleton, orders);
    };
    constexpr double h = 1e-4;
    const double slope = (at(h).volume - at(-h).volume) / (2 * h);
    CHECK(slope == Approx(-at(0).lengths[e] / 2).epsilon(1e-6));
  }
}

// Integrating dV = -1/2 sum l d(2 pi / n) from angle 0, where l behaves like c / n: n^2 (V_0 - V) -> pi/2 sum
// n l.
TEST_CASE("small cone angles tend to parabolic meridians", "[orbifold]") {
  const double limit = solved(samples::theta, "0-01:0 0-12:0 1-23:0").volume;
  const Triangulation tri = samples::gluings(samples::theta);
  const Skeleton skeleton(tri);
  double previous = limit;
  for (const double n : {40.0, 80.0, 160.0}) {
    const std::string order = std::to_string(n);
    const auto s = solved(tri, samples::marks("0-01:" + order + " 0-12:" + order + " 1-23:" + order));
    REQUIRE(s.outcome == OrbifoldOutcome::geometric);
    double sum = 0;
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
      if (s.orders[e] != 1) sum += n * s.lengths[e];
    CHECK(n * n * (limit - s.volume) == Approx(pi / 2 * sum).epsilon(5 / n));
    CHECK(std::abs(limit - s.volume) < std::abs(limit - previous) + (n == 40 ? 1 : 0));
    previous = s.volume;
  }
}

TEST_CASE("tetrahedra that turn over add up to the right volume", "[orbifold][homotopy]") {
  const format::Document good = format::read_any(orb(positive), "positive");
  const format::Document folded = format::read_any(orb(flat), "flat");
  const OrbifoldStructure a = solved(good.triangulation, good.marks);
  const OrbifoldStructure b = solved(folded.triangulation, folded.marks);
  REQUIRE(a.outcome == OrbifoldOutcome::geometric);
  REQUIRE(b.outcome == OrbifoldOutcome::turned_over);
  CHECK(b.flat() == 1);
  CHECK(b.negative() == 0);
  CHECK(std::abs(a.volume - b.volume) <= a.volume_error + b.volume_error);
  // The volume of Regina's closed census m004(6,1), and SnapPea's.
  const format::Document negative = format::read_any(orb(honours3), "honours3");
  const OrbifoldStructure c = solved(negative.triangulation, negative.marks);
  REQUIRE(c.outcome == OrbifoldOutcome::turned_over);
  CHECK(c.negative() == 1);
  CHECK(std::abs(c.volume - 1.2844853004683544) < 1e-9);
  CHECK(c.residual < 1e-11);
}

// Isomorphism signatures and volumes (by SnapPea's kernel) of Regina's census of closed hyperbolic manifolds:
// the first five, and three further down.
TEST_CASE("closed manifolds are solved by the homotopy", "[orbifold][homotopy]") {
  const std::vector<std::pair<const char*, double>> census{
      {"jLvMLQQbfefgihhiixiptvvvgof", 0.9427073627769277},
      {"jLvvQQQbghighigihduqugksnof", 0.9813688288922321},
      {"jLvAzQQbefgihhiihxttasjvobr", 1.0149416064096536},
      {"kLLLLMQkacfgijjhiijnkgjitpemgn", 1.2637092386580437},
      {"kLLvLQQkcdjgjijhihihsfrovojgng", 1.2844853004683544}};
  for (const auto& [text, volume] : census) {
    INFO(text);
    OrbifoldSearchOptions options;
    options.attempts = 10;
    const OrbifoldSearch found = find_orbifold(from_signature(text), {}, options);
    REQUIRE(found.structure.outcome == OrbifoldOutcome::geometric);
    CHECK(std::abs(found.structure.volume - volume) < 1e-11);
  }
}

// One of Regina's census whose own triangulation has a tetrahedron turned over, and none that is flat.
TEST_CASE("a tetrahedron turned over counts negatively", "[orbifold][homotopy]") {
  const OrbifoldStructure s = solved(from_signature("nLLLwALMQkcegffhlimklmmlhthanctnqrrfnj"), {});
  REQUIRE(s.outcome == OrbifoldOutcome::turned_over);
  CHECK(s.negative() == 1);
  CHECK(s.flat() == 0);
  CHECK(std::abs(s.volume - 2.2726318635865582) < 1e-11);
  CHECK(s.residual < 1e-11);
}

// S^3, lens spaces and the like have no hyperbolic structure; found by hand: their groups are finite or
// cyclic.
TEST_CASE("closed manifolds without a structure are not given one", "[orbifold][homotopy]") {
  int asked = 0;
  for (const support::ZooEntry& entry : support::zoo()) {
    const Triangulation tri = entry.triangulation();
    const Skeleton skeleton(tri);
    if (tri.size() == 0 || skeleton.has_boundary_faces() || !skeleton.is_connected()) continue;
    bool closed = true;
    for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
      closed = closed && skeleton.link(v).is_sphere();
    if (!closed || why_no_orbifold(skeleton, EdgeOrders(skeleton.edge_count(), 1.0))) continue;
    if (entry.name == "Weber-Seifert space" || entry.name == "Weeks manifold") continue; // hyperbolic
    INFO(entry.name);
    ++asked;
    OrbifoldSearchOptions options;
    options.attempts = 6;
    CHECK(find_orbifold(tri, {}, options).structure.outcome != OrbifoldOutcome::geometric);
  }
  CHECK(asked >= 1);
}

// The dodecahedron with dihedral angles 2 pi / 5: volume 11.19906474... (Weber and Seifert 1933; Regina's
// census does not go so far).
TEST_CASE("the Weber-Seifert space has its volume", "[orbifold][homotopy][slow]") {
  const OrbifoldSearch found = find_orbifold(support::zoo("Weber-Seifert space").triangulation(), {}, {});
  REQUIRE(found.structure.solved());
  CHECK(std::abs(found.structure.volume - 11.199064740893) < 1e-8);
}

TEST_CASE("the search keeps the marks and the volume", "[orbifold]") {
  // From triangulations made by marked moves, whose marks must be those of before.
  const format::Document folded = format::read_any(orb(flat), "flat");
  OrbifoldSearchOptions options;
  options.attempts = 12;
  const OrbifoldSearch found = find_orbifold(folded.triangulation, folded.marks, options);
  REQUIRE(found.structure.solved());
  std::vector<double> orders;
  for (const EdgeMark& mark : found.marks) orders.push_back(mark.order);
  std::sort(orders.begin(), orders.end());
  CHECK(orders == std::vector<double>{2, 3, 4});
  CHECK(std::abs(found.structure.volume - 0.132387219942) < 1e-9);
}

TEST_CASE("what no hyperbolic orbifold has is said", "[orbifold][bad]") {
  const auto orbifold_outcome = [](const std::string& gluings, const std::string& marks) {
    return solved(gluings, marks).outcome;
  };
  // One cone point on a sphere; two of different angles.
  CHECK(orbifold_outcome(samples::k4, "0-01:3") == OrbifoldOutcome::bad_vertex);
  CHECK(orbifold_outcome(samples::k4, "0-01:3 0-12:4 0-02:3") == OrbifoldOutcome::bad_vertex);
  CHECK(solved(samples::k4, "0-01:3").vertex.value >= 0);
  // A triangle of null edges: its three vertices are cusps.
  CHECK(orbifold_outcome(samples::k4, "0-01:0 0-12:0 0-02:0") == OrbifoldOutcome::null_edge);
  CHECK(orbifold_outcome("0:1023 0:1023 0:0132 0:0132", "") == OrbifoldOutcome::low_valence);
  CHECK(solved(Triangulation(), {}).outcome == OrbifoldOutcome::invalid);
  CHECK(solved(Triangulation(1), {}).outcome == OrbifoldOutcome::boundary_faces);
  const Triangulation tri = samples::gluings(samples::k4);
  const Skeleton skeleton(tri);
  CHECK_THROWS_AS(solve_orbifold(tri, skeleton, EdgeOrders(2, 1.0)), PreconditionError);
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  orders[EdgeId(0)] = 0.5;
  CHECK_THROWS_AS(solve_orbifold(tri, skeleton, orders), PreconditionError);
  CHECK_THROWS_AS(edge_orders(skeleton, samples::marks("0-01:3 0-10:4")), PreconditionError);
  CHECK_THROWS_AS(edge_orders(skeleton, samples::marks("7-01:3")), PreconditionError);
}

TEST_CASE("a stop ends the homotopy", "[orbifold]") {
  const Triangulation tri = from_signature("jLvMLQQbfefgihhiixiptvvvgof");
  const Skeleton skeleton(tri);
  std::stop_source source;
  int steps = 0;
  const Progress progress(
      [&](std::string_view stage, double) {
        if (stage == "homotopy" && ++steps == 3) source.request_stop();
      },
      source.get_token());
  OrbifoldOptions options = by(OrbifoldMethod::homotopy);
  CHECK_THROWS_AS(solve_orbifold(tri, skeleton, EdgeOrders(skeleton.edge_count(), 1.0), options, progress),
                  Stopped);
  CHECK(steps == 3);
}
