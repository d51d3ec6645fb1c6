// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/volume.hpp"

#include "samples.hpp"
#include "tetrarch/hyperbolic/real50.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using samples::Random;

namespace {

SixNumbers<double> all_angles(double theta) {
  return {theta, theta, theta, theta, theta, theta};
}

SixNumbers<Real50> precise(const SixNumbers<double>& numbers) {
  SixNumbers<Real50> out;
  for (int e = 0; e < 6; ++e) out[e] = numbers[e];
  return out;
}

} // namespace

TEST_CASE("Clausen's function: known values and functional equations", "[clausen]") {
  // Catalan's constant Cl(pi/2) and Gieseking's constant Cl(pi/3), the volume of the regular ideal
  // tetrahedron (OEIS A006752 and A143298).
  const Real50 catalan("0.915965594177219015054603514932384110774149374281672134266498");
  const Real50 gieseking("1.01494160640965362502120255427452028594168930753029979201749");
  const Real50 turn = 2 * pi<Real50>();
  CHECK(abs(clausen(Real50(turn / 4)) - catalan) < 1e-57);
  CHECK(abs(clausen(Real50(turn / 6)) - gieseking) < 1e-57);
  CHECK(clausen(0.0) == 0);
  CHECK(std::abs(clausen(pi<double>())) < 1e-15);
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const Real50 x = samples::between(random, -7, 7);
    CHECK(abs(clausen(Real50(-x)) + clausen(x)) < 1e-57);
    CHECK(abs(clausen(Real50(x + turn)) - clausen(x)) < 1e-56);
    // The duplication formula Cl(2x) = 2 Cl(x) - 2 Cl(pi - x).
    CHECK(abs(clausen(Real50(2 * x)) - 2 * clausen(x) + 2 * clausen(Real50(turn / 2 - x))) < 1e-55);
    CHECK(std::abs(clausen(static_cast<double>(x)) - static_cast<double>(clausen(x))) < 1e-14);
  }
}

TEST_CASE("Clausen's function is the sum of sin(n x) / n^2", "[clausen]") {
  for (const double x : {0.3, 1.0, 2.0, 2.5, 3.1}) {
    double sum = 0;
    for (int n = 2'000'000; n >= 1; --n) sum += std::sin(n * x) / (static_cast<double>(n) * n);
    CHECK(clausen(x) == Approx(sum).margin(1e-10));
  }
}

TEST_CASE("volumes that others have printed", "[volume]") {
  // Frigerio, Martelli, Petronio 2004: two regular truncated tetrahedra with angles pi/6, three with pi/9.
  CHECK(2 * volume(all_angles(pi<double>() / 6)) == Approx(6.451990270835).epsilon(1e-12));
  CHECK(3 * volume(all_angles(pi<double>() / 9)) == Approx(10.428601580236).epsilon(1e-12));
  // Milnor: the regular ideal tetrahedron and the regular ideal octahedron (all angles 0: the truncation
  // triangles have become ideal, and what remains is the octahedron).
  CHECK(volume(all_angles(pi<double>() / 3)) == Approx(1.014941606410).epsilon(1e-12));
  CHECK(volume(all_angles(0)) == Approx(3.663862376709).epsilon(1e-12));
  // The octahedron's volume is 4 times Catalan's constant: in all 60 digits.
  SixNumbers<Real50> zero;
  zero.fill(Real50(0));
  CHECK(abs(volume(zero) - 4 * clausen(Real50(pi<Real50>() / 2))) < 1e-55);
}

TEST_CASE("ideal tetrahedra: Milnor's sum of three Lobachevsky functions", "[volume]") {
  // V = L(a) + L(b) + L(c) with L(x) = Cl(2x) / 2, opposite angles equal: an independent formula.
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    const double a = samples::between(random, 0.05, 1.5);
    const double b = samples::between(random, 0.05, 1.5);
    const double c = pi<double>() - a - b;
    const double milnor = (clausen(2 * a) + clausen(2 * b) + clausen(2 * c)) / 2;
    CHECK(volume(SixNumbers<double>{a, b, c, c, b, a}) == Approx(milnor).margin(1e-12));
  }
}

TEST_CASE("orthoschemes with three right angles: the Coxeter tetrahedra [3,5,3], [5,3,4], [5,3,5]",
          "[volume]") {
  // Johnson, Kellerhals, Ratcliffe, Tschantz, "The size of a hyperbolic Coxeter simplex", 1999: the three
  // compact linear ones. The angle between consecutive walls k, k+1 is pi over the label, all others are
  // right; the angle between walls k, l is at the edge opposite edge kl.
  const auto orthoscheme = [](int p, int q, int r) {
    SixNumbers<double> angles = all_angles(pi<double>() / 2);
    angles[opposite_edge(edge_number[0][1])] = pi<double>() / p;
    angles[opposite_edge(edge_number[1][2])] = pi<double>() / q;
    angles[opposite_edge(edge_number[2][3])] = pi<double>() / r;
    return volume(angles);
  };
  CHECK(orthoscheme(3, 5, 3) == Approx(0.0390502856).margin(1e-10));
  CHECK(orthoscheme(5, 3, 4) == Approx(0.0358850633).margin(1e-10));
  CHECK(orthoscheme(5, 3, 5) == Approx(0.0933255395).margin(1e-10));
}

TEST_CASE("a flat or non-hyperbolic set of angles has no volume", "[volume]") {
  CHECK(volume(SixNumbers<double>{pi<double>(), 0, 0, 0, 0, pi<double>()}) == 0);
  // The regular Euclidean and a spherical tetrahedron.
  CHECK(volume(all_angles(std::acos(1.0 / 3))) < 1e-6);
  CHECK(volume(all_angles(1.5)) == 0);
}

TEST_CASE("the arguments of the dilogarithms have modulus one", "[volume]") {
  Random random(3);
  for (const VertexTypes& types : samples::all_mixtures())
    for (int round = 0; round < 5; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto angles = *dihedral_angles(precise(lengths), types);
      for (const auto& z : ushijima_roots(angles)) CHECK(abs(z[0] * z[0] + z[1] * z[1] - 1) < 1e-45);
      CHECK(std::abs(volume(*dihedral_angles(lengths, types)) - static_cast<double>(volume(angles))) < 1e-9);
    }
}

TEST_CASE("Schlaefli: dV = -1/2 sum of l d theta, for every mixture of vertex types", "[volume]") {
  Random random(4);
  const Real50 h = 1e-15;
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    for (int round = 0; round < 2; ++round) {
      const SixNumbers<Real50> lengths = precise(samples::existing_lengths(types, random));
      const auto jacobian = angle_jacobian(lengths, types);
      SixNumbers<Real50> up = lengths;
      SixNumbers<Real50> down = lengths;
      SixNumbers<Real50> direction;
      for (int e = 0; e < 6; ++e) {
        direction[e] = samples::between(random, -1, 1);
        up[e] += h * direction[e];
        down[e] -= h * direction[e];
      }
      Real50 expected = 0;
      for (int e = 0; e < 6; ++e)
        for (int f = 0; f < 6; ++f) expected -= lengths[e] * jacobian[e][f] * direction[f] / 2;
      const Real50 got =
          (volume(extended_dihedral_angles(up, types)) - volume(extended_dihedral_angles(down, types))) /
          (2 * h);
      // The central difference errs by h^2 = 1e-30 times a third derivative.
      CHECK(abs(got - expected) < 1e-20);
    }
  }
}
