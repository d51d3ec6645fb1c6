// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How a normal surface cuts one tetrahedron: its arcs, and what is left between them.
///
///            v             Arcs around corner v of a face are numbered from v on, 0, 1, ...; first come those
///           /0\            of the triangles at v, then those of the quadrilaterals that cut v off from the
///          /---\           face's other two corners. Strip (v, k) of the face lies just before arc k, seen
///         /  1  \          from v; what is left in the middle is the strip after the last arcs.
///        /-------\         Rooms of the tetrahedron: (v, k) just before triangle k at v; then those between
///       /  middle \        the quadrilaterals, from the edge with vertex 0 on.
///      x-----------y

#include "tetrarch/reasons/normal_surface.hpp"

#include <algorithm>
#include <array>

namespace tetrarch::reasons {

/// The kind of quadrilateral that parts i and j from the others.
constexpr int quad_kind(int i, int j) {
  return i == 0 ? j - 1 : j == 0 ? i - 1 : 5 - i - j; // with 0 on the other side: the third is parted with 0
}

/// The pieces of a normal surface in one tetrahedron.
class Pieces {
public:
  Pieces(const Coordinates& coordinates, int tet) {
    const std::size_t first = 7 * static_cast<std::size_t>(tet);
    for (int v = 0; v < 4; ++v) triangles_[v] = coordinates[first + static_cast<std::size_t>(v)];
    for (int k = 0; k < 3; ++k)
      if (coordinates[first + 4 + static_cast<std::size_t>(k)] > 0) {
        kind_ = k;
        quads_ = coordinates[first + 4 + static_cast<std::size_t>(k)];
      }
  }

  int triangles(int v) const { return triangles_[v]; }
  int quads() const { return quads_; }
  /// The corner on the same side of the quadrilaterals as v; -1 without any.
  int partner(int v) const {
    if (quads_ == 0) return -1;
    for (int w = 0; w < 4; ++w)
      if (w != v && quad_kind(std::min(v, w), std::max(v, w)) == kind_) return w;
    return -1;
  }
  /// On the side of vertex 0.
  bool is_near(int v) const { return v == 0 || partner(v) == 0; }

  int arcs(int face, int v) const { return triangles_[v] + (partner(v) == face ? quads_ : 0); }
  int points(int i, int j) const { return triangles_[i] + triangles_[j] + (partner(i) == j ? 0 : quads_); }

  /// Discs: triangles by corner, then quadrilaterals from the near side on.
  int disc_count() const { return triangles_[0] + triangles_[1] + triangles_[2] + triangles_[3] + quads_; }
  int disc_of_arc(int v, int k) const {
    if (k < triangles_[v]) return before(v) + k;
    const int quad = k - triangles_[v];
    return before(4) + (is_near(v) ? quad : quads_ - 1 - quad);
  }
  /// Whether the side of the disc towards v is its first one: towards its corner, or the near edge.
  bool first_side_is_towards(int v, int k) const { return k < triangles_[v] || is_near(v); }

  /// Rooms: before triangles by corner, then between quadrilaterals.
  int room_count() const { return disc_count() + 1; }
  /// The room of strip (v, k) of a face, k < arcs(face, v).
  int room_of_strip(int v, int k) const {
    if (k < triangles_[v]) return before(v) + k;
    const int quad = k - triangles_[v];
    return before(4) + (is_near(v) ? quad : quads_ - quad);
  }
  /// The room of the strip in the middle of a face.
  int room_of_middle(int face) const {
    // The face's corner that is parted from the other two lies with `face` itself on one side.
    if (quads_ == 0) return before(4);
    return before(4) + (is_near(face) ? quads_ : 0);
  }
  /// The room at the tip of corner v, or the middle one.
  int room_at_corner(int v) const { return triangles_[v] > 0 ? before(v) : room_beyond_triangles(v); }
  /// The room on one side of a disc.
  int room_beside(int disc, bool first_side) const {
    if (disc >= before(4)) return first_side ? disc : disc + 1;
    int v = 0;
    while (before(v + 1) <= disc) ++v;
    if (first_side) return disc;
    return disc + 1 < before(v + 1) ? disc + 1 : room_beyond_triangles(v);
  }

private:
  int before(int v) const {
    int sum = 0;
    for (int w = 0; w < v; ++w) sum += triangles_[w];
    return sum;
  }
  int room_beyond_triangles(int v) const { return before(4) + (is_near(v) ? 0 : quads_); }

  std::array<int, 4> triangles_{};
  int kind_ = 0;
  int quads_ = 0;
};

} // namespace tetrarch::reasons
