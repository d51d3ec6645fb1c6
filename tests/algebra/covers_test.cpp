// SPDX-License-Identifier: GPL-2.0-or-later
// Covers of small degree, against counts that others published and against Hall's formula.
#include "tetrarch/algebra/covers.hpp"
#include "tetrarch/algebra/group_text.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace tetrarch::algebra;

namespace {

Presentation group(const char* text) {
  return parse_presentation(text, "test");
}

/// The classes of conjugate subgroups of each index from 1 on.
std::vector<int> classes(const char* text, int degree) {
  std::vector<int> count(static_cast<std::size_t>(degree), 0);
  count[0] = 1;
  const bool all = for_each_cover(group(text),
                                  [&](const Cover& cover) {
                                    ++count[static_cast<std::size_t>(cover.degree - 1)];
                                    return true;
                                  },
                                  {degree});
  REQUIRE(all);
  return count;
}

} // namespace

TEST_CASE("Classes of subgroups are as many as published") {
  // Free group of rank 2: OEIS A057005. Z^2: sum of divisors, A000203. Modular group Z/2 * Z/3: OEIS A121350.
  CHECK(classes("< a, b | >", 6) == std::vector{1, 3, 7, 26, 97, 624});
  CHECK(classes("< a, b | abAB >", 6) == std::vector{1, 3, 4, 7, 6, 12});
  CHECK(classes("< a, b | aa, bbb >", 7) == std::vector{1, 1, 2, 2, 1, 8, 6});
  // A5: subgroups up to conjugacy of index 5, 6, 10, 12 and more.
  CHECK(classes("< a, b | aa, bbb, ababababab >", 6) == std::vector{1, 0, 0, 0, 1, 1});
}

TEST_CASE("Each cover satisfies the relators, and is connected") {
  const Presentation g = group("< a, b | abABaBAbaB >");
  int covers = 0;
  CHECK(for_each_cover(g,
                       [&](const Cover& cover) {
                         ++covers;
                         for (const Word& relator : g.relators)
                           for (int p = 0; p < cover.degree; ++p)
                             CHECK(action(cover, relator)[static_cast<std::size_t>(p)] == p);
                         std::vector<int> reached{0};
                         for (std::size_t k = 0; k < reached.size(); ++k)
                           for (const auto& sheet : cover.sheet) {
                             const int to = sheet[static_cast<std::size_t>(reached[k])];
                             if (std::find(reached.begin(), reached.end(), to) == reached.end())
                               reached.push_back(to);
                           }
                         CHECK(static_cast<int>(reached.size()) == cover.degree);
                         return true;
                       },
                       {6}));
  CHECK(covers > 5);
}

TEST_CASE("Homology of covers of the figure-eight knot is as tabulated") {
  // Cyclic covers: H1 of the 2- and 3-fold cyclic covers of the exterior is Z + Z/5 and Z + Z/4 + Z/4
  // (Rolfsen, "Knots and Links", 8.D). The knot group has one subgroup of each of these indices that is
  // cyclic.
  const Presentation figure_eight = group("< a, b | aBAbaBabAB >");
  const auto two = homology_of_covers(figure_eight, 2);
  REQUIRE(two.complete);
  CHECK(two.of == std::vector<std::string>{"Z + Z/5"});
  const auto three = homology_of_covers(figure_eight, 3);
  REQUIRE(three.complete);
  CHECK(three.of == std::vector<std::string>{"Z + Z/4 + Z/4"});
}

TEST_CASE("A budget that is too small is told") {
  CHECK_FALSE(homology_of_covers(group("< a, b | >"), 6, 100).complete);
}

TEST_CASE("Groups are told apart by the first number of sheets in which their covers differ") {
  const Presentation figure_eight = group("< a, b | aBAbaBabAB >");
  const Presentation trefoil = group("< a, b | aaBBB >");
  // The branched double covers are L(5,2) and L(3,1).
  const CoverDifference knots = difference_of_covers(figure_eight, trefoil, 4, 10'000);
  CHECK(knots.compared == 2);
  CHECK(
      knots.what ==
      "the first homology of covers of 2 sheets differs: in sorted order, first in Z + Z/5 against Z + Z/3");
  // Z/2 * Z/2 has three subgroups of index 2, Z has one.
  const CoverDifference numbers =
      difference_of_covers(group("< a, b | aa, bb >"), group("< a | >"), 4, 10'000);
  CHECK(numbers.what == "the numbers of covers of 2 sheets differ: 3 against 1");
  const CoverDifference same = difference_of_covers(trefoil, group("< a, b | abaBAB >"), 4, 10'000);
  CHECK(same.compared == 4);
  CHECK(same.what.empty());
  CHECK(difference_of_covers(figure_eight, trefoil, 4, 1).compared == 1);
}
