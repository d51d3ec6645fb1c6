// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include "samples.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/hyperbolic/cosine_laws.hpp"
#include "tetrarch/numeric/scalar.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using samples::Random;

namespace {

Eigen::Matrix<double, 6, 6> eigen(const std::array<SixNumbers<double>, 6>& rows) {
  Eigen::Matrix<double, 6, 6> m;
  for (int e = 0; e < 6; ++e)
    for (int f = 0; f < 6; ++f) m(e, f) = rows[e][f];
  return m;
}

double worst(const SixNumbers<double>& a, const SixNumbers<double>& b) {
  double most = 0;
  for (int e = 0; e < 6; ++e) most = std::max(most, std::abs(a[e] - b[e]));
  return most;
}

double dot(const SixNumbers<double>& a, const SixNumbers<double>& b) {
  double sum = 0;
  for (int e = 0; e < 6; ++e) sum += a[e] * b[e];
  return sum;
}

SixNumbers<double> moved(const SixNumbers<double>& l, int edge, double by) {
  SixNumbers<double> m = l;
  m[edge] += by;
  return m;
}

/// Adds `by` at the three edges that end at vertex v: another horosphere there.
SixNumbers<double> with_horosphere_moved(SixNumbers<double> l, int v, double by) {
  for (int w = 0; w < 4; ++w)
    if (w != v) l[edge_number[v][w]] += by;
  return l;
}

} // namespace

TEST_CASE("signed lengths and inner products undo each other for every pair of types", "[tetrahedron]") {
  Random random(1);
  for (const VertexType a : {VertexType::finite, VertexType::ideal, VertexType::hyperideal})
    for (const VertexType b : {VertexType::finite, VertexType::ideal, VertexType::hyperideal})
      for (int round = 0; round < 20; ++round) {
        // Only distances between two planes or two points cannot be negative.
        const bool positive = a == b && a != VertexType::ideal;
        const double l = samples::between(random, positive ? 0.1 : -3, 3);
        const double w = inner_product(a, b, l);
        CHECK(signed_length(a, b, w) == Approx(l).epsilon(1e-13).margin(1e-13));
        CHECK(inner_product(b, a, l) == w);
      }
  CHECK(inner_product(VertexType::hyperideal, VertexType::hyperideal, -1.0) == -1);
  CHECK(signed_length(VertexType::hyperideal, VertexType::hyperideal, -0.5) == 0);
  CHECK_THROWS_AS(signed_length(VertexType::ideal, VertexType::finite, 0.5), PreconditionError);
}

TEST_CASE("two points and a plane on a line: distances add up", "[tetrahedron]") {
  // On the x-axis of H^3 a point at arc length s is (sinh s, 0, 0, cosh s), the plane perpendicular to it at
  // s has the pole (cosh s, 0, 0, sinh s), the horosphere around the end at +infinity through s is
  // e^(-s) (1, 0, 0, 1): hand-made vectors as witness of the six signed lengths.
  using Vector = std::array<double, 2>;
  const auto product = [](const Vector& v, const Vector& w) { return v[0] * w[0] - v[1] * w[1]; };
  const auto point = [](double s) { return Vector{std::sinh(s), std::cosh(s)}; };
  const auto right_plane = [](double s) { return Vector{std::cosh(s), std::sinh(s)}; };
  const auto left_plane = [](double s) { return Vector{-std::cosh(s), -std::sinh(s)}; };
  // -<x,v> = 1 at x = point(s).
  const auto right_horosphere = [](double s) { return Vector{std::exp(s), std::exp(s)}; };
  const auto left_horosphere = [](double s) { return Vector{-std::exp(-s), std::exp(-s)}; };
  const double p = -0.4;
  const double q = 0.9;
  const auto length = [&](VertexType a, const Vector& v, VertexType b, const Vector& w) {
    return signed_length(a, b, product(v, w));
  };
  const auto finite = VertexType::finite;
  const auto ideal = VertexType::ideal;
  const auto hyper = VertexType::hyperideal;
  const auto distance = Approx(q - p);
  CHECK(length(finite, point(p), finite, point(q)) == distance);
  CHECK(length(hyper, left_plane(p), hyper, right_plane(q)) == distance);
  CHECK(length(finite, point(p), hyper, right_plane(q)) == distance);
  CHECK(length(hyper, left_plane(p), ideal, right_horosphere(q)) == distance);
  CHECK(length(finite, point(p), ideal, right_horosphere(q)) == distance);
  CHECK(length(ideal, left_horosphere(p), ideal, right_horosphere(q)) == distance);
  CHECK(length(finite, point(q), hyper, right_plane(p)) == Approx(p - q));
}

