// SPDX-License-Identifier: GPL-2.0-or-later
#include "bundled_strands.hpp"

#include "corner_sides.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tetrarch::surface {
namespace {

class Bundler {
public:
  Bundler(MarkedSurface& surface, const std::vector<Side>& entered, const std::vector<Side>& gates)
      : surface_(surface), is_gate_(entered.size(), 0), is_on_way_(entered.size(), 0),
        along_(surface.surface.side_count()), around_start_(surface.surface.side_count()) {
    for (const Side gate : gates) {
      is_gate_[gate.triangle()] = 1;
      for (int t = gate.triangle(); is_on_way_[t] == 0;) {
        is_on_way_[t] = 1;
        if (entered[t].exists()) t = entered[t].triangle();
      }
    }
    entered_ = &entered;
  }

  int run(const std::vector<SideEnd>& start) && {
    for (const SideEnd corner : start) follow_ways(corner);
    for (const Side s : ends_) set_mark(surface_, s, 0);
    Table<Side, std::vector<Crossing>> order(surface_.surface.side_count());
    for (int k = 0; k < order.size(); ++k) {
      const Side s(k);
      const Side m = surface_.surface.mate(s);
      if (m.value < k) continue;
      std::vector<Crossing>& all = order[s];
      all = around_start_[s];
      all.insert(all.end(), along_[s].begin(), along_[s].end());
      all.insert(all.end(), along_[m].rbegin(), along_[m].rend());
      all.insert(all.end(), around_start_[m].rbegin(), around_start_[m].rend());
    }
    return lay_strands(surface_, strands_, order);
  }

private:
  static constexpr int ends = 4; ///< of two loops
  enum class Turn { left, right };

  bool leads_on(Side s) const {
    const Side m = surface_.surface.mate(s);
    return is_on_way_[m.triangle()] != 0 && (*entered_)[m.triangle()] == s;
  }
  void follow_ways(SideEnd corner);
  void end_at(Side gate, SideEnd base, const std::vector<Side>& way);
  void turn(Side gate, Turn direction, std::array<int, 2> inner_first);
  void cross(int strand, Side s, std::vector<Crossing>& where) {
    std::vector<Side>& crossed = strands_[strand].crossed;
    where.push_back({strand, static_cast<int>(crossed.size())});
    crossed.push_back(s);
  }

  MarkedSurface& surface_;
  const std::vector<Side>* entered_;
  std::vector<char> is_gate_;
  std::vector<char> is_on_way_;              ///< of each triangle
  std::vector<Strand> strands_;              ///< from right to left
  Table<Side, std::vector<Crossing>> along_; ///< ways, from the start of a side on, which they leave by
  Table<Side, std::vector<Crossing>> around_start_; ///< turns around the start of a side, the nearest first
  std::vector<Side> ends_;                          ///< the first edges of loops, to be replaced
};

/// All ways through the triangle at this corner of the base, from right to left.
void Bundler::follow_ways(SideEnd corner) {
  struct Step {
    Side side;
    std::size_t depth;
  };
  std::vector<Step> stack;
  const auto push = [&](Side s, std::size_t depth) {
    if (leads_on(s)) stack.push_back({s, depth});
  };
  push(opposite(corner), 0);
  std::vector<Side> way;
  while (!stack.empty()) {
    const auto [side, depth] = stack.back();
    stack.pop_back();
    way.resize(depth);
    way.push_back(side);
    const Side here = surface_.surface.mate(side);
    if (is_gate_[here.triangle()]) {
      end_at(here, corner, way);
    } else {
      push(here.previous(), way.size()); // to the left, later
      push(here.next(), way.size());
    }
  }
}

void Bundler::end_at(Side gate, SideEnd base, const std::vector<Side>& way) {
  const int first = static_cast<int>(strands_.size());
  for (int k = 0; k < ends; ++k) {
    strands_.push_back({base, {}, {}, 0});
    for (const Side s : way) cross(first + k, s, along_[s]);
  }
  turn(gate, Turn::right, {first + 1, first});
  turn(gate, Turn::left, {first + 2, first + 3});
}

/// Two strands go around the point opposite the gate until each has met its end of a loop, the outer one
/// first.
void Bundler::turn(Side gate, Turn direction, std::array<int, 2> inner_first) {
  const Surface& whole = surface_.surface;
  SideEnd corner = corner_at(gate.triangle(), gate.corner());
  for (int going = 2; going > 0;) {
    // The strands come from outside: their right is the left of one who looks from the point.
    const bool is_left = direction == Turn::right;
    const Side s = is_left ? left_of(corner) : right_of(corner);
    const Side from_point = is_left ? whole.mate(s) : s;
    if (surface_.is_cut(s)) {
      Strand& strand = strands_[inner_first[--going]];
      strand.mark = surface_[from_point];
      strand.to = is_left ? start_of(s) : start_of(s.next());
      ends_.push_back(s);
    }
    for (int k = 0; k < going; ++k) cross(inner_first[k], s, around_start_[from_point]);
    const Side m = whole.mate(s);
    corner = is_left ? start_of(m) : start_of(m.next());
  }
}

} // namespace

int lay_bundled_strands(MarkedSurface& surface, const std::vector<SideEnd>& start,
                        const std::vector<Side>& entered, const std::vector<Side>& gates) {
  return Bundler(surface, entered, gates).run(start);
}

} // namespace tetrarch::surface
