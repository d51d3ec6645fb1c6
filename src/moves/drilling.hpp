// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What crushing and cutting share.

#include "tetrarch/core/skeleton.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <numeric>
#include <vector>

namespace tetrarch::moves {

using EdgeSet = Table<EdgeId, bool>;

/// Throws PreconditionError unless there is an entry for each edge and the skeleton is that of `tri`.
void require_fit(const Triangulation& tri, const Skeleton& skeleton, const EdgeSet& edges);

/// The vertices of the drilled edges.
Table<VertexId, bool> vertices_on(const Skeleton& skeleton, const EdgeSet& edges);

/// A forest of things to be identified, in which a circle is an error. Entry `count` stands for the whole
/// boundary.
class Forest {
public:
  explicit Forest(int count) : parent_(static_cast<std::size_t>(count) + 1) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int boundary() const { return static_cast<int>(parent_.size()) - 1; }
  /// False: the two were one already.
  bool join(int a, int b) {
    const int ra = numeric::find_root(parent_, a);
    const int rb = numeric::find_root(parent_, b);
    parent_[ra] = rb;
    return ra != rb;
  }

  int root(int a) { return numeric::find_root(parent_, a); }

private:
  std::vector<int> parent_;
};

} // namespace tetrarch::moves
