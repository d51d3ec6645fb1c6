// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/wirtinger.hpp"

#include <cstdlib>

namespace tetrarch::diagram {
namespace {

/// Of each dart the letter of its strand: positive where the strand leaves the dart's node.
class Strands {
public:
  explicit Strands(const Diagram& diagram)
      : diagram_(diagram), letter_(static_cast<std::size_t>(diagram.dart_count()), 0) {
    for (int d = 0; d < diagram.dart_count(); ++d)
      if (letter_[d] == 0) name(d);
  }
  int count() const { return count_; }
  int letter(int dart) const { return letter_[dart]; }

private:
  /// The dart by which the strand goes on where it has come in by this one; -1: it ends.
  int onward(int dart) const {
    if (diagram_.at_crossing(dart)) return diagram_.is_over(dart) ? diagram_.turned(dart, 2) : -1;
    return diagram_.node(diagram_.node_of(dart)).darts.size() == 2 ? diagram_.turned(dart, 1) : -1;
  }

  void name(int dart) {
    ++count_;
    follow(dart, count_);
    if (const int back = onward(dart); back >= 0 && letter_[back] == 0) follow(back, -count_);
  }

  /// Names the darts from this one on, in the direction in which it leaves its node.
  void follow(int dart, int letter) {
    while (dart >= 0 && letter_[dart] == 0) {
      letter_[dart] = letter;
      letter_[diagram_.opposite(dart)] = -letter;
      dart = onward(diagram_.opposite(dart));
    }
  }

  const Diagram& diagram_;
  std::vector<int> letter_;
  int count_ = 0;
};

} // namespace

Wirtinger wirtinger(const Diagram& diagram) {
  const Strands strands(diagram);
  Wirtinger out;
  out.group.generators = strands.count();
  for (const Node& node : diagram.nodes()) {
    if (!node.crossing && node.darts.size() == 2) continue;
    algebra::Word relator;
    for (const int d : node.darts) relator.push_back(strands.letter(d));
    out.group.relators.push_back(std::move(relator));
  }
  const Classes edge = edges(diagram);
  out.meridians.assign(static_cast<std::size_t>(edge.count), -1);
  for (int d = diagram.dart_count() - 1; d >= 0; --d)
    out.meridians[edge.of[d]] = std::abs(strands.letter(d)) - 1;
  return out;
}

} // namespace tetrarch::diagram
