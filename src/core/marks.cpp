// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/marks.hpp"

#include "tetrarch/core/error.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace tetrarch {
namespace {

std::string short_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

} // namespace

bool is_edge_order(double order) {
  return order == 0 || (order >= 1 && std::isfinite(order));
}

std::string fault_of(const Marks& marks, const Skeleton& skeleton) {
  Table<EdgeId, int> first(skeleton.edge_count(), -1);
  for (int m = 0; m < static_cast<int>(marks.size()); ++m) {
    const EdgeMark& mark = marks[static_cast<std::size_t>(m)];
    const std::string which = "mark " + std::to_string(m);
    if (mark.edge.tet < 0 || mark.edge.tet >= skeleton.tetrahedron_count())
      return which + " names tetrahedron " + std::to_string(mark.edge.tet) + " of " +
             std::to_string(skeleton.tetrahedron_count());
    if (mark.edge.edge < 0 || mark.edge.edge > 5) return which + " names no edge of a tetrahedron";
    if (!is_edge_order(mark.order))
      return which + " has the order " + short_text(mark.order) + " (expected 0, 1 or a number above 1)";
    int& known = first[skeleton.edge(mark.edge)];
    if (known < 0) known = m;
    if (marks[static_cast<std::size_t>(known)].order != mark.order)
      return which + " gives another order to the edge of mark " + std::to_string(known);
  }
  return {};
}

EdgeOrders edge_orders(const Skeleton& skeleton, const Marks& marks) {
  if (const std::string fault = fault_of(marks, skeleton); !fault.empty())
    throw PreconditionError("edge_orders: " + fault);
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  for (const EdgeMark& mark : marks) orders[skeleton.edge(mark.edge)] = mark.order;
  return orders;
}

Marks marks_of(const Skeleton& skeleton, const EdgeOrders& orders) {
  if (orders.size() != skeleton.edge_count())
    throw PreconditionError("marks_of: needs one order per edge class");
  Marks marks;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (orders[e] != 1) marks.push_back({skeleton.around(e).front().edge(), orders[e]});
  return marks;
}

std::string to_string(const EdgeMark& mark) {
  const auto [i, j] = edge_vertex[mark.edge.edge];
  return std::to_string(mark.edge.tet) + "-" + std::to_string(i) + std::to_string(j) + ":" +
         short_text(mark.order);
}

} // namespace tetrarch
