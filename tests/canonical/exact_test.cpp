// SPDX-License-Identifier: GPL-2.0-or-later

/// The proof by exact algebra, fed with guesses that are wrong in one respect each.

#include "src/canonical/exact.hpp"

#include "proved.hpp"
#include "tetrarch/catalogue/manifold.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

using namespace tetrarch;
using namespace tetrarch::canonical;
using numeric::Algebraic;
using numeric::Ball;

namespace {

constexpr int bits_of_guess = 2000;

/// All tetrahedra regular with geodesic triangles, and -c the inner products of their vertices: the dihedral
/// angle is that with cosine c / (2 c - 1).
Decorated<Ball> regular(const Triangulation& tri, const Ball& c) {
  Decorated<Ball> m{tri, {}, {}};
  m.gram.resize(static_cast<std::size_t>(tri.size()));
  for (Gram<Ball>& w : m.gram)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) w[i][j] = i == j ? Ball(1) : -c;
  return m;
}

std::vector<Algebraic> guessed(const Decorated<Ball>& m, const Skeleton& skeleton) {
  const auto seen = numeric::recognize(products_to_guess(m, skeleton), 16);
  REQUIRE(seen);
  return seen->numbers;
}

FlatFaces none_flat(const Triangulation& tri) {
  return FlatFaces(static_cast<std::size_t>(tri.size()));
}

bool is_proved(const Triangulation& tri, const std::vector<Algebraic>& products) {
  return are_of_flat_structure(tri, Skeleton(tri), none_flat(tri), products);
}

/// A manifold of so many tetrahedra with one edge; its tetrahedra are regular.
Triangulation with_one_edge(int tets) {
  for (const catalogue::Manifold& m : catalogue::stored_table(tets))
    if (m.edges == 1) return from_signature(m.signature);
  return Triangulation();
}

Ball product_for_angle(int part, int whole) {
  const Ball cosine = cos(part * numeric::pi<Ball>() / whole);
  return cosine / (2 * cosine - 1);
}

/// The structure, each cusp with the same area, and the first inner product -1.
Decorated<Ball> cusped(const Triangulation& tri, const Skeleton& skeleton) {
  const auto found = hyperbolic::hyperbolize(tri, skeleton);
  const auto precise = verified::certify(tri, skeleton, found, {bits_of_guess, bits_of_guess, false});
  REQUIRE(precise.proof);
  Decorated<Ball> m = decorate(tri, skeleton, precise.proof->lengths);
  const Walk& w = skeleton.around(EdgeId(0)).front();
  const Ball first = abs(m.gram[w.tet][w.from()][w.to()]);
  for (Gram<Ball>& gram : m.gram)
    for (auto& row : gram)
      for (Ball& x : row) x /= first;
  return m;
}

void double_vectors(Decorated<Ball>& m, const Skeleton& skeleton, VertexId vertex) {
  for (const TetVertex v : skeleton.preimages(vertex))
    for (int k = 0; k < 4; ++k) {
      m.gram[v.tet][v.vertex][k] *= Ball(2);
      m.gram[v.tet][k][v.vertex] *= Ball(2);
    }
}

} // namespace

TEST_CASE("a right guess is proved, and no number of it may be another", "[canonical]") {
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(2);
  const Skeleton skeleton(tri);
  REQUIRE(skeleton.edge_count() == 1);
  const std::vector<Algebraic> right = guessed(regular(tri, (3 + sqrt(Ball(3))) / 4), skeleton);
  REQUIRE(right.size() == 1 + 4);
  CHECK(is_proved(tri, right));
  for (std::size_t k = 0; k < right.size(); ++k)
    for (const int by : {-1, 1}) {
      CAPTURE(k, by);
      std::vector<Algebraic> wrong = right;
      wrong[k] += Algebraic(by);
      CHECK_FALSE(is_proved(tri, wrong));
    }
}

TEST_CASE("a face that is not flat is not flat exactly", "[canonical]") {
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(2);
  const Skeleton skeleton(tri);
  const std::vector<Algebraic> right = guessed(regular(tri, (3 + sqrt(Ball(3))) / 4), skeleton);
  for (int f = 0; f < 4; ++f) {
    FlatFaces flat = none_flat(tri);
    const Gluing g = tri.gluing({0, f});
    flat[0][f] = flat[g.tet][g.perm[f]] = true;
    CHECK_FALSE(are_of_flat_structure(tri, skeleton, flat, right));
  }
}

