// SPDX-License-Identifier: GPL-2.0-or-later

/// Fundamental domains, the holonomy, pieces of the universal cover and unrolled boundaries.

#include "hyperbolic/samples.hpp"
#include "src/embed/isometry_table.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/embed/cover.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/embed/model.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;
using namespace tetrarch::embed;
using numeric::Real50;

namespace {

struct Embedded {
  explicit Embedded(const std::string& sig, double cusp_area = DomainOptions{}.cusp_area)
      : tri(from_signature(sig)), skeleton(tri), structure(hyperbolic::hyperbolize(tri, skeleton)),
        domain(fundamental_domain(tri, skeleton, structure, {cusp_area})) {}

  Triangulation tri;
  Skeleton skeleton;
  hyperbolic::Hyperbolization<double> structure;
  Domain<double> domain;
};

/// Two tetrahedra, one edge, genus 2, all angles pi/6 (dissertation, section 4.2.3).
const std::string knotted_y = "cPcbbbihq";
/// Witness: Regina's Example<3>::figureEight().
const std::string figure_eight = "cPcbbbiht";
/// fmp3_25, the one census manifold with a cusp beside its geodesic boundary.
const std::string both_kinds = "dLQacccjjkg";
/// The Gieseking manifold, Regina's Example<3>::gieseking(): one tetrahedron, not orientable.
const std::string gieseking = "bkaaid";

Embedded census_entry(const std::string& name) {
  return Embedded(catalogue::find_by_name(name)->signature);
}

double max_difference(const Vector4<double>& v, const Vector4<double>& w) {
  double most = 0;
  for (int k = 0; k < 4; ++k) most = std::max(most, std::abs(v[k] - w[k]));
  return most;
}

/// max over all copies of the relative difference to the word's product in 50 digits.
double largest_word_error(const Embedded& e, const Piece& piece, double within) {
  const auto precise = hyperbolic::refine<Real50>(e.skeleton, e.structure);
  const auto domain = fundamental_domain(e.tri, e.skeleton, precise.lengths);
  std::vector<Matrix4<Real50>> copies{identity<Real50>()};
  double most = 0;
  for (std::size_t c = 1; c < piece.copies.size(); ++c) {
    copies.push_back(copies[piece.parent[c]] * domain.faces[piece.letter[c]].pairing);
    if (piece.distance[c] > within) continue;
    double largest = 0;
    double error = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        largest = std::max(largest, std::abs(piece.copies[c][i][j]));
        error = std::max(error, std::abs(static_cast<double>(copies[c][i][j] - piece.copies[c][i][j])));
      }
    most = std::max(most, error / largest);
  }
  return most;
}

} // namespace

TEST_CASE("the domain of the knotted Y: two tetrahedra, six open faces in three pairs") {
  const Embedded e(knotted_y);
  // By hand: 8 faces, one pair of them glued inside; H1 = Z^2, so that no generator is trivial.
  CHECK(e.domain.faces.size() == 6);
  CHECK(e.domain.holonomy.size() == 3);
  for (const auto& face : e.domain.faces) {
    CHECK(face.hexagons.size() == 1);
    CHECK(relative_difference(face.pairing * e.domain.faces[face.partner].pairing, identity<double>()) <
          1e-11);
  }
  CHECK(e.domain.order == std::vector<int>{0, 1});
  // The first one lies as in section 4.4.2: the truncation at 0 is the unit hemisphere.
  CHECK(max_difference(e.domain.half_space * e.domain.vertices[0][0], {0, 0, -1, 0}) < 1e-12);
}

