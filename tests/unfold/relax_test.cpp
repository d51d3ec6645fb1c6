// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/unfold/relax.hpp"

#include "support/random.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::unfold;
using support::Random;
using Complex = std::complex<double>;
using Kind = FlatFreedom::Kind;

namespace {

/// Triangles in the plane, with the places they would like to have.
struct Patch {
  std::vector<Complex> wanted;
  std::vector<std::array<int, 3>> triangles;
  std::vector<char> on_boundary;

  std::vector<FlatElement> elements(const std::vector<Complex>& now) const {
    std::vector<FlatElement> result;
    for (const auto& t : triangles)
      result.push_back({t,
                        {wanted[t[1]] - wanted[t[0]], wanted[t[2]] - wanted[t[0]]},
                        {now[t[1]] - now[t[0]], now[t[2]] - now[t[0]]},
                        1.0});
    return result;
  }
  bool is_unfolded(const std::vector<Complex>& now) const {
    for (const auto& t : triangles)
      if (!((std::conj(now[t[1]] - now[t[0]]) * (now[t[2]] - now[t[0]])).imag() > 0)) return false;
    return true;
  }
};

/// The unit disk: `rings` rings of 6k vertices around the center.
Patch disk(int rings) {
  Patch p;
  p.wanted.emplace_back(0);
  p.on_boundary.push_back(0);
  const auto at = [&](int ring, int k) {
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + (k + 6 * ring) % (6 * ring);
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < 6 * ring; ++k) {
      p.wanted.push_back(
          std::polar(ring / static_cast<double>(rings), 2 * std::numbers::pi * k / (6.0 * ring)));
      p.on_boundary.push_back(static_cast<char>(ring == rings));
    }
  for (int ring = 1; ring <= rings; ++ring)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k < ring; ++k) {
        const int outer = sector * ring + k;
        const int inner = sector * (ring - 1) + k;
        p.triangles.push_back({at(ring - 1, inner), at(ring, outer), at(ring, outer + 1)});
        if (k + 1 < ring)
          p.triangles.push_back({at(ring - 1, inner), at(ring, outer + 1), at(ring - 1, inner + 1)});
      }
  return p;
}

std::vector<Complex> moved(const std::vector<Complex>& from, const std::vector<Complex>& shift) {
  std::vector<Complex> result;
  for (std::size_t v = 0; v < from.size(); ++v) result.push_back(from[v] + shift[v]);
  return result;
}

} // namespace

TEST_CASE("The energy of a stretch by two and a half is that of the formula") {
  // Singular values 2 and 1/2: (4 + 1/4 + 1/4 + 4) / 4.
  const FlatElement e{{0, 1, 2}, {Complex(1, 0), Complex(0, 1)}, {Complex(0, 2), Complex(-0.5, 0)}, 3.0};
  FlatOptions none;
  none.most_steps = 0;
  const Relaxed found = relaxed({e}, std::vector<FlatFreedom>(3), none);
  CHECK(found.before == Approx(2.125).epsilon(1e-14));
  CHECK(found.after == found.before);
}

TEST_CASE("A patch laid anyhow without folds becomes congruent to what it would like to be") {
  const Patch p = disk(6);
  Random random(7);
  for (int round = 0; round < 10; ++round) {
    std::vector<Complex> start;
    const double bend = 0.35 * random.uniform();
    for (const Complex z : p.wanted)
      start.push_back(5.0 * std::polar(1.0, 2.0 * round) * (z + bend * z * z) +
                      0.1 * Complex(random.uniform(), random.uniform()));
    REQUIRE(p.is_unfolded(start));
    const Relaxed found = relaxed(p.elements(start), std::vector<FlatFreedom>(start.size()));
    const std::vector<Complex> end = moved(start, found.shift);
    CHECK(found.settled);
    CHECK(found.before > 3);
    CHECK(found.after == Approx(1).epsilon(1e-7));
    for (const auto& t : p.triangles)
      CHECK(std::abs(end[t[1]] - end[t[0]]) ==
            Approx(std::abs(p.wanted[t[1]] - p.wanted[t[0]])).epsilon(2e-3));
  }
}

TEST_CASE("A Moebius map of the disk is undone with the boundary on its circle") {
  const Patch p = disk(8);
  std::vector<Complex> start;
  std::vector<FlatFreedom> freedom;
  for (std::size_t v = 0; v < p.wanted.size(); ++v) {
    start.push_back((p.wanted[v] + 0.6) / (1.0 + 0.6 * p.wanted[v]));
    freedom.push_back({p.on_boundary[v] ? Kind::circle : Kind::free, start[v]});
  }
  const Relaxed found = relaxed(p.elements(start), freedom);
  const std::vector<Complex> end = moved(start, found.shift);
  CHECK(found.settled);
  CHECK(found.before > 2);
  CHECK(found.after == Approx(1).epsilon(1e-7));
  for (std::size_t v = 0; v < end.size(); ++v)
    if (p.on_boundary[v]) CHECK(std::abs(end[v]) == Approx(1).epsilon(1e-13));
}

TEST_CASE("No triangle folds and no fixed point moves, wherever the minimum is") {
  // The boundary is held in an ellipse, so that no isometry is allowed.
  const Patch p = disk(7);
  std::vector<Complex> start;
  std::vector<FlatFreedom> freedom;
  Random random(3);
  for (std::size_t v = 0; v < p.wanted.size(); ++v) {
    start.emplace_back(0.05 * p.wanted[v].real(), 4 * p.wanted[v].imag());
    if (!p.on_boundary[v]) start.back() += 1e-3 * Complex(random.uniform(), random.uniform());
    const bool slides = p.on_boundary[v] && v % 2 == 0;
    freedom.push_back({!p.on_boundary[v] ? Kind::free : slides ? Kind::line : Kind::fixed, Complex(0, 3)});
  }
  REQUIRE(p.is_unfolded(start));
  const Relaxed found = relaxed(p.elements(start), freedom);
  const std::vector<Complex> end = moved(start, found.shift);
  CHECK(found.settled);
  CHECK(found.after < found.before);
  CHECK(p.is_unfolded(end));
  for (std::size_t v = 0; v < end.size(); ++v) {
    if (freedom[v].kind == Kind::fixed) CHECK(found.shift[v] == 0.0);
    if (freedom[v].kind == Kind::line) CHECK(std::abs(found.shift[v].real()) < 1e-14);
  }
  // At a minimum a small motion of any point that is free lowers nothing beyond the tolerance.
  FlatOptions none;
  none.most_steps = 0;
  for (int k = 0; k < 50; ++k) {
    std::vector<Complex> beside = end;
    for (std::size_t v = 0; v < end.size(); ++v)
      if (freedom[v].kind == Kind::free)
        beside[v] += 1e-4 * Complex(random.uniform() - 0.5, random.uniform() - 0.5);
    CHECK(relaxed(p.elements(beside), freedom, none).before > found.after * (1 - 1e-5));
  }
}

TEST_CASE("What is folded at first is refused, and a job can be stopped") {
  const Patch p = disk(2);
  std::vector<Complex> start = p.wanted;
  const std::vector<FlatFreedom> freedom(start.size());
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(relaxed(p.elements(start), freedom, {}, Progress({}, source.get_token())), Stopped);
  start[0] = 3;
  CHECK_THROWS_AS(relaxed(p.elements(start), freedom), PreconditionError);
  CHECK_THROWS_AS(relaxed(p.elements(p.wanted), std::vector<FlatFreedom>(2)), PreconditionError);
}
