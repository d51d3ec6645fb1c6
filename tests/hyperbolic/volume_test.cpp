// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/volume.hpp"

#include "samples.hpp"
#include "src/hyperbolic/angle_data.hpp"
#include "src/hyperbolic/clausen.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using samples::Random;

namespace {

SixNumbers<double> all_angles(double theta) {
  return {theta, theta, theta, theta, theta, theta};
}

SixNumbers<numeric::Real50> precise(const SixNumbers<double>& numbers) {
  SixNumbers<numeric::Real50> out;
  for (int e = 0; e < 6; ++e) out[e] = numbers[e];
  return out;
}

SixNumbers<double> rounded(const SixNumbers<numeric::Real50>& numbers) {
  SixNumbers<double> out{};
  for (int e = 0; e < 6; ++e) out[e] = static_cast<double>(numbers[e]);
  return out;
}

AngleData<double> rounded(const AngleData<numeric::Real50>& data) {
  AngleData<double> out;
  out.turns = data.turns;
  out.rest = rounded(data.rest);
  out.spread = static_cast<double>(data.spread);
  for (int e = 0; e < 6; ++e) out.rest_error[e] = 1.2e-16 * std::abs(out.rest[e]);
  out.spread_error = 1.2e-16 * out.spread;
  return out;
}

std::array<kernel::EdgeForm<numeric::Real50>, 6> forms(const SixNumbers<numeric::Real50>& lengths,
                                                       const VertexTypes& types) {
  std::array<kernel::EdgeForm<numeric::Real50>, 6> form;
  for (int e = 0; e < 6; ++e)
    form[e] = kernel::edge_form(types[edge_vertex[e][0]], types[edge_vertex[e][1]], lengths[e]);
  return form;
}

/// Ushijima's formula as it is printed, with the determinant of cosines and the denominator of exponentials:
/// a witness in 60 digits, of which near a flat tetrahedron some thirty are left.
numeric::Real50 as_printed(const SixNumbers<numeric::Real50>& theta) {
  const numeric::Real50 a = theta[0], b = theta[1], c = theta[2], d = theta[5], e = theta[4], f = theta[3];
  numeric::Matrix4<numeric::Real50> g;
  for (int k = 0; k < 4; ++k) g[k][k] = 1;
  for (int n = 0; n < 6; ++n) {
    const auto [k, l] = edge_vertex[n];
    g[k][l] = -cos(theta[opposite_edge(n)]);
    g[l][k] = g[k][l];
  }
  numeric::Real50 re = 0;
  numeric::Real50 im = 0;
  for (const numeric::Real50& x :
       {numeric::Real50(a + d), numeric::Real50(b + e), numeric::Real50(c + f), numeric::Real50(a + b + f),
        numeric::Real50(a + c + e), numeric::Real50(b + c + d), numeric::Real50(d + e + f),
        numeric::Real50(a + b + c + d + e + f)}) {
    re += cos(x);
    im += sin(x);
  }
  const numeric::Real50 middle = numeric::pi<numeric::Real50>() - atan2(im, re);
  const numeric::Real50 spread = atan2(sqrt(numeric::Real50(-numeric::determinant(g))),
                                       numeric::Real50(sin(a) * sin(d) + sin(b) * sin(e) + sin(c) * sin(f)));
  const auto u = [&](const numeric::Real50& z) {
    const numeric::Real50 turned = z + numeric::pi<numeric::Real50>();
    return numeric::Real50(
        clausen(z) + clausen(numeric::Real50(z + a + b + d + e)) +
        clausen(numeric::Real50(z + a + c + d + f)) + clausen(numeric::Real50(z + b + c + e + f)) -
        clausen(numeric::Real50(turned + a + b + c)) - clausen(numeric::Real50(turned + a + e + f)) -
        clausen(numeric::Real50(turned + b + d + f)) - clausen(numeric::Real50(turned + c + d + e)));
  };
  return abs(numeric::Real50(u(middle - spread) - u(middle + spread))) / 4;
}

/// Lengths of a tetrahedron, and of none.
std::pair<SixNumbers<numeric::Real50>, SixNumbers<numeric::Real50>>
across_the_flat_ones(const VertexTypes& types, Random& random) {
  const SixNumbers<double> inside = samples::existing_lengths(types, random);
  SixNumbers<double> outside;
  do outside = samples::some_lengths(types, random);
  while (dihedral_angles(outside, types));
  return {precise(inside), precise(outside)};
}

/// On the way from the one to the other, `before` (in shares of the way) the last tetrahedron, which is flat.
SixNumbers<numeric::Real50> just_inside(const SixNumbers<numeric::Real50>& inside,
                                        const SixNumbers<numeric::Real50>& outside, const VertexTypes& types,
                                        const numeric::Real50& before) {
  const auto at = [&](const numeric::Real50& t) {
    SixNumbers<numeric::Real50> lengths;
    for (int e = 0; e < 6; ++e) lengths[e] = inside[e] + t * (outside[e] - inside[e]);
    return lengths;
  };
  numeric::Real50 there = 0;
  numeric::Real50 beyond = 1;
  for (int step = 0; step < 170; ++step) {
    const numeric::Real50 middle = (there + beyond) / 2;
    (dihedral_angles(at(middle), types) ? there : beyond) = middle;
  }
  return at(there - before);
}

} // namespace

