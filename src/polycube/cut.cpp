// SPDX-License-Identifier: GPL-2.0-or-later
#include "cut.hpp"

#include <algorithm>

namespace tetrarch::polycube {
namespace {

/// Less than this is rounding of sums of costs of about 1.
constexpr double no_flow = 1e-12;

} // namespace

void Cut::join(int from, int to, double capacity) {
  arcs_.push_back({to, first_[from], capacity});
  first_[from] = static_cast<int>(arcs_.size()) - 1;
  arcs_.push_back({from, first_[to], 0});
  first_[to] = static_cast<int>(arcs_.size()) - 1;
}

/// How far nodes are from the sink; whether the source reaches it.
bool Cut::find_layers() {
  const int source = static_cast<int>(cost_.size());
  const int sink = source + 1;
  layer_.assign(first_.size(), -1);
  layer_[sink] = 0;
  std::vector<int> queue{sink};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (int a = first_[queue[k]]; a >= 0; a = arcs_[a].next) {
      const int from = arcs_[a].to;
      if (layer_[from] >= 0 || !(arcs_[a ^ 1].left > no_flow)) continue;
      layer_[from] = layer_[queue[k]] + 1;
      queue.push_back(from);
    }
  return layer_[source] >= 0;
}

/// Flow along one path through the layers; 0 where there is none.
double Cut::push() {
  const int source = static_cast<int>(cost_.size());
  const int sink = source + 1;
  std::vector<int> path; // arcs
  int node = source;
  while (node != sink) {
    int& a = at_[node];
    while (a >= 0 && !(arcs_[a].left > no_flow && layer_[arcs_[a].to] == layer_[node] - 1)) a = arcs_[a].next;
    if (a >= 0) {
      path.push_back(a);
      node = arcs_[a].to;
      continue;
    }
    if (path.empty()) return 0;
    // A dead end: its predecessor tries the next arc.
    node = arcs_[path.back() ^ 1].to;
    at_[node] = arcs_[path.back()].next;
    path.pop_back();
  }
  double flow = arcs_[path.front()].left;
  for (const int a : path) flow = std::min(flow, arcs_[a].left);
  for (const int a : path) {
    arcs_[a].left -= flow;
    arcs_[a ^ 1].left += flow;
  }
  return flow;
}

std::vector<char> Cut::solve() {
  const int source = static_cast<int>(cost_.size());
  const int sink = source + 1;
  for (int node = 0; node < source; ++node) {
    if (cost_[node] > 0) join(source, node, cost_[node]);
    if (cost_[node] < 0) join(node, sink, -cost_[node]);
  }
  while (find_layers()) {
    at_ = first_;
    while (push() > 0) {
    }
  }
  // What still reaches the sink is of kind 1.
  std::vector<char> kind(cost_.size());
  for (int node = 0; node < source; ++node) kind[node] = layer_[node] >= 0 ? 1 : 0;
  return kind;
}

} // namespace tetrarch::polycube
