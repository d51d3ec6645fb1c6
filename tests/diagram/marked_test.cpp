// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/marked.hpp"

#include "support/errors.hpp"
#include "support/homology.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/hyperbolic/orbifold_search.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/moves/marked.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::diagram;
using namespace tetrarch::support;

namespace {

constexpr double octahedron = 3.663862376709; // the regular ideal one

double volume_of(const moves::MarkedTriangulation& marked) {
  const hyperbolic::OrbifoldSearch found = hyperbolic::find_orbifold(marked.tri, marked.marks);
  INFO(describe(found));
  REQUIRE(found.structure.solved());
  return found.structure.volume;
}

MarkedDiagram kept(const std::string& code, Fate fate) {
  MarkedDiagram marked = all_drilled(read_diagram(code, "test"));
  std::fill(marked.fates.begin(), marked.fates.end(), fate);
  return marked;
}

/// The double of the exterior, half: its meridians are parabolic.
double half_of_double(const Diagram& diagram) {
  hyperbolic::SearchOptions how;
  how.attempts = 1000;
  const hyperbolic::Search found = hyperbolic::find_structure(doubled_exterior(diagram), how);
  REQUIRE(found.structure.outcome == hyperbolic::Outcome::geometric);
  return found.structure.volume / 2;
}

/// An Orb file of the complete graph on four vertices in the plane: two tetrahedra, glued 1:1302 and 0:2031
/// four times, with edges 01, 02, 03, 12, 13, 23; edge lines by hand. Curve k + 1 has orders[k]. A drawing
/// follows.
std::string orb_file(const std::vector<double>& orders, const std::string& drawing) {
  const std::array<const char*, 6> cycles{"1wx  2wu", "1vx  2wx", "1vw  2ux",
                                          "1ux  2wv", "1uw  2uv", "1uv  2xv"};
  std::ostringstream text;
  text << "% orb\nown\nSolutionType geometric_solution\n\n";
  for (std::size_t k = 0; k < cycles.size(); ++k)
    text << k + 1 << " " << (k < orders.size() ? k + 1 : 0) << " " << (k < orders.size() ? orders[k] : 1.0)
         << " " << cycles[k] << "\n";
  text << "\n  1  -1.0  1.0  1.0  0.5  0.5\n\n" << drawing;
  return text.str();
}

struct Crossing {
  int over = 0;
  int under = 0;
  double along_over = 0;
  double along_under = 0;
};

/// Segments in space as one sees them from far up the z axis.
std::string drawing_of(const Curve& curve, bool drilled) {
  std::vector<Crossing> crossings;
  const auto at = [&](int s, int end) { return curve.points[curve.segments[s][end]]; };
  for (int s = 0; s < static_cast<int>(curve.segments.size()); ++s)
    for (int t = 0; t < s; ++t) {
      const auto [a, b, c, d] = std::array{at(s, 0), at(s, 1), at(t, 0), at(t, 1)};
      const double det = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
      if (det == 0) continue;
      const double u = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / det;
      const double v = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / det;
      const auto [p, q] = curve.segments[s];
      const auto [x, y] = curve.segments[t];
      if (p == x || p == y || q == x || q == y || u < 0 || u > 1 || v < 0 || v > 1) continue;
      const bool above = a[2] + u * (b[2] - a[2]) > c[2] + v * (d[2] - c[2]);
      crossings.push_back(above ? Crossing{s, t, u, v} : Crossing{t, s, v, u});
    }
  std::ostringstream text;
  text << curve.points.size() << "\n";
  for (std::size_t p = 0; p < curve.points.size(); ++p)
    text << p << "\t" << curve.points[p][0] << "\t" << -curve.points[p][1] << "\n"; // y goes down on a screen
  text << "\n" << curve.segments.size() << "\n";
  for (std::size_t s = 0; s < curve.segments.size(); ++s)
    text << s << "\t" << curve.segments[s][0] << "\t" << curve.segments[s][1] << "\t" << drilled << "\n";
  text << "\n" << crossings.size() << "\n";
  for (std::size_t x = 0; x < crossings.size(); ++x)
    text << x << "\t0\t0\t" << crossings[x].over << "\t" << crossings[x].under << "\t"
         << crossings[x].along_over << "\t" << crossings[x].along_under << "\n";
  return text.str();
}

/// Straight arcs between vertices, each by way of some random points. An end of -1 is a point on the way.
Curve random_curve(const std::vector<std::array<int, 2>>& arcs, int vertices, int between,
                   SplitMix64& random) {
  Curve curve;
  const auto add = [&] {
    const auto coordinate = [&random] { return static_cast<double>(random.below(2001) - 1000); };
    curve.points.push_back({coordinate(), coordinate(), coordinate()});
    return static_cast<int>(curve.points.size()) - 1;
  };
  for (int v = 0; v < vertices; ++v) add();
  for (const auto& [from, to] : arcs) {
    int last = from;
    for (int k = 0; k < between; ++k) {
      const int p = add();
      curve.segments.push_back({last, p});
      last = p;
    }
    curve.segments.push_back({last, to});
  }
  return curve;
}

const std::string plane_k4 = "4\n0 0 0\n1 100 60\n2 -100 60\n3 0 -90\n\n"
                             "6\n0 0 1 0\n1 0 2 0\n2 0 3 0\n3 1 2 0\n4 1 3 0\n5 2 3 0\n\n0\n";

} // namespace