TEST_CASE("regular tetrahedra: the angle is that of the closed formula", "[tetrahedron]") {
  // By symmetry all A_kk are equal: with w the common inner product and n the norm, cos theta = -w / (n + 2w)
  // (hand calculation with W = (n - w) I + w J).
  for (const double l : {0.4, 0.7, 1.0, 2.0, 5.0}) {
    for (const VertexType type : {VertexType::finite, VertexType::ideal, VertexType::hyperideal}) {
      const VertexTypes types{type, type, type, type};
      SixNumbers<double> lengths{};
      lengths.fill(l);
      const double w = inner_product(type, type, l);
      const auto angles = dihedral_angles(lengths, types);
      REQUIRE(angles);
      for (const double theta : *angles) CHECK(theta == Approx(std::acos(w / (norm(type) + 2 * w))));
    }
  }
  const auto regular_ideal = dihedral_angles(SixNumbers<double>{1, 1, 1, 1, 1, 1}, all_ideal);
  REQUIRE(regular_ideal);
  for (const double theta : *regular_ideal) CHECK(theta == Approx(numeric::pi<double>() / 3));
}

TEST_CASE("the cosine is A_kl / sqrt(A_kk A_ll), whatever the angle's own formula", "[tetrahedron]") {
  Random random(2);
  for (const VertexTypes& types : samples::all_mixtures())
    for (int round = 0; round < 20; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto a = numeric::adjugate(gram_matrix(lengths, types));
      const auto angles = extended_dihedral_angles(lengths, types);
      for (int e = 0; e < 6; ++e) {
        const auto [k, l] = edge_vertex[opposite_edge(e)];
        CHECK(std::cos(angles[e]) == Approx(a[k][l] / std::sqrt(a[k][k] * a[l][l])).margin(1e-9));
      }
    }
}

TEST_CASE("the angle sum at a vertex tells its type", "[tetrahedron]") {
  Random random(3);
  for (const VertexTypes& types : samples::all_mixtures())
    for (int round = 0; round < 20; ++round) {
      const auto angles = dihedral_angles(samples::existing_lengths(types, random), types);
      CHECK(vertex_types_of_angles(*angles, 1e-9) == types);
    }
}

TEST_CASE("angles to lengths to angles, and back to the lengths up to horospheres", "[tetrahedron]") {
  Random random(5);
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    for (int round = 0; round < 20; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto angles = extended_dihedral_angles(lengths, types);
      const auto back = lengths_from_angles(angles, types);
      REQUIRE(back);
      CHECK(worst(extended_dihedral_angles(*back, types), angles) < 1e-9);
      // Lengths at ideal vertices depend on the horosphere; the others come back as they were.
      for (int e = 0; e < 6; ++e) {
        const auto [i, j] = edge_vertex[e];
        if (types[i] != VertexType::ideal && types[j] != VertexType::ideal)
          CHECK((*back)[e] == Approx(lengths[e]).epsilon(1e-6));
      }
    }
  }
  CHECK_FALSE(lengths_from_angles(SixNumbers<double>{3, 3, 3, 3, 3, 3}, all_hyperideal));
  // All angles 1.2 make a compact tetrahedron (angle sum above pi), which has no hyperideal vertex.
  const SixNumbers<double> compact{1.2, 1.2, 1.2, 1.2, 1.2, 1.2};
  CHECK_FALSE(lengths_from_angles(compact, all_hyperideal));
  CHECK(vertex_types_of_angles(compact, 1e-9)[0] == VertexType::finite);
}

TEST_CASE("moving a horosphere changes no angle", "[tetrahedron]") {
  Random random(6);
  for (const VertexTypes& types : samples::all_mixtures())
    for (int v = 0; v < 4; ++v) {
      if (types[v] != VertexType::ideal) continue;
      const auto lengths = samples::existing_lengths(types, random);
      const auto other = with_horosphere_moved(lengths, v, 0.8);
      CHECK(worst(extended_dihedral_angles(lengths, types), extended_dihedral_angles(other, types)) < 1e-12);
    }
}

TEST_CASE("the dissertation's cosine laws lead to the same angles and back", "[tetrahedron][laws]") {
  Random random(7);
  for (int round = 0; round < 500; ++round) {
    const auto lengths = samples::existing_lengths(all_hyperideal, random);
    const auto angles = extended_dihedral_angles(lengths, all_hyperideal);
    CHECK(worst(angles_by_cosine_laws(lengths), angles) < 1e-9);
    CHECK(worst(lengths_by_cosine_laws(angles), lengths) < 1e-9);
    CHECK(worst(*lengths_from_angles(angles, all_hyperideal), lengths) < 1e-9);
    const auto by_lengths = triangle_sides_from_lengths(lengths);
    const auto by_angles = triangle_sides_from_angles(angles);
    for (int i = 0; i < 4; ++i)
      for (int l = 0; l < 4; ++l) CHECK(by_lengths[i][l] == Approx(by_angles[i][l]).margin(1e-12));
  }
}