TEST_CASE("Clausen's function: known values and functional equations", "[clausen]") {
  // Catalan's constant Cl(pi/2) and Gieseking's constant Cl(pi/3), the volume of the regular ideal
  // tetrahedron (OEIS A006752 and A143298).
  const numeric::Real50 catalan("0.915965594177219015054603514932384110774149374281672134266498");
  const numeric::Real50 gieseking("1.01494160640965362502120255427452028594168930753029979201749");
  const numeric::Real50 turn = 2 * numeric::pi<numeric::Real50>();
  CHECK(abs(clausen(numeric::Real50(turn / 4)) - catalan) < 1e-57);
  CHECK(abs(clausen(numeric::Real50(turn / 6)) - gieseking) < 1e-57);
  CHECK(clausen(0.0) == 0);
  CHECK(std::abs(clausen(numeric::pi<double>())) < 1e-15);
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const numeric::Real50 x = samples::between(random, -7, 7);
    CHECK(abs(clausen(numeric::Real50(-x)) + clausen(x)) < 1e-57);
    CHECK(abs(clausen(numeric::Real50(x + turn)) - clausen(x)) < 1e-56);
    // The duplication formula Cl(2x) = 2 Cl(x) - 2 Cl(pi - x).
    CHECK(abs(clausen(numeric::Real50(2 * x)) - 2 * clausen(x) + 2 * clausen(numeric::Real50(turn / 2 - x))) <
          1e-55);
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

TEST_CASE("Clausen's function errs by less than it says, also next to whole and half turns", "[clausen]") {
  Random random(5);
  for (int round = 0; round < 3000; ++round) {
    const double x = std::ldexp(samples::between(random, -12, 12), -(round / 2 % 60));
    const int half_turns = round % 2;
    const auto term = clausen_term(half_turns, x, 0.0);
    const numeric::Real50 exact =
        clausen(numeric::Real50(numeric::Real50(x) + half_turns * numeric::pi<numeric::Real50>()));
    REQUIRE(abs(exact - term.value) <= numeric::Real50(term.error));
    // About ten units of the value: next to a whole turn and next to half a turn no digit is lost.
    if (std::abs(x) < 1) REQUIRE(term.error <= 2e-15 * std::abs(term.value));
  }
}

TEST_CASE("volumes that others have printed", "[volume]") {
  // Frigerio, Martelli, Petronio 2004: two regular truncated tetrahedra with angles pi/6, three with pi/9.
  CHECK(2 * volume(all_angles(numeric::pi<double>() / 6)) == Approx(6.451990270835).epsilon(1e-12));
  CHECK(3 * volume(all_angles(numeric::pi<double>() / 9)) == Approx(10.428601580236).epsilon(1e-12));
  // Milnor: the regular ideal tetrahedron and the regular ideal octahedron (all angles 0: the truncation
  // triangles have become ideal, and what remains is the octahedron).
  CHECK(volume(all_angles(numeric::pi<double>() / 3)) == Approx(1.014941606410).epsilon(1e-12));
  CHECK(volume(all_angles(0)) == Approx(3.663862376709).epsilon(1e-12));
  // The octahedron's volume is 4 times Catalan's constant: in all 60 digits.
  SixNumbers<numeric::Real50> zero;
  zero.fill(numeric::Real50(0));
  CHECK(abs(volume(zero) - 4 * clausen(numeric::Real50(numeric::pi<numeric::Real50>() / 2))) < 1e-55);
}

TEST_CASE("ideal tetrahedra: Milnor's sum of three Lobachevsky functions", "[volume]") {
  // V = L(a) + L(b) + L(c) with L(x) = Cl(2x) / 2, opposite angles equal: an independent formula.
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    const double a = samples::between(random, 0.05, 1.5);
    const double b = samples::between(random, 0.05, 1.5);
    const double c = numeric::pi<double>() - a - b;
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
    SixNumbers<double> angles = all_angles(numeric::pi<double>() / 2);
    angles[opposite_edge(edge_number[0][1])] = numeric::pi<double>() / p;
    angles[opposite_edge(edge_number[1][2])] = numeric::pi<double>() / q;
    angles[opposite_edge(edge_number[2][3])] = numeric::pi<double>() / r;
    return volume(angles);
  };
  CHECK(orthoscheme(3, 5, 3) == Approx(0.0390502856).margin(1e-10));
  CHECK(orthoscheme(5, 3, 4) == Approx(0.0358850633).margin(1e-10));
  CHECK(orthoscheme(5, 3, 5) == Approx(0.0933255395).margin(1e-10));
}