TEST_CASE("a plane drawing in an Orb file has the structure of the file's triangulation", "[marked]") {
  // The volumes by Orb's method: see hyperbolic's test of marked edges.
  struct Case {
    std::vector<double> orders;
    double volume;
  };
  for (const Case& c : {Case{{0, 0, 0, 0, 0, 0}, 2 * octahedron}, Case{{2, 2, 3, 3, 6, 3}, 0.923164366693},
                        Case{{2, 0, 0, 2, 0, 0}, octahedron}}) {
    const auto drawn = read_orb_diagram(orb_file(c.orders, plane_k4), "f");
    REQUIRE(drawn);
    CHECK(fates_of_edges(*drawn) == std::vector<Fate>(c.orders.begin(), c.orders.end()));
    CHECK(volume_of(marked_exterior(*drawn)) == Approx(c.volume).margin(1e-11).epsilon(0));
    const auto drilled = read_orb_diagram(orb_file(c.orders, plane_k4), "f", true);
    CHECK_FALSE(keeps_edges(*drilled));
    CHECK(first_homology(marked_exterior(*drilled).tri) == "Z^3");
  }
  CHECK_FALSE(read_orb_diagram(orb_file({0, 0}, ""), "f"));
  CHECK_FALSE(read_orb_diagram(orb_file({0, 0}, "0\n\n0\n\n0\n"), "f"));
}

TEST_CASE("a drawing shows the curve that it is a picture of", "[marked]") {
  // The second route looks from a random place nearby and decides crossings by exact predicates.
  SplitMix64 random(5);
  int compared = 0;
  for (int k = 0; k < 24; ++k) {
    const bool theta = k % 2 == 0;
    const Curve curve = theta ? random_curve({{0, 1}, {0, 1}, {0, 1}}, 2, 3, random)
                              : random_curve({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}, 4, 1, random);
    const auto drawn = read_orb_diagram(orb_file({}, drawing_of(curve, true)), "f");
    REQUIRE(drawn);
    const Diagram seen = project(curve, "curve");
    CHECK(edges(drawn->diagram).count == (theta ? 3 : 6));
    const auto compare = [&](const moves::MarkedTriangulation& a, const moves::MarkedTriangulation& b) {
      const auto x = hyperbolic::find_orbifold(a.tri, a.marks);
      const auto y = hyperbolic::find_orbifold(b.tri, b.marks);
      if (!x.structure.solved() || !y.structure.solved()) return;
      ++compared;
      CHECK(x.structure.volume == Approx(y.structure.volume).margin(1e-9).epsilon(0));
    };
    MarkedDiagram one{drawn->diagram, std::vector<Fate>(drawn->fates.size(), Fate(0))};
    MarkedDiagram two = all_drilled(seen);
    CHECK(first_homology(marked_exterior(*drawn).tri) == first_homology(exterior(seen)));
    std::fill(two.fates.begin(), two.fates.end(), Fate(0));
    compare(marked_exterior(one), marked_exterior(two));
  }
  CHECK(compared >= 14);
}

TEST_CASE("null edges have half the volume of the double", "[marked]") {
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/data/handlebody_knots.txt");
  REQUIRE(file);
  int count = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::string name = line.substr(0, line.find('|'));
    const std::string code = line.substr(name.size() + 1, line.rfind('|') - name.size() - 1);
    if (name == "5_4" || name == "6_14" || name == "6_15" || name == "6_16") continue; // they have none
    INFO(name);
    ++count;
    const MarkedDiagram marked = kept(code, 0);
    CHECK(volume_of(marked_exterior(marked)) ==
          Approx(half_of_double(marked.diagram)).margin(1e-9).epsilon(0));
  }
  CHECK(count == 17);
}

