// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/moves.hpp"

#include "draft.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::diagram {
namespace {

void require_dart(const Diagram& diagram, int dart) {
  if (dart < 0 || dart >= diagram.dart_count())
    throw PreconditionError("there is no dart " + std::to_string(dart));
}

} // namespace

Diagram with_kinks(const Diagram& diagram, const std::vector<Kink>& kinks) {
  Draft draft(diagram);
  std::vector<bool> used(static_cast<std::size_t>(diagram.dart_count()), false);
  for (const Kink& kink : kinks) {
    require_dart(diagram, kink.dart);
    const int end = diagram.opposite(kink.dart);
    if (used[kink.dart]) throw PreconditionError("two kinks on one arc");
    used[kink.dart] = used[end] = true;
    // Darts to the west, south, east, north; one comes from the west.
    const int west = draft.add_node(4, true, kink.over_first ? 0 : 1);
    const int south = west + 1;
    const int east = west + 2;
    const int north = west + 3;
    draft.join(kink.dart, west);
    draft.join(east, kink.left ? north : south);
    draft.join(kink.left ? south : north, end);
  }
  return std::move(draft).finished();
}

Diagram with_poke(const Diagram& diagram, const Poke& poke) {
  require_dart(diagram, poke.mover);
  require_dart(diagram, poke.other);
  const Classes region = regions(diagram);
  const Classes part = parts(diagram);
  const int mover_end = diagram.opposite(poke.mover);
  const int other_end = diagram.opposite(poke.other);
  if (poke.mover == poke.other || poke.mover == other_end)
    throw PreconditionError("an arc cannot be pushed over itself");
  if (part.of[poke.mover] == part.of[poke.other] && region.of[poke.mover] != region.of[poke.other])
    throw PreconditionError("the two arcs have no region in common");
  // The mover runs east with the region to its north, the other one west with it to its south. The mover
  // goes north across the other at the first crossing, and comes back at the second, east of it.
  Draft draft(diagram);
  const int over = poke.over ? 1 : 0;
  const int first = draft.add_node(4, true, over); // east, north, west, south
  const int second = draft.add_node(4, true, over);
  draft.join(poke.mover, first + 3);
  draft.join(first + 1, second + 1);
  draft.join(second + 3, mover_end);
  draft.join(poke.other, second);
  draft.join(second + 2, first);
  draft.join(first + 2, other_end);
  return std::move(draft).finished();
}

Diagram connected(const Diagram& diagram) {
  Diagram joined = diagram;
  while (true) {
    const Classes part = parts(joined);
    if (part.count <= 1) return joined;
    const auto second = std::find_if(part.of.begin(), part.of.end(), [](int p) { return p != 0; });
    joined = with_poke(joined, {static_cast<int>(second - part.of.begin()), 0, true});
  }
}

} // namespace tetrarch::diagram
