// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace tetrarch::hex {
namespace {

/// Eight cells around a point of the grid as bits: bit 1 for the further along x, 2 along y, 4 along z.
using Around = unsigned;

bool hang_together(Around cells) {
  if (cells == 0) return true;
  Around reached = cells & (~cells + 1);
  for (Around before = 0; before != reached;) {
    before = reached;
    for (unsigned c = 0; c < 8; ++c)
      if ((reached >> c & 1U) != 0)
        for (unsigned axis = 1; axis < 8; axis *= 2) reached |= cells & (1U << (c ^ axis));
  }
  return reached == cells;
}

/// Whether the surface is a disk at a point: both what is taken and what is not hang together by faces.
const std::array<bool, 256>& disks() {
  static const std::array<bool, 256> table = [] {
    std::array<bool, 256> result{};
    for (Around c = 0; c < 256; ++c) result[c] = hang_together(c) && hang_together(~c & 255U);
    return result;
  }();
  return table;
}

class Chooser {
public:
  Chooser(const Grid& grid, const std::vector<float>& filled, double full)
      : grid_(grid), filled_(filled), full_(full), in_(filled.size()), flipped_(filled.size()) {
    for (std::size_t k = 0; k < in_.size(); ++k)
      in_[k] = filled[k] >= full && filled[k] > 0 && !is_outermost(k) ? 1 : 0;
  }

  /// One piece whose surface is a manifold. False: there is none.
  bool choose() {
    constexpr int most_rounds = 4;
    for (int round = 0; round < most_rounds; ++round) {
      keep_largest();
      if (!make_manifold()) return false;
      if (is_in_pieces(1)) return true;
    }
    return false;
  }

  /// One piece inside, and one outside.
  void keep_largest() {
    for (const char what : {1, 0}) {
      const std::vector<int> piece = pieces(what);
      const int count = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
      std::vector<double> size(static_cast<std::size_t>(count));
      for (const int p : piece)
        if (p >= 0) ++size[p];
      if (count <= 1) continue;
      const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
      for (std::size_t k = 0; k < in_.size(); ++k)
        if (piece[k] >= 0 && piece[k] != largest) in_[k] = what == 1 ? 0 : 1;
    }
  }

  /// Adds and removes cells, each at most once, until the surface is a disk at each point. False: not done.
  bool make_manifold() {
    constexpr int most_sweeps = 50;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      bool is_done = true;
      for (int z = 1; z < grid_.cells(2); ++z)
        for (int y = 1; y < grid_.cells(1); ++y)
          for (int x = 1; x < grid_.cells(0); ++x)
            if (!disks()[around(x, y, z)]) {
              is_done = false;
              if (!mend(x, y, z)) return false;
            }
      if (is_done) return true;
    }
    return false;
  }

  /// Of the surface, a manifold: vertices - edges + faces.
  int euler() const {
    int result = 0;
    for (int z = 1; z < grid_.cells(2); ++z)
      for (int y = 1; y < grid_.cells(1); ++y)
        for (int x = 1; x < grid_.cells(0); ++x) {
          const Around c = around(x, y, z);
          if (c != 0 && c != 255) ++result;
          // The edges and faces that leave the point in the three directions.
          for (unsigned axis = 1; axis < 8; axis *= 2) {
            Around four = 0;
            for (unsigned k = 0, bit = 0; k < 8; ++k)
              if ((k & axis) != 0) four |= (c >> k & 1U) << bit++;
            if (four != 0 && four != 15) --result;
          }
          for (unsigned axis = 1; axis < 8; axis *= 2)
            if ((c >> 7U & 1U) != (c >> (7U ^ axis) & 1U)) ++result;
        }
    return result;
  }

