// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>

namespace tetrarch::program {

EdgeId edge_named(const std::string& word, const Skeleton& skeleton, const std::string& what) {
  const std::string expected = " (expected the number of an edge, 0 to " +
                               std::to_string(skeleton.edge_count() - 1) + ", or one of a tetrahedron: 3:01)";
  EdgeId found;
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) {
    const auto number = format::parse_integer(word);
    if (!number || *number < 0 || *number >= skeleton.edge_count())
      throw InputError(what + ": found " + in_quotes(word) + expected);
    found = EdgeId(static_cast<int>(*number));
  } else {
    const auto tet = format::parse_integer(word.substr(0, colon));
    const std::string ends = word.substr(colon + 1);
    const bool good = tet && *tet >= 0 && *tet < skeleton.tetrahedron_count() && ends.size() == 2 &&
                      ends[0] >= '0' && ends[0] <= '3' && ends[1] >= '0' && ends[1] <= '3' &&
                      ends[0] != ends[1];
    if (!good) throw InputError(what + ": found " + in_quotes(word) + expected);
    found = skeleton.edge(TetEdge{static_cast<int>(*tet), edge_number[ends[0] - '0'][ends[1] - '0']});
  }
  if (skeleton.is_reversed(found))
    throw InputError(what + ": edge " + std::to_string(found.value) + " is identified with itself backwards");
  return found;
}

Table<EdgeId, bool> edges_named(const std::vector<std::string>& words, const Skeleton& skeleton,
                                const std::string& what) {
  Table<EdgeId, bool> chosen(skeleton.edge_count(), false);
  for (const std::string& list : words)
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t comma = std::min(list.find(',', at), list.size());
      chosen[edge_named(list.substr(at, comma - at), skeleton, what)] = true;
      at = comma + 1;
    }
  return chosen;
}

} // namespace tetrarch::program
