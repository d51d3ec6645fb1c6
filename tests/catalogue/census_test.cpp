// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/units.hpp"
#include "tetrarch/catalogue/validate.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/algebra/torsion.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/canonical/isometries.hpp"
#include "tetrarch/catalogue/cusped.hpp"
#include "tetrarch/core/double_cover.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>

using namespace tetrarch;
using namespace tetrarch::catalogue;

TEST_CASE("the tables have the published counts", "[census]") {
  // Frigerio, Martelli, Petronio, "Small hyperbolic 3-manifolds with geodesic boundary", 2004, tables 1 to 3.
  const auto two = stored_table(2);
  const auto three = stored_table(3);
  REQUIRE(two.size() == 8);
  REQUIRE(three.size() == 151);
  CHECK(count_volumes(two).size() == 1);
  CHECK(count_volumes(three).size() == 18);
  int single_edge = 0;
  int cusped = 0;
  for (const Manifold& m : three) {
    single_edge += m.edges == 1;
    cusped += m.cusps;
  }
  CHECK(single_edge == 74);
  CHECK(cusped == 1);
}

TEST_CASE("the cusped census has the published counts", "[census]") {
  // Callahan, Hildebrand, Weeks 1999: 301 orientable ones of up to five tetrahedra and 962 and 3,552 of six
  // and seven; 114 non-orientable ones of up to five, 259 and 887 of six and seven.
  std::map<char, int> counts;
  std::map<char, int> largest;
  int orientable = 0;
  std::set<std::string_view> different;
  for (int k = 0; k < cusped_count(); ++k) {
    const Cusped c = cusped_at(k);
    const char series = c.name.front();
    const Triangulation tri = from_signature(std::string(c.signature));
    CHECK(std::stoi(std::string(c.name.substr(1))) == counts[series]++);
    largest[series] = std::max(largest[series], tri.size());
    orientable += series == 'm' && Skeleton(tri).is_orientable();
    different.insert(c.isometry_signature);
    CHECK(from_signature(std::string(c.isometry_signature)).size() > 0);
  }
  CHECK(counts == std::map<char, int>{{'m', 415}, {'s', 962}, {'v', 3552}, {'x', 259}, {'y', 887}});
  CHECK(largest == std::map<char, int>{{'m', 5}, {'s', 6}, {'v', 7}, {'x', 6}, {'y', 7}});
  CHECK(orientable == 301);
  CHECK(different.size() == 6074); // x101 and x103 are one manifold
  CHECK(find_cusped("m004")->signature == "cPcbbbiht");
  CHECK(find_cusped_by_isometry_signature("dLQbcccbbgb")->name == "m002");
  CHECK_FALSE(find_cusped("m415"));
  CHECK_FALSE(find_cusped(""));
  CHECK_THROWS_AS(cusped_at(6075), PreconditionError);
  CHECK_THROWS_AS(cusped_at(-1), PreconditionError);
}

TEST_CASE("published volumes stand in the tables", "[census]") {
  // FMP 2004: 6.451990 for two tetrahedra, 10.428602 for three regular ones.
  CHECK(stored_table(2).front().volume.substr(0, 8) == "6.451990");
  CHECK(stored_table(3).back().volume.substr(0, 9) == "10.428601");
  CHECK(count_volumes(stored_table(3)).back().manifolds == 74);
}

TEST_CASE("the classification gives the stored bytes again, with one thread and with two", "[census]") {
  for (const TableKey table : {TableKey(2), TableKey(3), TableKey(2, false)})
    for (const int threads : {1, 2})
      CHECK(write_table(table, classify_manifolds(table, threads).manifolds) == stored_table_text(table));
}

TEST_CASE("not orientable: every gluing of three tetrahedra is settled", "[census]") {
  // Regina (tricensus -n -i -d) lists 14 and 753 valid gluings with such links and valences
  // (tests/oracle/record_census.py).
  const Classification two = classify_manifolds(TableKey(2, false));
  CHECK((two.tally.gluings == 14 && two.manifolds.size() == 14));
  const Classification three = classify_manifolds(TableKey(3, false), 2);
  CHECK((three.tally.gluings == 753 && three.tally.geometric == 746 && three.tally.none == 7));
  CHECK((three.open.empty() && three.unproved.empty() && three.stuck.empty()));
  CHECK(three.tally.proved == 746);
  CHECK(write_table({3, false}, three.manifolds) == stored_table_text({3, false}));
  CHECK(classify_manifolds(TableKey(1, false)).manifolds.empty());
}

