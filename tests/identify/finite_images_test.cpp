// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/identify/finite_images.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/names.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::identify;

namespace {

diagram::PairExterior pair_of(const std::string& name, std::uint64_t seed = 1) {
  for (;; ++seed) {
    REQUIRE(seed < 20);
    if (auto found = diagram::pair_exterior(*diagram::named_diagram(name), {seed})) return *std::move(found);
  }
}

ImageCounts counts_of(const diagram::PairExterior& pair, const std::string& group) {
  const auto counts = image_counts(pair.tri, pair.monodromy, group);
  REQUIRE(counts.has_value());
  return *counts;
}

/// What the exterior alone knows: the orders of the kernels' images left out.
ImageCounts without_kernels(const ImageCounts& counts) {
  ImageCounts out;
  for (const auto& [orders, count] : counts) {
    std::vector<int> key{orders[0]};
    for (std::size_t k = 1; k < orders.size(); k += 2) key.push_back(orders[k]);
    out[key] += count;
  }
  return out;
}

long long total(const ImageCounts& counts) {
  long long sum = 0;
  for (const auto& [orders, count] : counts) sum += count;
  return sum;
}

} // namespace

TEST_CASE("homomorphisms are counted as by hand", "[images]") {
  // The trefoil's group < a, b | aba = bab > has 12 homomorphisms to S3: 6 cyclic ones, and 6 onto (a, b two
  // different transpositions). Meridians go to transpositions there, which generate all.
  const ImageCounts trefoil = counts_of(pair_of("3_1"), "S3");
  CHECK(total(trefoil) == 12);
  long long onto = 0;
  for (const auto& [orders, count] : trefoil)
    if (orders[0] == 6) onto += count;
  CHECK(onto == 6);
  // Two free generators: |G|^2.
  CHECK(total(counts_of(pair_of("theta0_1"), "A4")) == 144);
  CHECK_THROWS_AS(image_counts(pair_of("3_1").tri, pair_of("3_1").monodromy, "M11"), PreconditionError);
  CHECK_FALSE(image_counts(pair_of("theta0_1").tri, pair_of("theta0_1").monodromy, "A5", 100).has_value());
}

TEST_CASE("what kills the meridians kills the exterior's group", "[images]") {
  // Filling the handlebody in again gives the 3-sphere, which is simply connected.
  for (const std::string& name : diagram::tabulated_names()) {
    if (!name.starts_with("hk") && name != "L6a4") continue;
    INFO(name);
    for (const char* group : {"S3", "A4"}) {
      long long trivial = 0;
      for (const auto& [orders, count] : counts_of(pair_of(name), group)) {
        bool kernels_die = true;
        for (std::size_t k = 2; k < orders.size(); k += 2) kernels_die &= orders[k] == 1;
        if (kernels_die) trivial += count;
      }
      CHECK(trivial == 1);
    }
  }
}

TEST_CASE("counts do not depend on the triangulation", "[images]") {
  for (const char* name : {"hk4_1", "hk5_1", "hk6_4", "hk6_9"}) {
    INFO(name);
    CHECK(counts_of(pair_of(name, 1), "S4") == counts_of(pair_of(name, 5), "S4"));
  }
}

TEST_CASE("5_1 and 6_4 have one exterior, and A5 tells them apart", "[images]") {
  // Lee and Lee, "Inequivalent handlebody-knots with homeomorphic complements" (2012); by finite groups:
  // Bellettini, Paolini and Wang (2019).
  const ImageCounts one = counts_of(pair_of("hk5_1"), "A5");
  const ImageCounts two = counts_of(pair_of("hk6_4"), "A5");
  CHECK(without_kernels(one) == without_kernels(two));
  CHECK(one != two);
}
