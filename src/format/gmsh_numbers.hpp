// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The numbers of Gmsh's files, as text or bytes, and its types of elements.

#include "cells.hpp"
#include "mesh_cursor.hpp"

#include <optional>

namespace tetrarch::format {

/// The corners and all nodes of elements of a type; corners come first.
struct GmshType {
  int type;
  Shape shape;
  int nodes;
};

/// None for a type that is not known.
std::optional<GmshType> gmsh_type(std::int64_t type);
inline constexpr int gmsh_triangle = 2;
inline constexpr int gmsh_tetrahedron = 4;

/// Integers and reals of a section, as text or as the bytes of this file.
class GmshNumbers {
public:
  explicit GmshNumbers(MeshCursor& in) : in_(in) {}

  void set_binary(bool swapped) {
    binary_ = true;
    swapped_ = swapped;
  }
  bool is_binary() const { return binary_; }

  /// Binary version 4.1 writes counts and tags with 8 bytes, the rest and all of version 2 with 4.
  template <class Stored>
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
    if (!binary_) return in_.integer(expected, least, greatest);
    const auto value =
        static_cast<std::int64_t>(load<Stored>(in_.bytes(sizeof(Stored), expected).data(), swapped_));
    if (value < least || value > greatest) in_.fail(std::to_string(value), expected);
    return value;
  }
  double real(std::string_view expected) {
    if (!binary_) return in_.number(expected);
    return load<double>(in_.bytes(sizeof(double), expected).data(), swapped_);
  }
  std::array<double, 3> point() {
    const double x = real("a coordinate");
    const double y = real("a coordinate");
    return {x, y, real("a coordinate")};
  }
  template <class Stored>
  std::int64_t count(std::string_view expected) {
    return integer<Stored>(expected, 0, most_elements);
  }
  template <class Stored>
  int any(std::string_view expected) {
    return static_cast<int>(integer<Stored>(expected, -most_elements - 1, most_elements));
  }
  /// Four bytes, whose sign may be taken away.
  int any_but_least(std::string_view expected) {
    return static_cast<int>(integer<std::int32_t>(expected, -most_elements, most_elements));
  }
  template <class Stored>
  int tag(std::string_view expected) {
    return static_cast<int>(integer<Stored>(expected, 1, most_elements));
  }

private:
  MeshCursor& in_;
  bool binary_ = false;
  bool swapped_ = false;
};

} // namespace tetrarch::format