TEST_CASE(
    "not orientable: the orientable double cover has twice the volume, and an isometry that reverses it",
    "[census]") {
  std::map<std::string, int> covers;
  for (const int n : {2, 3}) {
    const std::vector<Manifold>& table = stored_table({n, false});
    for (std::size_t k = 0; k < table.size(); k += n == 2 ? 1 : 20) {
      const Manifold& m = table[k];
      const Triangulation tri = from_signature(m.signature);
      REQUIRE_FALSE(Skeleton(tri).is_orientable());
      const Triangulation cover = orientable_double_cover(tri);
      REQUIRE((Skeleton(cover).is_orientable() && components(cover).count == 1));
      const auto structure = hyperbolic::hyperbolize(cover, Skeleton(cover));
      REQUIRE(structure.outcome == hyperbolic::Outcome::geometric);
      CHECK(structure.volume == Approx(2 * std::stod(m.volume)).epsilon(1e-13));
      const canonical::Canonical cells = canonical::canonize(cover, structure);
      REQUIRE(cells.outcome == canonical::Canonical::Outcome::canonical);
      CHECK(canonical::is_amphichiral(cells.canonical_triangulation,
                                      automorphisms(cells.canonical_triangulation))
                .value());
      if (n == 2) ++covers[find_by_isometry_signature(cells.isometry_signature).value().boundary_text()];
    }
  }
  CHECK(covers == std::map<std::string, int>{{"genus 3", 14}}); // of four crosscaps: all in the table of four
}

namespace {

/// Units of one to three tetrahedra, of every `of`-th one.
int units_of_three(int first, int of) {
  int count = 0;
  for (const int n : {1, 2, 3}) {
    enumeration::GluingOptions options;
    options.tetrahedra = n;
    options.orientability = enumeration::GluingOptions::Orientability::orientable;
    options.links = enumeration::LinkSet{{1, 2, 3}, {}};
    options.min_valence = 3;
    count += (enumeration::GluingUnits(options).size() - first + of - 1) / of;
  }
  return count;
}

} // namespace

TEST_CASE("every gluing of three tetrahedra is settled", "[census]") {
  const Classification three = classify_manifolds(3);
  CHECK(three.tally.gluings == 170);
  CHECK(three.tally.geometric == 167);
  CHECK(three.tally.certified == 167);
  CHECK(three.tally.proved == 167);
  // dLQacccjcog, dLQacccjjwc and dLQacccjkfr: Frigerio, Martelli and Petronio have no further manifold.
  CHECK(three.tally.none == 3);
  CHECK(three.open.empty());
  CHECK(three.stuck.empty());
  CHECK(three.unproved.empty());
}

TEST_CASE("units that were kept, shared out and put together make the same table", "[census]") {
  RecordsInMemory all;
  std::map<std::string, std::string>& kept = all.texts;
  WorkOptions how;
  how.records = all.both();
  how.share = Share{1, 2};
  CHECK(classify_manifolds(3, how).missing_units == units_of_three(0, 2)); // whatever is in them
  const std::size_t half = kept.size();
  REQUIRE(half > 0);
  how.share.reset();
  CHECK(classify_manifolds(3, how).manifolds.empty());
  how.share = Share{};
  CHECK(write_table(3, classify_manifolds(3, how).manifolds) == stored_table_text(3));
  CHECK(kept.size() > half);
  how.share.reset(); // nothing is computed any more
  CHECK(write_table(3, classify_manifolds(3, how).manifolds) == stored_table_text(3));

  SECTION("a unit of other gluings does not count") {
    std::vector<std::string> keys; // of units of three tetrahedra
    for (const auto& [key, text] : kept)
      if (key.starts_with("3.") && !key.ends_with("no")) keys.push_back(key);
    REQUIRE(keys.size() > 1);
    const std::string right = kept[keys[0]];
    for (const std::string& wrong :
         {kept[keys[1]], std::string("[]"), std::string("no JSON"), right + " ", right.substr(1)}) {
      kept[keys[0]] = wrong;
      CHECK(classify_manifolds(3, how).missing_units == (wrong == right + " " ? 0 : 1));
    }
  }
}

