// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/field.hpp"

#include "product/solids.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::product;

namespace {

using support::divided;
using support::Divided;

double root_mean_square_error(const support::Extrusion& from, const HarmonicField& field) {
  double sum = 0;
  for (std::size_t v = 0; v < from.at.size(); ++v) sum += std::pow(field.w[v] - from.at[v][2], 2);
  return std::sqrt(sum / static_cast<double>(from.at.size()));
}

} // namespace

TEST_CASE("Where the field is linear it is exact", "[field]") {
  for (const auto& from : {support::box({1, 2, 3}, {4, 5, 6}), support::cylinder(5, 4),
                           support::plate(3, 4, 3), support::pipe(0.5, 1, 4)}) {
    const Divided c = divided(from);
    const HarmonicField field = harmonic_field(c.solid, c.partition);
    for (std::size_t v = 0; v < from.at.size(); ++v)
      REQUIRE(field.w[v] == Approx(from.at[v][2]).margin(1e-13));
    CHECK(field.residual < 1e-13);
    CHECK(field.iterations == 0);
  }
}

TEST_CASE("The flow is area times slope", "[field]") {
  // By hand: 1 x 2 across, 3 high, w from 0 to 5.
  const Divided c = divided(support::box({1, 2, 3}, {3, 3, 3}));
  CHECK(harmonic_field(c.solid, c.partition, {.height = 5}).flow == Approx(2 * 5.0 / 3));
}

TEST_CASE("Between cylinders and spheres the field converges at order h^2", "[field]") {
  // w = log(r/a) / log(b/a) and (1/a - 1/r) / (1/a - 1/b): textbooks.
  const auto errors = [](const auto& make_solid) {
    std::vector<double> error;
    for (const int fine : {4, 8, 16}) {
      const support::Extrusion from = make_solid(fine);
      const Divided c = divided(from);
      error.push_back(root_mean_square_error(from, harmonic_field(c.solid, c.partition)));
    }
    return error;
  };
  for (const auto& error : {errors([](int fine) { return support::radial_pipe(0.5, fine); }),
                            errors([](int fine) { return support::shell(0, 0.6, fine); }),
                            errors([](int fine) { return support::shell(2, 0.6, fine); })}) {
    INFO(error[0] << " " << error[1] << " " << error[2]);
    // Two halvings of h: 16 times less. The rims, where walls meet floors that are polygons, cost a little.
    CHECK(error[2] < error[0] / 8);
    CHECK(error[1] < error[0] / 2.3);
  }
}

TEST_CASE("The flow between cylinders is that of the logarithm", "[field]") {
  // 2 pi z / log(b/a) for a ring of height z = 0.5 from radius 0.5 to 1.
  const Divided c = divided(support::radial_pipe(0.5, 16));
  CHECK(harmonic_field(c.solid, c.partition).flow ==
        Approx(2 * std::numbers::pi * 0.5 / std::log(2.0)).epsilon(0.01));
}

TEST_CASE("Conjugate gradients find what the factorisation finds", "[field]") {
  const Divided c = divided(support::bent(2, 6, 6));
  const HarmonicField direct = harmonic_field(c.solid, c.partition, {.solver = FieldOptions::Solver::direct});
  const HarmonicField iterative =
      harmonic_field(c.solid, c.partition, {.solver = FieldOptions::Solver::iterative});
  CHECK(direct.iterations == 0);
  CHECK(iterative.iterations > 5);
  CHECK(iterative.residual < 1e-11);
  for (std::size_t v = 0; v < direct.w.size(); ++v)
    REQUIRE(iterative.w[v] == Approx(direct.w[v]).margin(1e-10));
}

TEST_CASE("Without negative weights nothing inside is above or below all its neighbours", "[field]") {
  const Divided c = divided(support::bent(1, 6, 3, 0.3));
  const HarmonicField field = harmonic_field(c.solid, c.partition, {.clamped = true});
  CHECK(field.negative_weights > 0);
  const HarmonicField free = harmonic_field(c.solid, c.partition);
  CHECK(free.negative_weights == field.negative_weights);
  CHECK(free.w != field.w);
  CHECK(free.flow < field.flow); // less energy, as weights were less
  const std::vector<int> base = bases_of_vertices(c.solid, c.partition);
  std::vector<char> has_lower(base.size(), 0);
  std::vector<char> has_higher(base.size(), 0);
  for (const auto& corners : c.solid.mesh.tetrahedra)
    for (const int v : corners)
      for (const int u : corners) {
        if (field.w[u] < field.w[v]) has_lower[v] = 1;
        if (field.w[u] > field.w[v]) has_higher[v] = 1;
      }
  for (std::size_t v = 0; v < base.size(); ++v) {
    CHECK((base[v] == floor_patch) != static_cast<bool>(has_lower[v]));
    CHECK((base[v] == ceiling_patch) != static_cast<bool>(has_higher[v]));
  }
}

TEST_CASE("A field that is stopped says so", "[field]") {
  const Divided c = divided(support::bent(1, 4, 3));
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(harmonic_field(c.solid, c.partition, {}, Progress({}, source.get_token())), Stopped);
}
