// SPDX-License-Identifier: GPL-2.0-or-later
#include "expect.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <locale>
#include <sys/stat.h>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

TEST_CASE("a cursor knows the line of the next token", "[text]") {
  TextCursor in("one two\n\n  three\r\n4 5.5", "here");
  CHECK(in.line() == 1);
  CHECK(in.token("a word") == "one");
  CHECK(in.token("a word") == "two");
  CHECK(in.line() == 3);
  CHECK(in.peek() == "three");
  CHECK(in.token("a word") == "three");
  CHECK(in.integer("an integer", 0, 9) == 4);
  CHECK(in.number("a number") == 5.5);
  CHECK(in.at_end());
  CHECK(in.peek().empty());
  CHECK(in.line() == 4);
}

TEST_CASE("the rest of a line is trimmed and its end passed over", "[text]") {
  TextCursor in("name  of it \r\n\nnext", "here");
  CHECK(in.token("a word") == "name");
  CHECK(in.rest_of_line() == "of it");
  CHECK(in.rest_of_line().empty());
  CHECK(in.rest_of_line() == "next");
  CHECK(in.rest_of_line().empty());
}

TEST_CASE("a cursor names place, find and wish", "[text]") {
  const auto integer = [](std::string_view text) {
    return error_of([&] { TextCursor(text, "f").integer("a count", 0, 9); });
  };
  CHECK(integer("\n\nx1") == "f:3: found 'x1', expected a count");
  CHECK(integer("\n10") == "f:2: found '10', expected a count");
  CHECK(integer("1.5") == "f:1: found '1.5', expected a count");
  CHECK(integer("99999999999999999999") == "f:1: found '99999999999999999999', expected a count");
  CHECK(integer("  \n ") == "f:1: the text ends, expected a count");
  // Only the first 40 characters of a token are shown (core/error).
  CHECK(integer(std::string(1000, 'a')) == "f:1: found '" + std::string(40, 'a') + "...', expected a count");
  const auto number = [](std::string_view text, bool finite) {
    return error_of([&] { TextCursor(text, "f").number("a number", finite); });
  };
  CHECK(number("0,5", true) == "f:1: found '0,5', expected a number");
  CHECK(number("nan", true) == "f:1: found 'nan', expected a number");
  CHECK(number("inf", false).empty());
  CHECK(number("1e999", false) == "f:1: found '1e999', expected a number");
}

TEST_CASE("numbers read back as they were written", "[text]") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  for (const double x : {0.1, 1.0 / 3, 6.02214076e23, -2.5e-300, tiny, huge, 1e22, 123456789.0})
    CHECK(parse_double(to_text(x)) == x);
  CHECK(to_text(0.1) == "0.1");
  CHECK(to_text(1e22) == "1e+22");
  CHECK(std::signbit(*parse_double(to_text(-0.0))));
}

TEST_CASE("no locale changes a number", "[text]") {
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new German));
  CHECK(to_text(1234567.5) == "1234567.5");
  CHECK(parse_double("1234567.5") == 1234567.5);
  CHECK_FALSE(parse_double("1.234.567,5"));
  CHECK(error_of([] { TextCursor("\nx", "f").number("x"); }) == "f:2: found 'x', expected x");
  std::locale::global(old);
}

TEST_CASE("a file comes back as it was written", "[file]") {
  const Scratch scratch;
  const std::string content("a\0b\n\xff", 5);
  write_file_atomically(scratch / "new", content);
  CHECK(read_file(scratch / "new") == content);
  write_file_atomically(scratch / "new", "shorter");
  CHECK(read_file(scratch / "new") == "shorter");
  CHECK(scratch.count() == 1);
}

TEST_CASE("what cannot be read is named", "[file]") {
  const Scratch scratch;
  const auto reading = [](const std::string& path, std::size_t limit = longest_file) {
    return error_of([&] { read_file(path, limit); });
  };
  CHECK(reading(scratch / "none") == (scratch / "none") + ": there is no such file");
  CHECK(reading(scratch / ".") == (scratch / ".") + ": is a directory, expected a file");
  write_file_atomically(scratch / "long", "12345");
  CHECK(reading(scratch / "long", 4) == (scratch / "long") + ": is longer than 4 bytes");
  CHECK(reading(scratch / "long/below") == (scratch / "long/below") + ": cannot be read: Not a directory");
  CHECK(reading("/dev/zero", 1000000) == "/dev/zero: is longer than 1000000 bytes");
}

TEST_CASE("a write that fails leaves everything as it was", "[file]") {
  const Scratch scratch;
  const auto writing = [](const std::string& path) {
    return error_of([&] { write_file_atomically(path, "x"); });
  };
  CHECK(writing(scratch / "no/such") ==
        (scratch / "no/such") + ": cannot be written: No such file or directory");
  CHECK(writing(scratch / ".") == (scratch / ".") + ": is a directory, expected a file to write");
  CHECK(scratch.count() == 0);
  // A full device: what was there stays. /dev/full is Linux's device that is always full.
  CHECK(writing("/dev/full") == "/dev/full: cannot be written: No space left on device");
}

TEST_CASE("writing keeps permissions, links and devices", "[file]") {
  const Scratch scratch;
  write_file_atomically(scratch / "target", "old");
  REQUIRE(::chmod((scratch / "target").c_str(), 0640) == 0);
  std::filesystem::create_symlink("target", scratch / "link");
  write_file_atomically(scratch / "link", "new");
  CHECK(std::filesystem::is_symlink(scratch / "link"));
  CHECK(read_file(scratch / "target") == "new");
  struct stat about {};
  REQUIRE(::stat((scratch / "target").c_str(), &about) == 0);
  CHECK((about.st_mode & 0777U) == 0640U);
  write_file_atomically("/dev/null", "gone");
  CHECK(std::filesystem::is_character_file("/dev/null"));
  CHECK(scratch.count() == 2);
}