TEST_CASE("the Jacobian is the finite difference of the angles", "[tetrahedron][jacobian]") {
  Random random(8);
  const double h = 1e-5;
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    for (int round = 0; round < 10; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto jacobian = angle_jacobian(lengths, types);
      for (int f = 0; f < 6; ++f) {
        const auto up = extended_dihedral_angles(moved(lengths, f, h), types);
        const auto down = extended_dihedral_angles(moved(lengths, f, -h), types);
        for (int e = 0; e < 6; ++e) {
          // Error of the central difference: h^2 times a third derivative that large entries bring along.
          const double scale = 1 + std::pow(std::abs(jacobian[e][f]), 3);
          CHECK(std::abs(jacobian[e][f] - (up[e] - down[e]) / (2 * h)) < 1e-6 * scale);
        }
      }
    }
  }
}

TEST_CASE("the Jacobian is symmetric; its kernel is the horospheres, its negative part the finite vertices",
          "[tetrahedron][jacobian]") {
  Random random(9);
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    int ideal = 0;
    int finite = 0;
    for (const VertexType type : types) {
      ideal += type == VertexType::ideal;
      finite += type == VertexType::finite;
    }
    for (int round = 0; round < 10; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto m = eigen(angle_jacobian(lengths, types));
      const double scale = m.cwiseAbs().maxCoeff();
      CHECK((m - m.transpose()).cwiseAbs().maxCoeff() <= 1e-13 * scale);
      for (int v = 0; v < 4; ++v) {
        if (types[v] != VertexType::ideal) continue;
        Eigen::Matrix<double, 6, 1> u;
        const auto move = with_horosphere_moved({0, 0, 0, 0, 0, 0}, v, 1);
        for (int e = 0; e < 6; ++e) u[e] = move[e];
        CHECK((m * u).cwiseAbs().maxCoeff() < 1e-10 * scale);
      }
      const Eigen::Matrix<double, 6, 1> values =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(m).eigenvalues();
      CHECK((values.array() < -1e-9 * scale).count() == finite);
      CHECK((values.array().abs() <= 1e-9 * scale).count() == ideal);
    }
  }
}

TEST_CASE("a tetrahedron that stops existing has angles 0 and pi, reached continuously", "[tetrahedron]") {
  // Opposite edges long, the others short: flat with angles pi at the long pair.
  const SixNumbers<double> flat{3, 0.5, 0.5, 0.5, 0.5, 3};
  CHECK_FALSE(exists(flat, all_hyperideal));
  CHECK_FALSE(dihedral_angles(flat, all_hyperideal));
  const auto angles = extended_dihedral_angles(flat, all_hyperideal);
  for (int e = 0; e < 6; ++e) CHECK(angles[e] == (e == 0 || e == 5 ? numeric::pi<double>() : 0));
  for (const auto& row : angle_jacobian(flat, all_hyperideal))
    for (const double d : row) CHECK(d == 0);
  // On a segment from a tetrahedron that exists the angles change by little between near points: they are
  // Hoelder continuous with exponent 1/2.
  SixNumbers<double> before{1, 1, 1, 1, 1, 1};
  for (int n = 0; n <= 100000; ++n) {
    SixNumbers<double> here{};
    for (int e = 0; e < 6; ++e) here[e] = 1 + (flat[e] - 1) * n / 100000.0;
    const auto now = extended_dihedral_angles(here, all_hyperideal);
    if (n > 0 && worst(now, before) > 0.05) FAIL("a jump at " << n);
    before = now;
  }
  // A negative length between hyperideal vertices is read as 0: no tetrahedron, but an angle.
  CHECK_FALSE(exists(SixNumbers<double>{-1, 1, 1, 1, 1, 1}, all_hyperideal));
  CHECK(extended_dihedral_angles(SixNumbers<double>{-1, 1, 1, 1, 1, 1}, all_hyperideal) ==
        extended_dihedral_angles(SixNumbers<double>{0, 1, 1, 1, 1, 1}, all_hyperideal));
}

TEST_CASE("the extended angles are a monotone map: the gradient of a convex function", "[tetrahedron]") {
  Random random(10);
  int missing = 0;
  for (const VertexTypes& types : samples::all_mixtures()) {
    if (samples::has_finite(types)) continue;
    for (int round = 0; round < 3000; ++round) {
      SixNumbers<double> a{};
      SixNumbers<double> b{};
      for (int e = 0; e < 6; ++e) {
        a[e] = samples::between(random, -1, 4);
        b[e] = round % 2 == 0 ? samples::between(random, -1, 4) : a[e] + samples::between(random, -0.3, 0.3);
      }
      missing += !exists(a, types);
      const auto at_a = extended_dihedral_angles(a, types);
      const auto at_b = extended_dihedral_angles(b, types);
      SixNumbers<double> l{};
      SixNumbers<double> theta{};
      for (int e = 0; e < 6; ++e) {
        l[e] = b[e] - a[e];
        theta[e] = at_b[e] - at_a[e];
      }
      if (dot(l, theta) < -1e-9) FAIL_CHECK(samples::name(types) << ": " << dot(l, theta));
    }
  }
  CHECK(missing > 10000); // of 48,000: the extension is what is tested here
}
