// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the mesh formats that are text share: elements in, lines out.

#include "mesh_cursor.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace tetrarch::format {

inline void note(Labels& labels, int number, int line) {
  labels.numbers.push_back(number);
  labels.lines.push_back(line);
}

/// Tags that are 0 everywhere tell nothing.
inline void drop_empty_tags(Soup& soup) {
  for (std::vector<int>* tags : {&soup.triangle_tags, &soup.tetrahedron_tags})
    if (std::all_of(tags->begin(), tags->end(), [](int tag) { return tag == 0; })) tags->clear();
}

/// The corners of an element, counted from `first_number` in the file and from 0 in what is returned.
template <std::size_t corners>
std::array<int, corners> read_corners(MeshCursor& in, int first_number) {
  std::array<int, corners> out{};
  for (int& corner : out)
    corner = static_cast<int>(in.integer("the number of a vertex", 1 - most_elements, most_elements) -
                              first_number);
  return out;
}

/// A point's coordinates with spaces between them, then `end`.
inline void append_line(std::string& out, const std::array<double, 3>& point, std::string_view end) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) out += ' ';
    append_number(out, point[i]);
  }
  out += end;
}

/// An element's corners, counted from `first_number`, with spaces between them, then `end`.
template <std::size_t corners>
void append_line(std::string& out, const std::array<int, corners>& element, std::string_view end,
                 int first_number) {
  for (std::size_t i = 0; i < corners; ++i) {
    if (i > 0) out += ' ';
    append_number(out, static_cast<std::int64_t>(element[i]) + first_number);
  }
  out += end;
}

/// Points, then triangles with their number of corners before them, as OFF and PLY have it.
inline void append_surface(std::string& out, const Soup& soup) {
  for (const auto& p : soup.points) append_line(out, p, "\n");
  for (const auto& corners : soup.triangles) {
    out += "3 ";
    append_line(out, corners, "\n", 0);
  }
}

} // namespace tetrarch::format