TEST_CASE("a flat or non-hyperbolic set of angles has no volume", "[volume]") {
  CHECK(volume(SixNumbers<double>{numeric::pi<double>(), 0, 0, 0, 0, numeric::pi<double>()}) == 0);
  // The regular Euclidean and a spherical tetrahedron.
  CHECK(volume(all_angles(std::acos(1.0 / 3))) < 1e-6);
  CHECK(volume(all_angles(1.5)) == 0);
}

TEST_CASE("from lengths and from angles, in double and in 60 digits, the volume is the same", "[volume]") {
  Random random(3);
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    for (int round = 0; round < 5; ++round) {
      const auto lengths = samples::existing_lengths(types, random);
      const auto precise_lengths = precise(lengths);
      const numeric::Real50 exact = as_printed(*dihedral_angles(precise_lengths, types));
      const auto in_60_digits = volume(precise_lengths, types);
      REQUIRE(in_60_digits);
      CHECK(abs(in_60_digits->value - exact) < 1e-45);
      CHECK(in_60_digits->error < 1e-50);
      const auto estimate = volume(lengths, types);
      REQUIRE(estimate);
      CHECK(abs(estimate->value - exact) <= estimate->error);
      CHECK(estimate->error < 1e-13);
      CHECK(abs(volume(*dihedral_angles(lengths, types)) - exact) < 1e-13);
    }
  }
  CHECK_FALSE(volume(SixNumbers<double>{4, 0, 0, 0, 0, 4}, all_ideal));
  CHECK_FALSE(volume(SixNumbers<double>{-1, 1, 1, 1, 1, 1}, all_hyperideal));
}