  /// Takes and leaves cells, one at a time, that want to be like a neighbor, where the surface stays what it
  /// is.
  void follow_neighbors() {
    constexpr int most_sweeps = 30;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      std::vector<std::pair<float, std::size_t>> wishes;
      for (std::size_t k = 0; k < in_.size(); ++k)
        if (const float wish = part_of_neighbor(k); wish < 0.5F) wishes.emplace_back(wish, k);
      std::sort(wishes.begin(), wishes.end());
      bool is_done = true;
      for (const auto& [wish, k] : wishes)
        if (part_of_neighbor(k) < 0.5F && contact(k) == Contact::disk && flips(k)) is_done = false;
      if (is_done) return;
    }
  }

  /// Pierces walls and bridges gaps that are one cell thick, or plugs holes and cuts bridges, the most
  /// doubtful first, until the genus is this. False: it does not come to that.
  bool reach_genus(int genus, int most_changes) {
    int now = (2 - euler()) / 2;
    for (; now != genus && changes_ < most_changes; ++changes_) {
      const bool is_more = now < genus;
      std::vector<std::pair<float, std::size_t>> choice;
      for (std::size_t k = 0; k < in_.size(); ++k)
        if (const Contact c = contact(k); c == (is_more ? Contact::ring : Contact::ends))
          choice.emplace_back(in_[k] != 0 ? filled_[k] : 1 - filled_[k], k);
      std::sort(choice.begin(), choice.end());
      const auto is_done = [&](const auto& c) {
        if (!flips(c.second)) return false;
        if (is_more || is_in_pieces(1)) return true;
        in_[c.second] ^= 1;
        return false;
      };
      if (std::none_of(choice.begin(), choice.end(), is_done)) return false;
      now += is_more ? 1 : -1;
    }
    return now == genus && is_in_pieces(1);
  }
  /// Of the genus, so far.
  int changes() const { return changes_; }

  bool is_in_pieces(int expected) const {
    for (const char what : {1, 0}) {
      const std::vector<int> piece = pieces(what);
      if (*std::max_element(piece.begin(), piece.end()) + 1 != expected) return false;
    }
    return true;
  }

  std::vector<char> take() { return std::move(in_); }

