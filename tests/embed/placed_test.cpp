// SPDX-License-Identifier: GPL-2.0-or-later

/// One tetrahedron, the isometries of R^{3,1}, the models and the Moebius transformations.

#include "hyperbolic/samples.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/embed/model.hpp"
#include "tetrarch/embed/placed.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <catch2/catch.hpp>
#include <complex>

using namespace tetrarch;
using namespace tetrarch::embed;
using hyperbolic::samples::between;
using numeric::Real50;
using support::Random;

namespace {

/// A product of boosts and rotations along random axes; moves the base point by at most `reach`.
Matrix4<double> random_isometry(Random& random, double reach, bool reversing = false) {
  Matrix4<double> m = identity<double>();
  if (reversing) m[0][0] = -1;
  for (int step = 0; step < 4; ++step) {
    const int axis = random.below(3);
    const double s = between(random, -reach / 4, reach / 4);
    Matrix4<double> boost = identity<double>();
    boost[axis][axis] = boost[3][3] = std::cosh(s);
    boost[axis][3] = boost[3][axis] = std::sinh(s);
    Matrix4<double> turn = identity<double>();
    const double angle = between(random, -3, 3);
    const int next = (axis + 1) % 3;
    turn[axis][axis] = turn[next][next] = std::cos(angle);
    turn[axis][next] = -std::sin(angle);
    turn[next][axis] = std::sin(angle);
    m = m * boost * turn;
  }
  return m;
}

Vector4<double> random_point(Random& random, double reach) {
  return random_isometry(random, reach) * base_point<double>;
}

} // namespace

TEST_CASE("a placed tetrahedron has the Gram matrix that its lengths say, whatever its vertices are") {
  Random random(1);
  int placed = 0;
  for (const VertexTypes& types : hyperbolic::samples::all_mixtures())
    for (int trial = 0; trial < 40; ++trial) {
      const auto lengths = hyperbolic::samples::some_lengths(types, random);
      if (!hyperbolic::exists(lengths, types)) continue;
      ++placed;
      const Perm4 hold = random.perm();
      const auto v = place(lengths, types, hold);
      const auto w = hyperbolic::gram_matrix(lengths, types);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) REQUIRE(inner(v[i], v[j]) == Approx(w[i][j]).margin(1e-10));
      // As the header draws it: the edge on the axis, then y = 0 with x > 0, then y > 0.
      REQUIRE(v[hold[0]][0] == 0);
      REQUIRE(v[hold[1]][1] == 0);
      REQUIRE(v[hold[2]][1] == 0);
      REQUIRE(v[hold[2]][0] > 0);
      REQUIRE(v[hold[3]][1] > 0);
      // The faces meet in the dihedral angles, and every normal points away from the vertex opposite.
      const auto angles = *hyperbolic::dihedral_angles(lengths, types);
      for (int e = 0; e < 6; ++e) {
        const auto [k, l] = edge_vertex[opposite_edge(e)];
        REQUIRE(inner(face_normal(v, k), face_normal(v, l)) == Approx(-std::cos(angles[e])).margin(1e-9));
      }
      for (int f = 0; f < 4; ++f) {
        REQUIRE(inner(face_normal(v, f), v[f]) < 0);
        for (const int i : face_vertex[f]) REQUIRE(inner(face_normal(v, f), v[i]) == Approx(0).margin(1e-9));
      }
    }
  CHECK(placed > 800);
}

TEST_CASE("the first truncation is the unit hemisphere, the second has radius e^l") {
  // Two tetrahedra of the knotted Y: all angles pi/6 (dissertation, section 4.3.4).
  hyperbolic::SixNumbers<double> angles;
  angles.fill(numeric::pi<double>() / 6);
  const auto lengths = *hyperbolic::lengths_from_angles(angles, hyperbolic::all_hyperideal);
  const auto v = place(lengths, hyperbolic::all_hyperideal);
  const auto first = circle_at_infinity(v[0]);
  CHECK(first.center == std::array<double, 2>{0, 0});
  CHECK(first.radius == Approx(1).epsilon(1e-14));
  CHECK(circle_at_infinity(v[1]).radius == Approx(std::exp(lengths[0])).epsilon(1e-13));
  // Faces 3 and 2 are vertical planes through the axis, pi/6 apart.
  const auto floor = circle_at_infinity(face_normal(v, 3));
  const auto other = circle_at_infinity(face_normal(v, 2));
  REQUIRE(floor.line);
  REQUIRE(other.line);
  CHECK(floor.radius == Approx(0).margin(1e-12));
  CHECK(other.radius == Approx(0).margin(1e-12));
  CHECK(floor.center[0] * other.center[0] + floor.center[1] * other.center[1] ==
        Approx(-std::cos(numeric::pi<double>() / 6)));
}

