// SPDX-License-Identifier: GPL-2.0-or-later
#include "flatness.hpp"

#include "relations.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tetrarch::canonical {
namespace {

using numeric::Ball;
using Coordinates = std::array<Ball, 4>;

/// The vectors of a cell's corners in the basis of its first tetrahedron, read off across flat faces.
std::vector<Coordinates> develop(const Decorated<Ball>& m, const FlatFaces& flat, const CellShapes& shapes,
                                 int cell) {
  const CellShape& shape = shapes.cells[cell];
  std::vector<Coordinates> at(static_cast<std::size_t>(shape.corners));
  std::vector<bool> known(at.size(), false);
  for (int v = 0; v < 4; ++v) {
    const int corner = shapes.corner[shape.tets[0]][v];
    at[corner].fill(Ball(0));
    at[corner][v] = 1;
    known[corner] = true;
  }
  std::vector<int> queue{shape.tets[0]};
  std::vector<bool> seen(static_cast<std::size_t>(m.tri.size()), false);
  seen[shape.tets[0]] = true;
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (int f = 0; f < 4; ++f) {
      const int t = queue[head];
      if (!flat[t][f]) continue;
      const Gluing g = m.tri.gluing({t, f});
      if (seen[g.tet]) continue;
      seen[g.tet] = true;
      queue.push_back(g.tet);
      const int far = shapes.corner[g.tet][g.perm[f]];
      if (known[far]) continue;
      const Across<Ball> across = look_across(m, {t, f});
      at[far].fill(Ball(0));
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k) at[far][k] += across.a[j] * at[shapes.corner[t][j]][k];
      known[far] = true;
    }
  return at;
}

Ball ball_product(const Gram<Ball>& w, const Coordinates& x, const Coordinates& y) {
  Ball sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) sum += x[i] * w[i][j] * y[j];
  return sum;
}

/// The orbits of a group of maps on its points, by a number for each point.
std::vector<int> orbits(const std::vector<CornerMap>& group, int points) {
  std::vector<int> root(static_cast<std::size_t>(points));
  std::iota(root.begin(), root.end(), 0);
  for (const CornerMap& map : group)
    for (int p = 0; p < points; ++p) {
      const int a = numeric::find_root(root, p);
      const int b = numeric::find_root(root, map[p]);
      root[std::max(a, b)] = std::min(a, b);
    }
  std::vector<int> number(root.size(), -1);
  std::vector<int> orbit(root.size());
  int count = 0;
  for (int p = 0; p < points; ++p) {
    int& n = number[numeric::find_root(root, p)];
    if (n < 0) n = count++;
    orbit[p] = n;
  }
  return orbit;
}

/// One cell with its group.
class FlatCell {
public:
  FlatCell(const CellShape& shape, std::vector<Coordinates> at, BallMatrix gram, std::vector<int> basis,
           std::vector<CornerMap> group)
      : shape_(shape), at_(std::move(at)), basis_(std::move(basis)), group_(std::move(group)),
        orbit_(orbits(group_, shape.corners)),
        orbit_count_(1 + *std::max_element(orbit_.begin(), orbit_.end())), gram_(std::move(gram)) {}

  bool has_regular_orbits() const {
    if (orbit_count_ > 4) return false; // G has rank 4
    BallMatrix r(static_cast<std::size_t>(orbit_count_),
                 std::vector<Ball>(static_cast<std::size_t>(orbit_count_), Ball(0)));
    for (std::size_t i = 0; i < at_.size(); ++i)
      for (std::size_t j = 0; j < at_.size(); ++j) r[orbit_[i]][orbit_[j]] += gram_[i][j];
    return is_regular(std::move(r));
  }

  bool fixes_one_line() const {
    if (!(mean_trace() < 2)) return false; // a whole number, and not 0: sums over orbits are fixed
    const std::vector<int> symbol = symbols();
    for (int a = 1; a < orbit_count_; ++a)
      if (!has_equal_means(0, a, symbol)) return false;
    return true;
  }

  bool has_relations() const {
    const std::vector<int> symbol = symbols();
    SymbolMatrix named(gram_.size(), std::vector<int>(gram_.size(), 0));
    for (int i = 0; i < shape_.corners; ++i)
      for (int j = 0; j < shape_.corners; ++j)
        if (i == j)
          named[i][i] = numeric::to_double(gram_[i][i]) > 0.5 ? 1 : 0; // it is one of these
        else
          named[i][j] = symbol[pair(i, j)];
    return is_flat_by_relations(named, gram_);
  }

private:
  /// The dimension of what the group fixes in R^{3,1}.
  Ball mean_trace() const {
    Ball sum = 0;
    for (const CornerMap& map : group_)
      for (int k = 0; k < 4; ++k) sum += at_[map[basis_[k]]][k];
    return sum / static_cast<int>(group_.size());
  }