private:
  Around around(int x, int y, int z) const {
    Around result = 0;
    for (int k = 0; k < 8; ++k)
      result |= static_cast<Around>(in_[at(x, y, z, k)]) << static_cast<unsigned>(k);
    return result;
  }
  /// The k-th of the eight cells around a point.
  std::size_t at(int x, int y, int z, int k) const {
    return grid_.index(x - 1 + (k & 1), y - 1 + (k >> 1 & 1), z - 1 + (k >> 2 & 1));
  }

  /// How many of the points of a cell have no disk.
  int faults(std::size_t cell) const {
    const auto [x, y, z] = grid_.cell(cell);
    int count = 0;
    for (int dz = 0; dz < 2; ++dz)
      for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx)
          if (is_inner(x + dx, y + dy, z + dz) && !disks()[around(x + dx, y + dy, z + dz)]) ++count;
    return count;
  }
  bool is_inner(int x, int y, int z) const {
    return x > 0 && y > 0 && z > 0 && x < grid_.cells(0) && y < grid_.cells(1) && z < grid_.cells(2);
  }
  bool is_outermost(std::size_t cell) const {
    const auto [x, y, z] = grid_.cell(cell);
    return x == 0 || y == 0 || z == 0 || x == grid_.cells(0) - 1 || y == grid_.cells(1) - 1 ||
           z == grid_.cells(2) - 1;
  }

  /// Changes the one of eight cells that leaves the fewest faults, and of those the most doubtful.
  bool mend(int x, int y, int z) {
    std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
    for (int k = 0; k < 8; ++k) {
      const std::size_t cell = at(x, y, z, k);
      if (flipped_[cell] != 0 || is_outermost(cell)) continue;
      const int before = faults(cell);
      in_[cell] ^= 1;
      const double cost = faults(cell) - before + std::abs(filled_[cell] - full_);
      in_[cell] ^= 1;
      best = std::min(best, {cost, cell});
    }
    if (!std::isfinite(best.first)) return false;
    in_[best.second] ^= 1;
    flipped_[best.second] = 1;
    return true;
  }

  /// How much a cell has of what is taken, or of what is left if it is that, in terms of what the neighbor of
  /// its kind has that has most of it. Infinite where none has any.
  float part_of_neighbor(std::size_t cell) const {
    const auto has = [&](std::size_t k) { return in_[cell] != 0 ? filled_[k] : 1 - filled_[k]; };
    float most = 0;
    visit_neighbors(cell, [&](std::size_t n, unsigned) {
      if (in_[n] == in_[cell]) most = std::max(most, has(n));
    });
    return most > 0 ? has(cell) / most : std::numeric_limits<float>::infinity();
  }

  /// What a cell touches of its own kind, of its six sides: a disk, and then it can change without harm; a
  /// ring around it, as in a wall; its two ends alone, as in a bridge; all or nothing.
  enum class Contact { disk, ring, ends, other };
  Contact contact(std::size_t cell) const {
    if (is_outermost(cell)) return Contact::other;
    unsigned like = 0; // a bit for each side, opposite ones beside each other
    visit_neighbors(cell, [&](std::size_t n, unsigned side) {
      if (in_[n] == in_[cell]) like |= 1U << side;
    });
    constexpr unsigned all = 63;
    for (const unsigned axis : {3U, 12U, 48U}) {
      if (like == axis) return Contact::ends;
      if (like == (all ^ axis)) return Contact::ring;
    }
    return like == 0 || like == all ? Contact::other : Contact::disk;
  }

  /// Changes a cell if all its points have disks afterwards.
  bool flips(std::size_t cell) {
    in_[cell] ^= 1;
    if (faults(cell) == 0) return true;
    in_[cell] ^= 1;
    return false;
  }

  template <class Visit>
  void visit_neighbors(std::size_t cell, const Visit& visit) const {
    const auto at = grid_.cell(cell);
    unsigned side = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        std::array<int, 3> next = at;
        next[axis] += step;
        if (next[axis] >= 0 && next[axis] < grid_.cells(axis))
          visit(grid_.index(next[0], next[1], next[2]), side);
        ++side;
      }
  }

  /// By faces; -1 for cells that are not of the kind.
  std::vector<int> pieces(char what) const {
    std::vector<int> piece(in_.size(), -1);
    int count = 0;
    std::vector<std::size_t> stack;
    for (std::size_t k = 0; k < in_.size(); ++k) {
      if (in_[k] != what || piece[k] >= 0) continue;
      piece[k] = count;
      stack.push_back(k);
      while (!stack.empty()) {
        const std::size_t cell = stack.back();
        stack.pop_back();
        visit_neighbors(cell, [&](std::size_t n, unsigned) {
          if (in_[n] != what || piece[n] >= 0) return;
          piece[n] = count;
          stack.push_back(n);
        });
      }
      ++count;
    }
    return piece;
  }

  const Grid& grid_;
  const std::vector<float>& filled_;
  double full_;
  std::vector<char> in_;
  std::vector<char> flipped_;
  int changes_ = 0;
};

} // namespace

std::optional<std::vector<char>> chosen_cells(const Grid& grid, const std::vector<float>& filled, int genus,
                                              double full) {
  Chooser chooser(grid, filled, full);
  if (!chooser.choose() || chooser.euler() != 2 - 2 * genus) return std::nullopt;
  return chooser.take();
}

std::optional<ThinnedCells> thinned_cells(const Grid& grid, const std::vector<float>& filled, int genus,
                                          double full) {
  constexpr int most_changes = 8; // of the genus
  Chooser chooser(grid, filled, full);
  if (!chooser.choose()) return std::nullopt;
  chooser.follow_neighbors();
  if (!chooser.reach_genus(genus, most_changes)) return std::nullopt;
  if (chooser.changes() > 0) chooser.follow_neighbors();
  return ThinnedCells{chooser.take(), chooser.changes()};
}

} // namespace tetrarch::hex
