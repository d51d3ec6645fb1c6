// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A diagram while it is being changed.

#include "tetrarch/diagram/diagram.hpp"

#include <array>
#include <utility>
#include <vector>

namespace tetrarch::diagram {

struct Draft {
  std::vector<Node> nodes;
  std::vector<int> opposite;

  Draft() = default;
  explicit Draft(const Diagram& diagram) : nodes(diagram.nodes()), opposite(diagram.opposites()) {}

  /// Makes one arc of two half arcs.
  void join(int a, int b) {
    opposite[a] = b;
    opposite[b] = a;
  }

  /// Adds a node with so many darts, not yet joined; returns the first, the others follow counterclockwise.
  int add_node(int valence, bool crossing, int over) {
    const int first = static_cast<int>(opposite.size());
    Node node{{}, crossing, over};
    for (int k = 0; k < valence; ++k) {
      node.darts.push_back(first + k);
      opposite.push_back(-1);
    }
    nodes.push_back(std::move(node));
    return first;
  }

  Diagram finished() && { return {std::move(nodes), std::move(opposite)}; }
};

} // namespace tetrarch::diagram