  std::size_t pair(int i, int j) const { return static_cast<std::size_t>(i) * at_.size() + j; }

  /// Of each pair of corners a number, equal where the inner products are for a reason: they are on edges of
  /// one class, or symmetric.
  std::vector<int> symbols() const {
    const int n = shape_.corners;
    std::vector<int> root(static_cast<std::size_t>(n) * n);
    std::iota(root.begin(), root.end(), 0);
    const auto join = [&root](std::size_t x, std::size_t y) {
      const int a = numeric::find_root(root, static_cast<int>(x));
      const int b = numeric::find_root(root, static_cast<int>(y));
      root[std::max(a, b)] = std::min(a, b);
    };
    std::map<int, std::size_t> first;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        for (const CornerMap& map : group_) join(pair(i, j), pair(map[i], map[j]));
        join(pair(i, j), pair(j, i));
        if (shape_.edge_class[i][j] >= 0)
          join(pair(i, j), first.try_emplace(shape_.edge_class[i][j], pair(i, j)).first->second);
      }
    for (std::size_t k = 0; k < root.size(); ++k) numeric::find_root(root, static_cast<int>(k));
    return root;
  }

  /// For some j the mean of G_ij over i in orbit a is that over orbit b, symbol by symbol, and not 0.
  bool has_equal_means(int a, int b, std::vector<int> symbol) const {
    for (int j = 0; j < shape_.corners; ++j) {
      std::map<int, std::array<int, 2>> count;
      std::array<int, 2> size{};
      Ball sum = 0;
      for (int i = 0; i < shape_.corners; ++i) {
        if (orbit_[i] != a && orbit_[i] != b) continue;
        const int which = orbit_[i] == a ? 0 : 1;
        ++size[which];
        ++count[numeric::find_root(symbol, static_cast<int>(pair(i, j)))][which];
        if (which == 0) sum += gram_[i][j];
      }
      const bool equal = std::all_of(count.begin(), count.end(), [&size](const auto& entry) {
        return entry.second[0] * size[1] == entry.second[1] * size[0];
      });
      if (equal && abs(sum) > 0) return true;
    }
    return false;
  }

  const CellShape& shape_;
  std::vector<Coordinates> at_;
  std::vector<int> basis_;
  std::vector<CornerMap> group_;
  std::vector<int> orbit_;
  int orbit_count_;
  BallMatrix gram_;
};

} // namespace

bool is_regular(BallMatrix m) {
  const std::size_t n = m.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(numeric::to_double(m[r][c])) > std::abs(numeric::to_double(m[pivot][c]))) pivot = r;
    if (!(abs(m[pivot][c]) > 0)) return false;
    std::swap(m[pivot], m[c]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const Ball times = m[r][c] / m[c][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] -= times * m[c][k];
    }
  }
  return true;
}

BallMatrix gram_of_cell(const Decorated<Ball>& m, const FlatFaces& flat, const CellShapes& shapes, int cell) {
  const std::vector<Coordinates> at = develop(m, flat, shapes, cell);
  const Gram<Ball>& w = m.gram[shapes.cells[cell].tets[0]];
  BallMatrix gram(at.size(), std::vector<Ball>(at.size(), Ball(0)));
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = 0; j < at.size(); ++j) gram[i][j] = ball_product(w, at[i], at[j]);
  return gram;
}

std::optional<Criterion> prove_flat(const Decorated<Ball>& m, const FlatFaces& flat, const CellShapes& shapes,
                                    int cell, bool relations) {
  const CellShape& shape = shapes.cells[cell];
  if (shape.tets.size() == 1) return Criterion::tetrahedron;
  bool cusps = false;
  for (const Gram<Ball>& w : m.gram)
    for (int v = 0; v < 4; ++v) cusps |= w[v][v] == Ball(0);
  const auto symmetries = symmetries_of_cell(shapes, cell, cusps);
  if (!symmetries || symmetries->empty()) return std::nullopt;
  std::vector<CornerMap> group;
  for (const Symmetry& symmetry : *symmetries) group.push_back(symmetry[cell].corners);
  const auto& corners = shapes.corner[shape.tets[0]];
  const FlatCell look(shape, develop(m, flat, shapes, cell), gram_of_cell(m, flat, shapes, cell),
                      std::vector<int>(corners.begin(), corners.end()), std::move(group));
  if (look.has_regular_orbits()) return Criterion::orbits;
  if (look.fixes_one_line()) return Criterion::one_line;
  if (relations && look.has_relations()) return Criterion::relations;
  return std::nullopt;
}

} // namespace tetrarch::canonical
