// SPDX-License-Identifier: GPL-2.0-or-later
/// Procedure 5.3.1, mended.
///
/// The text sweeps over the extremely dangerous pieces again and again. A piece with forbidding value b
/// takes -b from a neighbour, across their breaking edge, if the neighbour can afford b: it is safe,
/// moderately dangerous, or has the opposite forbidding value. Other pieces are skipped until a neighbour
/// has been relieved. That is quadratic, and it leaves open what a piece without any value should take: such
/// a piece needs both values, and giving it one too early can cut it off from the only help there is.
///
/// Here the order is found first. The pieces form a tree. Its *roots* are the pieces that need nothing or,
/// if there are none, two neighbours with opposite forbidding values, whose edge relieves both. Relief
/// travels outwards from the roots, so every other piece has a neighbour towards the roots that will be
/// relieved, and takes its value from there, farthest pieces first. Then the pieces farther out are relieved
/// when a piece has its turn: each either gave it a value or can afford any. So every piece gets what it
/// needs, and one without values, which has three neighbours or more, gets both. Without roots all forbidding
/// values are equal: that is the obstruction of Definition 5.3.2.
#include "rounds.hpp"

#include <algorithm>

namespace tetrarch::bundle {
namespace {

class Relief {
public:
  explicit Relief(Work& work);
  std::optional<Obstruction> run();

private:
  /// What a piece still needs, and which way help is.
  struct Needs {
    bool plus = false;  ///< +1
    bool minus = false; ///< -1
    int forbidding = 0; ///< 0 for a piece that needs nothing
    Side back;          ///< its side of the breaking edge towards the roots
  };

  int piece_at(Side s) const { return work_.partition.piece_of(s.triangle()); }
  int piece_behind(Side s) const { return piece_at(work_.disk().mate(s)); }
  template <class Visit>
  void for_each_door(int piece, Visit visit) const;
  void spread_forbidding_values();
  std::vector<int> find_roots();
  std::vector<int> outwards_from(const std::vector<int>& roots);
  void serve(int piece);
  void set(Side s, int value);
  Obstruction everything() const;

  Work& work_;
  std::vector<Needs> needs_;
};

Relief::Relief(Work& work) : work_(work), needs_(work.partition.pieces().size()) {
  for (std::size_t p = 0; p < needs_.size(); ++p) {
    const Assignment given = classify(work_.partition, work_.pattern, work_.partition.pieces()[p]);
    if (given.danger != Danger::extreme) continue;
    needs_[p].plus = given.forbidding <= 0;
    needs_[p].minus = given.forbidding >= 0;
    needs_[p].forbidding = given.forbidding;
  }
}

/// Visits a piece's *doors*: its sides of breaking edges.
template <class Visit>
void Relief::for_each_door(int piece, Visit visit) const {
  const auto [type, first, count] = work_.partition.pieces()[piece];
  for (int k = first; k < first + count; ++k)
    for (const Side s : sides_of(work_.partition.triangles()[k]))
      if (work_.mesh.is_separating(s) && !work_.partition.is_joined(s)) visit(s);
}

std::optional<Obstruction> Relief::run() {
  spread_forbidding_values();
  const std::vector<int> roots = find_roots();
  if (roots.empty()) return everything();
  const std::vector<int> order = outwards_from(roots);
  for (auto p = order.rbegin(); p != order.rend(); ++p) serve(*p);
  // Step [2], which forgets the edges between two safe pieces: whatever is open can have any value.
  for (const Side s : work_.partition.breaking_edges())
    if (work_.pattern.is_open(s)) set(s, 1);
  return std::nullopt;
}

/// A piece without any value has, in effect, the forbidding value of a neighbour, which will give it that.
void Relief::spread_forbidding_values() {
  std::vector<int> queue;
  for (int p = 0; p < static_cast<int>(needs_.size()); ++p)
    if (needs_[p].forbidding != 0) queue.push_back(p);
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const int forbidding = needs_[queue[k]].forbidding;
    for_each_door(queue[k], [&](Side door) {
      Needs& neighbour = needs_[piece_behind(door)];
      if (neighbour.forbidding != 0 || !neighbour.plus) return;
      neighbour.forbidding = forbidding;
      queue.push_back(piece_behind(door));
    });
  }
}

std::vector<int> Relief::find_roots() {
  std::vector<int> roots;
  for (int p = 0; p < static_cast<int>(needs_.size()); ++p)
    if (!needs_[p].plus && !needs_[p].minus) roots.push_back(p);
  if (!roots.empty()) return roots;
  for (const Side s : work_.partition.breaking_edges()) {
    const int here = piece_at(s);
    const int there = piece_behind(s);
    if (needs_[here].forbidding != -needs_[there].forbidding) continue;
    set(s, -needs_[here].forbidding);
    return {here, there};
  }
  return {};
}

/// All pieces breadth first. With two roots next to each other, each has its own side of the tree.
std::vector<int> Relief::outwards_from(const std::vector<int>& roots) {
  std::vector<char> seen(needs_.size(), 0);
  for (const int p : roots) seen[p] = 1;
  std::vector<int> order = roots;
  for (std::size_t k = 0; k < order.size(); ++k)
    for_each_door(order[k], [&](Side door) {
      const int p = piece_behind(door);
      if (seen[p]) return;
      seen[p] = 1;
      needs_[p].back = work_.disk().mate(door);
      order.push_back(p);
    });
  return order;
}

/// Takes what the piece needs, from farther out if it can.
void Relief::serve(int piece) {
  const Needs& needs = needs_[piece];
  if (!needs.plus && !needs.minus) return;
  for_each_door(piece, [&](Side door) {
    if ((needs.plus || needs.minus) && door != needs.back && work_.pattern.is_open(door))
      set(door, needs.plus ? 1 : -1);
  });
  if (needs.plus || needs.minus) set(needs.back, needs.plus ? 1 : -1);
}

void Relief::set(Side s, int value) {
  work_.set(s, value);
  for (const Side side : {s, work_.disk().mate(s)}) {
    Needs& piece = needs_[piece_at(side)];
    (work_.pattern[side] > 0 ? piece.plus : piece.minus) = false;
  }
}

Obstruction Relief::everything() const {
  Obstruction all{work_.partition.triangles(), needs_.front().forbidding};
  std::sort(all.triangles.begin(), all.triangles.end());
  return all;
}

} // namespace

std::optional<Obstruction> relieve(Work& work) {
  return Relief(work).run();
}

} // namespace tetrarch::bundle
