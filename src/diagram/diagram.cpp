// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/diagram.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <numeric>

namespace tetrarch::diagram {
namespace {

using Places = std::vector<std::pair<int, int>>;

/// Where each dart stands; node -1: nowhere.
Places places_of(const std::vector<Node>& nodes, std::size_t darts) {
  Places places(darts, {-1, 0});
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < nodes[n].darts.size(); ++k)
      places[nodes[n].darts[k]] = {static_cast<int>(n), static_cast<int>(k)};
  return places;
}

std::vector<int> singletons(int count) {
  std::vector<int> parent(static_cast<std::size_t>(count));
  std::iota(parent.begin(), parent.end(), 0);
  return parent;
}

void merge(std::vector<int>& parent, int a, int b) {
  parent[numeric::find_root(parent, a)] = numeric::find_root(parent, b);
}

/// The classes of a union-find forest, numbered by their first members.
Classes numbered(std::vector<int>& parent) {
  Classes classes;
  std::vector<int> number(parent.size(), -1);
  for (int d = 0; d < static_cast<int>(parent.size()); ++d) {
    int& n = number[numeric::find_root(parent, d)];
    if (n < 0) n = classes.count++;
    classes.of.push_back(n);
  }
  return classes;
}

/// What is wrong with the places of the darts, each by itself.
std::string wrong_places(const std::vector<Node>& nodes, const std::vector<int>& opposite) {
  const int darts = static_cast<int>(opposite.size());
  std::vector<int> seen(opposite.size(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Node& node = nodes[n];
    const std::string name = "node " + std::to_string(n);
    if (node.darts.empty()) return name + " has no arcs (expected one or more)";
    if (node.crossing && node.darts.size() != 4)
      return name + " is a crossing of " + std::to_string(node.darts.size()) + " arcs (expected 4)";
    if (node.crossing && node.over != 0 && node.over != 1) return name + " does not say what passes over";
    for (const int d : node.darts) {
      if (d < 0 || d >= darts) return name + " has a dart that there is none of";
      if (seen[d]++ > 0) return "dart " + std::to_string(d) + " stands in two places";
    }
  }
  for (int d = 0; d < darts; ++d) {
    if (seen[d] == 0) return "dart " + std::to_string(d) + " stands nowhere";
    const int o = opposite[d];
    if (o < 0 || o >= darts || o == d || opposite[o] != d)
      return "dart " + std::to_string(d) + " has no other half";
  }
  return {};
}

int orbits_on_left(const std::vector<Node>& nodes, const std::vector<int>& opposite, const Places& places) {
  int count = 0;
  std::vector<bool> seen(opposite.size(), false);
  for (std::size_t first = 0; first < opposite.size(); ++first) {
    if (seen[first]) continue;
    ++count;
    for (int d = static_cast<int>(first); !seen[d];) {
      seen[d] = true;
      const auto [n, k] = places[opposite[d]];
      const auto& round = nodes[n].darts;
      d = round[(static_cast<std::size_t>(k) + round.size() - 1) % round.size()];
    }
  }
  return count;
}

} // namespace

std::string why_not(const std::vector<Node>& nodes, const std::vector<int>& opposite) {
  if (std::string wrong = wrong_places(nodes, opposite); !wrong.empty()) return wrong;
  const Places places = places_of(nodes, opposite.size());
  std::vector<int> parent = singletons(static_cast<int>(nodes.size()));
  for (std::size_t d = 0; d < opposite.size(); ++d) merge(parent, places[d].first, places[opposite[d]].first);
  const int regions = orbits_on_left(nodes, opposite, places);
  const int euler = static_cast<int>(nodes.size()) - static_cast<int>(opposite.size() / 2) + regions;
  const int genus = (2 * numbered(parent).count - euler) / 2;
  if (genus == 0) return {};
  return "the order of the arcs round the nodes is that of a surface of genus " + std::to_string(genus) +
         " (expected the plane)";
}

Diagram::Diagram(std::vector<Node> nodes, std::vector<int> opposite)
    : nodes_(std::move(nodes)), opposite_(std::move(opposite)) {
  if (const std::string wrong = why_not(nodes_, opposite_); !wrong.empty())
    throw PreconditionError("no diagram: " + wrong);
  place_ = places_of(nodes_, opposite_.size());
}

int Diagram::turned(int dart, int steps) const {
  const auto [n, k] = place_[dart];
  const auto& round = nodes_[n].darts;
  const int valence = static_cast<int>(round.size());
  return round[((k + steps) % valence + valence) % valence];
}

Classes regions(const Diagram& diagram) {
  Classes classes;
  classes.of.assign(static_cast<std::size_t>(diagram.dart_count()), -1);
  for (int first = 0; first < diagram.dart_count(); ++first) {
    if (classes.of[first] >= 0) continue;
    for (int d = first; classes.of[d] < 0; d = diagram.next_on_left(d)) classes.of[d] = classes.count;
    ++classes.count;
  }
  return classes;
}

Classes parts(const Diagram& diagram) {
  std::vector<int> parent = singletons(diagram.dart_count());
  for (int d = 0; d < diagram.dart_count(); ++d) {
    merge(parent, d, diagram.opposite(d));
    merge(parent, d, diagram.turned(d, 1));
  }
  return numbered(parent);
}

Classes edges(const Diagram& diagram) {
  std::vector<int> parent = singletons(diagram.dart_count());
  for (int d = 0; d < diagram.dart_count(); ++d) {
    merge(parent, d, diagram.opposite(d));
    if (diagram.at_crossing(d)) merge(parent, d, diagram.turned(d, 2));
    if (diagram.node(diagram.node_of(d)).darts.size() == 2) merge(parent, d, diagram.turned(d, 1));
  }
  return numbered(parent);
}

Classes components(const Diagram& diagram) {
  std::vector<int> parent = singletons(diagram.dart_count());
  for (int d = 0; d < diagram.dart_count(); ++d) {
    merge(parent, d, diagram.opposite(d));
    merge(parent, d, diagram.turned(d, diagram.at_crossing(d) ? 2 : 1));
  }
  return numbered(parent);
}

int crossing_count(const Diagram& diagram) {
  return static_cast<int>(std::count_if(diagram.nodes().begin(), diagram.nodes().end(),
                                        [](const Node& n) { return n.crossing; }));
}

int vertex_count(const Diagram& diagram) {
  return static_cast<int>(std::count_if(diagram.nodes().begin(), diagram.nodes().end(),
                                        [](const Node& n) { return !n.crossing && n.darts.size() != 2; }));
}

Diagram mirrored(const Diagram& diagram) {
  std::vector<Node> nodes = diagram.nodes();
  for (Node& n : nodes)
    if (n.crossing) n.over = 1 - n.over;
  return {std::move(nodes), diagram.opposites()};
}

Diagram circle() {
  return {{Node{{0, 1}, false, 0}}, {1, 0}};
}

} // namespace tetrarch::diagram
