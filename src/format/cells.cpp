// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"

#include "mesh_text.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::format {
namespace {

struct ShapeRow {
  const char* name;
  int corners;
  int dimension;
};

/// In the order of `Shape`.
constexpr std::array<ShapeRow, 10> shape_rows{{{"point element", 1, 0},
                                               {"line element", 2, 1},
                                               {"triangle", 3, 2},
                                               {"quadrilateral", 4, 2},
                                               {"tetrahedron", 4, 3},
                                               {"pyramid", 5, 3},
                                               {"prism", 6, 3},
                                               {"hexahedron", 8, 3},
                                               {"pentagonal prism", 10, 3},
                                               {"hexagonal prism", 12, 3}}};

const ShapeRow& row_of(Shape shape) {
  return shape_rows[static_cast<std::size_t>(shape)];
}

using Face = std::vector<std::size_t>;

/// The faces of a prism over an n-gon, counterclockwise seen from outside.
std::vector<Face> prism_faces(std::size_t n) {
  Face bottom;
  Face top;
  std::vector<Face> faces;
  for (std::size_t k = 0; k < n; ++k) {
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
    const std::size_t next = (k + 1) % n;
    faces.push_back({k, next, n + next, n + k});
  }
  faces.push_back(bottom);
  faces.push_back(top);
  return faces;
}

/// Counterclockwise seen from outside.
const std::vector<Face>& faces_of(Shape shape) {
  static const std::vector<Face> pyramid{{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const std::vector<Face> prism = prism_faces(3);
  static const std::vector<Face> hexahedron = prism_faces(4);
  static const std::vector<Face> pentagonal = prism_faces(5);
  static const std::vector<Face> hexagonal = prism_faces(6);
  switch (shape) {
  case Shape::pyramid:
    return pyramid;
  case Shape::prism:
    return prism;
  case Shape::hexahedron:
    return hexahedron;
  case Shape::pentagonal_prism:
    return pentagonal;
  case Shape::hexagonal_prism:
    return hexagonal;
  default:
    throw PreconditionError("this shape is not cut");
  }
}

double volume(const Soup& soup, const std::array<int, 4>& corners) {
  const auto point = [&](std::size_t k) { return soup.points[static_cast<std::size_t>(corners[k])]; };
  const auto from_first = [&](std::size_t k) {
    return std::array<double, 3>{point(k)[0] - point(0)[0], point(k)[1] - point(0)[1],
                                 point(k)[2] - point(0)[2]};
  };
  const auto a = from_first(1);
  const auto b = from_first(2);
  const auto c = from_first(3);
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

bool in_range(const Soup& soup, std::span<const int> corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < soup.points.size(); });
}

} // namespace

int corner_count(Shape shape) {
  return row_of(shape).corners;
}

int dimension_of(Shape shape) {
  return row_of(shape).dimension;
}

void Cells::add_triangle(const std::array<int, 3>& corners, const CellName& name) {
  soup_.triangles.push_back(corners);
  soup_.triangle_tags.push_back(name.tag);
  note(soup_.triangle_labels, name.number, name.line);
}

void Cells::add_tetrahedron(const std::array<int, 4>& corners, const CellName& name) {
  soup_.tetrahedra.push_back(corners);
  soup_.tetrahedron_tags.push_back(name.tag);
  note(soup_.tetrahedron_labels, name.number, name.line);
}

void Cells::add(Shape shape, std::span<const int> nodes, const CellName& name) {
  const auto corners = static_cast<std::size_t>(corner_count(shape));
  if (nodes.size() < corners) throw PreconditionError("a cell with fewer nodes than corners");
  midside_nodes_.insert(midside_nodes_.end(), nodes.begin() + static_cast<std::ptrdiff_t>(corners),
                        nodes.end());
  nodes = nodes.first(corners);
  if (dimension_of(shape) < 2) {
    soup_.passed_over.note(row_of(shape).name);
  } else if (shape == Shape::triangle) {
    add_triangle({nodes[0], nodes[1], nodes[2]}, name);
  } else if (shape == Shape::quadrilateral) {
    add_polygon(nodes, name);
  } else if (shape == Shape::tetrahedron) {
    add_tetrahedron({nodes[0], nodes[1], nodes[2], nodes[3]}, name);
  } else {
    add_cone(shape, nodes, name);
  }
}

/// A cell that is collapsed, as a hexahedron with an edge of length zero is, has flat tetrahedra with a
/// vertex twice: these are nothing.
void Cells::add_cone(Shape shape, std::span<const int> nodes, const CellName& name) {
  const int apex = *std::min_element(nodes.begin(), nodes.end());
  for (const Face& face : faces_of(shape)) {
    const auto vertex = [&](std::size_t k) { return nodes[face[k % face.size()]]; };
    std::size_t first = 0;
    for (std::size_t k = 1; k < face.size(); ++k)
      if (vertex(k) < vertex(first)) first = k;
    if (vertex(first) == apex) continue;
    for (std::size_t k = first + 1; k + 1 < first + face.size(); ++k) {
      const std::array<int, 4> corners{apex, vertex(first), vertex(k), vertex(k + 1)};
      if (corners[1] == corners[2] || corners[2] == corners[3] || corners[1] == corners[3]) continue;
      if (shape == Shape::prism) prisms_.push_back(soup_.tetrahedra.size());
      add_tetrahedron(corners, name);
    }
  }
  soup_.passed_over.note(std::string(row_of(shape).name) + ", cut into tetrahedra");
}

void Cells::add_polygon(std::span<const int> corners, const CellName& name) {
  if (corners.size() == 3) return add_triangle({corners[0], corners[1], corners[2]}, name);
  if (corners.size() < 3) return soup_.passed_over.note("face of fewer than three corners");
  soup_.passed_over.note(corners.size() == 4 ? "quadrilateral, cut into triangles"
                                             : "polygon, cut into triangles");
  polygons_.push_back({polygon_corners_.size(), soup_.triangles.size(), name});
  polygon_corners_.insert(polygon_corners_.end(), corners.begin(), corners.end());
}

void Cells::add_strip(std::span<const int> points, const CellName& name) {
  std::size_t first = 0;
  for (std::size_t k = 0; k <= points.size(); ++k) {
    if (k < points.size() && points[k] >= 0) {
      if (k < first + 2) continue;
      std::array<int, 3> corners{points[k - 2], points[k - 1], points[k]};
      if ((k - first) % 2 == 1) std::swap(corners[0], corners[1]);
      // Strips are sewn together by triangles without area.
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
        add_triangle(corners, name);
    } else {
      if (k > first) soup_.passed_over.note("strip, cut into triangles");
      first = k + 1;
    }
  }
}

/// The triangles of the polygons, put between the others where the polygons stood.
void Cells::cut_polygons() {
  if (polygons_.empty()) return;
  std::vector<std::array<int, 3>> others = std::exchange(soup_.triangles, {});
  const std::vector<int> tags = std::exchange(soup_.triangle_tags, {});
  const Labels labels = std::exchange(soup_.triangle_labels, {});
  std::size_t done = 0;
  const auto copy_up_to = [&](std::size_t end) {
    for (; done < end; ++done)
      add_triangle(others[done], {labels.numbers[done], labels.lines[done], tags[done]});
  };
  for (std::size_t p = 0; p < polygons_.size(); ++p) {
    copy_up_to(polygons_[p].triangles_before);
    const std::size_t end = p + 1 < polygons_.size() ? polygons_[p + 1].first : polygon_corners_.size();
    const auto corners =
        std::span<const int>(polygon_corners_).subspan(polygons_[p].first, end - polygons_[p].first);
    for (const auto& [a, b, c] : cut_polygon(corners, soup_.points))
      add_triangle({corners[a], corners[b], corners[c]}, polygons_[p].name);
  }
  copy_up_to(others.size());
}

void Cells::leave_out_midside_nodes() {
  if (midside_nodes_.empty()) return;
  std::vector<char> left_out(soup_.points.size(), 0);
  for (const int v : midside_nodes_)
    if (v >= 0 && static_cast<std::size_t>(v) < left_out.size()) left_out[static_cast<std::size_t>(v)] = 1;
  const auto keep = [&](const auto& elements) {
    for (const auto& corners : elements) {
      if (!in_range(soup_, corners)) return false;
      for (const int v : corners) left_out[static_cast<std::size_t>(v)] = 0;
    }
    return true;
  };
  // Where an index is out of range, renumbering would make another point of it.
  if (!keep(soup_.triangles) || !keep(soup_.tetrahedra)) return;
  std::vector<int> index(left_out.size(), -1);
  Labels kept;
  std::size_t size = 0;
  for (std::size_t v = 0; v < left_out.size(); ++v) {
    if (left_out[v]) continue;
    index[v] = static_cast<int>(size);
    soup_.points[size++] = soup_.points[v];
    note(kept, static_cast<int>(point_number(soup_, static_cast<int>(v))),
         soup_.point_labels.line(static_cast<std::int64_t>(v)));
  }
  soup_.passed_over.note("midside node", static_cast<std::int64_t>(soup_.points.size() - size));
  soup_.points.resize(size);
  soup_.point_labels = std::move(kept);
  for (auto& corners : soup_.triangles)
    for (int& v : corners) v = index[static_cast<std::size_t>(v)];
  for (auto& corners : soup_.tetrahedra)
    for (int& v : corners) v = index[static_cast<std::size_t>(v)];
}

void Cells::turn_prisms() {
  double total = 0;
  for (const std::size_t t : prisms_)
    if (in_range(soup_, soup_.tetrahedra[t])) total += volume(soup_, soup_.tetrahedra[t]);
  if (!(total < 0)) return;
  for (const std::size_t t : prisms_) std::swap(soup_.tetrahedra[t][2], soup_.tetrahedra[t][3]);
}

void Cells::finish() {
  cut_polygons();
  leave_out_midside_nodes();
  drop_empty_tags(soup_);
}

void Cells::finish_turning_prisms() {
  turn_prisms();
  finish();
}

} // namespace tetrarch::format
