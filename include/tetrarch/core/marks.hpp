// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Marks: edges of a triangulation that are more than lines to draw along.
///
/// The order of an edge says what the space is like around it. 1: a regular edge, unmarked. A number n > 1:
/// the angle around it is 2 pi / n (a whole n: the axis of a rotation in an orbifold; any other: a cone
/// manifold). 0: a null edge, whose meridian is parabolic; the edge itself lies at infinity.
///
/// A mark names its edge by one of the t-edges in its class, so that it needs no skeleton to be written down:
/// tetrahedron 0, edge 12, order 3.

#include "tetrarch/core/skeleton.hpp"

#include <string>
#include <vector>

namespace tetrarch {

/// The order of every edge class.
using EdgeOrders = Table<EdgeId, double>;

struct EdgeMark {
  TetEdge edge;
  double order = 1;
  friend bool operator==(const EdgeMark&, const EdgeMark&) = default;
};
using Marks = std::vector<EdgeMark>;

/// 0, 1, or a finite number above 1.
bool is_edge_order(double order);

/// What is wrong with the marks, as a phrase ("mark 3 names tetrahedron 7 of 5"); empty if nothing is. A
/// class may be named twice with the same order. O(marks).
std::string fault_of(const Marks& marks, const Skeleton& skeleton);

/// The order of every class, 1 where no mark is. Throws PreconditionError where `fault_of` finds one. O(n).
EdgeOrders edge_orders(const Skeleton& skeleton, const Marks& marks);
/// The inverse: one mark a class of an order other than 1, at the class's first t-edge, in order of classes.
Marks marks_of(const Skeleton& skeleton, const EdgeOrders& orders);

/// "0-12:3" as the marks of papers' tables are written: tetrahedron, edge, order. Orders as short as they
/// read back the same.
std::string to_string(const EdgeMark& mark);

} // namespace tetrarch