TEST_CASE("units that are made one by one, backwards, are the classification", "[census]") {
  RecordsInMemory all;
  const UnitRecords records = all.both();
  const ClassificationUnits units(3, true);
  REQUIRE(units.size() == units_of_three(0, 1));
  int without = 0;
  for (int k = units.size() - 1; k >= 0; --k) {
    REQUIRE_FALSE(units.is_kept(k, records));
    const auto made = units.make(k);
    for (const auto& [key, text] : made) records.keep(key, text);
    without += made.empty();
    REQUIRE(units.is_kept(k, records) == !made.empty());
  }
  CHECK(without < units.size());
  WorkOptions how;
  how.records = records;
  how.share.reset(); // nothing is computed any more
  CHECK(write_table(3, classify_manifolds(3, how).manifolds) == stored_table_text(3));
  // A unit whose second look is missing is not kept.
  const auto second = std::find_if(all.texts.begin(), all.texts.end(),
                                   [](const auto& record) { return record.first.ends_with(".no"); });
  REQUIRE(second != all.texts.end());
  int before = 0;
  int after = 0;
  for (int k = 0; k < units.size(); ++k) before += units.is_kept(k, records);
  all.texts.erase(second);
  for (int k = 0; k < units.size(); ++k) after += units.is_kept(k, records);
  CHECK(after == before - 1);
  CHECK_THROWS_AS(ClassificationUnits(0, true), PreconditionError);
}

TEST_CASE("what is looked up is what the table holds", "[census]") {
  CHECK(stored_names().size() == 8 + 151 + 5033 + 14 + 701);
  for (const TableKey n : {TableKey(2), TableKey(3), TableKey(2, false), TableKey(3, false)})
    for (const Manifold& m : stored_table(n)) {
      REQUIRE(find_by_name(m.name) == m);
      REQUIRE(find_by_isometry_signature(m.canonical_signature) == m);
    }
  CHECK(find_by_name("fmp4_5033")->symmetries == stored_table(4).back().symmetries);
  for (const char* name : {"fmp4_5034", "fmp4_0", "fmp4_", "fmp4_1\"", "fmp5_1", ""})
    CHECK_FALSE(find_by_name(name));
  CHECK_FALSE(find_by_isometry_signature(""));
  CHECK_FALSE(find_by_isometry_signature("eLAkbcbdddhjh"));
}

TEST_CASE("the canonical triangulation tells the isometries", "[census]") {
  std::map<std::pair<std::string, bool>, int> groups;
  for (const TableKey n : stored_tables())
    for (const Manifold& m : stored_table(n)) {
      const Symmetry symmetry = symmetry_of(m);
      REQUIRE(symmetry.order == m.symmetries);
      REQUIRE_FALSE(symmetry.group.empty());
      REQUIRE(symmetry.amphichiral.has_value() == n.orientable);
      if (n == TableKey(2)) ++groups[{symmetry.group, *symmetry.amphichiral}];
    }
  // By hand, of two regular tetrahedra: the exterior of the knotted Y has the symmetries of the graph (D3).
  CHECK(symmetry_of(*find_by_name("fmp2_8")).group == "D3");
  CHECK(groups.at({"D3", false}) >= 1);
  Manifold broken = stored_table(2).front();
  broken.canonical_signature = "no signature";
  CHECK_THROWS_AS(symmetry_of(broken), InputError);
}

TEST_CASE("one tetrahedron makes no manifold with geodesic boundary", "[census]") {
  CHECK(classify_manifolds(1).manifolds.empty()); // FMP 2004
}

TEST_CASE("four tetrahedra make 5,033 manifolds", "[census][slow]") {
  // FMP 2004: 5,033 manifolds: 5,002 compact ones with boundary of genus 4, 3, 2 (2340 + 2034 + 628), 30 with
  // one cusp and one with two; 262 volumes, counted as 252 of compact and 10 of cusped ones with one in both.
  const Classification four = classify_manifolds(4, 2);
  CHECK(four.manifolds.size() == 5033);
  CHECK(count_volumes(four.manifolds).size() == 261);
  CHECK(four.tally.stuck == 0);
  // Every structure is proved, and so are its cells: 84 manifolds have others than tetrahedra, by the
  // arguments R, F, B as often as mathematics says (counted by a prototype in other arithmetic: 74, 1, 9
  // manifolds).
  CHECK(four.unproved.empty());
  // Every gluing is settled: 168 are proved to carry none, and 32 are manifolds of three tetrahedra.
  CHECK(four.open.empty());
  CHECK(four.tally.gluings == four.tally.geometric + four.tally.elsewhere + four.tally.none);
  CHECK(four.tally.certified == four.tally.geometric + four.tally.elsewhere);
  CHECK(four.tally.proved == four.tally.certified);
  CHECK(four.tally.flat == 84);
  CHECK(four.tally.widest < 1e-30);
  CHECK(four.tally.arguments.at('F') == 1);
  CHECK(four.tally.arguments.at('B') == 9);
  int one_cusp = 0;
  int two_cusps = 0;
  std::map<int, int> genus;
  for (const Manifold& m : four.manifolds) {
    one_cusp += m.cusps == 1;
    two_cusps += m.cusps == 2;
    if (m.cusps == 0) ++genus[m.boundary.front()];
  }
  CHECK(one_cusp == 30);
  CHECK(two_cusps == 1);
  CHECK(genus == std::map<int, int>{{2, 628}, {3, 2034}, {4, 2340}});
}

