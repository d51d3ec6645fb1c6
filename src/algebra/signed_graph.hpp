// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Incidence matrices with at most two non-zeros, +-1, per row: their Smith form needs no elimination.
///
/// The rows are arcs and the columns nodes. An arc of sign +1 carries (-1, +1) or (+1, -1) at its two nodes,
/// one of sign -1 carries equal signs; on a loop the two add up, to 0 or +-2. A grounded node has no column.
/// A component of m nodes is *balanced* if signs can be switched at nodes until all arcs are +1. Then its
/// form is m-1 ones; unbalanced, m-1 ones and a two; with a grounded node, one 1 for each node that is not
/// grounded, balanced or not. Both outer boundary maps of a triangulated manifold are such.
/// Source: Zaslavsky, "Signed graphs", Discrete Applied Mathematics 4 (1982), theorem 5.1 for the ranks.

#include "tetrarch/algebra/smith.hpp"

#include <vector>

namespace tetrarch::algebra {

class SignedGraph {
public:
  explicit SignedGraph(int nodes);
  /// Takes the node's column away. O(1) amortised.
  void ground(int node);
  /// sign is +1 or -1. Amortised near-constant time.
  void join(int a, int b, int sign);
  SmithForm form();

private:
  struct Root {
    int node;
    int sign;
  };
  Root find(int node);

  int nodes_; ///< the ground is one further node
  int grounded_ = 0;
  std::vector<int> parent_;
  std::vector<int> sign_; ///< of the path to the parent
  std::vector<char> unbalanced_;
  std::vector<char> is_grounded_;
};

} // namespace tetrarch::algebra
