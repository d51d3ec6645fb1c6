// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/records.hpp"

#include "support/errors.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

using namespace tetrarch;
using format::Records;

namespace {

/// A file in a folder of its own.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("records_" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string file() const { return (path / "records").string(); }
};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

} // namespace

TEST_CASE("records come back, the last of each key", "[records]") {
  const Folder folder;
  {
    Records records(folder.file(), "a test", Records::Open::fresh);
    records.add("1", "one");
    records.add("2", "");
    records.add("1", "uno dos");
    CHECK_THROWS_AS(records.add("3", "two\nlines"), PreconditionError);
    CHECK_THROWS_AS(records.add("a key", "x"), PreconditionError);
    CHECK_THROWS_AS(Records(folder.file(), "a test", Records::Open::resume), InputError); // in use
  }
  const Records again(folder.file(), "a test", Records::Open::read);
  REQUIRE(again.size() == 2);
  CHECK(*again.find("1") == "uno dos");
  CHECK(again.find("2")->empty());
  CHECK(again.find("3") == nullptr);
  CHECK(again.damaged() == 0);
  CHECK_THROWS_AS(Records(folder.file(), "a test", Records::Open::fresh), InputError);
  CHECK_THROWS_AS(Records(folder.file(), "another", Records::Open::resume), InputError);
}

TEST_CASE("a file cut off anywhere keeps its whole records and goes on", "[records]") {
  const Folder folder;
  {
    Records records(folder.file(), "a test", Records::Open::fresh);
    for (int k = 0; k < 5; ++k) records.add(std::to_string(k), "text of " + std::to_string(k));
  }
  const std::string whole = content(folder.file());
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    write(folder.file(), whole.substr(0, length));
    Records records(folder.file(), "a test", Records::Open::resume);
    for (int k = 0; k < 5; ++k)
      if (records.find(std::to_string(k)) == nullptr)
        records.add(std::to_string(k), "text of " + std::to_string(k));
    REQUIRE(content(folder.file()) == whole);
  }
}

TEST_CASE("an altered record is as if it had not been written", "[records]") {
  const Folder folder;
  {
    Records records(folder.file(), "a test", Records::Open::fresh);
    for (int k = 0; k < 5; ++k) records.add(std::to_string(k), "text");
  }
  const std::string whole = content(folder.file());
  const std::size_t heading = whole.find('\n') + 1;
  for (std::size_t at = heading; at < whole.size(); ++at) {
    std::string altered = whole;
    altered[at] ^= 1;
    write(folder.file(), altered);
    const Records records(folder.file(), "a test", Records::Open::read);
    REQUIRE(records.damaged() >= 1);
    int found = 0;
    for (int k = 0; k < 5; ++k)
      if (const std::string* text = records.find(std::to_string(k))) {
        REQUIRE(*text == "text");
        ++found;
      }
    REQUIRE(found >= 3); // a line feed more or less is in two of them
    REQUIRE(found < 5);
  }
}

TEST_CASE("what is no file of records is left alone", "[records]") {
  const Folder folder;
  write(folder.file(), "notes of mine\n");
  CHECK_THROWS_AS(Records(folder.file(), "a test", Records::Open::resume), InputError);
  CHECK(content(folder.file()) == "notes of mine\n");
  CHECK_THROWS_AS(Records((folder.path / "none").string(), "a test", Records::Open::read), InputError);
  CHECK_THROWS_AS(Records("/nowhere/records", "a test", Records::Open::fresh), InputError);
}
