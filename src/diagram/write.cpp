// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/write.hpp"

#include <algorithm>

namespace tetrarch::diagram {
namespace {

class CodeWriter {
public:
  explicit CodeWriter(const Diagram& diagram)
      : diagram_(diagram), label_(static_cast<std::size_t>(diagram.dart_count()), 0),
        incoming_(static_cast<std::size_t>(diagram.dart_count()), false) {
    // Edges with ends first: a walk along a circle may begin anywhere.
    for (int d = 0; d < diagram.dart_count(); ++d)
      if (label_[d] == 0 && is_end(d)) walk(d);
    for (int d = 0; d < diagram.dart_count(); ++d)
      if (label_[d] == 0 && diagram.at_crossing(d)) walk(d);
    for (int d = 0; d < diagram.dart_count(); ++d)
      if (label_[d] == 0) walk(d);
  }

  std::string text() const {
    std::string out = "PD[";
    for (const Node& node : diagram_.nodes()) out += item(node);
    for (const int circle : circles_) out += "Loop[" + std::to_string(circle) + "], ";
    out.resize(std::max<std::size_t>(3, out.size() - 2));
    return out + "]";
  }

private:
  bool is_point(int dart) const {
    return !diagram_.at_crossing(dart) && diagram_.node(diagram_.node_of(dart)).darts.size() == 2;
  }
  bool is_end(int dart) const { return !diagram_.at_crossing(dart) && !is_point(dart); }

  /// Numbers the arcs of an edge, from the dart that it leaves a node by.
  void walk(int dart) {
    bool is_circle = true;
    int label = 0;
    for (int d = dart; d >= 0 && label_[d] == 0;) {
      if (label == 0 || !is_point(d)) label = ++count_;
      const int end = diagram_.opposite(d);
      label_[d] = label_[end] = label;
      incoming_[end] = true;
      is_circle &= is_point(d) && is_point(end);
      d = is_end(end) ? -1 : diagram_.turned(end, is_point(end) ? 1 : 2);
    }
    if (is_circle) circles_.push_back(label);
  }

  std::string item(const Node& node) const {
    if (!node.crossing && node.darts.size() == 2) return {};
    std::size_t first = 0;
    if (node.crossing) {
      first = node.over == 0 ? 1 : 0;
      if (!incoming_[node.darts[first]]) first += 2;
    }
    std::string text = node.crossing ? "X[" : "V[";
    for (std::size_t k = 0; k < node.darts.size(); ++k)
      text += (k == 0 ? "" : ", ") + std::to_string(label_[node.darts[(first + k) % node.darts.size()]]);
    return text + "], ";
  }

  const Diagram& diagram_;
  std::vector<int> label_;
  std::vector<bool> incoming_;
  std::vector<int> circles_;
  int count_ = 0;
};

} // namespace

std::string planar_diagram_code(const Diagram& diagram) {
  return CodeWriter(diagram).text();
}

} // namespace tetrarch::diagram