TEST_CASE("chi(boundary) is 2 (E - T) for every stored gluing", "[census]") {
  for (const TableKey n : stored_tables()) {
    for (const Manifold& m : stored_table(n)) {
      const Triangulation tri = from_signature(m.signature);
      int euler = 0;
      for (const int genus : m.boundary) euler += genus > 0 ? 2 - 2 * genus : 2 + genus;
      CHECK(euler == 2 * (Skeleton(tri).edge_count() - n.tetrahedra));
    }
  }
}

TEST_CASE("names are unique, and lead back to their manifold", "[census]") {
  std::set<std::string> isometry;
  for (const TableKey n : stored_tables())
    for (const Manifold& m : stored_table(n)) {
      CHECK(find_by_name(m.name) == m);
      CHECK(isometry.insert(m.canonical_signature).second);
    }
  CHECK_FALSE(find_by_name("fmp3_152"));
  CHECK_FALSE(find_by_name("tetn3_702"));
  CHECK_FALSE(find_by_name("m004"));
}

TEST_CASE("a table survives writing and reading, and a broken one is refused", "[census]") {
  const auto two = stored_table(2);
  const std::string text = write_table(2, two);
  CHECK(read_table(text, "x") == two);
  CHECK_THROWS_AS(read_table(text.substr(0, text.size() / 2), "x"), InputError);
  CHECK_THROWS_AS(read_table("{}", "x"), InputError);
  std::string wrong = text;
  wrong.replace(wrong.find("cMca"), 4, "c!ca");
  CHECK_THROWS_WITH(read_table(wrong, "x.json"), Catch::Contains("x.json") && Catch::Contains("manifold 0"));
}

TEST_CASE("validation keeps rebuilt and re-solved apart", "[census]") {
  const Validation v = validate(2);
  CHECK(v.rebuilt);
  CHECK(v.failures.empty());
  CHECK(v.manifolds == 8);
  CHECK(v.max_angle_error < 1e-10);
  CHECK(v.max_angle_error_flow < 1e-9);
  CHECK_THROWS_AS(validate(5), InputError);
  CHECK_THROWS_WITH(validate({4, false}), Catch::Contains("not orientable") && Catch::Contains("2, 3"));
}

TEST_CASE("Regina agrees about signature, homology, boundary and symmetries of every entry",
          "[census][oracle]") {
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/regina_census.txt");
  std::vector<std::string> recorded;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('#')) recorded.push_back(line);
  std::vector<std::string> ours;
  for (const TableKey n : {TableKey(2), TableKey(3), TableKey(2, false), TableKey(3, false)}) {
    for (const Manifold& m : stored_table(n)) {
      std::string homology; // "Z^2 + Z/3" is Regina's "2 Z + Z_3", "Z^2 + Z/2 + Z/2" its "2 Z + 2 Z_2"
      const Triangulation tri = from_signature(m.signature);
      const algebra::AbelianGroup group = algebra::homology(tri, Skeleton(tri), 1);
      CHECK(group.str() == m.homology);
      std::map<algebra::Integer, int> orders;
      for (const auto& order : group.torsion()) ++orders[order];
      if (group.rank() > 0) homology = (group.rank() > 1 ? std::to_string(group.rank()) : "") + "Z";
      for (const auto& [order, count] : orders)
        homology +=
            (homology.empty() ? "" : "+") + (count > 1 ? std::to_string(count) : "") + "Z_" + order.str();
      std::string links;
      for (const int genus : m.boundary)
        links += (links.empty() ? "" : ",") + std::to_string(genus > 0 ? 2 - 2 * genus : 2 + genus);
      for (int k = 0; k < m.cusps; ++k) links += ",0";
      ours.push_back(m.signature + "|" + homology + "|" + links + "|" + std::to_string(m.symmetries));
    }
  }
  CHECK(ours == recorded);
}
