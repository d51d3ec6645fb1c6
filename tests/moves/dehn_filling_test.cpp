// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/dehn_filling.hpp"

#include "support/homology.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/snappea.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/identify/recognise.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace tetrarch;
using namespace tetrarch::moves;
using support::first_homology;

namespace {

using Flow = std::int64_t;

/// The Whitehead link as SnapPea's kernel writes it, with these slopes on its cusps, and filled so.
Triangulation filled_link(int m0, int l0, int m1 = 0, int l1 = 0) {
  std::string text =
      format::read_file(std::string(TETRARCH_SOURCE_DIR) + "/tests/data/format/tri/kernel_whitehead.tri");
  const std::string complete = "torus   0.000000000000   0.000000000000";
  for (const auto& [m, l] : {std::pair{m0, l0}, std::pair{m1, l1}}) {
    const std::size_t at = text.find(complete);
    text.replace(at, complete.size(), "torus " + std::to_string(m) + " " + std::to_string(l) + " ");
  }
  return filled(format::read_snappea(text, "whitehead.tri").triangulation,
                format::read_dehn_fillings(text, "whitehead.tri").curves);
}

/// A curve on the cusp of the figure-eight knot complement cPcbbbiht: so many meridians and longitudes, as
/// the kernel chooses them there (Regina 7.3). Both bound as in the 3-sphere.
CuspCurves on_figure_eight(Flow m, Flow l) {
  constexpr std::array<std::array<std::array<int, 16>, 2>, 2> curves{
      {{{{0, 0, 0, 0, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0},
         {0, -1, 0, 1, 1, 0, -2, 1, 0, 1, 0, -1, 0, -1, 1, 0}}},
       {{{0, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
         {0, -1, 2, -1, -1, 0, 0, 1, 0, -1, 0, 1, 0, 1, -1, 0}}}}};
  CuspCurves made(2);
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t k = 0; k < 16; ++k) made[t][k / 4][k % 4] = m * curves[t][0][k] + l * curves[t][1][k];
  return made;
}

/// Its gluings in the order of the above: both tetrahedra on each other by 0132 1302 1023 2031.
Triangulation figure_eight() {
  Triangulation tri(2);
  tri.glue({0, 0}, 1, Perm4(0, 1, 3, 2));
  tri.glue({0, 1}, 1, Perm4(1, 3, 0, 2));
  tri.glue({0, 2}, 1, Perm4(1, 0, 2, 3));
  tri.glue({0, 3}, 1, Perm4(2, 0, 3, 1));
  return tri;
}

void check_closed(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  REQUIRE(check(skeleton).empty());
  REQUIRE_FALSE(skeleton.has_boundary_faces());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) REQUIRE(skeleton.link(v).is_sphere());
}

} // namespace

TEST_CASE("fillings of the figure-eight knot complement are homology lens spaces", "[filling]") {
  for (int p = 0; p <= 9; ++p)
    for (int q = -5; q <= 5; ++q) {
      if (std::gcd(p, q) != 1) continue;
      INFO(p << ", " << q);
      const Triangulation tri = filled(figure_eight(), on_figure_eight(p, q));
      check_closed(tri);
      CHECK(first_homology(tri) == (p == 0 ? "Z" : p == 1 ? "0" : "Z/" + std::to_string(p)));
      CHECK(Skeleton(tri).is_orientable());
    }
}

TEST_CASE("the meridian's filling is the 3-sphere", "[filling]") {
  CHECK(identify::recognise(truncate(filled(figure_eight(), on_figure_eight(1, 0))).tri).name == "S^3");
  CHECK(identify::recognise(truncate(filled(figure_eight(), on_figure_eight(-1, 0))).tri).name == "S^3");
}

