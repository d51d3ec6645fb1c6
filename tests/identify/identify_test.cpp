// SPDX-License-Identifier: GPL-2.0-or-later
/// Manifolds made large and strange, and known again.

#include "support/links.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/catalogue/database.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/identify/identify.hpp"
#include "tetrarch/moves/simplify.hpp"
#include "tetrarch/moves/subdivide.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <thread>

using namespace tetrarch;
using namespace tetrarch::catalogue;
using namespace tetrarch::identify;
using namespace tetrarch::support;

namespace {

/// Another triangulation of the same manifold with real boundary and at least `size` tetrahedra: a finite
/// model, subdivided here and there by chance, shaken, and renamed.
Triangulation grown(const Triangulation& small, int size, std::uint64_t seed) {
  Random random(seed);
  Triangulation tri = moves::finite_model(small).tri;
  while (tri.size() < size) {
    if (24 * tri.size() <= size && random.below(2) == 0) {
      tri = moves::barycentric(tri).tri;
      continue;
    }
    std::vector<int> tets(static_cast<std::size_t>(tri.size()));
    std::iota(tets.begin(), tets.end(), 0);
    random.shuffle(tets);
    tets.resize(std::min(tets.size(), static_cast<std::size_t>(size - tri.size() + 2) / 3));
    tri = moves::subdivided_1_4(tri, tets).tri;
  }
  moves::Complex complex(tri);
  SplitMix64 shaking(seed);
  moves::shake(complex, tri.size(), shaking);
  tri = complex.triangulation();
  return relabelled(tri, random_relabelling(tri.size(), random));
}

std::vector<Manifold> both_tables() {
  std::vector<Manifold> all = stored_table(2);
  for (const Manifold& m : stored_table(3)) all.push_back(m);
  return all;
}

std::string told(const Identification& found) {
  std::string text;
  for (const std::string& sentence : found.tried) text += sentence + "; ";
  return text;
}

/// Grows every `step`-th manifold of a list and identifies it.
void check_round_trips(const std::vector<Manifold>& manifolds, std::size_t step, int size) {
  for (std::size_t k = 0; k < manifolds.size(); k += step) {
    const Manifold& m = manifolds[k];
    const Triangulation tri = grown(from_signature(m.signature), size, 7 + k);
    REQUIRE(tri.size() >= size - size / 100); // shaking may take a few away
    const Identification found = identify::identify(tri);
    INFO(m.name << " of " << tri.size() << " tetrahedra: " << told(found));
    CHECK(found.name == m.name);
    CHECK(found.by == Identification::By::isometry_signature);
    REQUIRE(found.manifold);
    CHECK(*found.manifold == m);
    CHECK(found.volume.value_or(0) == Approx(std::stod(m.volume)).epsilon(1e-10));
  }
}

std::string homology_of(const Identification& found) {
  return algebra::homology(found.triangulation, Skeleton(found.triangulation), 1).str();
}

} // namespace