TEST_CASE("gluable faces come in pairs and look at other copies") {
  // Witness: counting by hand how the faces around each edge lie in the domain; every gluable face has as
  // many hexagons as its partner, and all hexagons of one look at the same copy (residuals measure that).
  int grouped = 0;
  for (int k = 1; k <= 151; ++k) {
    const Embedded e = census_entry("fmp3_" + std::to_string(k));
    std::size_t hexagons = 0;
    for (std::size_t f = 0; f < e.domain.faces.size(); ++f) {
      const auto& face = e.domain.faces[f];
      hexagons += face.hexagons.size();
      grouped += face.hexagons.size() > 1;
      REQUIRE(face.partner != static_cast<int>(f));
      REQUIRE(e.domain.faces[face.partner].partner == static_cast<int>(f));
      REQUIRE(e.domain.faces[face.partner].hexagons.size() == face.hexagons.size());
      // An open face looks at another copy.
      REQUIRE(relative_difference(face.pairing, identity<double>()) > 0.1);
    }
    // 12 faces, of which the tree of three tetrahedra glues 4; further generators may be trivial.
    REQUIRE(hexagons <= 8);
    REQUIRE(hexagons % 2 == 0);
  }
  CHECK(grouped > 0);
}

TEST_CASE("a generator that an edge shows to be trivial is no open face") {
  // Nine tetrahedra with edges of valence three: two of the three faces around one lie in the tree.
  const Embedded e("jLLzzQQccdffihhiiqffofafoaa");
  std::size_t hexagons = 0;
  for (const auto& face : e.domain.faces) {
    hexagons += face.hexagons.size();
    CHECK(relative_difference(face.pairing, identity<double>()) > 0.1);
  }
  CHECK(hexagons < 2 * e.domain.holonomy.size());
  CHECK(residuals(e.tri, e.skeleton, e.domain).seam < 1e-10);
}

TEST_CASE("all 8 + 151 manifolds: seams, relators, edges, boundary planes and areas") {
  Residuals worst;
  const auto raise = [](double& most, double x) { most = std::max(most, x); };
  int manifolds = 0;
  for (const auto& [tets, count] : {std::pair{2, 8}, std::pair{3, 151}})
    for (int k = 1; k <= count; ++k) {
      const Embedded e = census_entry("fmp" + std::to_string(tets) + "_" + std::to_string(k));
      const Residuals r = residuals(e.tri, e.skeleton, e.domain);
      raise(worst.seam, r.seam);
      raise(worst.relator, r.relator);
      raise(worst.relator_sl2c, r.relator_sl2c);
      raise(worst.edge_rotation, r.edge_rotation);
      raise(worst.boundary_plane, r.boundary_plane);
      raise(worst.gauss_bonnet, r.gauss_bonnet);
      ++manifolds;
    }
  CAPTURE(worst.seam, worst.relator, worst.relator_sl2c, worst.edge_rotation, worst.boundary_plane,
          worst.gauss_bonnet);
  CHECK(manifolds == 159);
  CHECK(worst.seam < 1e-10);
  CHECK(worst.relator < 1e-9);
  CHECK(worst.relator_sl2c < 1e-9);
  CHECK(worst.edge_rotation < 1e-10);
  CHECK(worst.boundary_plane < 1e-10);
  CHECK(worst.gauss_bonnet < 1e-9);
}

TEST_CASE("larger triangulations are placed in doubles: covers of the knotted Y") {
  // Of degree 5, by the same lengths as below; ten tetrahedra and five edges.
  const Triangulation y = from_signature(knotted_y);
  const auto cover = hyperbolic::samples::some_cyclic_cover(y, 5);
  REQUIRE(cover);
  const Skeleton skeleton(*cover);
  const auto lengths = hyperbolic::hyperbolize(*cover, skeleton).lengths;
  const auto domain = fundamental_domain(*cover, skeleton, lengths);
  const Residuals r = residuals(*cover, skeleton, domain);
  CHECK(domain.order.size() == 10);
  CHECK(r.seam < 1e-9);
  CHECK(r.edge_rotation < 1e-9);
  CHECK(r.boundary_plane < 1e-9);
  CHECK(r.gauss_bonnet < 1e-9);
  CHECK(r.relator_sl2c < 1e-9);
}

