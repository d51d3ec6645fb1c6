// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cuts of least cost between two kinds of nodes: a maximal flow by shortest augmenting paths, layer by
/// layer.
///
/// Boost.Graph's Boykov-Kolmogorov was tried; its iterators do not compile without warnings in GCC 12.
/// Source: Dinic, "Algorithm for solution of a problem of maximum flow in networks" (1970).

#include <cstddef>
#include <vector>

namespace tetrarch::polycube {

class Cut {
public:
  explicit Cut(std::size_t nodes) : first_(nodes + 2, -1), cost_(nodes) {}

  /// What it costs if the node is of kind 1, beyond what kind 0 costs.
  void add(int node, double cost) { cost_[static_cast<std::size_t>(node)] += cost; }
  /// What it costs if `zero` is of kind 0 and `one` of kind 1.
  void add(int zero, int one, double cost) { join(zero, one, cost); }
  /// The kind of each node; 0 where both cost the same. Once only. O(n^2 m), in practice nearly O(m).
  std::vector<char> solve();

private:
  struct Arc {
    int to = 0;
    int next = -1; ///< of the same node
    double left = 0;
  };
  void join(int from, int to, double capacity);
  bool find_layers();
  double push();

  std::vector<Arc> arcs_; ///< arc k runs against arc k ^ 1
  std::vector<int> first_;
  std::vector<double> cost_;
  std::vector<int> layer_;
  std::vector<int> at_; ///< the arc that each node tries next
};

} // namespace tetrarch::polycube
