// SPDX-License-Identifier: GPL-2.0-or-later
#include "signed_graph.hpp"

#include <numeric>

namespace tetrarch::algebra {

SignedGraph::SignedGraph(int nodes)
    : nodes_(nodes), parent_(static_cast<std::size_t>(nodes) + 1), sign_(parent_.size(), 1),
      unbalanced_(parent_.size(), 0), is_grounded_(parent_.size(), 0) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

void SignedGraph::ground(int node) {
  if (is_grounded_[node]) return;
  is_grounded_[node] = 1;
  ++grounded_;
  join(node, nodes_, 1);
}

auto SignedGraph::find(int node) -> Root {
  int sign = 1;
  while (parent_[node] != node) {
    const int up = parent_[node];
    sign_[node] *= sign_[up]; // halve the path: the parent's parent becomes the parent
    parent_[node] = parent_[up];
    sign *= sign_[node];
    node = parent_[node];
  }
  return {node, sign};
}

void SignedGraph::join(int a, int b, int sign) {
  const Root p = find(a);
  const Root q = find(b);
  const int between = p.sign * sign * q.sign;
  if (p.node == q.node) {
    if (between < 0) unbalanced_[p.node] = 1;
    return;
  }
  parent_[p.node] = q.node;
  sign_[p.node] = between;
  if (unbalanced_[p.node]) unbalanced_[q.node] = 1;
}

SmithForm SignedGraph::form() {
  SmithForm form;
  form.units = -grounded_; // below, every node that is no root counts as a unit, and these have no column
  const int grounded = find(nodes_).node;
  for (int node = 0; node <= nodes_; ++node) {
    const bool is_root = parent_[node] == node;
    if (!is_root)
      ++form.units;
    else if (node != grounded && unbalanced_[node])
      form.factors.emplace_back(2);
  }
  return form;
}

} // namespace tetrarch::algebra
