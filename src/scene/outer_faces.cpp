// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/files.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace tetrarch::scene {
namespace {

using namespace numeric;

/// The sides of a hexahedron, counter-clockwise from outside.
constexpr std::array<std::array<int, 4>, 6> hexahedron_sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
/// The faces of a tetrahedron whose corner 3 lies where 0, 1, 2 are seen counter-clockwise.
constexpr std::array<std::array<int, 3>, 4> tetrahedron_sides{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The fourth corner of a triangle.
constexpr int no_corner = -1;

/// All faces of all cells: four for each tetrahedron, then six for each hexahedron.
///
/// Equal faces are found like in solid/face_sweep.hpp: their numbers are sorted into buckets by their
/// smallest corner, and only within a bucket are the other corners compared.
class Faces {
public:
  explicit Faces(const Cells& cells)
      : cells_(cells), tetrahedral_(4 * cells.tetrahedra.size()),
        count_(tetrahedral_ + 6 * cells.hexahedra.size()) {
    if (count_ > std::numeric_limits<std::uint32_t>::max()) throw PreconditionError("too many cells");
  }

  std::size_t count() const { return count_; }
  std::size_t cell(std::size_t face) const {
    return face < tetrahedral_ ? face / 4 : cells_.tetrahedra.size() + (face - tetrahedral_) / 6;
  }

  /// Three and `no_corner`, or four, counter-clockwise from outside.
  std::array<int, 4> outward(std::size_t face) const {
    std::array<int, 4> out = corners(face);
    if (face < tetrahedral_ && is_mirrored(cells_.tetrahedra[face / 4])) std::swap(out[1], out[2]);
    return out;
  }

  /// Whether each face belongs to one cell alone. O(faces), and the sorting of those around each point.
  std::vector<bool> outer() const {
    std::vector<std::uint32_t> start(cells_.points.size() + 2, 0);
    for (std::size_t face = 0; face < count_; ++face) ++start[smallest(face) + 2];
    for (std::size_t p = 2; p < start.size(); ++p) start[p] += start[p - 1];
    std::vector<std::uint32_t> bucketed(count_);
    // start[p + 1] runs through bucket p and ends where bucket p + 1 begins.
    for (std::size_t face = 0; face < count_; ++face)
      bucketed[start[smallest(face) + 1]++] = static_cast<std::uint32_t>(face);
    std::vector<bool> out(count_, false);
    std::vector<Sorted> bucket;
    for (std::size_t p = 0; p < cells_.points.size(); ++p) {
      bucket.clear();
      for (std::uint32_t i = start[p]; i < start[p + 1]; ++i)
        bucket.push_back({sorted(bucketed[i]), bucketed[i]});
      mark_single(bucket, out);
    }
    return out;
  }

private:
  struct Sorted {
    std::array<int, 4> corners;
    std::uint32_t face;
  };

  static void mark_single(std::vector<Sorted>& bucket, std::vector<bool>& out) {
    std::sort(bucket.begin(), bucket.end(),
              [](const Sorted& a, const Sorted& b) { return a.corners < b.corners; });
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const bool as_before = i > 0 && bucket[i - 1].corners == bucket[i].corners;
      const bool as_after = i + 1 < bucket.size() && bucket[i + 1].corners == bucket[i].corners;
      if (!as_before && !as_after) out[bucket[i].face] = true;
    }
  }

  /// As the cell has them.
  std::array<int, 4> corners(std::size_t face) const {
    if (face < tetrahedral_) {
      const auto& cell = cells_.tetrahedra[face / 4];
      const auto& side = tetrahedron_sides[face % 4];
      return {cell[side[0]], cell[side[1]], cell[side[2]], no_corner};
    }
    const auto& cell = cells_.hexahedra[(face - tetrahedral_) / 6];
    const auto& side = hexahedron_sides[(face - tetrahedral_) % 6];
    return {cell[side[0]], cell[side[1]], cell[side[2]], cell[side[3]]};
  }
  bool is_mirrored(const std::array<int, 4>& cell) const {
    const Point& from = cells_.points[cell[0]];
    return dot(cross(cells_.points[cell[1]] - from, cells_.points[cell[2]] - from),
               cells_.points[cell[3]] - from) < 0;
  }
  std::array<int, 4> sorted(std::size_t face) const {
    std::array<int, 4> out = corners(face);
    std::sort(out.begin(), out.end());
    return out;
  }
  int smallest(std::size_t face) const {
    const std::array<int, 4> all = corners(face);
    const int of_three = std::min({all[0], all[1], all[2]});
    return all[3] == no_corner ? of_three : std::min(of_three, all[3]);
  }

  const Cells& cells_;
  std::size_t tetrahedral_;
  std::size_t count_;
};

/// Copies points of the cells to the surface as they are asked for.
class PointPicker {
public:
  PointPicker(const Cells& from, Surface& to) : from_(from), to_(to), number_(from.points.size(), -1) {}

  int operator()(int p) {
    int& number = number_[static_cast<std::size_t>(p)];
    if (number >= 0) return number;
    number = static_cast<int>(to_.points.size());
    to_.points.push_back(from_.points[p]);
    if (!from_.textures.empty()) to_.textures.push_back({from_.textures[p][0], from_.textures[p][1]});
    for (std::size_t i = 0; i < to_.point_fields.size(); ++i)
      to_.point_fields[i].values.push_back(from_.point_fields[i].values[p]);
    return number;
  }

private:
  const Cells& from_;
  Surface& to_;
  std::vector<int> number_;
};

} // namespace

Surface outer_faces(const Cells& cells) {
  require_sound(cells);
  const Faces faces(cells);
  const std::vector<bool> is_outer = faces.outer();
  Surface out;
  out.name = cells.name;
  for (const Data& data : cells.data) out.data.push_back({data.name, {}});
  for (const Field& field : cells.cell_fields) out.cell_fields.push_back({field.name, {}});
  for (const Field& field : cells.point_fields) out.point_fields.push_back({field.name, {}});
  PointPicker pick(cells, out);
  const auto add = [&](std::size_t cell, int a, int b, int c) {
    out.triangles.push_back({a, b, c});
    for (std::size_t i = 0; i < cells.data.size(); ++i)
      out.data[i].values.push_back(cells.data[i].values[cell]);
    for (std::size_t i = 0; i < cells.cell_fields.size(); ++i)
      out.cell_fields[i].values.push_back(cells.cell_fields[i].values[cell]);
  };
  for (std::size_t face = 0; face < faces.count(); ++face) {
    if (!is_outer[face]) continue;
    const std::array<int, 4> corners = faces.outward(face);
    const int a = pick(corners[0]);
    const int b = pick(corners[1]);
    const int c = pick(corners[2]);
    add(faces.cell(face), a, b, c);
    if (corners[3] != no_corner) add(faces.cell(face), a, c, pick(corners[3]));
  }
  return out;
}

} // namespace tetrarch::scene
