// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/tetgen.hpp"

#include "cells.hpp"
#include "mesh_text.hpp"

namespace tetrarch::format {
namespace {

/// "1 0 0" and an end of line are as short as a point or a tetrahedron can be.
constexpr std::size_t shortest_tetgen_line = 6;
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

/// A number of the first line; `otherwise` where the line has ended.
std::int64_t next_or(MeshCursor& in, std::int64_t otherwise, std::string_view expected, std::int64_t least,
                     std::int64_t greatest) {
  return in.line_goes_on() ? in.integer(expected, least, greatest) : otherwise;
}

/// The numbers that are left on the line of an element or point.
struct Rest {
  std::vector<double> numbers;

  /// Those announced, which may stand on the next lines, and what else the line holds.
  void read(MeshCursor& in, std::int64_t announced) {
    numbers.clear();
    for (std::int64_t k = 0; k < announced; ++k) numbers.push_back(in.number("an attribute or marker"));
    while (in.line_goes_on()) numbers.push_back(in.number("an attribute or marker"));
  }
  /// As a tag: 0 for what is no integer.
  int tag(std::size_t k) const {
    if (k >= numbers.size()) return 0;
    const double x = numbers[k];
    const bool fits = x > -static_cast<double>(most_elements) && x < static_cast<double>(most_elements);
    return fits && x == static_cast<double>(static_cast<int>(x)) ? static_cast<int>(x) : 0;
  }
};

/// Returns the dimension.
std::int64_t read_points(MeshCursor& in, Soup& soup) {
  const std::int64_t count = in.integer("the number of points", 0, most_elements - 1);
  const std::int64_t dimension = next_or(in, 3, "dimension 2 or 3", 2, 3);
  const std::int64_t attributes = next_or(in, 0, "the number of attributes", 0, most_attributes);
  const std::int64_t markers = next_or(in, 0, "0 or 1 for a boundary marker", 0, 1);
  soup.points.reserve(in.believable(count, shortest_tetgen_line));
  soup.first_number = !in.at_end() && in.peek() == "0" ? 0 : 1;
  Rest rest;
  for (std::int64_t i = 0; i < count; ++i) {
    const int number = read_number(in, i, soup.first_number, "point");
    note(soup.point_labels, number, in.line());
    std::array<double, 3> p{};
    for (std::int64_t axis = 0; axis < dimension; ++axis)
      p[static_cast<std::size_t>(axis)] = in.number("a coordinate");
    soup.points.push_back(p);
    rest.read(in, attributes + markers);
    const auto last = rest.numbers.size() - (markers > 0 ? 1 : 0);
    soup.passed_over.note("attribute of a point", static_cast<std::int64_t>(last));
    soup.passed_over.note("marker of a point", markers > 0 && rest.numbers.back() != 0 ? 1 : 0);
  }
  require_end(in);
  return dimension;
}

struct Kind {
  Shape shape;
  const char* what;
  std::int64_t nodes;
};

Kind kind_of_elements(MeshCursor& in, std::int64_t dimension) {
  const bool flat = dimension == 2;
  const std::int64_t nodes = next_or(in, flat ? 3 : 4, "the number of points in an element", 1, 10);
  if (nodes == 3 || nodes == 6) return {Shape::triangle, "triangle", nodes};
  if (!flat && (nodes == 4 || nodes == 10)) return {Shape::tetrahedron, "tetrahedron", nodes};
  in.fail(std::to_string(nodes), flat ? "3 or 6 points in a triangle" : "4 or 10 points in a tetrahedron");
}

void read_elements(MeshCursor& in, Soup& soup, Cells& cells, std::int64_t dimension) {
  const std::int64_t count = in.integer("the number of elements", 0, most_elements - 1);
  const Kind kind = kind_of_elements(in, dimension);
  const std::int64_t attributes = next_or(in, 0, "the number of attributes", 0, most_attributes);
  soup.tetrahedra.reserve(kind.shape == Shape::tetrahedron ? in.believable(count, shortest_tetgen_line) : 0);
  Rest rest;
  std::array<int, 10> nodes{};
  for (std::int64_t i = 0; i < count; ++i) {
    const int number = read_number(in, i, soup.first_number, kind.what);
    const int line = in.line();
    for (std::int64_t k = 0; k < kind.nodes; ++k)
      nodes[static_cast<std::size_t>(k)] = static_cast<int>(
          in.integer("the number of a vertex", 1 - most_elements, most_elements) - soup.first_number);
    rest.read(in, attributes);
    soup.passed_over.note("further attribute of an element",
                          rest.numbers.empty() ? 0 : static_cast<std::int64_t>(rest.numbers.size()) - 1);
    cells.add(kind.shape, std::span<const int>(nodes).first(static_cast<std::size_t>(kind.nodes)),
              {number, line, rest.tag(0)});
  }
  require_end(in);
}

void read_faces(MeshCursor& in, const Soup& soup, Cells& cells) {
  const std::int64_t count = in.integer("the number of triangles", 0, most_elements - 1);
  const std::int64_t markers = next_or(in, 0, "0 or 1 for a boundary marker", 0, 1);
  Rest rest;
  for (std::int64_t i = 0; i < count; ++i) {
    const int number = read_number(in, i, soup.first_number, "triangle");
    const int line = in.line();
    const std::array<int, 3> corners = read_corners<3>(in, soup.first_number);
    rest.read(in, markers);
    cells.add(Shape::triangle, corners, {number, line, markers > 0 ? rest.tag(0) : 0});
  }
  require_end(in);
}

template <class Elements>
void append_elements(std::string& out, const Elements& elements, const std::vector<int>& tags) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    append_number(out, i + 1);
    out += ' ';
    append_line(out, elements[i], tags.empty() ? "\n" : " " + std::to_string(tags[i]) + "\n", 1);
  }
}

} // namespace

Soup read_tetgen(const TetgenFiles& files) {
  Soup soup;
  Cells cells(soup);
  soup.source = files.ele_source;
  soup.point_source = files.node_source;
  MeshCursor node(without_byte_order_mark(files.node), files.node_source, '#');
  const std::int64_t dimension = read_points(node, soup);
  MeshCursor ele(without_byte_order_mark(files.ele), files.ele_source, '#');
  read_elements(ele, soup, cells, dimension);
  if (!files.face.empty()) {
    MeshCursor face(without_byte_order_mark(files.face), files.face_source, '#');
    if (dimension == 3 && !soup.tetrahedra.empty()) read_faces(face, soup, cells);
  }
  cells.finish();
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
  const bool is_surface = soup.tetrahedra.empty() && !soup.triangles.empty();
  const std::vector<int>& tags = is_surface ? soup.triangle_tags : soup.tetrahedron_tags;
  files.ele = std::to_string(is_surface ? soup.triangles.size() : soup.tetrahedra.size()) +
              (is_surface ? " 3 " : " 4 ") + (tags.empty() ? "0\n" : "1\n");
  if (is_surface) {
    append_elements(files.ele, soup.triangles, tags);
    return files;
  }
  append_elements(files.ele, soup.tetrahedra, tags);
  if (soup.triangles.empty()) return files;
  files.face = std::to_string(soup.triangles.size()) + (soup.triangle_tags.empty() ? " 0\n" : " 1\n");
  append_elements(files.face, soup.triangles, soup.triangle_tags);
  return files;
}

} // namespace tetrarch::format