TEST_CASE("the figure-eight knot with cone angles", "[marked]") {
  // V(a) = integral from a to 2 pi / 3 of arcosh(1 + cos t - cos 2t): Hilden, Lozano and Montesinos, "On a
  // remarkable polyhedron geometrizing the figure eight knot cone manifolds" (1995). Simpson's rule; the
  // square root at the upper end goes with t = 2 pi / 3 - s^2.
  const auto volume = [](double angle) {
    constexpr double end = 2 * std::numbers::pi / 3;
    const auto f = [](double s) {
      const double t = end - s * s;
      return 2 * s * std::acosh(std::max(1.0, 1 + std::cos(t) - std::cos(2 * t)));
    };
    constexpr int steps = 2000;
    const double h = std::sqrt(end - angle) / steps;
    double sum = f(0) + f(steps * h);
    for (int k = 1; k < steps; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(k * h);
    return sum * h / 3;
  };
  CHECK(volume(0) == Approx(2.029883212819).margin(1e-9).epsilon(0));
  for (const double n : {4.0, 5.0, 7.5})
    CHECK(volume_of(marked_exterior(kept("braid 1 -2 1 -2", n))) ==
          Approx(volume(2 * std::numbers::pi / n)).margin(1e-9).epsilon(0));
  // Parabolic: the knot becomes a cusp.
  const moves::MarkedTriangulation cusp = marked_exterior(kept("braid 1 -2 1 -2", 0));
  CHECK(cusp.marks.empty());
  CHECK(signature(cusp.tri) == "cPcbbbiht");
}

TEST_CASE("a drilled edge between vertices is as good as one vertex", "[marked]") {
  // Two arcs of a link beside one region, pulled together into a vertex of valence 4, and the two ways to
  // pull that apart into vertices of valence 3 with a drilled edge between them.
  SplitMix64 random(3);
  int compared = 0;
  for (const char* code : {"braid 1 -2 1 -2", "braid 1 -2 1 -2 1 -2 1 -2", "braid 1 -2 3 -2 1 -2 3 -2 1",
                           "braid 1 -2 3 2 1 -3 -3 2"})
    for (int k = 0; k < 8; ++k) {
      const Diagram link = read_diagram(code, "test");
      const int d = random.below(link.dart_count());
      int e = link.next_on_left(d);
      for (int steps = random.below(4); steps > 0; --steps) e = link.next_on_left(e);
      if (e == d || e == link.opposite(d)) continue;
      INFO(code << ", arcs " << d << " and " << e);
      // At the arc of d the darts west (back along d), east and north (into the region); at that of e so,
      // too.
      const auto build = [&](const std::vector<std::vector<int>>& vertices, bool pulled) {
        std::vector<Node> nodes = link.nodes();
        std::vector<int> opposite = link.opposites();
        const int base = link.dart_count();
        const std::array<int, 4> beyond{d, link.opposite(d), e, link.opposite(e)};
        for (int j = 0; j < 4; ++j) {
          opposite.push_back(beyond[j]);
          opposite[beyond[j]] = base + j;
        }
        if (pulled) opposite.insert(opposite.end(), {base + 5, base + 4});
        for (std::vector<int> darts : vertices) {
          for (int& x : darts) x += base;
          nodes.push_back({darts, false, 0});
        }
        MarkedDiagram marked = all_drilled({nodes, opposite});
        std::fill(marked.fates.begin(), marked.fates.begin() + base + 4, Fate(0));
        return hyperbolic::find_orbifold(marked_exterior(marked).tri, marked_exterior(marked).marks)
            .structure;
      };
      const auto joined = build({{0, 1, 2, 3}}, false); // west, east of d, then of e, counterclockwise
      const auto apart = build({{1, 4, 0}, {3, 5, 2}}, true);
      const auto across = build({{1, 2, 4}, {5, 3, 0}}, true);
      const auto is_found = [](const auto& x) { return x.outcome == hyperbolic::OrbifoldOutcome::geometric; };
      if (!is_found(joined) || !is_found(apart) || !is_found(across)) continue;
      ++compared;
      CHECK(apart.volume == Approx(joined.volume).margin(1e-9).epsilon(0));
      CHECK(across.volume == Approx(joined.volume).margin(1e-9).epsilon(0));
    }
  CHECK(compared >= 6);
}

TEST_CASE("a drilled edge may go on as one that stays", "[marked]") {
  // The figure-eight knot with a point where a drilled arc begins and one where it ends: a tree is crushed,
  // and what is left is the knot with a cone angle.
  const char* const code =
      "PD[X[4, 2, 5, 1], X[8, 6, 1, 5], X[6, 3, 7, 4], X[2, 7, 3, 10], P[8, 9], P[9, 10]]";
  MarkedDiagram marked = kept(code, 5);
  REQUIRE(edges(marked).count == 1);
  for (int d = 0; d < marked.diagram.dart_count(); ++d) {
    const int e = marked.diagram.opposite(d);
    if (!marked.diagram.at_crossing(d) && !marked.diagram.at_crossing(e)) marked.fates[d].reset();
  }
  CHECK(edges(marked).count == 2);
  CHECK(fates_of_edges(marked).size() == 2);
  const double whole = volume_of(marked_exterior(kept("braid 1 -2 1 -2", 5)));
  CHECK(volume_of(marked_exterior(marked)) == Approx(whole).margin(1e-10).epsilon(0));
}

TEST_CASE("wrong drawings in Orb files", "[bad][marked]") {
  const auto complaint = [](const std::string& drawing,
                            const std::vector<double>& orders = {0, 0, 0, 0, 0, 0}) {
    return error_of([&] { (void)read_orb_diagram(orb_file(orders, drawing), "f"); });
  };
  const std::string two = "4\n0 0 0\n1 10 10\n2 0 10\n3 10 0\n\n2\n0 0 1 0\n1 2 3 0\n\n";
  const auto last = "1\n0 5 5 0 1 0.5 0.5\n";
  CHECK(complaint(two + last, {0, 0}).empty());
  CHECK(complaint(two + last, {0, 0, 0}) == "f: the drawing has 2 edges that are not drilled, the "
                                            "triangulation 3 singular curves: their orders cannot be told");
  CHECK(complaint(two + "0\n", {0, 0}) == "f:22: segments 0 and 1 cross, and no crossing says how");
  CHECK(complaint(two + "1\n0 5 5 0 0 0.5 0.5\n", {0, 0}).find("cross, and no crossing") !=
        std::string::npos);
  CHECK(complaint(two + "2\n0 5 5 0 1 0.5 0.5\n1 5 5 1 0 0.5 0.5\n", {0, 0}) ==
        "f:26: segments 1 and 0 cross twice");
  CHECK(complaint(two + "1\n0 5 5 0 2 0.5 0.5\n", {0, 0}).find("found '2', expected a segment") !=
        std::string::npos);
  CHECK(complaint("4\n0 0 0\n1 10 10\n2 0 10\n3 5 5\n\n2\n0 0 1 0\n1 2 3 0\n\n0\n", {0, 0}) ==
        "f:22: segments 0 and 1 meet in an end of one");
  CHECK(complaint("3\n0 0 0\n1 10 10\n2 20 20\n\n2\n0 0 1 0\n1 0 2 0\n\n0\n", {0}) ==
        "f:21: segments 0 and 1 leave point 0 in one direction");
  CHECK(complaint("2\n0 0 0\n1 10 10\n\n1\n0 1 1 0\n\n0\n", {0}) ==
        "f:19: found '1', expected another point than that where the segment begins");
  CHECK(complaint("2\n0 0 0\n1 10 1x\n\n1\n0 0 1 0\n\n0\n", {0}).find("found '1x'") != std::string::npos);
  CHECK(complaint("x\n").find("expected the number of points") != std::string::npos);
  // Two crossings of one segment the wrong way round.
  CHECK(complaint("6\n0 0 0\n1 30 0\n2 10 -10\n3 10 10\n4 20 -10\n5 20 10\n\n"
                  "3\n0 0 1 0\n1 2 3 0\n2 4 5 0\n\n2\n0 10 0 0 1 0.6 0.5\n1 20 0 0 2 0.3 0.5\n",
                  {0, 0, 0})
            .empty()); // a tree cannot show it
  CHECK(complaint(
            "6\n0 0 0\n1 30 0\n2 10 -10\n3 10 10\n4 20 -10\n5 20 10\n\n"
            "5\n0 0 1 0\n1 2 3 0\n2 4 5 0\n3 0 2 0\n4 4 1 0\n\n2\n0 10 0 0 1 0.6 0.5\n1 20 0 0 2 0.3 0.5\n",
            {0})
            .find("genus") != std::string::npos);
  // Whatever is cut off or spoilt, there is a diagram or one line that says why not.
  SplitMix64 random(8);
  const Curve curve = random_curve({{0, 1}, {0, 1}, {0, 1}}, 2, 2, random);
  const std::string whole = orb_file({0, 3, 2}, drawing_of(curve, false));
  REQUIRE(error_of([&] { (void)read_orb_diagram(whole, "f"); }).empty());
  int refused = 0;
  for (std::size_t k = 0; k < whole.size(); k += 3) {
    std::string spoilt = whole;
    spoilt[k] = static_cast<char>(32 + random.below(95));
    for (const std::string& text : {whole.substr(0, k), spoilt}) {
      const std::string message = error_of([&] { (void)read_orb_diagram(text, "f"); });
      refused += message.empty() ? 0 : 1;
      CHECK(message.find('\n') == std::string::npos);
    }
  }
  CHECK(refused > 100);
  std::string contradicting = orb_file({0, 0}, plane_k4);
  contradicting.replace(contradicting.find("\n2 2 0 "), 7, "\n2 1 3 ");
  CHECK(error_of([&] { (void)read_orb_diagram(contradicting, "f"); }) ==
        "f:6: found '1', expected a curve of one order, 0");
}
