// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/database.hpp"

#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sqlite3.h>
#include <unistd.h>

using namespace tetrarch;
using namespace tetrarch::catalogue;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
  Folder() : path(std::filesystem::temp_directory_path() / ("tetrarch-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
  std::filesystem::path path;
};

std::vector<Manifold> all_stored() {
  std::vector<Manifold> all;
  for (const TableKey n : stored_tables())
    for (Manifold& m : without_angles(stored_table(n))) all.push_back(std::move(m));
  return all;
}

void write_database(const std::string& path, const std::vector<Manifold>& manifolds) {
  std::ofstream(path, std::ios::binary) << database_of(manifolds);
}

std::vector<Manifold> found(const Database& file, const Wanted& wanted) {
  std::vector<Manifold> list;
  file.visit(wanted, [&](const Manifold& m) { list.push_back(m); });
  return list;
}

} // namespace

TEST_CASE("a file of tables gives back what was put in", "[census]") {
  const Folder folder;
  const std::vector<Manifold> all = all_stored();
  write_database(folder / "census.sqlite", all);
  CHECK(is_database(folder / "census.sqlite"));
  const Database file(folder / "census.sqlite");
  CHECK(file.tables() == std::vector<TableKey>{2, 3, 4, {2, false}, {3, false}});
  CHECK(found(file, {}) == all);
  for (std::size_t k = 0; k < all.size(); k += 17) {
    REQUIRE(file.by_name(all[k].name) == all[k]);
    REQUIRE(file.by_isometry_signature(all[k].canonical_signature) == all[k]);
  }
  for (const char* name : {"", "fmp4_5034", "fmp4_", "fmp2_1' OR '1'='1", "FMP2_1"})
    CHECK_FALSE(file.by_name(name));
  CHECK_FALSE(file.by_isometry_signature(""));
}

TEST_CASE("a file of tables counts as Frigerio, Martelli and Petronio do", "[census]") {
  const Folder folder;
  write_database(folder / "census.sqlite", all_stored());
  const Database file(folder / "census.sqlite");
  const auto wanted = [](int tetrahedra, const auto& change) {
    Wanted w;
    w.tetrahedra = tetrahedra;
    w.orientable = true;
    change(w);
    return w;
  };
  // FMP 2004: compact ones of genus 4, 3, 2 among 5,033; 30 with a cusp and one with two; 74 of one edge.
  const std::map<int, int> by_genus{{4, 2340}, {3, 2034}, {2, 628}};
  for (const auto& [genus, count] : by_genus)
    CHECK(file.count(wanted(4, [g = genus](Wanted& w) {
      w.boundary = std::vector<int>{g};
      w.cusps = 0;
    })) == count);
  CHECK(file.count(wanted(4, [](Wanted& w) { w.cusps = 1; })) == 30);
  CHECK(file.count(wanted(4, [](Wanted& w) { w.cusps = 2; })) == 1);
  CHECK(file.count(wanted(3, [](Wanted& w) { w.least_volume = 10.4; })) == 74);
  CHECK(file.count(wanted(3, [](Wanted& w) { w.greatest_volume = 10.4; })) == 77);
  CHECK(file.count(wanted(3, [](Wanted& w) { w.homology = "Z^2+Z/3"; })) ==
        file.count(wanted(3, [](Wanted& w) { w.homology = " Z^2 + Z/3 "; })));
  CHECK(file.count(wanted(5, [](Wanted&) {})) == 0);
  // Counted by Regina's word on the links: tests/oracle/regina_census.txt.
  CHECK(file.count({3, std::vector<int>{-4}, 0, 100, "", 1, false}) == 9);
  CHECK(file.count({3, std::vector<int>{2}, 0, 100, "", {}, false}) == 1);
  CHECK(file.count({}) == 8 + 151 + 5033 + 14 + 701);
}

