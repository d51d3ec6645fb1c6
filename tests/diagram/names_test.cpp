// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/wirtinger.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/identify/identify.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::diagram;

namespace {

/// The order of the first homology of the double branched cover: colorings of the strands by the numbers of a
/// dihedral group, where the letters of a relator count +1 and -1 by turns (Fox). One row and one column are
/// left out.
double determinant_of(const Diagram& knot) {
  const algebra::Presentation group = wirtinger(knot).group;
  const std::size_t n = static_cast<std::size_t>(group.generators) - 1;
  std::vector<std::vector<double>> m;
  for (std::size_t r = 0; r + 1 < group.relators.size(); ++r) {
    std::vector<double> row(n + 1, 0.0);
    double sign = 1;
    for (const int letter : group.relators[r]) {
      row[static_cast<std::size_t>(std::abs(letter)) - 1] += sign;
      sign = -sign;
    }
    row.pop_back();
    m.push_back(row);
  }
  REQUIRE(m.size() == n);
  double product = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t r = k; r < n; ++r)
      if (std::abs(m[r][k]) > std::abs(m[best][k])) best = r;
    std::swap(m[k], m[best]);
    product *= m[k][k];
    for (std::size_t r = k + 1; r < n && m[k][k] != 0; ++r) {
      const double factor = m[r][k] / m[k][k];
      for (std::size_t c = k; c < n; ++c) m[r][c] -= factor * m[k][c];
    }
  }
  return std::abs(product);
}

} // namespace

TEST_CASE("volumes of the knots to seven crossings", "[names]") {
  // Adams, Hildebrand and Weeks, "Hyperbolic invariants of knots and links" (1991), to the digits that
  // SnapPea's kernel adds.
  const std::map<std::string, double> volumes{
      {"4_1", 2.029883212819}, {"5_2", 2.828122088330}, {"6_1", 3.163963228883}, {"6_2", 4.400832516123},
      {"6_3", 5.693021091281}, {"7_2", 3.331744231641}, {"7_3", 4.592125697027}, {"7_4", 5.137941201873},
      {"7_5", 6.443537380850}, {"7_6", 7.084925953510}, {"7_7", 7.643375172359}};
  for (const auto& [name, volume] : volumes) {
    INFO(name);
    const auto found = hyperbolic::find_structure(exterior(*named_diagram(name)), {});
    CHECK(found.structure.volume == Approx(volume).margin(1e-10).epsilon(0));
  }
}

TEST_CASE("the knots of the table are knots, and all differ", "[names]") {
  // The torus knots among them have no structure: (2,n), (3,4) and (3,5). Complements of prime knots that are
  // homeomorphic belong to one knot or its mirror image (Gordon and Luecke, 1989).
  const std::set<std::string> torus{"0_1", "3_1", "5_1", "7_1", "8_19", "9_1", "10_124"};
  std::map<std::string, std::string> seen;
  REQUIRE(diagram_names().size() == 250);
  for (const std::string& name : diagram_names()) {
    INFO(name);
    const Diagram knot = *named_diagram(name);
    CHECK(components(knot).count == 1);
    if (torus.count(name) != 0) continue;
    const std::string signature = identify::identify(exterior(knot)).isometry_signature;
    REQUIRE_FALSE(signature.empty());
    const auto [at, fresh] = seen.emplace(signature, name);
    INFO("is " << at->second);
    CHECK(fresh);
  }
}

TEST_CASE("the knots of eleven crossings have the known determinants and volumes", "[names]") {
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/data/knots11.txt");
  REQUIRE(file);
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    std::string name;
    std::string determinant;
    std::string volume;
    std::getline(std::getline(std::getline(fields, name, '|'), determinant, '|'), volume);
    INFO(name);
    names.push_back(name);
    const Diagram knot = *named_diagram(name);
    CHECK(crossing_count(knot) == 11);
    CHECK(components(knot).count == 1);
    CHECK(determinant_of(knot) == Approx(std::stod(determinant)).margin(1e-6).epsilon(0));
    const auto found = hyperbolic::find_structure(exterior(knot), {});
    const bool hyperbolic = found.structure.outcome == hyperbolic::Outcome::geometric;
    CHECK(hyperbolic == (volume != "-")); // K11a367 is the torus knot (2, 11)
    if (hyperbolic) CHECK(found.structure.volume == Approx(std::stod(volume)).margin(6e-5).epsilon(0));
  }
  CHECK(names == eleven_crossing_names());
  CHECK(names.size() == 552);
  for (const char* name :
       {"K11a0", "K11a368", "K11n186", "K11b1", "K11a", "K11a1x", "11n_", "K12a1", "K11a-1"})
    CHECK_FALSE(named_diagram(name));
}

TEST_CASE("Conway's knot and that of Kinoshita and Terasaka", "[names]") {
  // Mutants, of one volume and with Alexander polynomial 1. Braids: SageMath's documentation of
  // Braid.jones_polynomial, which names 11n34 and 11n42 so.
  const auto signature_of = [](const std::string& what) {
    const std::optional<Diagram> named = named_diagram(what);
    return identify::identify(exterior(named ? *named : read_diagram(what, "test"))).isometry_signature;
  };
  const std::string conway = signature_of("K11n34");
  const std::string terasaka = signature_of("11n_42");
  CHECK_FALSE(conway.empty());
  CHECK(conway != terasaka);
  CHECK(conway == signature_of("braid 1 1 2 -3 2 -3 1 -2 -2 -3 -3"));
  CHECK(terasaka == signature_of("braid 1 -2 3 -2 3 -2 -2 -1 2 -3 -3 2 2"));
}

