// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A complex with marked edges, which no move may lose.
///
/// The marked edges are a graph in the manifold, and a move has to leave the pair as it was. So here a move
/// is legal if it is legal in a Complex, and
///
///   - an edge that leaves (3-2, 4-4, 2-0, 2-1) is not marked;
///   - of edges that become one, at most one is marked;
///   - a merge shrinks an unmarked edge that has an end which no mark meets, or a marked edge that has an end
///     where two edges of equal order meet and nothing else.
///
/// Law: the list of orders at each vertex that is more than a point of an edge stays the same.
/// Source: Heard, Orb's documentation, 2007, on moves that keep the singular locus.

#include "tetrarch/core/marks.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <variant>

namespace tetrarch::moves {

struct MarkedTriangulation {
  Triangulation tri;
  Marks marks;
};

class MarkedComplex {
public:
  /// Throws PreconditionError if the skeleton is stale, or there is not one order per edge class.
  MarkedComplex(const Triangulation& tri, const Skeleton& skeleton, const EdgeOrders& orders);

  const Complex& complex() const { return complex_; }
  int size() const { return complex_.size(); }
  double order(EdgeId e) const { return order_[static_cast<std::size_t>(e.value)]; }

  /// Makes one of the moves merge, 2-3, 3-2, 4-4, 2-0 at an edge and 2-1, or returns false and changes
  /// nothing. O(n): the complex is copied.
  bool apply(const Move& move);
  /// The living tetrahedra and the marks on them. O(n).
  MarkedTriangulation compact() const;

private:
  bool may_shrink(const Move& move) const;
  bool carry(const Change& change);

  Complex complex_;
  std::vector<double> order_; ///< by edge id
};

/// Crushes edges (drill.hpp) and keeps the marks of the others; or why not. Two marked edges that would
/// become one are an obstacle, `edges_form_cycle`. Throws PreconditionError for a stale skeleton. O(n).
[[nodiscard]] std::variant<MarkedTriangulation, Obstacle> crushed(const Triangulation& tri,
                                                                  const Skeleton& skeleton,
                                                                  const EdgeOrders& orders,
                                                                  const Table<EdgeId, bool>& edges);

/// Makes moves that remove tetrahedra until there is none. O(n^2); for some hundreds of tetrahedra.
void reduce(MarkedComplex& complex, const Progress& progress = {});
/// `count` random 2-3 and 4-4 moves; attempts that are illegal count.
void shake(MarkedComplex& complex, int count, SplitMix64& random);

} // namespace tetrarch::moves