TEST_CASE("conditions mean the same in a file and in a table", "[census]") {
  const Folder folder;
  const std::vector<Manifold> all = all_stored();
  write_database(folder / "census.sqlite", all);
  const Database file(folder / "census.sqlite");
  for (std::size_t k = 0; k < all.size(); k += 97) {
    Wanted wanted;
    if (k % 2 == 0) wanted.tetrahedra = all[k].tetrahedra;
    if (k % 3 == 0) wanted.boundary = all[k].boundary;
    if (k % 5 != 0) wanted.homology = all[k].homology;
    if (k % 7 == 0) wanted.cusps = all[k].cusps;
    const double volume = std::stod(all[k].volume);
    if (k % 4 < 2) wanted.least_volume = volume;
    if (k % 4 == 1) wanted.greatest_volume = volume;
    std::vector<Manifold> expected;
    for (const Manifold& m : all)
      if (wanted.fits(m)) expected.push_back(m);
    CHECK_FALSE(expected.empty());
    CHECK(found(file, wanted) == expected);
    CHECK(file.count(wanted) == static_cast<long long>(expected.size()));
  }
}

TEST_CASE("looking a manifold up uses an index", "[census]") {
  const Folder folder;
  write_database(folder / "census.sqlite", all_stored());
  sqlite3* db = nullptr;
  REQUIRE(::sqlite3_open_v2((folder / "census.sqlite").c_str(), &db, SQLITE_OPEN_READONLY, nullptr) ==
          SQLITE_OK);
  const auto plan = [db](const char* condition) {
    std::string text;
    const auto keep = [](void* out, int columns, char** values, char**) {
      *static_cast<std::string*>(out) += std::string(values[columns - 1]) + "\n";
      return 0;
    };
    const std::string sql = std::string("EXPLAIN QUERY PLAN SELECT * FROM manifold WHERE ") + condition;
    ::sqlite3_exec(db, sql.c_str(), keep, &text, nullptr);
    return text;
  };
  CHECK_THAT(plan("name = 'fmp3_1'"), Catch::Contains("USING INDEX by_name"));
  CHECK_THAT(plan("canonical_signature = 'x'"), Catch::Contains("USING INDEX by_canonical_signature"));
  CHECK_THAT(plan("tetrahedra = 4 AND volume_value > 14"), Catch::Contains("USING INDEX"));
  CHECK_THAT(plan("tetrahedra = 4 AND homology = 'Z^2'"), Catch::Contains("USING INDEX"));
  ::sqlite3_close(db);
}

TEST_CASE("what is no file of tables is refused, and names do not repeat", "[census]") {
  const Folder folder;
  CHECK_THROWS_WITH(Database(folder / "none"), Catch::Contains("there is no such file"));
  std::ofstream(folder / "text")
      << "no database, but longer than the heading of one, which has sixteen bytes\n";
  CHECK_FALSE(is_database(folder / "text"));
  CHECK_FALSE(is_database(folder / "none"));
  CHECK_THROWS_AS(Database(folder / "text"), InputError);
  sqlite3* db = nullptr; // somebody else's
  ::sqlite3_open((folder / "other").c_str(), &db);
  ::sqlite3_exec(db, "CREATE TABLE manifold (name TEXT)", nullptr, nullptr, nullptr);
  ::sqlite3_close(db);
  CHECK_THROWS_WITH(Database(folder / "other"), Catch::Contains("no file of census tables"));

  std::vector<Manifold> twice = without_angles(stored_table(2));
  write_database(folder / "good", twice);
  twice.push_back(twice.front());
  CHECK_THROWS_WITH(database_of(twice), Catch::Contains("UNIQUE"));
  CHECK(Database(folder / "good").count({}) == 8);
}

TEST_CASE("a table of lines gives its manifolds back with their names", "[census]") {
  for (const TableKey n : {TableKey(2), TableKey(3), TableKey(2, false)}) {
    const std::vector<Manifold> table = without_angles(stored_table(n));
    const std::string text = write_table_lines(n, table);
    CHECK(std::count(text.begin(), text.end(), '\n') == static_cast<long>(table.size()) + 1);
    CHECK(read_table(text, "x") == table);
    CHECK_THROWS_AS(read_table(text.substr(0, text.size() - 30), "x"), InputError);
    std::string wrong = text;
    wrong.replace(wrong.find("\"version\":1"), 11, "\"version\":9");
    CHECK_THROWS_WITH(read_table(wrong, "x"), Catch::Contains("version"));
  }
  CHECK(name_prefix(4) == "fmp4_");
  CHECK(name_prefix(5) == "tet5_");
  CHECK(name_prefix({5, false}) == "tetn5_");
}
