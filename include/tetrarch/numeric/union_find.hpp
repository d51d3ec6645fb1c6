// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Classes that only merge: a forest of parents, where a root stands for its class.
///
/// `parent[find_root(parent, a)] = find_root(parent, b)` merges two classes; which root survives is the
/// caller's choice.

#include <vector>

namespace tetrarch::numeric {

/// The root of x's class. Halves the path on the way, which makes a sequence of finds near-linear.
inline int find_root(std::vector<int>& parent, int x) {
  while (parent[x] != x) x = parent[x] = parent[parent[x]];
  return x;
}

} // namespace tetrarch::numeric