TEST_CASE("in 50 digits the residuals shrink to 1e-40") {
  for (const std::string& sig : {knotted_y, figure_eight}) {
    const Triangulation tri = from_signature(sig);
    const Skeleton skeleton(tri);
    const auto precise = hyperbolic::refine<Real50>(skeleton, hyperbolic::hyperbolize(tri, skeleton));
    const auto domain = fundamental_domain(tri, skeleton, precise.lengths);
    const Residuals r = residuals(tri, skeleton, domain);
    CHECK(r.seam < 1e-40);
    CHECK(r.relator < 1e-40);
    CHECK(r.relator_sl2c < 1e-40);
    CHECK(r.edge_rotation < 1e-40);
    CHECK(r.boundary_plane < 1e-40);
    CHECK(r.gauss_bonnet < 1e-40);
  }
}

TEST_CASE("the residuals see what is wrong") {
  Embedded e(knotted_y);
  REQUIRE(residuals(e.tri, e.skeleton, e.domain).seam < 1e-10);
  Domain<double> bent = e.domain;
  bent.vertices[1][2][0] += 1e-6;
  CHECK(residuals(e.tri, e.skeleton, bent).seam > 1e-8);
  CHECK(residuals(e.tri, e.skeleton, bent).edge_rotation > 1e-8);
  CHECK(residuals(e.tri, e.skeleton, bent).gauss_bonnet > 1e-8);
  CHECK(residuals(e.tri, e.skeleton, bent).boundary_plane > 1e-8);
  bent = e.domain;
  for (auto& g : bent.holonomy) g = g * g;
  CHECK(residuals(e.tri, e.skeleton, bent).relator > 0.1);
  CHECK(residuals(e.tri, e.skeleton, bent).relator_sl2c > 0.1);
}

TEST_CASE("cusps and boundaries that are not orientable embed alike") {
  int seen = 0;
  int not_orientable = 0;
  int with_cusps = 0;
  for (const std::string& sig : {gieseking, figure_eight, both_kinds, std::string("eLPkbcddddcwjb")}) {
    const Embedded e(sig);
    const Residuals r = residuals(e.tri, e.skeleton, e.domain);
    CAPTURE(sig);
    CHECK(r.seam < 1e-10);
    CHECK(r.relator < 1e-9);
    CHECK(r.relator_sl2c < 1e-9);
    CHECK(r.edge_rotation < 1e-10);
    ++seen;
    not_orientable += !e.skeleton.is_orientable();
    for (const auto& types : e.domain.types)
      with_cusps += std::count(types.begin(), types.end(), VertexType::ideal) > 0;
  }
  CHECK(seen == 4);
  CHECK(not_orientable >= 1);
  CHECK(with_cusps > 0);
}

TEST_CASE("the cusp of the figure eight knot is cut off at the area asked for") {
  for (const double area : {0.1, 0.5}) {
    const Embedded e(figure_eight, area);
    // Heron's formula on the corners, whose Euclidean distances on the horosphere are their distances in
    // R^{3,1}.
    double sum = 0;
    for (int t = 0; t < 2; ++t)
      for (int i = 0; i < 4; ++i) {
        std::array<Vector4<double>, 3> c;
        for (int k = 0; k < 3; ++k)
          c[k] = corner(e.domain.vertices[t], e.domain.types[t], i, face_vertex[i][k]);
        std::array<double, 3> side;
        for (int k = 0; k < 3; ++k) {
          const auto d = combination(1.0, c[k], -1.0, c[(k + 1) % 3]);
          side[k] = std::sqrt(inner(d, d));
        }
        const double s = (side[0] + side[1] + side[2]) / 2;
        sum += std::sqrt(s * (s - side[0]) * (s - side[1]) * (s - side[2]));
      }
    CHECK(sum == Approx(area).epsilon(1e-10));
  }
  // A large area would make horospheres overlap; then they are moved out. The largest embedded cusp of the
  // figure eight has area 2 sqrt(3), where it touches itself.
  const Embedded crowded(figure_eight, 2 * std::sqrt(3.0) * 1.01);
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const auto& v = crowded.domain.vertices[0];
    CHECK(inner(v[i], v[j]) <= -2 * std::exp(0.2) * (1 - 1e-12));
  }
}

