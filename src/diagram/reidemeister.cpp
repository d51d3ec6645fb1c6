// SPDX-License-Identifier: GPL-2.0-or-later
#include "removal.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/moves.hpp"

#include <array>
#include <string>

namespace tetrarch::diagram {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw PreconditionError(std::string("the region is no ") + what);
}

} // namespace

bool is_kink(const Diagram& diagram, int dart) {
  return diagram.at_crossing(dart) && diagram.next_on_left(dart) == dart;
}

bool is_poke(const Diagram& diagram, int dart) {
  const int next = diagram.next_on_left(dart);
  return next != dart && diagram.next_on_left(next) == dart && diagram.at_crossing(dart) &&
         diagram.at_crossing(next) && diagram.node_of(dart) != diagram.node_of(next) &&
         diagram.is_over(dart) == diagram.is_over(diagram.opposite(dart));
}

bool is_triangle(const Diagram& diagram, int dart) {
  const int second = diagram.next_on_left(dart);
  const int third = diagram.next_on_left(second);
  if (diagram.next_on_left(third) != dart) return false;
  const std::array<int, 3> darts{dart, second, third};
  bool top = false;
  bool bottom = false;
  for (const int d : darts) {
    if (!diagram.at_crossing(d)) return false;
    const int end = diagram.opposite(d);
    top |= diagram.is_over(d) && diagram.is_over(end);
    bottom |= !diagram.is_over(d) && !diagram.is_over(end);
  }
  const int a = diagram.node_of(dart);
  const int b = diagram.node_of(second);
  const int c = diagram.node_of(third);
  return top && bottom && a != b && b != c && c != a;
}

Diagram without_kink(const Diagram& diagram, int dart) {
  require(is_kink(diagram, dart), "kink");
  // The loop is passed over: what is left are the two other darts, which the removal joins through it.
  return Removal(diagram, {diagram.node_of(dart)}).run();
}

Diagram without_poke(const Diagram& diagram, int dart) {
  require(is_poke(diagram, dart), "poke");
  return Removal(diagram, {diagram.node_of(dart), diagram.node_of(diagram.opposite(dart))}).run();
}

bool is_twist(const Diagram& diagram, int dart) {
  const int next = diagram.next_on_left(dart);
  if (next == dart || diagram.next_on_left(next) != dart) return false;
  return (is_vertex(diagram, dart) && diagram.at_crossing(next)) ||
         (is_vertex(diagram, next) && diagram.at_crossing(dart));
}

Diagram without_twist(const Diagram& diagram, int dart) {
  require(is_twist(diagram, dart), "twist");
  const int out = is_vertex(diagram, dart) ? dart : diagram.next_on_left(dart);
  const int back = diagram.next_on_left(out);
  Removal removal(diagram, {diagram.node_of(back)});
  removal.swap(out, diagram.opposite(back));
  return removal.run();
}

Diagram with_twist(const Diagram& diagram, int dart, bool over) {
  if (!is_vertex(diagram, dart)) throw PreconditionError("a twist needs a vertex of valence 3 or more");
  const int next = diagram.turned(dart, 1);
  Draft draft(diagram);
  // The vertex lies west of the crossing, `dart` leaves it to the southeast, `next` to the northeast. Darts
  // of the crossing: northwest, southwest, southeast, northeast. What came from the southeast comes from
  // there.
  const int near = draft.add_node(4, true, over ? 0 : 1);
  const int end = diagram.opposite(dart);
  const int next_end = diagram.opposite(next);
  draft.join(dart, near + 1);
  draft.join(next, near);
  if (end == next) {
    draft.join(near + 3, near + 2);
  } else {
    draft.join(near + 2, end);
    draft.join(near + 3, next_end);
  }
  return std::move(draft).finished();
}

Diagram with_triangle_turned(const Diagram& diagram, int dart) {
  require(is_triangle(diagram, dart), "triangle of three levels");
  // A strand comes from outside to a first crossing, runs along a side and leaves by the second; then it
  // meets the second first. What came to the outer dart of the one now comes to the inner dart of the other.
  std::vector<std::pair<int, int>> moved;
  std::vector<std::pair<int, int>> sides;
  for (int k = 0, d = dart; k < 3; ++k, d = diagram.next_on_left(d)) {
    const int end = diagram.opposite(d);
    const int out = diagram.turned(d, 2);
    const int end_out = diagram.turned(end, 2);
    moved.emplace_back(out, end);
    moved.emplace_back(end_out, d);
    sides.emplace_back(out, end_out);
  }
  const auto image = [&moved](int d) {
    for (const auto& [from, to] : moved)
      if (from == d) return to;
    return d;
  };
  Draft draft(diagram);
  for (const auto& [from, to] : moved) draft.join(to, image(diagram.opposite(from)));
  for (const auto& [a, b] : sides) draft.join(a, b);
  return std::move(draft).finished();
}

} // namespace tetrarch::diagram
