// SPDX-License-Identifier: GPL-2.0-or-later
/// The knots of Rolfsen's table, as closures of braids.
///
/// Source: Rolfsen, "Knots and Links" (1976), appendix C; the braids are those of Bar-Natan, Morrison and
/// others, "The Knot Atlas" (katlas.org). 10_162 to 10_165 are numbered without the duplicate that Perko
/// found (1974).
#include "tetrarch/diagram/names.hpp"

#include "readers.hpp"

#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/diagram/read.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace tetrarch::diagram {
namespace {

/// a, b, ... are the generators, A, B, ... their inverses. From 3_1 to 10_165.
constexpr std::array<std::string_view, 249> braids{{
    // 3 crossings
    "AAA",
    // 4 crossings
    "AbAb",
    // 5 crossings
    "AAAAA",
    "AAABaB",
    // 6 crossings
    "AABacBc",
    "AAAbAb",
    "AAbAbb",
    // 7 crossings
    "AAAAAAA",
    "AAABaBCbC",
    "aaaaabAb",
    "aabAbbcBc",
    "AAAABaBB",
    "AAbACbC",
    "aBaBcBc",
    // 8 crossings
    "AABaBCbdCd",
    "AAAAAbAb",
    "AABacBcdCd",
    "AAAbAbcBc",
    "aaaBaaaB",
    "AAAABacBc",
    "aaaaBaBB",
    "aaabACbCC",
    "AAAbAbbb",
    "aaaBaaBB",
    "AABaBBcBc",
    "AbACbdCd",
    "AAbAbbcBc",
    "AAABaBcBc",
    "AAbACBBBC",
    "AAbAAbAb",
    "AAbAbAbb",
    "AbAbAbAb",
    "aaabaaab",
    "aaaBAAAB",
    "AAABaaBB",
    // 9 crossings
    "AAAAAAAAA",
    "AAABaBCbCDcD",
    "aaaaaaabAb",
    "AAAAABaBCbC",
    "aabAbbcBcdCd",
    "AAAAAABaBB",
    "AAAABaBCbCC",
    "AAbAbcBDcD",
    "AAAAABaBBB",
    "aabAbbbbcBc",
    "aaaaBacBc",
    "AAbACbCDcD",
    "aaaabAbbcBc",
    "aabACbCdCd",
    "aaabACbdCd",
    "aaaabbAbbb",
    "aBaBBBcBc",
    "AAABaBBBCbC",
    "aBaBBCbdCd",
    "AAAbACbCC",
    "aabAbCbdCd",
    "AbAbCbbbC",
    "AAABaBBCbCC",
    "AAbACbbbC",
    "AAbACBBdCd",
    "aaaBaBcBc",
    "AAbAbbCbC",
    "AAbACbbCC",
    "aBBcBaBcB",
    "AAbbAbCbC",
    "AAbAbCbCC",
    "aaBaBacBc",
    "AbAbbACbC",
    "AbAbCbAbC",
    "AABaBBCbbDcBDC",
    "aaaBaacBc",
    "AAbACbadCbCd",
    "AABBcBaBCCB",
    "aabACBadcBcd",
    "AbACbACbC",
    "AABacbbDCbCD",
    "aaaBAAcBc",
    "aaabaaCbC",
    "AAABaacBc",
    "AABaBACbC",
    "AbAbCBaBC",
    "AbAbcbAbc",
    "aabAbaCbAbC",
    "aabaaCbAbcc",
    // 10 crossings
    "AABaBCbCDceDe",
    "AAAAAAAbAb",
    "AABaBCbdCdeDe",
    "AAAbAbcBcdCd",
    "aaaaaaBaBB",
    "AAAAAABacBc",
    "AABaBCbCCdCd",
    "AAAAAbAbcBc",
    "aaaaaBaBBB",
    "AAbAbbcBcdCd",
    "AAAABacBcdCd",
    "aaaaabACbCC",
    "AABacBDceDe",
    "AAAAABaBcBc",
    "aaaaBaBCbCC",
    "aabAbbCbCDcD",
    "AAAAbAbbbb",
    "AAABaBcBcdCd",
    "AAAAbAbbcBc",
    "AAAABaBCbdCd",
    "AABaBBBBcBc",
    "aaaabACbCCC",
    "AAbAbbbbcBc",
    "AABaBBBCbdCd",
    "AAAABaBBcBc",
    "AAAbAbbbcBc",
    "AAAABaBcBcc",
    "aabAbbcBDcDD",
    "AAAbACbdCd",
    "AABaBBCbCdCd",
    "AAABacBccdCd",
    "aaaBaBBCbCC",
    "AABaBcBccdCd",
    "aaabAbcBDcDD",
    "AbAbcBDceDe",
    "AAABaBCbCdCd",
    "AAABacBcdCdd",
    "AAABaBBCbdCd",
    "AAABaBBBcBc",
    "aaabAbbCbCC",
    "aBaBBcBDcD",
    "AAbAbCbdCd",
    "AAbACbdCdd",
    "AAbACbCdCd",
    "AbAbCbCdCd",
    "aaaaaBaaaB",
    "aaaaaBaaBB",
    "AAAAbbAbbb",
    "AAAAbACBBBC",
    "aabAbbCbbbC",
    "aabAbbCbbCC",
    "aaaBaaBBCbC",
    "AABaBcBDCCCD",
    "aaaBaaBCbCC",
    "AAABacBDCCCD",
    "aaabAbCbbbC",
    "aaabAbCbbCC",
    "aBacBDCCeDe",
    "AbAbCbbdCd",
    "AbAbbCbCBDcD",
    "aaaBaaaBCbC",
    "aaaaBaaaBB",
    "AAbACBBBCDcD",
    "aaaBaaaBBB",
    "aabAbCbbbCC",
    "AAAbACBBBCC",
    "AAABaBCbbdCBdC",
    "aaBaBBCbbDcBDC",
    "aabACbadCbCd",
    "AbACbbbdCd",
    "AAbACbbdCd",
    "aaaabbAbCbC",
    "AABaBAcBcDcD",
    "AABaBBCbbdCBdC",
    "aBaBcBBdCbdc",
    "aaaabACbbbC",
    "aaaabACbbCC",
    "AABaBAcBDcDD",
    "AAAbbAAbbb",
    "AAAbAACBBBC",
    "aaBacbbDCCCD",
    "AAAAbAbAbb",
    "aabAbCbbCbC",
    "aaabACbbCbC",
    "AAAAbAAbAb",
    "AAbAbAbbcBc",
    "aaabACbCbCC",
    "AbACbCbdCd",
    "AbAbcBADCbCD",
    "AAbAbcBAcbb",
    "AAAbAbbAbb",
    "aaabbCbAbCb",
    "AAbAAbAbcBc",
    "aaaBaaBBaB",
    "AAbbCbAbccb",
    "AbaCbaCdCbCd",
    "aabAbaCbAbcDcD",
    "AABBcBaBBcB",
    "AAbAAbbAbb",
    "AAAbAAbAAb",
    "aaabAcBacbbdCd",
    "AAbACbAbbcc",
    "AABacBBcBBc",
    "AAAbbAbAbb",
    "aaBacbbDCbCD",
    "aaaBaBaaBB",
    "AAbAcbbDcBcD",
    "aaBaacBaBCC",
    "AAbAbbAAbb",
    "AbACBBBdcBcd",
    "aabbCbbAbCb",
    "AAAbAbAbAb",
    "aaabCbAbCbC",
    "AABacBcBcBc",
    "aBacbbDCbCCD",
    "AAbAAbAbAb",
    "aabbCbAbCbC",
    "aaBaBaBBaB",
    "AAbACbAbccb",
    "AABacbADCBBCCD",
    "AABcBaBcBcB",
    "aabCbACbCbC",
    "AbAbAbAbAb",
    "aaaaabaaab",
    "aaaaaBAAAB",
    "AAAAABaaaB",
    "AAAAABaaBB",
    "aaabaabbcBc",
    "aaaBAAcBAcB",
    "aaaBAABBCbC",
    "AAABaaBBCbC",
    "aaaBAABCbCC",
    "AAABaaBCbCC",
    "aaabaabcBcc",
    "aaabAbCBBBC",
    "aBaBCbbdCd",
    "AbAbCBBdCd",
    "AbAbcbbDcD",
    "aaaabaaabb",
    "aaaBAAABCbC",
    "aaaaBAAABB",
    "aaabaaabcBc",
    "AAAABaaaBB",
    "AABaBAcBAcb",
    "AABaBACBaBC",
    "AAbAbaCbAbC",
    "aaaBaBCbAbC",
    "AAAABaaBaB",
    "AAAABaBaBB",
    "aaaBaacBAcb",
    "aaabAAcBacB",
    "AAABBAABBB",
    "AAABAAcbbbc",
    "aabAbacbbbc",
    "aaabAAbAAb",
    "AAAbaaCBaBC",
    "aaabbAbAbb",
    "AAABaacbAbc",
    "AAABaBaaBB",
    "aaabaaCbAbC",
    "AAABaBAABB",
    "AABaaBBAcBc",
    "aaBAAcbAbbc",
    "aaBaBBCbAbC",
    "aabACbAbccb",
}};

/// How many knots have 0, 1, ... 10 crossings.
constexpr std::array<int, 11> knots_with{1, 0, 0, 1, 1, 2, 3, 7, 21, 49, 165};

/// "10_12" as 10 and 12; the second 0 if it is no such word.
std::array<int, 2> numbers_of(std::string_view name) {
  std::array<int, 2> numbers{0, 0};
  const std::size_t bar = name.find('_');
  if (bar == std::string_view::npos || bar == 0 || bar > 2 || name.size() < bar + 2 || name.size() > bar + 4)
    return numbers;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (k == bar) continue;
    if (name[k] < '0' || name[k] > '9') return {0, 0};
    int& number = numbers[k < bar ? 0 : 1];
    number = 10 * number + (name[k] - '0');
  }
  return numbers;
}

} // namespace

