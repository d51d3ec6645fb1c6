// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/compressed.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/text.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <unistd.h>

using namespace tetrarch;
using namespace tetrarch::format;

namespace {

/// "twelve bytes" three hundred times, packed by xz 5.4.1: printf 'twelve bytes%.0s' {1..300} | xz
constexpr std::array<unsigned char, 104> packed_bytes{
    0xfd, 0x37, 0x7a, 0x58, 0x5a, 0x00, 0x00, 0x04, 0xe6, 0xd6, 0xb4, 0x46, 0x02, 0x00, 0x21,
    0x01, 0x16, 0x00, 0x00, 0x00, 0x74, 0x2f, 0xe5, 0xa3, 0xe0, 0x0e, 0x0f, 0x00, 0x26, 0x5d,
    0x00, 0x3a, 0x1d, 0xc8, 0xce, 0x69, 0xc9, 0x8d, 0x25, 0x91, 0xa0, 0x6b, 0x71, 0xaa, 0xfa,
    0x89, 0xa6, 0x11, 0xa3, 0x2e, 0x7a, 0x4d, 0xc3, 0xd5, 0xbf, 0x81, 0x62, 0x4a, 0x20, 0x0d,
    0xf0, 0x4b, 0x81, 0xc7, 0x9c, 0x6c, 0xef, 0xd4, 0x00, 0x00, 0x00, 0x00, 0x01, 0xfa, 0x70,
    0x0f, 0x18, 0x12, 0x33, 0x09, 0x00, 0x01, 0x42, 0x90, 0x1c, 0x00, 0x00, 0x00, 0x8d, 0xb0,
    0x0c, 0x4a, 0xb1, 0xc4, 0x67, 0xfb, 0x02, 0x00, 0x00, 0x00, 0x00, 0x04, 0x59, 0x5a};
const std::string three_hundred(packed_bytes.begin(), packed_bytes.end());

std::string repeated(int count) {
  std::string text;
  for (int k = 0; k < count; ++k) text += "twelve bytes";
  return text;
}

} // namespace

TEST_CASE("what xz packed is unpacked, and all else stays as it is", "[format]") {
  CHECK(unpacked(three_hundred, "x") == repeated(300));
  CHECK(unpacked(three_hundred + three_hundred, "x") == repeated(600)); // as xz -d does
  for (const std::string& other : {std::string(), std::string("text"), three_hundred.substr(1)})
    CHECK(unpacked(other, "x") == other);
}

TEST_CASE("damaged or endless packed files are refused", "[format]") {
  for (std::size_t length = 6; length < three_hundred.size(); ++length)
    CHECK_THROWS_WITH(unpacked(three_hundred.substr(0, length), "x.xz"), Catch::Contains("x.xz"));
  for (std::size_t at = 6; at < three_hundred.size(); ++at) {
    std::string damaged = three_hundred;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    CHECK_THROWS_AS(unpacked(damaged, "x"), InputError);
  }
  CHECK_THROWS_WITH(unpacked(three_hundred, "x", 3599), Catch::Contains("more than 3599 bytes"));
  CHECK(unpacked(three_hundred, "x", 3600).size() == 3600);
}

TEST_CASE("what is packed is unpacked again, and smaller where it repeats itself", "[format]") {
  std::string text;
  for (int k = 0; k < 20'000; ++k) text += "line " + std::to_string(k % 7) + "\n";
  for (const std::string& bytes : {std::string(), std::string("\0\xFF", 2), text}) {
    const std::string small = tetrarch::format::packed(bytes);
    CHECK(small.starts_with("\xFD"
                            "7zXZ"));
    CHECK(unpacked(small, "x") == bytes);
  }
  CHECK(tetrarch::format::packed(text).size() < text.size() / 100);
}

TEST_CASE("a file that grows is there at the end or not at all", "[format]") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("tetrarch-grow-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "file").string();
  {
    GrowingFile file(path);
    file.add("one\n");
    CHECK_FALSE(std::filesystem::exists(path));
  }
  CHECK(std::filesystem::is_empty(folder));
  {
    GrowingFile file(path);
    file.add("one\n");
    file.add("two\n");
    file.keep();
  }
  CHECK(read_file(path) == "one\ntwo\n");
  {
    GrowingFile file(path); // given up
    file.add("three\n");
  }
  CHECK(read_file(path) == "one\ntwo\n");
  CHECK_THROWS_AS(GrowingFile((folder / "none" / "file").string()), InputError);
  CHECK_THROWS_AS(GrowingFile(folder.string()), InputError);
  GrowingFile full("/dev/full");
  CHECK_THROWS_WITH(full.add("x"), Catch::Contains("/dev/full"));
  std::filesystem::remove_all(folder);
}