TEST_CASE("one cusp filled, the other stays", "[filling]") {
  // The longitude of the file is the knot's with two meridians, so H1 = Z + Z/|p - 2 q| (Regina 7.3 says so
  // of seven of them).
  for (int p = -7; p <= 7; ++p)
    for (int q = 0; q <= 5; ++q) {
      if (std::gcd(p, q) != 1) continue;
      INFO(p << ", " << q);
      const Triangulation tri = truncate(filled_link(p, q)).tri;
      const Skeleton skeleton(tri);
      REQUIRE(check(skeleton).empty());
      REQUIRE(skeleton.vertex_count() == 1);
      CHECK(skeleton.link(VertexId(0)).euler == 0);
      const int torsion = std::abs(p - 2 * q);
      CHECK(first_homology(tri) == (torsion == 0   ? "Z^2"
                                    : torsion == 1 ? "Z"
                                                   : "Z + Z/" + std::to_string(torsion)));
    }
}

TEST_CASE("both cusps filled", "[filling]") {
  // Linking number 0, and longitudes with two meridians each: H1 = Z/|p - 2 q| + Z/|r - 2 s|.
  const Triangulation tri = filled_link(5, 1, -5, 1);
  check_closed(tri);
  CHECK(first_homology(tri) == "Z/21");
  check_closed(filled_link(3, 1, 1, 0));
  CHECK(identify::recognise(truncate(filled_link(1, 0, 1, 0)).tri).name == "S^3");
}

TEST_CASE("curves that are none, or too many, are refused", "[filling]") {
  const auto why = [](const CuspCurves& curves) { return why_not_fill(figure_eight(), curves).value_or(""); };
  CHECK(why(on_figure_eight(3, 1)).empty());
  CHECK(why(on_figure_eight(0, 0)).empty()); // no curve, nothing to fill
  CHECK(why(on_figure_eight(4, 2)) == "a curve runs 2 times along another at vertex 0 of tetrahedron 0");
  CHECK(why({}) == "there are not as many entries as tetrahedra");
  CuspCurves curves = on_figure_eight(1, 0);
  curves[0][1][2] += 1;
  CHECK(why(curves) == "the curve does not leave as often as it enters at vertex 1 of tetrahedron 0");
  curves[0][1][3] -= 1;
  CHECK(why(curves).find("the curve breaks off at vertex") == 0);
  CHECK_THROWS_AS(filled(figure_eight(), curves), PreconditionError);
  CHECK(why(on_figure_eight(1'000'000, 1)).find("too long") != std::string::npos);
  // A small circle around a vertex of the torus: into each triangle at one side, out at the next.
  const Triangulation tri = figure_eight();
  const Skeleton skeleton(tri);
  CuspCurves circle(2);
  for (const Walk& w : skeleton.around(EdgeId(0))) {
    circle[w.tet][w.from()][w.left_face().face] += 1;
    circle[w.tet][w.from()][w.right_face().face] -= 1;
  }
  CHECK(why(circle).find("a curve bounds a disk") == 0);
  // A cusp with a Klein bottle: a curve across one face and back.
  const Triangulation gieseking = support::zoo("Gieseking manifold m000").triangulation();
  CuspCurves any(1);
  const Skeleton around(gieseking);
  for (const Walk& w : around.around(EdgeId(0))) {
    any[0][w.from()][w.left_face().face] += 1;
    any[0][w.from()][w.right_face().face] -= 1;
  }
  CHECK(why_not_fill(gieseking, any).value_or("").find("there is no torus") == 0);
}

TEST_CASE("long slopes take a layer for each step of Euclid's algorithm", "[filling]") {
  const int base = filled(figure_eight(), on_figure_eight(1, 0)).size();
  CHECK(filled(figure_eight(), on_figure_eight(987, 610)).size() < base + 40); // Fibonacci numbers
  CHECK(filled(figure_eight(), on_figure_eight(1, 1000)).size() > base + 900);
  CHECK(first_homology(filled(figure_eight(), on_figure_eight(987, 610))) == "Z/987");
}
