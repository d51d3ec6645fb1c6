// SPDX-License-Identifier: GPL-2.0-or-later
#include "removal.hpp"
#include "reroute.hpp"

#include "tetrarch/diagram/moves.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace tetrarch::diagram {
namespace {

/// A circle that passes over (or under) all that it crosses lies apart.
std::optional<Diagram> with_circle_apart(const Diagram& diagram) {
  for (int d = 0; d < diagram.dart_count(); ++d) {
    if (!diagram.at_crossing(d)) continue;
    std::vector<int> crossings;
    int at = d;
    do {
      crossings.push_back(diagram.node_of(at));
      at = diagram.turned(diagram.opposite(at), 2);
    } while (at != d && diagram.at_crossing(at) && diagram.is_over(at) == diagram.is_over(d));
    if (at == d) return Removal(diagram, crossings).run();
  }
  return std::nullopt;
}

} // namespace

Diagram without_points(const Diagram& diagram) {
  std::vector<int> points;
  for (int n = 0; n < diagram.node_count(); ++n)
    if (!diagram.node(n).crossing && diagram.node(n).darts.size() == 2) points.push_back(n);
  return Removal(diagram, points).run();
}

Diagram simplified(const Diagram& diagram, const Progress& progress) {
  Diagram best = without_points(diagram);
  for (bool again = true; again;) {
    again = false;
    progress.step("crossings removed", -1);
    for (int d = 0; d < best.dart_count() && !again; ++d) {
      again = true;
      if (is_kink(best, d))
        best = without_kink(best, d);
      else if (is_poke(best, d))
        best = without_poke(best, d);
      else if (is_twist(best, d))
        best = without_twist(best, d);
      else
        again = false;
    }
    if (again) continue;
    std::optional<Diagram> shorter = with_circle_apart(best);
    if (!shorter) shorter = with_shorter_strand(best, progress);
    if (!shorter) break;
    best = std::move(*shorter);
    again = true;
  }
  return best;
}

} // namespace tetrarch::diagram
