// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/cut.hpp"

namespace tetrarch::bundle {
namespace {

std::string unsafe_piece(const Round& round) {
  for (const Piece& piece : round.partition.pieces()) {
    const int t = round.partition.triangles()[piece.first];
    const Danger danger = classify(round.partition, round.pattern, piece).danger;
    if (danger == Danger::extreme || (danger == Danger::moderate && !round.dangerous))
      return "safeness: the piece that begins with triangle " + std::to_string(t) + " is dangerous";
  }
  for (const Side s : round.partition.breaking_edges())
    if (round.pattern.is_open(s))
      return "safeness: a breaking edge of triangle " + std::to_string(s.triangle()) + " is open";
  return "";
}

std::string incomplete_triangle(const Round& round) {
  const Disk& disk = round.mesh.disk();
  for (const int t : round.mesh.frontier()) {
    const std::string where = ": triangle " + std::to_string(t);
    int sum = 0;
    for (const Side s : sides_of(t)) {
      sum += round.pattern[s];
      if (round.pattern.is_open(s)) return "completeness" + where + " has an open side";
      if (!disk.is_boundary(s) && round.pattern[disk.mate(s)] != -round.pattern[s])
        return "consistency" + where + " and its neighbor have equal values on their edge";
    }
    if (sum == 3 || sum == -3) return "completeness" + where + " has three equal values";
  }
  return "";
}

} // namespace

std::string broken_invariant(const Round& round) {
  switch (round.stage) {
  case Round::Stage::begun:
    if (round.dangerous || is_safe(round.mesh, round.pattern)) return "";
    return "safeness: the unsolved mesh of round " + std::to_string(round.number) + " is not safe";
  case Round::Stage::completed:
    return unsafe_piece(round);
  case Round::Stage::solved:
    break;
  }
  return incomplete_triangle(round);
}

} // namespace tetrarch::bundle
