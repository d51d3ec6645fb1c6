// SPDX-License-Identifier: GPL-2.0-or-later
// Reasons why a manifold is not hyperbolic: given where there is no structure, never where there is one, and
// checked.
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using reasons::Kind;
using reasons::Reason;
using reasons::why_not_hyperbolic;

namespace {

/// A reason that holds what it says.
Reason checked(const Triangulation& tri) {
  const auto reason = why_not_hyperbolic(tri);
  REQUIRE(reason);
  CHECK(reasons::what_is_wrong(*reason).empty());
  CHECK_FALSE(reason->text.empty());
  CHECK_FALSE(reason->theorem.empty());
  return *reason;
}

} // namespace

TEST_CASE("No manifold of the census has a reason") {
  // 8 + 151 manifolds with a certified structure: a reason for one of them would be a false proof.
  for (const int n : {2, 3})
    for (const auto& m : catalogue::stored_table(n)) {
      reasons::ReasonOptions few;
      few.changes = 2;
      CHECK_FALSE(why_not_hyperbolic(from_signature(m.signature), few));
    }
}

TEST_CASE("Simple manifolds have their reasons") {
  const auto named = [](const char* name) { return identify::find_named(name)->triangulation; };
  CHECK(checked(named("S^3")).kind == Kind::cyclic_group);
  CHECK(checked(named("L(7,2)")).kind == Kind::cyclic_group);
  CHECK(checked(named("solid torus")).kind == Kind::cyclic_group);
  CHECK(checked(named("T^3")).kind == Kind::abelian_group);
  CHECK(checked(named("genus 3 handlebody")).kind == Kind::root);
}

TEST_CASE("A damaged reason is refused") {
  // Of eLMkbbdddduadu all tetrahedra degenerate: its group splits, b conjugating one letter.
  const Reason reason = checked(from_signature("eLMkbbdddduadu"));
  REQUIRE(reason.group);
  Reason damaged = reason;
  damaged.group->shown.relators.front().push_back(1);
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.group->image.front().push_back(damaged.group->image.front().back());
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.kind = Kind::free_product;
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.group->triangulation = "cPcbbbihq";
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
}