std::optional<std::vector<int>> rolfsen_braid(std::string_view name) {
  const auto [crossings, index] = numbers_of(name);
  if (crossings >= static_cast<int>(knots_with.size())) return std::nullopt;
  if (index < 1 || index > knots_with[static_cast<std::size_t>(crossings)]) return std::nullopt;
  std::vector<int> letters;
  if (crossings == 0) return letters;
  int row = index - 1;
  for (int n = 3; n < crossings; ++n) row += knots_with[static_cast<std::size_t>(n)];
  for (const char c : braids[static_cast<std::size_t>(row)])
    letters.push_back(c >= 'a' ? c - 'a' + 1 : -(c - 'A' + 1));
  return letters;
}

std::optional<Diagram> named_diagram(std::string_view name) {
  const std::optional<std::vector<int>> letters = rolfsen_braid(name);
  if (!letters) {
    const std::optional<std::string> code = eleven_crossing_code(name);
    return code ? read_diagram(*code, std::string(name)) : tabulated_diagram(name);
  }
  return without_points(std::move(closed_braid(*letters, 1)).finished());
}

std::vector<std::string> diagram_names() {
  std::vector<std::string> names;
  for (int n = 0; n < static_cast<int>(knots_with.size()); ++n)
    for (int k = 1; k <= knots_with[static_cast<std::size_t>(n)]; ++k)
      names.push_back(std::to_string(n) + "_" + std::to_string(k));
  return names;
}

} // namespace tetrarch::diagram