TEST_CASE("links by name are those of Regina's kernel", "[names]") {
  // tests/oracle/record_named_links.py; no other volumes of links to seven crossings stand in Adams,
  // Hildebrand and Weeks (1991): L6a4, the Borromean rings, has 7.327724753418, L6a5, the magic
  // link, 5.333489566898.
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/oracle/regina_named_links.txt");
  REQUIRE(file);
  int links = 0;
  int hyperbolic = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    INFO(line);
    std::istringstream fields(line);
    std::string name;
    std::string count;
    std::string volume;
    std::getline(fields, name, '|');
    std::getline(fields, count, '|');
    std::getline(fields, volume, '|');
    const Diagram link = *named_diagram(name);
    ++links;
    CHECK(crossing_count(link) == name[1] - '0');
    CHECK(vertex_count(link) == 0);
    CHECK(components(link).count == std::stoi(count));
    if (volume == "-") continue;
    ++hyperbolic;
    const auto found = hyperbolic::find_structure(exterior(link), {});
    CHECK(found.structure.volume == Approx(std::stod(volume)).margin(1e-10).epsilon(0));
  }
  CHECK(links == 130);
  CHECK(hyperbolic == 116);
}

TEST_CASE("graphs by name", "[names]") {
  int graphs = 0;
  for (const std::string& name : tabulated_names()) {
    if (name.front() == 'L') continue;
    INFO(name);
    ++graphs;
    const Diagram graph = *named_diagram(name);
    CHECK(vertex_count(graph) == 2);
    CHECK(components(graph).count == 1);
    CHECK(edges(graph).count == 3);
    const std::string number = name.substr(name.find_first_of("0123456789"));
    CHECK(crossing_count(graph) >= std::stoi(number));
    // Theta curves have no loops; handcuff graphs have two.
    int loops = 0;
    for (int d = 0; d < graph.dart_count(); ++d)
      for (int e = d + 1; e < graph.dart_count(); ++e)
        loops += graph.node_of(d) == graph.node_of(e) && !graph.at_crossing(d) &&
                 diagram::edges(graph).of[d] == diagram::edges(graph).of[e];
    if (name.starts_with("theta")) CHECK(loops == 0);
    if (name.starts_with("handcuff")) CHECK(loops == 2);
  }
  CHECK(graphs == 21 + 26 + 13);
}

TEST_CASE("Conway's notation of the knots to nine crossings", "[names]") {
  // Conway (1970); Rolfsen, appendix C: one knot of each kind of notation, two links.
  const auto signature_of = [](const Diagram& diagram) {
    return identify::identify(exterior(diagram)).isometry_signature;
  };
  for (const auto& [code, name] : std::map<std::string, std::string>{{"Conway[2 2]", "4_1"},
                                                                     {"Conway[3 2]", "5_2"},
                                                                     {"Conway[4 2]", "6_1"},
                                                                     {"Conway[3 1 2]", "6_2"},
                                                                     {"Conway[2 1 1 2]", "6_3"},
                                                                     {"Conway[2 1 1 1 2]", "7_7"},
                                                                     {"Conway[3, 3, 2]", "8_5"},
                                                                     {"Conway[2 1, 2 1, 2]", "8_15"},
                                                                     {"Conway[3, 2 1, -2]", "8_20"},
                                                                     {"Conway[3, 3, 2+]", "9_16"},
                                                                     {"Conway[3, 3, 2 1-]", "9_46"},
                                                                     {"Conway[2 1 2]", "L5a1"},
                                                                     {"Conway[2 1 1 1 1 1 2]", "9_31"}}) {
    INFO(code << " is " << name);
    const Diagram diagram = read_diagram(code, "test");
    CHECK_FALSE(signature_of(diagram).empty());
    CHECK(signature_of(diagram) == signature_of(*named_diagram(name)));
  }
  CHECK(crossing_count(read_diagram("Conway[3 1 2]", "test")) == 6);
  for (const char* wrong :
       {"Conway[]", "Conway[3", "Conway[3 x]", "Conway 3", "Conway[3,]", "Conway[2000000]"})
    CHECK_THROWS_AS(read_diagram(wrong, "test"), InputError);
}

TEST_CASE("what is no name of a knot", "[names]") {
  for (const char* name :
       {"",           "_",    "4_", "_1",  "4_2",  "1_1", "11_1",  "10_166", "4_1 ",     "4_01x",
        "99999999_1", "m004", "L",  "L6a", "L6a6", "hk",  "hk4_2", "hkL6a4", "theta2_1", "handcuff3_1"})
    CHECK_FALSE(named_diagram(name).has_value());
  CHECK(rolfsen_braid("4_1") == std::vector<int>{-1, 2, -1, 2});
}
