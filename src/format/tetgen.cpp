// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/tetgen.hpp"

#include "mesh_text.hpp"

namespace tetrarch::format {
namespace {

/// "1 0 0 0" and an end of line are as short as a point or a tetrahedron can be.
constexpr std::size_t shortest_line = 8;
constexpr std::int64_t most_attributes = 1000;

void require_end(MeshCursor& in) {
  if (!in.at_end()) in.fail(in.token(""), "the end of the file");
}

/// The number of the i-th element of a file that counts from `first`.
int read_number(MeshCursor& in, std::int64_t i, int first, std::string_view what) {
  const std::int64_t number = in.integer("a number", 0, most_elements);
  if (number != i + first)
    in.fail(std::to_string(number), std::string(what) + " " + std::to_string(i + first) + " next");
  return static_cast<int>(number);
}

void read_points(MeshCursor& in, Soup& soup) {
  const std::int64_t count = in.integer("the number of points", 0, most_elements - 1);
  in.integer("dimension 3", 3, 3);
  const std::int64_t attributes = in.integer("the number of attributes", 0, most_attributes);
  const std::int64_t extra = attributes + in.integer("0 or 1 for a boundary marker", 0, 1);
  soup.points.reserve(in.believable(count, shortest_line));
  soup.first_number = !in.at_end() && in.peek() == "0" ? 0 : 1;
  for (std::int64_t i = 0; i < count; ++i) {
    const int number = read_number(in, i, soup.first_number, "point");
    note(soup.point_labels, number, in.line());
    soup.points.push_back(in.point());
    for (std::int64_t k = 0; k < extra; ++k) in.number("an attribute or marker");
  }
  require_end(in);
}

void read_tetrahedra(MeshCursor& in, Soup& soup) {
  const std::int64_t count = in.integer("the number of tetrahedra", 0, most_elements - 1);
  in.integer("4 points in a tetrahedron", 4, 4);
  const std::int64_t extra = in.integer("the number of attributes", 0, most_attributes);
  soup.tetrahedra.reserve(in.believable(count, shortest_line));
  for (std::int64_t i = 0; i < count; ++i) {
    const int number = read_number(in, i, soup.first_number, "tetrahedron");
    note(soup.tetrahedron_labels, number, in.line());
    soup.tetrahedra.push_back(read_corners<4>(in, soup.first_number));
    for (std::int64_t k = 0; k < extra; ++k) in.number("an attribute");
  }
  require_end(in);
}

} // namespace

Soup read_tetgen(const TetgenFiles& files) {
  Soup soup;
  soup.source = files.ele_source;
  soup.point_source = files.node_source;
  MeshCursor node(files.node, files.node_source, '#');
  read_points(node, soup);
  MeshCursor ele(files.ele, files.ele_source, '#');
  read_tetrahedra(ele, soup);
  return soup;
}

TetgenFiles write_tetgen(const Soup& soup) {
  TetgenFiles files;
  files.node = std::to_string(soup.points.size()) + " 3 0 0\n";
  std::int64_t number = 0;
  for (const auto& p : soup.points) {
    append_number(files.node, ++number);
    files.node += ' ';
    append_line(files.node, p, "\n");
  }
  files.ele = std::to_string(soup.tetrahedra.size()) + " 4 0\n";
  number = 0;
  for (const auto& corners : soup.tetrahedra) {
    append_number(files.ele, ++number);
    files.ele += ' ';
    append_line(files.ele, corners, "\n", 1);
  }
  return files;
}

} // namespace tetrarch::format