TEST_CASE("corners lie on both objects, an edge length apart") {
  Random random(2);
  for (const VertexTypes& types : hyperbolic::samples::all_mixtures())
    for (int trial = 0; trial < 10; ++trial) {
      const auto lengths = hyperbolic::samples::some_lengths(types, random);
      if (!hyperbolic::exists(lengths, types)) continue;
      const auto v = place(lengths, types);
      for (int e = 0; e < 6; ++e) {
        const auto [i, j] = edge_vertex[e];
        const auto p = corner(v, types, i, j);
        const auto q = corner(v, types, j, i);
        for (const auto& [x, at] : {std::pair{p, i}, std::pair{q, j}}) {
          REQUIRE(inner(x, x) == Approx(-1).epsilon(1e-9));
          REQUIRE(x[3] > 0);
          // On the plane, on the horosphere, or the point.
          const double expected = types[at] == VertexType::hyperideal ? 0 : -1;
          REQUIRE(inner(x, v[at]) == Approx(expected).margin(1e-9));
        }
        // A negative length: the two objects overlap along the edge.
        REQUIRE(distance(p, q) == Approx(std::abs(lengths[e])).margin(1e-7));
      }
    }
}

TEST_CASE("no tetrahedron is placed that does not exist") {
  hyperbolic::SixNumbers<double> lengths;
  lengths.fill(0.1);
  lengths[0] = 3; // against the triangle inequality, with finite vertices
  const hyperbolic::VertexTypes finite{VertexType::finite, VertexType::finite, VertexType::finite,
                                       VertexType::finite};
  REQUIRE_FALSE(hyperbolic::exists(lengths, finite));
  CHECK_THROWS_AS(place(lengths, finite), PreconditionError);
}

TEST_CASE("a motion takes a tetrahedron to its image, also in 50 digits") {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto lengths = hyperbolic::samples::some_lengths(hyperbolic::all_hyperideal, random);
    if (!hyperbolic::exists(lengths, hyperbolic::all_hyperideal)) continue;
    const auto v = place(lengths, hyperbolic::all_hyperideal);
    const Matrix4<double> m = random_isometry(random, 2, trial % 2 == 1);
    VertexVectors<double> image;
    for (int i = 0; i < 4; ++i) image[i] = m * v[i];
    REQUIRE(relative_difference(motion(v, image, hyperbolic::all_hyperideal), m) < 1e-11);
    hyperbolic::SixNumbers<Real50> precise;
    for (int e = 0; e < 6; ++e) precise[e] = lengths[e];
    const auto a = place(precise, hyperbolic::all_hyperideal);
    const auto b = place(precise, hyperbolic::all_hyperideal, Perm4(2, 0, 3, 1));
    REQUIRE(lorentz_defect(motion(a, b, hyperbolic::all_hyperideal)) < 1e-50);
  }
}

TEST_CASE("reorthonormalisation squares the defect") {
  Random random(4);
  for (int trial = 0; trial < 20; ++trial) {
    Matrix4<double> m = random_isometry(random, 1);
    for (auto& row : m)
      for (double& x : row) x += between(random, -1e-5, 1e-5);
    REQUIRE(lorentz_defect(m) > 1e-7);
    REQUIRE(lorentz_defect(reorthonormalized(m)) < 1e-13);
  }
}

TEST_CASE("distances agree near and far, with the metric of the half space") {
  // The distance of two points over the same place is the logarithm of the ratio of their heights.
  for (const double s : {1e-9, 1e-4, 0.3, 1.2, 1.4, 5.0, 40.0}) {
    const auto p = from_model(Model::half_space, {0.3, -0.2, 1});
    const auto q = from_model(Model::half_space, {0.3, -0.2, std::exp(-s)});
    CHECK(distance(p, q) == Approx(s).epsilon(1e-5));
  }
  CHECK(distance(base_point<double>, base_point<double>) == 0);
}

TEST_CASE("points come back from every model") {
  Random random(5);
  for (const Model model : {Model::half_space, Model::ball, Model::klein})
    for (int trial = 0; trial < 100; ++trial) {
      const auto x = random_point(random, 5);
      REQUIRE(distance(from_model(model, to_model(model, x)), x) < 1e-9);
    }
  CHECK_THROWS_AS(from_model(Model::half_space, {0, 0, 0}), PreconditionError);
  CHECK_THROWS_AS(from_model(Model::ball, {1, 0, 0}), PreconditionError);
  for (const Model model : {Model::half_space, Model::ball, Model::klein})
    CHECK(model_named(to_string(model)) == model);
}