TEST_CASE("census manifolds of ten thousand tetrahedra are known by name", "[identify]") {
  check_round_trips(stored_table(2), 1, 10'000);
  check_round_trips(stored_table(3), 15, 10'000);
}

TEST_CASE("all census manifolds come back from ten thousand tetrahedra, some from more", "[identify][slow]") {
  check_round_trips(both_tables(), 1, 10'000);
  check_round_trips(both_tables(), 15, 100'000);
}

TEST_CASE("cusped manifolds of fame are known by name", "[identify]") {
  // From the exteriors of links drawn as grid diagrams: links.hpp has witnesses for what they are and for
  // their volumes. H1 of the exterior of a link of c components is Z^c; of the others see the zoo.
  const std::vector<std::pair<std::string, std::string>> names{
      {"figure eight", "figure-eight knot complement (m004)"},
      {"5_2", "5_2 knot complement (m015)"},
      {"Whitehead link", "Whitehead link complement (m129)"},
      {"Borromean rings", "Borromean rings complement"}};
  for (const auto& [link, name] : names) {
    const NamedLink& known = named_link(link);
    const Identification found = identify::identify(triangulation_of(exterior(known.grid)));
    INFO(link << ": " << told(found));
    CHECK(found.name == name);
    CHECK(found.volume.value_or(0) == Approx(known.volume).epsilon(1e-12));
    CHECK(homology_of(found) == (known.components == 1 ? "Z" : "Z^" + std::to_string(known.components)));
    CHECK_FALSE(found.manifold); // has no geodesic boundary
    // The box around the link.
    CHECK(told(found).find("1 boundary sphere was filled in") != std::string::npos);
    // The Borromean rings' cells are octahedra, whose faces symmetry proves flat.
    CHECK_FALSE(found.confirmed_only);
    CHECK((told(found).find("proved flat") != std::string::npos) == (link == "Borromean rings"));
  }
  // Volumes: half of m004's, and the same as m004's (Adams 1987; Cao and Meyerhoff 2001).
  const std::vector<std::tuple<std::string, std::string, double>> others{
      {"Gieseking manifold m000", "Gieseking manifold (m000)", 2.029883212819 / 2},
      {"figure-eight sister m003", "figure-eight sister (m003)", 2.029883212819}};
  for (const auto& [entry, name, volume] : others) {
    const Identification found = identify::identify(grown(zoo(entry).triangulation(), 1000, 3));
    INFO(entry << ": " << told(found));
    CHECK(found.name == name);
    CHECK(found.volume.value_or(0) == Approx(volume).epsilon(1e-12));
  }
}

TEST_CASE("flat cells are proved, or it is said that they are not", "[identify]") {
  // Every tenth of the 84 manifolds of four tetrahedra with flat cells: `canonize` proves all of them.
  int flat = 0;
  for (const Manifold& m : stored_table(4)) {
    const bool tetrahedral = std::all_of(m.cells.begin(), m.cells.end(),
                                         [](const std::string& cell) { return cell == "tetrahedron"; });
    if (tetrahedral || ++flat % 10 != 0) continue;
    const Identification found = identify::identify(grown(from_signature(m.signature), 100, 5));
    INFO(m.name << ": " << told(found));
    CHECK(found.name == m.name);
    CHECK_FALSE(found.confirmed_only);
    CHECK(told(found).find("are proved flat") != std::string::npos);
    CHECK(told(found).find("not a proof") == std::string::npos);
  }
  CHECK(flat == 84);
  // Where all cells are tetrahedra, there is nothing to say.
  CHECK(told(identify::identify(from_signature(stored_table(2)[0].signature))).find("flat") ==
        std::string::npos);
}

TEST_CASE("without a structure the triangulation or the group may tell", "[identify]") {
  const std::vector<std::tuple<std::string, std::string, Identification::By>> names{
      {"L(7,2)", "L(7,2)", Identification::By::triangulation},
      {"3-torus", "T^3", Identification::By::group},
      {"B^3, one tetrahedron", "B^3", Identification::By::group},
      {"genus 2 handlebody", "genus 2 handlebody", Identification::By::group},
      {"solid Klein bottle", "solid Klein bottle", Identification::By::group}};
  for (const auto& [entry, name, by] : names) {
    const Identification found = identify::identify(moves::barycentric(zoo(entry).triangulation()).tri);
    INFO(entry << ": " << told(found));
    CHECK(found.name == name);
    CHECK(found.by == by);
    CHECK_FALSE(found.volume);
    CHECK(found.isometry_signature.empty());
  }
}

TEST_CASE("why there is no name is said", "[identify]") {
  // Torus knots have no hyperbolic structure: the trefoil's group amalgamates two cyclic ones. It tells no name.
  const Identification trefoil = identify::identify(triangulation_of(exterior(named_link("trefoil").grid)));
  CHECK_FALSE(trefoil);
  CHECK(trefoil.name.empty());
  CHECK(told(trefoil).find("not hyperbolic: every relator holds the generator") != std::string::npos);
  CHECK(told(trefoil).find("not recognised") != std::string::npos);
  // The exterior of the knot 7_6, of eight tetrahedra, one more than the census has (t11291, says Regina; its
  // volume is the knot tables').
  const Identification unnamed = identify::identify(from_signature("iLLPwQcccdefghhhhggaaaacv"));
  INFO(told(unnamed));
  CHECK_FALSE(unnamed);
  CHECK(unnamed.volume.value_or(0) == Approx(7.08492595351).epsilon(1e-9));
  CHECK(told(unnamed).find("isometry signature " + unnamed.isometry_signature + " is in no table") !=
        std::string::npos);
  // The installed file of tables, where there is one, goes further than what is compiled in.
  const catalogue::Database* const installed = catalogue::installed_database();
  int largest = 4;
  if (installed != nullptr)
    for (const catalogue::TableKey table : installed->tables()) largest = std::max(largest, table.tetrahedra);
  CHECK(told(unnamed).find("up to " + std::to_string(largest) + " tetrahedra") != std::string::npos);
}

TEST_CASE("identification does not depend on the thread, only on the manifold", "[identify]") {
  const Triangulation tri = grown(from_signature(stored_table(3)[99].signature), 2000, 1);
  Identification a;
  Identification b;
  std::thread other([&] { a = identify::identify(tri); });
  b = identify::identify(tri);
  other.join();
  CHECK(a.name == "fmp3_100");
  CHECK(a.name == b.name);
  CHECK(a.tried == b.tried);
  CHECK(a.triangulation == b.triangulation);
}

TEST_CASE("only connected manifolds can be identified", "[identify]") {
  CHECK_THROWS_AS(identify::identify(Triangulation()), PreconditionError);
  CHECK_THROWS_AS(identify::identify(Triangulation(2)), PreconditionError);
}
