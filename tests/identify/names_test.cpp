// SPDX-License-Identifier: GPL-2.0-or-later
/// Names make the manifolds that are called so.

#include "support/errors.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/catalogue/cusped.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/identify/identify.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/identify/recognise.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <set>

using namespace tetrarch;
using namespace tetrarch::catalogue;
using namespace tetrarch::identify;
using support::error_of;

namespace {

Triangulation called(const std::string& name) {
  const std::optional<Named> found = find_named(name);
  INFO(name);
  REQUIRE(found);
  return found->triangulation;
}

/// The least of +-q and +-1/q modulo p: two lens spaces are homeomorphic if these agree (Reidemeister 1935).
long long least_q(long long p, long long q) {
  long long least = std::min(q, p - q);
  for (long long r = 1; r < p; ++r)
    if (q * r % p == 1 || q * r % p == p - 1) least = std::min(least, r);
  return least;
}

} // namespace

TEST_CASE("what identify names is found by that name", "[names]") {
  for (const char* name : {"m000", "m003", "m004", "m015", "m129", "Borromean rings"}) {
    const std::optional<Named> found = find_named(name);
    REQUIRE(found);
    const Identification back = identify::identify(found->triangulation);
    INFO(name << " is " << back.name);
    CHECK(back.name == found->name);
    CHECK(signature(called(back.name)) == signature(found->triangulation));
  }
  CHECK(find_named("fmp3_17")->name == "fmp3_17");
  CHECK(identify::identify(called("fmp3_17")).name == "fmp3_17");
}

TEST_CASE("the cusped census: what a name makes is called so", "[names]") {
  for (int k = 5; k < cusped_count(); k += 97) {
    const Cusped cusped = cusped_at(k);
    INFO(cusped.name);
    const Identification back = identify::identify(called(std::string(cusped.name)));
    CHECK((cusped.name == "m015" || cusped.name == "m129" || back.name == cusped.name));
    CHECK(back.isometry_signature == cusped.isometry_signature);
  }
  // Two names of one manifold, which Regina 7.3 calls by one name, too.
  CHECK(identify::identify(called("x103")).name == "x101");
}

TEST_CASE("aliases of knots and links", "[names]") {
  // Signatures and tetrahedra as Regina 7.3's census has them: m004, m015 and m129 (#2), t12067.
  CHECK(signature(called("4_1")) == "cPcbbbiht");
  CHECK(signature(called("figure-eight knot complement")) == "cPcbbbiht");
  CHECK(signature(called("5_2")) == "dLQbcccdero");
  CHECK(signature(called("L5a1")) == "eLPkbdcddhgggb");
  CHECK(signature(called("L6a4")) == "iLLLQPcceefgghhhddaaadada");
}

TEST_CASE("what recognise names is found by that name", "[names]") {
  for (const char* name : {"S^3", "RP^3", "S^2 x S^1", "S^2 x~ S^1", "T^3", "B^3", "solid torus",
                           "solid Klein bottle", "L(3,1)", "L(4,1)", "L(5,1)", "L(5,2)", "L(7,2)",
                           "genus 2 handlebody", "genus 5 handlebody", "non-orientable genus 3 handlebody"}) {
    const Recognition back = recognise(called(name));
    INFO(back.because);
    CHECK(back.name == name);
  }
  CHECK(recognise(called("L(1,0)")).name == "S^3");
  CHECK(recognise(called("L(0,1)")).name == "S^2 x S^1");
  CHECK(recognise(called("genus 1 handlebody")).name == "solid torus");
  CHECK(called("genus 50 handlebody").size() < 500);
}

TEST_CASE("lens spaces are those of the zoo, and have the homology that they must", "[names]") {
  for (const char* name : {"L(4,1)", "L(5,2)", "L(7,2)", "L(8,3)"})
    CHECK(signature(called(name)) == support::zoo(name).signature); // Regina's Example3.lens
  for (long long p = 3; p < 60; ++p)
    for (long long q = 1; q < p; ++q) {
      if (std::gcd(p, q) != 1) continue;
      const Triangulation tri = lens_space(p, q).value();
      const Skeleton skeleton(tri);
      INFO("L(" << p << "," << q << ")");
      REQUIRE(is_valid(skeleton));
      REQUIRE(skeleton.is_orientable());
      REQUIRE(algebra::homology(tri, skeleton, 1).str() == "Z/" + std::to_string(p));
      if (p < 25)
        CHECK(recognise(tri).name == "L(" + std::to_string(p) + "," + std::to_string(least_q(p, q)) + ")");
    }
  // 2^61 - 1 is a prime, and its quotients by Fibonacci numbers are tame.
  const Triangulation large = lens_space((1LL << 61) - 1, 1424981476321421053LL).value();
  CHECK(algebra::homology(large, Skeleton(large), 1).str() == "Z/2305843009213693951");
  CHECK_FALSE(lens_space(1'000'000'007, 1));
}

TEST_CASE("names with no one meaning are refused", "[bad][names]") {
  const auto refusal = [](const std::string& name) { return error_of([&] { find_named(name); }); };
  CHECK(refusal("L(7,?)") == "'L(7,?)' leaves open which lens space is meant: give the second number");
  CHECK(refusal("L(6,2)") == "'L(6,2)' is no lens space: its numbers have a common divisor");
  CHECK(refusal("L(1000000007,1)") == "'L(1000000007,1)' would take more than 10000 tetrahedra");
  CHECK(refusal("genus 51 handlebody") == "'genus 51 handlebody' has more than 50 handles");
  for (const char* name :
       {"", "m", "m0", "m999", "L(", "L()", "L(7)", "L(a,b)", "L(-7,2)", "genus  handlebody",
        "genus 0 handlebody", "genus -1 handlebody", "fmp3_152", "fmp3_", "cPcbbbiht"})
    CHECK_FALSE(find_named(name));
}

TEST_CASE("every listed name is found", "[names]") {
  const std::vector<std::string> names = listed_names();
  // The tables of 8, 151 and 5,033 manifolds, six famous cusped ones with some names each, eight others, and
  // the cusped census.
  CHECK(names.size() > 8 + 151 + 5033 + 6 + 8 + 6075);
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size();
  for (std::size_t k = 0; k < names.size(); k += 17) CHECK(find_named(names[k]));
}
