// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/cells.hpp"

#include "cells_with_marks.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace tetrarch::canonical {
namespace {

/// Corners of the small tetrahedra: 0 and 1 the ends of the side, then these.
constexpr int wall_center = 2;
constexpr int cell_center = 3;

/// A side of a wall polygon, seen from inside its cell, is held by its edge with the wall to the right.
class Coner {
public:
  Coner(const Triangulation& tri, const Skeleton& skeleton, const FlatFaces& flat,
        const Table<EdgeId, bool>& kept)
      : tri_(tri), skeleton_(skeleton), flat_(flat), kept_(kept), walls_around_(skeleton.edge_count(), 0),
        small_(static_cast<std::size_t>(tri.size()) * 16, -1) {
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
      for (const Walk& w : skeleton.around(e)) walls_around_[e] += is_wall(w.left_face());
  }

  CellDecomposition run() {
    CellDecomposition out;
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        for (const int k : face_vertex[f])
          if (is_wall({t, f}) && is_side(hold(t, f, k))) {
            small_[slot(t, f, k)] = out.coned.add_tetrahedra();
            out.origin.push_back({{t, f}, k});
          }
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        for (const int k : face_vertex[f])
          if (small_[slot(t, f, k)] >= 0) glue_small(out.coned, hold(t, f, k));
    out.cells = list_cells();
    return out;
  }

private:
  static std::size_t slot(int t, int f, int k) {
    return static_cast<std::size_t>(t) * 16 + static_cast<std::size_t>(4 * f + k);
  }
  /// Held by the edge of face f that lies opposite vertex k, smaller end first, f to the right.
  static Walk hold(int t, int f, int k) {
    std::array<int, 2> ends{};
    int count = 0;
    for (const int v : face_vertex[f])
      if (v != k) ends[count++] = v;
    return {t, Perm4(ends[0], ends[1], f, k)};
  }
  bool is_wall(TetFace f) const { return !flat_[f.tet][f.face]; }
  bool is_side(const Walk& w) const {
    const EdgeId e = skeleton_.edge(w.edge());
    return walls_around_[e] > 2 || kept_[e];
  }
  int small(const Walk& w) const { return small_[slot(w.tet, w.hold[2], w.hold[3])]; }
  /// The small tetrahedron's corner that lies at the walk's start.
  static int start_corner(const Walk& w) { return w.from() < w.to() ? 0 : 1; }

  /// Turns around the edge, inside the cell, to the wall on the other side; that wall is then to the left.
  void turn_to_far_wall(Walk& w) const {
    while (!is_wall(w.left_face())) w.step_left(tri_);
  }

  /// From the side at w, held with the wall to the right, to the next side of the same polygon at w's end;
  /// the result is held from that end on, with the wall to the right.
  Walk next_side(Walk w) const {
    while (true) {
      w.hold = Perm4(w.hold[1], w.hold[3], w.hold[2], w.hold[0]);
      if (is_side(w)) return w;
      turn_to_far_wall(w); // a diagonal: the polygon goes on beyond it
      w.hold =
          w.hold * Perm4::swap(2, 3) * Perm4::swap(0, 1); // wall to the right again, the same end at hold[1]
    }
  }

  static void glue_ends(Triangulation& coned, int from, int face, int to, int start_image) {
    const Perm4 p = start_image == 0 ? Perm4() : Perm4::swap(0, 1);
    if (coned.is_boundary({from, face})) coned.glue({from, face}, to, p);
  }

  void glue_small(Triangulation& coned, const Walk& w) const {
    const int here = small(w);
    // Through the wall, to the same side of it seen from the other cell.
    Walk through = w;
    through.step_right(tri_);
    through.hold = through.hold * Perm4::swap(2, 3);
    glue_ends(coned, here, cell_center, small(through), start_corner(through));
    // Around the side, to the other wall of this cell.
    Walk around = w;
    turn_to_far_wall(around);
    around.hold = around.hold * Perm4::swap(2, 3);
    glue_ends(coned, here, wall_center, small(around), start_corner(around));
    // Along the polygon, at either end.
    for (int end = 0; end < 2; ++end) {
      Walk along = w;
      if (end == 0) along.hold = along.hold * Perm4::swap(0, 1);
      along = next_side(along); // starts at the common end
      const int away = 1 - end;
      const Perm4 p = start_corner(along) == end ? Perm4() : Perm4::swap(0, 1);
      if (coned.is_boundary({here, away})) coned.glue({here, away}, small(along), p);
    }
  }

  std::vector<Cell> list_cells() const {
    std::vector<int> cell(static_cast<std::size_t>(tri_.size()));
    std::iota(cell.begin(), cell.end(), 0);
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        if (!is_wall({t, f})) {
          const int a = numeric::find_root(cell, t);
          const int b = numeric::find_root(cell, tri_.gluing({t, f}).tet);
          cell[std::max(a, b)] = std::min(a, b);
        }
    std::vector<Cell> by_root(cell.size());
    std::vector<char> seen(small_.size(), 0);
    for (int t = 0; t < tri_.size(); ++t)
      for (int f = 0; f < 4; ++f)
        for (const int k : face_vertex[f]) {
          if (small_[slot(t, f, k)] < 0 || seen[slot(t, f, k)]) continue;
          int corners = 0;
          Walk w = hold(t, f, k);
          do {
            seen[slot(w.tet, w.hold[2], w.hold[3])] = 1;
            ++corners;
            w = next_side(w);
          } while (!seen[slot(w.tet, w.hold[2], w.hold[3])]);
          by_root[numeric::find_root(cell, t)].walls.push_back(corners);
        }
    std::vector<Cell> cells;
    for (Cell& c : by_root) {
      std::sort(c.walls.begin(), c.walls.end(), std::greater<>());
      if (!c.walls.empty()) cells.push_back(std::move(c));
    }
    return cells;
  }

  const Triangulation& tri_;
  const Skeleton& skeleton_;
  const FlatFaces& flat_;
  const Table<EdgeId, bool>& kept_; ///< sides, however many walls are around
  Table<EdgeId, int> walls_around_;
  std::vector<int> small_; ///< by (tetrahedron, wall face, vertex opposite the side); -1: no side
};

} // namespace

std::string Cell::name() const {
  if (walls == std::vector<int>{3, 3, 3, 3}) return "tetrahedron";
  if (walls == std::vector<int>{4, 3, 3, 3, 3}) return "square pyramid";
  if (walls == std::vector<int>(8, 3)) return "octahedron";
  if (walls == std::vector<int>(6, 4)) return "cube";
  if (walls == std::vector<int>(6, 3)) return "triangular bipyramid";
  if (walls == std::vector<int>{4, 4, 4, 3, 3}) return "triangular prism";
  std::string text = "cell with " + std::to_string(walls.size()) + " walls (";
  for (std::size_t k = 0; k < walls.size(); ++k) text += (k > 0 ? "," : "") + std::to_string(walls[k]);
  return text + ")";
}

CellDecomposition cell_decomposition(const Triangulation& tri, const Skeleton& skeleton,
                                     const FlatFaces& flat) {
  return cell_decomposition(tri, skeleton, flat, Table<EdgeId, bool>(skeleton.edge_count(), false));
}

CellDecomposition cell_decomposition(const Triangulation& tri, const Skeleton& skeleton,
                                     const FlatFaces& flat, const Table<EdgeId, bool>& kept) {
  skeleton.require_current(tri);
  if (skeleton.has_boundary_faces()) throw PreconditionError("a cell decomposition needs a closed gluing");
  return Coner(tri, skeleton, flat, kept).run();
}

} // namespace tetrarch::canonical
