// SPDX-License-Identifier: GPL-2.0-or-later
/// Names, against Regina's (tests/oracle/record_names.py describes the record), the zoo's, and solids'.

#include "support/links.hpp"
#include "support/zoo.hpp"
#include "tetrarch/identify/recognise.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <set>

using namespace tetrarch;
using namespace tetrarch::identify;
using namespace tetrarch::support;

namespace {

/// Regina's name in our spelling; empty where we have no name for it.
std::string our_name(const std::string& regina) {
  static const std::map<std::string, std::string> spelling{
      {"S3", "S^3"},
      {"RP3", "RP^3"},
      {"S2 x S1", "S^2 x S^1"},
      {"S2 x~ S1", "S^2 x~ S^1"},
      {"T x I / [ 1,0 | 0,1 ]", "T^3"},
      {"handlebody 0", "B^3"},
      {"handlebody 1", "solid torus"},
  };
  if (const auto it = spelling.find(regina); it != spelling.end()) return it->second;
  if (regina.starts_with("handlebody ")) return "genus " + regina.substr(11) + " handlebody";
  return regina.starts_with("L(") ? regina : "";
}

/// "L(7,?)" of "L(7,2)".
std::string without_q(const std::string& lens) {
  return lens.substr(0, lens.find(',') + 1) + "?)";
}

} // namespace

TEST_CASE("names are Regina's", "[recognise][oracle]") {
  std::ifstream in(TETRARCH_SOURCE_DIR "/tests/oracle/regina_names.txt");
  REQUIRE(in);
  std::map<Recognition::By, int> count;
  int undecided = 0;
  Random random(5);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    INFO(line);
    const std::size_t bar = line.find('|');
    const std::string expected = our_name(line.substr(bar + 1));
    const Triangulation tri = from_signature(line.substr(0, bar));
    const Recognition r = recognise(tri);
    INFO(r.because);
    ++count[r.by];
    CHECK_FALSE(r.because.empty());
    if (r.name.ends_with("?)")) {
      ++undecided;
      CHECK(r.by == Recognition::By::group);
      CHECK(r.name == without_q(expected));
    } else {
      CHECK(r.name == expected);
    }
    // Labels do not matter.
    const Recognition again = recognise(relabelled(tri, random_relabelling(tri.size(), random)));
    CHECK((again.by == r.by && again.name == r.name));
  }
  CHECK(count[Recognition::By::triangulation] > 200);
  CHECK(count[Recognition::By::group] > 200);
  CHECK(count[Recognition::By::nothing] > 10);
  CHECK(undecided < 200);
}

TEST_CASE("every minimal layered lens space is named by its layers", "[recognise][oracle]") {
  // In the record each L(p,q) with 3 <= p < 24 comes layered, and once more after a 1-4 move.
  std::ifstream in(TETRARCH_SOURCE_DIR "/tests/oracle/regina_names.txt");
  std::set<std::string> layered;
  for (std::string line; std::getline(in, line);) {
    const std::string name = line.substr(line.find('|') + 1);
    if (line.starts_with("#") || !name.starts_with("L(")) continue;
    const Recognition r = recognise(from_signature(line.substr(0, line.find('|'))));
    if (r.by == Recognition::By::triangulation) layered.insert(r.name);
  }
  // By hand: lens spaces up to orientation-reversal, q among +-q, +-1/q.
  std::set<std::string> all;
  for (int p = 3; p < 24; ++p)
    for (int q = 1; 2 * q < p; ++q) {
      if (std::gcd(p, q) > 1) continue;
      int inverse = 1;
      while (inverse * q % p != 1) ++inverse;
      all.insert("L(" + std::to_string(p) + "," + std::to_string(std::min({q, inverse, p - inverse})) + ")");
    }
  CHECK(std::includes(layered.begin(), layered.end(), all.begin(), all.end()));
}

TEST_CASE("the zoo by name", "[recognise]") {
  // Entries whose name in the zoo is not ours; "" for manifolds that are none of ours (the trefoil's group is
  // one of two generators, ...).
  const std::map<std::string, std::string> other{
      {"B^3, one tetrahedron", "B^3"},
      {"S^3, one tetrahedron", "S^3"},
      {"S^3, boundary of a 4-simplex", "S^3"},
      {"S^3, Bing's house", "S^3"},
      {"solid torus LST(1,2,3)", "solid torus"},
      {"solid torus LST(3,4,7)", "solid torus"},
      {"genus 2 handlebody", "genus 2 handlebody"},
      {"genus two torus with a cusp", "genus 2 handlebody"},
      {"3-torus", "T^3"},
  };
  const std::set<std::string> same{"RP^3",      "L(3,1)",     "L(4,1)",
                                   "L(5,2)",    "L(7,2)",     "L(8,3)",
                                   "S^2 x S^1", "S^2 x~ S^1", "solid Klein bottle"};
  for (const ZooEntry& entry : zoo()) {
    const Recognition r = recognise(entry.triangulation());
    INFO(entry.name << ": " << r.because);
    if (const auto it = other.find(entry.name); it != other.end())
      CHECK(r.name == it->second);
    else
      CHECK(r.name == (same.contains(entry.name) ? entry.name : ""));
    CHECK(static_cast<bool>(r) == !r.name.empty());
  }
}

TEST_CASE("solids and the cubical torus by their groups", "[recognise]") {
  Random random(3);
  CHECK(recognise(triangulation_of(bars(random_graph({2, 2, 2}, 0, random), {}))).name == "B^3");
  CHECK(recognise(triangulation_of(bars(random_graph({2, 2, 2}, 1, random), {}))).name == "solid torus");
  CHECK(recognise(triangulation_of(bars(random_graph({2, 2, 3}, 3, random), {}))).name ==
        "genus 3 handlebody");
  CHECK(recognise(cubical_torus(2, 3, 2)).name == "T^3");
  // The unknot's exterior in a box has a sphere as a second boundary: no handlebody, though its group is
  // free.
  const Recognition unknot = recognise(triangulation_of(exterior(named_link("unknot").grid)));
  CHECK_FALSE(unknot);
  CHECK(unknot.because.find("2 boundary component(s)") != std::string::npos);
  // Nor is S^2 x S^1 without a ball, which has the group of a solid torus and a sphere as boundary.
  // (Signature: Regina, from its second barycentric subdivision less a tetrahedron, simplified.)
  const Recognition punctured = recognise(from_signature("fHLykadceebibaj"));
  CHECK_FALSE(punctured);
  CHECK(punctured.because.find("< a | >") != std::string::npos);
}

TEST_CASE("what is no connected manifold has no name, and the reason says so", "[recognise]") {
  CHECK(recognise(Triangulation()).because == "empty or not connected");
  CHECK(recognise(Triangulation(2)).because == "empty or not connected");
  Triangulation reversed(1); // the edge 23 of two faces glued to each other by exchanging its ends
  reversed.glue({0, 0}, 0, Perm4(1, 0, 3, 2));
  CHECK_FALSE(recognise(reversed));
  CHECK(recognise(reversed).because.starts_with("no manifold: "));
}