TEST_CASE("the holonomy of the figure eight knot has traces in Z[omega]") {
  // Riley 1975: the group is a subgroup of PSL(2, Z[omega]), omega = (-1 + sqrt(-3)) / 2; traces are
  // conjugation invariant, hence a + b omega with integers.
  const Embedded e(figure_eight);
  for (std::size_t g = 0; g < e.domain.holonomy.size(); ++g)
    for (std::size_t h = 0; h < e.domain.holonomy.size(); ++h) {
      const auto m = mobius_of(e.domain.holonomy[g] * e.domain.holonomy[h]);
      const double b = (m.a.im + m.d.im) / (std::sqrt(3.0) / 2);
      const double a = m.a.re + m.d.re + b / 2;
      CHECK(std::abs(a - std::round(a)) < 1e-9);
      CHECK(std::abs(b - std::round(b)) < 1e-9);
    }
}

TEST_CASE("100,000 copies of the knotted Y, each once") {
  const Embedded e(knotted_y);
  const Piece piece = universal_cover(e.domain, {100'000, 0, 0});
  REQUIRE(piece.copies.size() == 100'000);
  CHECK(piece.complete);
  // The two kinds of pairs are far apart: same copies to rounding, different ones by their displacement.
  CHECK(piece.largest_duplicate < 1e-8);
  CHECK(piece.closest > 1e-4);
  // A second route to "each once": sorted by where the copies take a point without symmetry, neighbours
  // differ.
  const Vector4<double> probe = normalized(Vector4<double>{0.21, 0.13, 0.34, 1});
  std::vector<std::array<double, 4>> images;
  for (const auto& copy : piece.copies) images.push_back(copy * probe);
  std::sort(images.begin(), images.end());
  double closest = 1;
  for (std::size_t k = 0; k + 1 < images.size(); ++k)
    for (std::size_t l = k + 1; l < images.size() && images[l][0] - images[k][0] < 0.01; ++l)
      closest = std::min(closest, distance(images[k], images[l]));
  CHECK(closest > 0.1);
  for (std::size_t c = 1; c < piece.copies.size(); ++c)
    REQUIRE(piece.length[c] == piece.length[piece.parent[c]] + 1);
}

TEST_CASE("words within distance 12 are right to 1e-9") {
  const Embedded y(knotted_y);
  CHECK(largest_word_error(y, universal_cover(y.domain, {20'000, 0, 0}), 12) < 1e-9);
  const Embedded cusped("eLAkbccddhhnxk");
  CHECK(largest_word_error(cusped, universal_cover(cusped.domain, {20'000, 0, 0}), 12) < 1e-9);
}

TEST_CASE("copies by word length are the ball of the group's Cayley graph") {
  // Witness: words in the pairings written out, told apart by their matrices, without hashing.
  const Embedded e = census_entry("fmp3_7");
  std::vector<Matrix4<double>> ball{identity<double>()};
  std::vector<std::size_t> sizes{1};
  std::size_t first = 0;
  for (int length = 1; length <= 3; ++length) {
    const std::size_t last = ball.size();
    for (; first < last; ++first)
      for (const auto& face : e.domain.faces) {
        const Matrix4<double> m = ball[first] * face.pairing;
        if (std::none_of(ball.begin(), ball.end(),
                         [&](const auto& n) { return relative_difference(m, n) < 1e-6; }))
          ball.push_back(m);
      }
    sizes.push_back(ball.size());
  }
  for (int length = 1; length <= 3; ++length) {
    const Piece piece = universal_cover(e.domain, {0, length, 0});
    CHECK(piece.copies.size() == sizes[length]);
    CHECK(*std::max_element(piece.length.begin(), piece.length.end()) == length);
  }
}

TEST_CASE("copies by radius: none is missed, cusps or not") {
  // Witness: all copies of much larger balls by word length, sifted by distance.
  for (const std::string& sig : {knotted_y, figure_eight, both_kinds, std::string("eLAkbccddhhnxk")}) {
    const Embedded e(sig);
    const Piece by_words = universal_cover(e.domain, {200'000, 0, 0});
    for (const double radius : {1.3, 1.9, 2.5}) {
      const Piece by_radius = universal_cover(e.domain, {0, 0, radius});
      const auto count = [radius](const Piece& piece) {
        return std::count_if(piece.distance.begin(), piece.distance.end(),
                             [&](double d) { return d <= radius; });
      };
      CAPTURE(sig, radius);
      CHECK(count(by_radius) == count(by_words));
      CHECK(by_radius.complete);
      // What lies outside leads to something inside.
      std::vector<char> leads(by_radius.copies.size(), 0);
      for (std::size_t c = by_radius.copies.size(); c-- > 1;) {
        REQUIRE((leads[c] || by_radius.distance[c] <= radius));
        leads[by_radius.parent[c]] = 1;
      }
    }
    const Piece by_radius = universal_cover(e.domain, {0, 0, 2.5});
    CHECK(by_radius.copies.size() > 5);
    // It hangs together: every copy's parent is there and next to it.
    for (std::size_t c = 1; c < by_radius.copies.size(); ++c) {
      REQUIRE(by_radius.parent[c] >= 0);
      REQUIRE(relative_difference(by_radius.copies[by_radius.parent[c]] *
                                      e.domain.faces[by_radius.letter[c]].pairing,
                                  by_radius.copies[c]) < 1e-9);
    }
  }
}

TEST_CASE("a word leads to its copy") {
  const Embedded e(knotted_y);
  const Piece piece = universal_cover(e.domain, {500, 0, 0});
  for (const int c : {0, 1, 77, 499}) {
    Matrix4<double> m = identity<double>();
    for (const int letter : word_to(piece, c)) m = m * e.domain.faces[letter].pairing;
    CHECK(relative_difference(m, piece.copies[c]) < 1e-10);
    CHECK(static_cast<int>(word_to(piece, c).size()) == piece.length[c]);
  }
}

TEST_CASE("a piece needs a bound, and says when it was cut off") {
  const Embedded e(knotted_y);
  CHECK_THROWS_AS(universal_cover(e.domain, {}), PreconditionError);
  CHECK_THROWS_AS(universal_cover(e.domain, {-1, 0, 0}), PreconditionError);
  CHECK_FALSE(universal_cover(e.domain, {10, 3, 0}).complete);
  CHECK(universal_cover(e.domain, {1000, 1, 0}).complete);
}

TEST_CASE("a geodesic boundary unrolls into the plane y = 0, seen from outside") {
  for (const std::string& sig : {knotted_y, both_kinds}) {
    const Embedded e(sig);
    const auto lifts = boundary_lifts(e.tri, e.skeleton, e.domain);
    REQUIRE_FALSE(lifts.empty());
    for (const BoundaryLift& lift : lifts) {
      CHECK(lift.triangles.size() == e.skeleton.preimages(lift.vertex).size());
      CHECK(lift.off_surface < 1e-10);
      const Vector4<double> surface =
          lift.type == VertexType::hyperideal ? Vector4<double>{0, 1, 0, 0} : Vector4<double>{0, 0, 1, 1};
      const double expected = lift.type == VertexType::hyperideal ? 0 : -1;
      for (const auto& corners : lift.corners)
        for (const auto& x : corners) REQUIRE(inner(x, surface) == Approx(expected).margin(1e-9));
      for (const auto& g : lift.pairings) {
        const auto image = g * surface;
        for (int k = 0; k < 4; ++k) REQUIRE(image[k] == Approx(surface[k]).margin(1e-9));
      }
      // A surface of chi triangles with n triangles has n + 2 open sides in a polygon (a tree of triangles).
      CHECK(lift.pairings.size() <= lift.triangles.size() + 2);
      // The middle of the first triangle is the base point.
      const auto& c = lift.corners.front();
      CHECK(distance(normalized(combination(1.0, combination(1.0, c[0], 1.0, c[1]), 1.0, c[2])),
                     base_point<double>) < (lift.type == VertexType::hyperideal ? 1e-9 : 1));
    }
  }
}

TEST_CASE("an unrolled boundary is seen from outside, not in a mirror") {
  // Tetrahedron 0 is positively handed where it lies: from outside its face i shows outward(i)
  // counter-clockwise, so that from vertex i, beyond the truncation, the edges to those vertices leave it
  // clockwise.
  for (const std::string& sig : {knotted_y, both_kinds, figure_eight}) {
    const Embedded e(sig);
    const auto hands = orientation(e.tri);
    REQUIRE(hands);
    for (const BoundaryLift& lift : boundary_lifts(e.tri, e.skeleton, e.domain))
      for (std::size_t k = 0; k < lift.triangles.size(); ++k) {
        const TetVertex at = lift.triangles[k];
        const OrientedTetFace order = outward({at.tet, at.vertex});
        std::array<std::array<double, 2>, 3> p;
        for (int c = 0; c < 3; ++c) {
          const int vertex = c == 0 ? order.a : c == 1 ? order.b : order.c;
          const auto q = to_model(Model::half_space, lift.corners[k][face_corner(at.vertex, vertex)]);
          // The plane y = 0 from the side y < 0; the plane z = 1 from above.
          p[c] = {q[0], lift.type == VertexType::hyperideal ? q[2] : q[1]};
        }
        const double area =
            (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
        REQUIRE(area * (*hands)[at.tet] < 0);
      }
  }
}

TEST_CASE("an isometry is found again wherever rounding puts it") {
  // Boosts whose image of the base point lies on the border of a cell, from just below it to just above.
  for (const int cell : {-700, -3, 0, 5, 64, 900})
    for (const double off : {-1e-10, -1e-13, 0.0, 1e-13, 1e-10}) {
      const double x = (cell - 0.3819660112501051) / 1024;
      const auto boost = [](double speed) {
        const double t = 1 / std::sqrt(1 - speed * speed);
        return boost_to(Vector4<double>{speed * t, 0, 0, t});
      };
      std::vector<Matrix4<double>> list{boost(x + off)};
      IsometryTable table(list);
      table.add_last();
      CHECK(table.find(boost(x - off)) == 0);
      CHECK(table.find(boost(x + 1e-5)) == -1);
    }
}

TEST_CASE("the tiling of a boundary covers the disk: areas add up, and copies do not overlap") {
  const Embedded e(knotted_y);
  const auto lift = boundary_lifts(e.tri, e.skeleton, e.domain).front();
  // Genus 2 has area 4 pi; of a disk of radius R, area 2 pi (cosh R - 1), the copies whose centres lie in it
  // fill about as much: exactly so when counted with a smooth enough weight, within 15 percent here.
  const double radius = 5;
  const Piece piece = group_piece(lift.pairings, lift.size, {0, 0, radius});
  // None is missed: all of a much larger ball by word length, sifted.
  const Piece by_words = group_piece(lift.pairings, lift.size, {100'000, 0, 0});
  const auto count = [&](const Piece& p) {
    return std::count_if(p.distance.begin(), p.distance.end(), [&](double d) { return d <= radius; });
  };
  const auto inside = count(piece);
  CHECK(count(by_words) == inside);
  const double pi = numeric::pi<double>();
  const double expected = 2 * pi * (std::cosh(radius) - 1) / (4 * pi);
  CHECK(static_cast<double>(inside) == Approx(expected).epsilon(0.15));
}

TEST_CASE("the caller's mistakes are told") {
  const Embedded e(knotted_y);
  hyperbolic::Hyperbolization<double> none;
  CHECK_THROWS_AS(fundamental_domain(e.tri, e.skeleton, none), PreconditionError);
  CHECK_THROWS_AS(fundamental_domain(e.tri, e.skeleton, Metric<double>(3, 1.0)), PreconditionError);
  const Triangulation ball = from_signature("baa"); // one tetrahedron with four boundary faces
  const Skeleton skeleton(ball);
  CHECK_THROWS_AS(fundamental_domain(ball, skeleton, Metric<double>(6, 1.0)), PreconditionError);
}
