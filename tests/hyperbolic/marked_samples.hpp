// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangulations with marks, as short texts.

#include "tetrarch/core/marks.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace tetrarch::hyperbolic::samples {

/// Per tetrahedron four words "neighbor:images of 0123", one a face: "1:1302 1:1302 1:1302 1:1302 0:2031
/// ...".
inline Triangulation gluings(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::pair<int, Perm4>> words;
  for (std::string word; in >> word;) {
    const std::size_t colon = word.find(':');
    const auto image = [&](int k) { return word[colon + 1 + static_cast<std::size_t>(k)] - '0'; };
    words.emplace_back(std::stoi(word.substr(0, colon)), Perm4(image(0), image(1), image(2), image(3)));
  }
  Triangulation tri(static_cast<int>(words.size()) / 4);
  for (int k = 0; k < static_cast<int>(words.size()); ++k)
    if (tri.is_boundary({k / 4, k % 4})) tri.glue({k / 4, k % 4}, words[k].first, words[k].second);
  return tri;
}

/// "0-12:3 0-01:0": tetrahedron, edge, order.
inline Marks marks(const std::string& text) {
  std::istringstream in(text);
  Marks list;
  for (std::string word; in >> word;) {
    const std::size_t dash = word.find('-');
    const std::size_t colon = word.find(':');
    const int i = word[dash + 1] - '0';
    const int j = word[dash + 2] - '0';
    list.push_back({{std::stoi(word.substr(0, dash)), edge_number[i][j]}, std::stod(word.substr(colon + 1))});
  }
  return list;
}

/// S^3 with the complete graph on four vertices, and the theta graph 3_1 (Heard, Hodgson, Martelli, Petronio,
/// "Hyperbolic graphs of small complexity").
inline const char* const k4 = "1:1302 1:1302 1:1302 1:1302 0:2031 0:2031 0:2031 0:2031";
inline const char* const theta = "1:2310 1:0321 0:0132 0:0132 1:1023 1:1023 0:3201 0:0321";

} // namespace tetrarch::hyperbolic::samples
