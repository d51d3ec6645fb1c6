// SPDX-License-Identifier: GPL-2.0-or-later
#include "merged.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tetrarch::canonical {
namespace {

using numeric::Ball;

/// Lengths closer than this look equal; whether they are is proved afterwards.
constexpr double looks_equal = 1e-9;
/// The merged system has one zero within this of the structure: symmetric images of the zero must be no
/// farther.
constexpr double reach = 1e-6;

/// The blocks of edge classes, and which of them are edges of cells.
struct Blocks {
  Table<EdgeId, int> of;
  Table<EdgeId, bool> is_side; ///< an edge of cells; else a diagonal inside of one
  int count = 0;
  bool any_merged = false;
};

Blocks find_blocks(const Skeleton& skeleton, const hyperbolic::Metric<Ball>& lengths,
                   const CellShapes& shapes) {
  Blocks blocks{Table<EdgeId, int>(skeleton.edge_count(), -1),
                Table<EdgeId, bool>(skeleton.edge_count(), false)};
  for (const CellShape& cell : shapes.cells)
    for (const auto& row : cell.edge_class)
      for (const int e : row)
        if (e >= 0) blocks.is_side[EdgeId(e)] = true;
  std::vector<std::pair<double, int>> known; // length and number
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const double length = numeric::to_double(lengths[e]);
    if (blocks.is_side[e])
      for (const auto& [other, number] : known)
        if (std::abs(other - length) < looks_equal) blocks.of[e] = number;
    if (blocks.of[e] >= 0) {
      blocks.any_merged = true;
      continue;
    }
    blocks.of[e] = blocks.count++;
    if (blocks.is_side[e]) known.emplace_back(length, blocks.of[e]);
  }
  return blocks;
}

CellShapes with_blocks(CellShapes shapes, const Blocks& blocks) {
  for (CellShape& cell : shapes.cells)
    for (auto& row : cell.edge_class)
      for (int& e : row)
        if (e >= 0) e = blocks.of[EdgeId(e)];
  return shapes;
}

/// One proof that the zero of the merged system is the structure.
class Merger {
public:
  Merger(const Skeleton& skeleton, const FlatFaces& flat, const CellShapes& shapes, const Blocks& blocks,
         const hyperbolic::Metric<Ball>& lengths, const MergedCells& merged)
      : skeleton_(skeleton), shapes_(shapes), blocks_(blocks), lengths_(lengths), merged_(merged),
        size_(static_cast<std::size_t>(blocks.count), 0), length_(size_.size(), Ball(0)) {
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
      ++size_[blocks.of[e]];
      length_[blocks.of[e]] = lengths[e];
    }
    for (int cell = 0; cell < static_cast<int>(shapes.cells.size()); ++cell) {
      gram_.push_back(gram_of_cell(merged.m, flat, merged.shapes, cell));
      first_pair_.push_back(pairs_);
      pairs_ += shapes.cells[cell].corners * shapes.cells[cell].corners;
    }
    orbit_.resize(static_cast<std::size_t>(pairs_));
    std::iota(orbit_.begin(), orbit_.end(), 0);
  }

  bool run() {
    for (int cell = 0; cell < static_cast<int>(shapes_.cells.size()); ++cell) {
      const auto symmetries = symmetries_of_cell(merged_.shapes, cell, false);
      if (!symmetries) return false;
      for (const Symmetry& symmetry : *symmetries) {
        if (!keeps_the_zero(symmetry)) return false;
        join_orbits(cell, symmetry[cell].corners);
      }
    }
    return counts_agree();
  }

