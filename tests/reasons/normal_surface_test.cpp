// SPDX-License-Identifier: GPL-2.0-or-later
// Normal surfaces: as many vertex surfaces, with the same Euler characteristics, as Regina finds; and what
// they prove.
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/reasons/normal_surface.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using reasons::Coordinates;

namespace {

constexpr long long enough = 100'000'000;

std::vector<Coordinates> surfaces_of(const char* signature) {
  const auto found = reasons::vertex_surfaces(from_signature(signature), enough);
  REQUIRE(found);
  return *found;
}

/// Vertices, edges and discs, counted one by one: twice the arcs are the sides of the discs.
int euler(const Triangulation& tri, const Coordinates& c) {
  const Skeleton skeleton(tri);
  const auto at = [&c](int tet, int k) { return c[static_cast<std::size_t>(7 * tet + k)]; };
  int discs = 0;
  int sides = 0;
  int points = 0;
  for (int t = 0; t < tri.size(); ++t)
    for (int k = 0; k < 7; ++k) {
      discs += at(t, k);
      sides += (k < 4 ? 3 : 4) * at(t, k);
    }
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const Walk w = skeleton.around(e).front();
    const int kept = std::min(w.from(), w.to()) == 0 ? std::max(w.from(), w.to()) - 1 : 5 - w.from() - w.to();
    points += at(w.tet, w.from()) + at(w.tet, w.to());
    for (int k = 0; k < 3; ++k) points += k == kept ? 0 : at(w.tet, 4 + k);
  }
  return points - sides / 2 + discs;
}

} // namespace

TEST_CASE("Vertex surfaces are Regina's") {
  // Number and Euler characteristics >= 0 of the vertex normal surfaces that are no vertex links, by
  // Regina 7.3.
  struct Entry {
    const char* signature;
    std::size_t surfaces;
    std::vector<int> spherical;
  };
  for (const Entry& entry :
       std::vector<Entry>{{"cPcbbbiht", 0, {}},                         // figure-eight knot
                          {"cPcbbbadu", 1, {}},                         // trefoil
                          {"fvPQcdecedekrsnrs", 6, {0, 0, 0, 0, 0, 0}}, // Poincare sphere
                          {"eLPkbdcddhgggb", 1, {}},                    // Whitehead link
                          {"eLMkabcddbrrag", 8, {0, 0, 0, 0, 1, 1}},    // RP^3 # RP^3
                          {"cMcabbjaj", 3, {0, 0, 2}},                  // S^2 x S^1
                          {"eLMkbcddddlihu", 4, {0, 0}},                // granny knot
                          {"jLvAMPQadfgghhiiijaqgjqxims", 19, std::vector<int>(10, 0)}}) {
    CAPTURE(entry.signature);
    const Triangulation tri = from_signature(entry.signature);
    const auto surfaces = surfaces_of(entry.signature);
    CHECK(surfaces.size() == entry.surfaces);
    std::vector<int> spherical;
    for (const Coordinates& c : surfaces) {
      CHECK(reasons::is_normal_surface(tri, c));
      if (euler(tri, c) >= 0) spherical.push_back(euler(tri, c));
    }
    std::sort(spherical.begin(), spherical.end());
    CHECK(spherical == entry.spherical);
  }
}

TEST_CASE("Surfaces prove what they are known to prove") {
  using reasons::Kind;
  struct Entry {
    const char* signature;
    Kind kind;
  };
  reasons::ReasonOptions surfaces;
  surfaces.groups = false;
  surfaces.changes = 0;
  for (const Entry& entry :
       std::vector<Entry>{{"eLMkabcddbrrag", Kind::klein_bottle},             // RP^3 # RP^3
                          {"eLMkbcddddlihu", Kind::essential_torus},          // granny knot: two trefoils
                          {"fLAPcacceeejkkkfk", Kind::essential_sphere},      // L(3,1) # L(5,2)
                          {"gLAzQbbcdeffhtoggak", Kind::essential_sphere}}) { // figure eight # L(3,1)
    CAPTURE(entry.signature);
    const auto reason = why_not_hyperbolic(from_signature(entry.signature), surfaces);
    REQUIRE(reason);
    CHECK(reason->kind == entry.kind);
    CHECK(reasons::what_is_wrong(*reason).empty());
    reasons::Reason damaged = *reason;
    ++damaged.surface->coordinates.back();
    CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
    damaged = *reason;
    damaged.surface->euler -= 2;
    CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  }
  // The tori in the Poincare sphere and in the Weeks manifold compress, and knots that are hyperbolic have none: no
  // the Weeks manifold compress: they prove nothing.
  for (const char* signature : {"cPcbbbiht", "cPcbbbadu", "fvPQcdecedekrsnrs", "jLvAMPQadfgghhiiijaqgjqxims"})
    CHECK_FALSE(why_not_hyperbolic(from_signature(signature), surfaces));
}

TEST_CASE("A budget that is too small gives nothing") {
  CHECK_FALSE(reasons::vertex_surfaces(from_signature("jLvAMPQadfgghhiiijaqgjqxims"), 10));
}

TEST_CASE("Numbers that do not match are no surface") {
  const Triangulation tri = from_signature("eLMkbcddddlihu");
  for (Coordinates c : surfaces_of("eLMkbcddddlihu"))
    for (int& x : c) {
      ++x;
      CHECK_FALSE(reasons::is_normal_surface(tri, c));
      --x;
    }
}
