// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Taking elements and points away from a soup; the rest keeps its numbers and lines in the file.

#include "tetrarch/format/soup.hpp"

#include <algorithm>
#include <vector>

namespace tetrarch::doctor {

/// The elements whose flag is not set, with their labels.
template <class Elements>
void remove_flagged(Elements& elements, format::Labels& labels, int first_number,
                    const std::vector<char>& flagged) {
  format::Labels kept;
  std::size_t size = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (flagged[i]) continue;
    elements[size++] = elements[i];
    const auto index = static_cast<std::int64_t>(i);
    kept.numbers.push_back(static_cast<int>(labels.number(index, first_number)));
    kept.lines.push_back(labels.line(index));
  }
  elements.resize(size);
  labels = std::move(kept);
}

void remove_tags(std::vector<int>& tags, const std::vector<char>& flagged);
void remove_tetrahedra(format::Soup& soup, const std::vector<char>& flagged);
void remove_triangles(format::Soup& soup, const std::vector<char>& flagged);

template <std::size_t N>
bool in_range(const format::Soup& soup, const std::array<int, N>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < soup.points.size(); });
}

template <std::size_t N>
bool has_repeated(std::array<int, N> corners) {
  std::sort(corners.begin(), corners.end());
  return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

template <std::size_t N>
bool is_proper(const format::Soup& soup, const std::array<int, N>& corners) {
  return in_range(soup, corners) && !has_repeated(corners);
}

/// Takes away the points that no tetrahedron names (or, of a surface, no triangle), and with them the
/// triangles that name such. Returns how many points went; none where an index is out of range, as
/// renumbering would make another point of it.
std::int64_t remove_unused_points(format::Soup& soup);

/// The triangles by their vertices in increasing order, sorted, with their indices.
struct ListedTriangle {
  std::array<int, 3> corners;
  int index;
};
std::vector<ListedTriangle> listed_triangles(const format::Soup& soup);
/// Those on three vertices in increasing order: from the first to behind the last.
std::pair<std::size_t, std::size_t> on_corners(const std::vector<ListedTriangle>& list,
                                               const std::array<int, 3>& corners);

} // namespace tetrarch::doctor
