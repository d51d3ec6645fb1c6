// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The sections of a MEDIT file, whether their numbers are text or bytes.

#include "cells.hpp"
#include "mesh_cursor.hpp"
#include "mesh_text.hpp"

#include <optional>
#include <string>
#include <utility>

namespace tetrarch::format {

/// How a keyword's elements look: their nodes, corners first.
struct MeditElements {
  std::string_view keyword;
  Shape shape;
  int nodes;
  const char* plural;
};

inline constexpr std::array<MeditElements, 16> medit_elements{
    {{"Edges", Shape::line, 2, "edges"},
     {"Triangles", Shape::triangle, 3, "triangles"},
     {"Quadrilaterals", Shape::quadrilateral, 4, "quadrilaterals"},
     {"Tetrahedra", Shape::tetrahedron, 4, "tetrahedra"},
     {"Pyramids", Shape::pyramid, 5, "pyramids"},
     {"Prisms", Shape::prism, 6, "prisms"},
     {"Hexahedra", Shape::hexahedron, 8, "hexahedra"},
     {"Pentahedra", Shape::prism, 6, "prisms"},
     {"Hexaedra", Shape::hexahedron, 8, "hexahedra"},
     {"EdgesP2", Shape::line, 3, "edges"},
     {"TrianglesP2", Shape::triangle, 6, "triangles"},
     {"QuadrilateralsQ2", Shape::quadrilateral, 9, "quadrilaterals"},
     {"TetrahedraP2", Shape::tetrahedron, 10, "tetrahedra"},
     {"PyramidsP2", Shape::pyramid, 14, "pyramids"},
     {"PrismsP2", Shape::prism, 18, "prisms"},
     {"HexahedraQ2", Shape::hexahedron, 27, "hexahedra"}}};

template <class Numbers>
class MeditSections {
public:
  MeditSections(MeshCursor& in, Numbers& numbers) : in_(in), numbers_(numbers) {
    soup_.source = in.source();
    soup_.first_number = 1;
  }

  /// Reads what follows a keyword; false if it is not known.
  bool read(std::string_view keyword) {
    if (keyword == "Dimension") {
      dimension_ = static_cast<int>(numbers_.integer("dimension 2 or 3", 2, 3));
      return true;
    }
    if (keyword == "Vertices") {
      read_vertices();
      return true;
    }
    for (std::size_t row = 0; row < medit_elements.size(); ++row)
      if (medit_elements[row].keyword == keyword) {
        read_elements(medit_elements[row], seen_[row]);
        return true;
      }
    return false;
  }

  void pass_over(std::string_view keyword, std::int64_t count) {
    soup_.passed_over.note("entry of " + std::string(keyword), count);
  }

  Soup soup() && {
    cells_.finish();
    return std::move(soup_);
  }

private:
  void read_vertices() {
    if (!soup_.points.empty()) in_.fail("vertices", "only one list of vertices");
    const std::int64_t count = numbers_.integer("the number of vertices", 0, most_elements);
    soup_.points.reserve(numbers_.believable(count));
    std::int64_t references = 0;
    for (std::int64_t i = 1; i <= count; ++i) {
      std::array<double, 3> p{};
      for (int axis = 0; axis < dimension_; ++axis)
        p[static_cast<std::size_t>(axis)] = numbers_.real("a coordinate");
      soup_.points.push_back(p);
      note(soup_.point_labels, static_cast<int>(i), in_.line());
      references += numbers_.reference() != 0 ? 1 : 0;
    }
    soup_.passed_over.note("reference of a vertex", references);
  }

  void read_elements(const MeditElements& elements, bool& seen) {
    const std::string plural = elements.plural;
    const std::int64_t count = numbers_.integer("the number of " + plural, 0, most_elements);
    if (count > 0 && std::exchange(seen, true)) in_.fail(plural, "only one list of " + plural);
    if (elements.shape == Shape::triangle) soup_.triangles.reserve(numbers_.believable(count));
    if (elements.shape == Shape::tetrahedron) soup_.tetrahedra.reserve(numbers_.believable(count));
    std::array<int, 27> nodes{};
    for (std::int64_t i = 1; i <= count; ++i) {
      for (int k = 0; k < elements.nodes; ++k)
        nodes[static_cast<std::size_t>(k)] = static_cast<int>(
            numbers_.integer("the number of a vertex", 1 - most_elements, most_elements) - 1);
      const int line = in_.line();
      cells_.add(elements.shape, std::span<const int>(nodes).first(static_cast<std::size_t>(elements.nodes)),
                 {static_cast<int>(i), line, numbers_.reference()});
    }
  }

  MeshCursor& in_;
  Numbers& numbers_;
  Soup soup_;
  Cells cells_{soup_};
  int dimension_ = 3;
  std::array<bool, medit_elements.size()> seen_{};
};

} // namespace tetrarch::format