TEST_CASE("circles at infinity are where the planes end, and normals point out of them") {
  Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const auto m = random_isometry(random, 3);
    const Vector4<double> n = m * Vector4<double>{1, 0, 0, 0};
    // Points of the plane: the image of x = 0, y = sinh s, far out on both sides.
    for (const double s : {-12.0, 12.0}) {
      const auto x = m * Vector4<double>{0, std::sinh(s), 0, std::cosh(s)};
      const auto p = to_model(Model::half_space, x);
      const auto circle = circle_at_infinity(n);
      if (circle.line) continue;
      REQUIRE(std::hypot(p[0] - circle.center[0], p[1] - circle.center[1], p[2]) ==
              Approx(circle.radius).epsilon(1e-6));
    }
    const auto x = m * base_point<double>;
    const auto beyond = m * Vector4<double>{std::sinh(1e-6), 0, 0, std::cosh(1e-6)}; // <beyond, n> > 0
    for (const Model model : {Model::half_space, Model::ball, Model::klein}) {
      const auto p = to_model(model, x);
      const auto q = to_model(model, beyond);
      const auto normal = plane_normal(model, n, p);
      const double along = (q[0] - p[0]) * normal[0] + (q[1] - p[1]) * normal[1] + (q[2] - p[2]) * normal[2];
      const double step = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      REQUIRE(along > 0);
      if (model != Model::klein) REQUIRE(along == Approx(step).epsilon(1e-4)); // these two are conformal
    }
  }
}

TEST_CASE("horospheres look round, and their normals point into the horoball") {
  Random random(7);
  const Vector4<double> v{0, 0, 1, 1}; // the horosphere z = 1 of the half space
  for (int trial = 0; trial < 100; ++trial) {
    const auto m = random_isometry(random, 2);
    const auto p0 = from_model(Model::half_space, {between(random, -1, 1), between(random, -1, 1), 1});
    REQUIRE(inner(p0, v) == Approx(-1));
    const auto above = from_model(Model::half_space, {to_model(Model::half_space, p0)[0],
                                                      to_model(Model::half_space, p0)[1], 1 + 1e-6});
    for (const Model model : {Model::half_space, Model::ball, Model::klein}) {
      const auto p = to_model(model, m * p0);
      const auto q = to_model(model, m * above);
      const auto normal = horosphere_normal(model, m * v, p);
      const double along = (q[0] - p[0]) * normal[0] + (q[1] - p[1]) * normal[1] + (q[2] - p[2]) * normal[2];
      REQUIRE(along > 0);
      if (model != Model::klein)
        REQUIRE(along == Approx(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2])).epsilon(1e-4));
    }
  }
}

TEST_CASE("Moebius transformations are a representation, up to sign, and act as the isometries do") {
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const auto m = random_isometry(random, 3, trial % 3 == 0);
    const auto n = random_isometry(random, 3, trial % 2 == 0);
    const auto a = mobius_of(m);
    const auto b = mobius_of(n);
    REQUIRE(a.reverses == (trial % 3 == 0));
    REQUIRE(relative_difference(composed(a, b), mobius_of(m * n)) < 1e-10);
    REQUIRE(relative_difference(lorentz_of(a), m) < 1e-11);
    // On the plane at infinity: zeta = w1 / w2 for the light-like vector w w*.
    const std::complex<double> zeta(between(random, -2, 2), between(random, -2, 2));
    const double s = std::norm(zeta);
    const Vector4<double> light{zeta.real(), zeta.imag(), (s - 1) / 2, (s + 1) / 2};
    const auto image = m * light;
    const std::complex<double> expected(image[0] / (image[3] - image[2]), image[1] / (image[3] - image[2]));
    const auto c = [](const Complex<double>& z) { return std::complex<double>(z.re, z.im); };
    const auto from = a.reverses ? std::conj(zeta) : zeta;
    REQUIRE(std::abs((c(a.a) * from + c(a.b)) / (c(a.c) * from + c(a.d)) - expected) <
            1e-9 * (1 + std::abs(expected)));
    REQUIRE(std::abs(c(a.a) * c(a.d) - c(a.b) * c(a.c) - 1.0) < 1e-11);
  }
  // A rotation by pi about the axis, where the trace vanishes: i and -i on the diagonal.
  Matrix4<double> half_turn = identity<double>();
  half_turn[0][0] = half_turn[1][1] = -1;
  CHECK(relative_difference(lorentz_of(mobius_of(half_turn)), half_turn) < 1e-15);
}