TEST_CASE("down to 1e-10 from flat no digit of the volume is lost, for every mixture of vertices",
          "[volume]") {
  Random random(6);
  for (const VertexTypes& types : samples::all_mixtures()) {
    const auto [inside, outside] = across_the_flat_ones(types, random);
    for (const double distance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      INFO(samples::name(types) << ", " << distance << " from flat");
      const SixNumbers<numeric::Real50> lengths =
          just_inside(inside, outside, types, numeric::Real50(distance) * distance);
      const auto angles = *dihedral_angles(lengths, types);
      const numeric::Real50 exact = as_printed(angles);
      const auto in_60_digits = volume(lengths, types);
      // What the printed formula keeps of 60 digits.
      CHECK(abs(in_60_digits->value - exact) < numeric::Real50(1e-49) / (distance * distance));
      const AngleData<double> data = rounded(*angle_data(forms(lengths, types), types));
      const ClausenSum<double> sum = clausen_sum(data, types);
      const numeric::Real50 error = abs(exact - sum.value);
      CHECK(error <= 1e-14);
      CHECK(error <= 1e-10 * exact);
      CHECK(error <= numeric::Real50(sum.error));
      CHECK(sum.error < 1e-13);
      // From the rounded lengths: another tetrahedron, or none.
      const auto estimate = volume(rounded(lengths), types);
      if (!estimate) continue;
      const auto truth = volume(precise(rounded(lengths)), types);
      CHECK(abs(truth->value - estimate->value) <= estimate->error);
      CHECK(estimate->error < 1e-12);
    }
  }
}

TEST_CASE("nearly flat ideal tetrahedra: Milnor's sum of three Lobachevsky functions", "[volume]") {
  for (const double flat : {1e-3, 1e-6, 1e-10}) {
    // L(x) = Cl(2x) / 2; the third is minus that of the sum of the other two.
    const numeric::Real50 a = 0.7 * flat;
    const numeric::Real50 b = 0.3 * flat;
    const numeric::Real50 milnor = (clausen(numeric::Real50(2 * a)) + clausen(numeric::Real50(2 * b)) -
                                    clausen(numeric::Real50(2 * (a + b)))) /
                                   2;
    AngleData<double> data;
    data.turns = {0, 0, 1, 1, 0, 0};
    data.rest = {0.7 * flat, 0.3 * flat, -flat, -flat, 0.3 * flat, 0.7 * flat};
    // Cosines of angles near flat, as sines of the rests: the spread is the angle at 0 of z = 1 ... z+.
    data.spread = std::atan2(std::sin(0.7 * flat) * std::sin(0.3 * flat) * std::sin(flat) * 2,
                             std::pow(std::sin(0.7 * flat), 2) + std::pow(std::sin(0.3 * flat), 2) +
                                 std::pow(std::sin(flat), 2));
    const double got = clausen_sum(data, all_ideal).value;
    CHECK(abs(milnor - got) < 1e-13 * milnor);
  }
}

TEST_CASE("Schlaefli: dV = -1/2 sum of l d theta, for every mixture of vertex types", "[volume]") {
  Random random(4);
  const numeric::Real50 h = 1e-15;
  for (const VertexTypes& types : samples::all_mixtures()) {
    INFO(samples::name(types));
    for (int round = 0; round < 2; ++round) {
      const SixNumbers<numeric::Real50> lengths = precise(samples::existing_lengths(types, random));
      const auto jacobian = angle_jacobian(lengths, types);
      SixNumbers<numeric::Real50> up = lengths;
      SixNumbers<numeric::Real50> down = lengths;
      SixNumbers<numeric::Real50> direction;
      for (int e = 0; e < 6; ++e) {
        direction[e] = samples::between(random, -1, 1);
        up[e] += h * direction[e];
        down[e] -= h * direction[e];
      }
      numeric::Real50 expected = 0;
      for (int e = 0; e < 6; ++e)
        for (int f = 0; f < 6; ++f) expected -= lengths[e] * jacobian[e][f] * direction[f] / 2;
      const numeric::Real50 got =
          (volume(extended_dihedral_angles(up, types)) - volume(extended_dihedral_angles(down, types))) /
          (2 * h);
      // The central difference errs by h^2 = 1e-30 times a third derivative.
      CHECK(abs(got - expected) < 1e-20);
    }
  }
}