private:
  int pair(int cell, int i, int j) const {
    return first_pair_[cell] + std::min(i, j) * shapes_.cells[cell].corners + std::max(i, j);
  }

  /// Some number in the ball and the length of edge e's ball differ by less than the reach, whichever they
  /// are.
  bool is_near(const Ball& length, const Ball& middle) const {
    return abs(length - numeric::midpoint(middle)) < Ball(reach);
  }

  /// The image of the zero is within the reach: block by block, and where the symmetry moves a diagonal.
  bool keeps_the_zero(const Symmetry& symmetry) const {
    for (int cell = 0; cell < static_cast<int>(shapes_.cells.size()); ++cell) {
      const CornerMap& map = symmetry[cell].corners;
      const int image = symmetry[cell].cell;
      for (int i = 0; i < shapes_.cells[cell].corners; ++i)
        for (int j = 0; j < i; ++j) {
          const int here = merged_.shapes.cells[cell].edge_class[i][j];
          if (here < 0) continue;
          const int there = merged_.shapes.cells[image].edge_class[map[i]][map[j]];
          if (size_[here] != size_[there] || !is_near(length_[there], length_[here])) return false;
        }
      for (const int t : shapes_.cells[cell].tets)
        for (int e = 0; e < 6; ++e)
          if (!diagonal_stays(t, e, gram_[image], map)) return false;
    }
    return true;
  }

  bool diagonal_stays(int t, int e, const BallMatrix& image, const CornerMap& map) const {
    const EdgeId edge = skeleton_.edge({t, e});
    if (blocks_.is_side[edge]) return true;
    const auto [v, w] = edge_vertex[e];
    const Ball product = image[map[shapes_.corner[t][v]]][map[shapes_.corner[t][w]]];
    const Ball middle = numeric::midpoint(lengths_[edge]);
    return cosh(middle - Ball(reach)) < -product && -product < cosh(middle + Ball(reach)) &&
           middle > Ball(reach);
  }

  void join_orbits(int cell, const CornerMap& map) {
    for (int i = 0; i < shapes_.cells[cell].corners; ++i)
      for (int j = 0; j < i; ++j) {
        const int a = numeric::find_root(orbit_, pair(cell, i, j));
        const int b = numeric::find_root(orbit_, pair(cell, map[i], map[j]));
        orbit_[std::max(a, b)] = std::min(a, b);
      }
  }

  /// All classes of a block have equally many edges in each orbit.
  bool counts_agree() {
    std::vector<std::map<int, int>> count(static_cast<std::size_t>(skeleton_.edge_count()));
    for (int cell = 0; cell < static_cast<int>(shapes_.cells.size()); ++cell)
      for (int i = 0; i < shapes_.cells[cell].corners; ++i)
        for (int j = 0; j < i; ++j) {
          const int e = shapes_.cells[cell].edge_class[i][j];
          if (e >= 0) ++count[e][numeric::find_root(orbit_, pair(cell, i, j))];
        }
    std::map<int, EdgeId> first;
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count()))
      if (blocks_.is_side[e] &&
          count[e.value] != count[first.try_emplace(blocks_.of[e], e).first->second.value])
        return false;
    return true;
  }

  const Skeleton& skeleton_;
  const CellShapes& shapes_;
  const Blocks& blocks_;
  const hyperbolic::Metric<Ball>& lengths_; ///< the merged system's zero
  const MergedCells& merged_;
  std::vector<int> size_;    ///< of each block, the number of classes
  std::vector<Ball> length_; ///< of each block
  std::vector<BallMatrix> gram_;
  std::vector<int> first_pair_;
  int pairs_ = 0;
  std::vector<int> orbit_; ///< union-find over pairs of corners of one cell
};

} // namespace

std::optional<MergedCells> merge_equal_lengths(const Triangulation& tri, const Skeleton& skeleton,
                                               const hyperbolic::Metric<Ball>& lengths, const FlatFaces& flat,
                                               const CellShapes& shapes, const MergedSolver& solver) {
  for (const CellShape& cell : shapes.cells)
    for (const auto& diagonals : cell.drawn)
      if (!diagonals.empty()) return std::nullopt;
  const Blocks blocks = find_blocks(skeleton, lengths, shapes);
  if (!blocks.any_merged) return std::nullopt;
  const auto zero = solver(blocks.of, reach);
  if (!zero) return std::nullopt;
  MergedCells merged{with_blocks(shapes, blocks), decorate(tri, skeleton, *zero)};
  if (!Merger(skeleton, flat, shapes, blocks, *zero, merged).run()) return std::nullopt;
  return merged;
}

} // namespace tetrarch::canonical
