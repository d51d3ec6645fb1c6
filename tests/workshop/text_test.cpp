// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/text.hpp"

#include "tetrarch/workshop/tree.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace tetrarch::workshop;

TEST_CASE("a name makes no rows of its own", "[workshop]") {
  CHECK(block({{"name", "x\nhomology  Z^7\x1b[2J"}, {"a\rb", "\u00e9"}}) == "name  x?homology  Z^7?[2J\n"
                                                                            "a?b   \u00e9\n");
}

TEST_CASE("what is no number is found wherever it stands", "[workshop]") {
  Tree tree{{"a", 1.0}, {"b", Tree::array()}};
  tree["b"].push_back(2.0);
  CHECK(tree.where_not_a_number().empty());
  tree["b"].push_back({{"c", std::numeric_limits<double>::quiet_NaN()}});
  CHECK(tree.where_not_a_number() == "b/1/c");
  tree["a"] = -std::numeric_limits<double>::infinity();
  CHECK(tree.where_not_a_number() == "a");
}

TEST_CASE("JSON holds no character that a terminal obeys", "[workshop]") {
  const Tree tree{{"n\x7f", "\u00e9\x1b\n\x7f\u009b\u0080\u00a0"}};
  CHECK(tree.dump(-1) == R"({"n\u007f":"é\u001b\n\u007f\u009b\u0080)"
                         "\u00a0\"}");
  CHECK(Tree::parse(tree.dump(-1)).dump(-1) == tree.dump(-1));
}