TEST_CASE("angles near 2 pi are not 2 pi", "[canonical]") {
  // Twelve angles of 33.56 degrees: all tetrahedra exist and fit across faces, but not around the edge.
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(2);
  CHECK_FALSE(is_proved(tri, guessed(regular(tri, Ball(1.25)), Skeleton(tri))));
}

TEST_CASE("angles that add up to 4 pi make no structure", "[canonical]") {
  // Eighteen of 20 degrees do, eighteen of 40 do not, though they come back exactly.
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(3);
  const Skeleton skeleton(tri);
  REQUIRE(skeleton.around(EdgeId(0)).size() == 18);
  CHECK(is_proved(tri, guessed(regular(tri, product_for_angle(1, 9)), skeleton)));
  CHECK_FALSE(is_proved(tri, guessed(regular(tri, product_for_angle(2, 9)), skeleton)));
}

TEST_CASE("tetrahedra folded onto each other make no structure", "[canonical]") {
  // Each far vertex is where the near one is. Around an edge of twelve they come back as well.
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(2);
  std::vector<Algebraic> folded = guessed(regular(tri, (3 + sqrt(Ball(3))) / 4), Skeleton(tri));
  std::fill(folded.begin() + 1, folded.end(), Algebraic(1));
  CHECK_FALSE(is_proved(tri, folded));
}

TEST_CASE("a far vertex has its norm, and lies on the other side", "[canonical]") {
  // Four vectors of norm 1 with products -2; the fourth reflected in the others' span. By hand: its
  // projection there is 2/3 of their sum, of norm -4, so that 4/3, 4/3, 4/3, -1 are the coordinates, and -9
  // the product with the fourth.
  Gram<Algebraic> near;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) near[i][j] = Algebraic(i == j ? 1 : -2);
  for (int face = 0; face < 4; ++face) {
    CAPTURE(face);
    std::array<Algebraic, 4> products{Algebraic(-2), Algebraic(-2), Algebraic(-2), Algebraic(-2)};
    products[face] = Algebraic(-9);
    const auto a = far_vertex(near, products, Algebraic(1), face);
    REQUIRE(a);
    for (int k = 0; k < 4; ++k) CHECK((*a)[k] * Algebraic(3) == Algebraic(k == face ? -3 : 4));
    CHECK_FALSE(far_vertex(near, products, Algebraic(0), face)); // another norm
    products[face] = Algebraic(-8);                              // on the other side, but of norm -4 + 16/5
    CHECK_FALSE(far_vertex(near, products, Algebraic(1), face));
    products[face] = Algebraic(1); // the fourth itself
    CHECK_FALSE(far_vertex(near, products, Algebraic(1), face));
  }
}

TEST_CASE("cusps must have one area", "[canonical]") {
  // The Whitehead link, all of whose tetrahedra are alike, and m202, whose are not. Vectors of one cusp
  // doubled tell the same structure with another cross-section.
  const numeric::WorkingPrecision precise(bits_of_guess);
  for (const char* signature : {"eLPkbdcddhgggb", "eLMkbbdddemdxi"}) {
    CAPTURE(signature);
    const Triangulation tri = from_signature(signature);
    const Skeleton skeleton(tri);
    REQUIRE(skeleton.vertex_count() == 2);
    Decorated<Ball> m = cusped(tri, skeleton);
    CHECK(is_proved(tri, guessed(m, skeleton)));
    double_vectors(m, skeleton, VertexId(0));
    CHECK_FALSE(is_proved(tri, guessed(m, skeleton)));
    double_vectors(m, skeleton, VertexId(1));
    CHECK(is_proved(tri, guessed(m, skeleton)));
  }
}

TEST_CASE("an exact proof can be ended at each face and each edge", "[canonical]") {
  const numeric::WorkingPrecision precise(bits_of_guess);
  const Triangulation tri = with_one_edge(2);
  const Skeleton skeleton(tri);
  const std::vector<Algebraic> right = guessed(regular(tri, (3 + sqrt(Ball(3))) / 4), skeleton);
  for (int last = 1; last <= 4 + 1; ++last) {
    int asked = 0;
    const auto stop = [&] {
      if (++asked == last) throw std::runtime_error("enough");
    };
    CHECK_THROWS_WITH(are_of_flat_structure(tri, skeleton, none_flat(tri), right, stop), "enough");
  }
}
