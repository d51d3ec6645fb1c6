// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/marked.hpp"

#include "sphere.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/moves/marked.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

namespace tetrarch::diagram {
namespace {

/// The vertices that the exterior will have, as far as the diagram shows them: nodes joined by drilled arcs.
/// Crossings are two points each, one for each strand.
class Blobs {
public:
  explicit Blobs(const MarkedDiagram& marked)
      : marked_(marked), parent_(2 * static_cast<std::size_t>(marked.diagram.node_count())) {
    std::iota(parent_.begin(), parent_.end(), 0);
    const Diagram& diagram = marked_.diagram;
    for (int d = 0; d < diagram.dart_count(); ++d)
      if (!marked_.fates[d]) parent_[root(point(d))] = root(point(diagram.opposite(d)));
    // chi of the link: 2 for each point, less 2 for each drilled arc, less what ends there.
    chi_.assign(parent_.size(), 0);
    for (int n = 0; n < diagram.node_count(); ++n)
      for (int strand = 0; strand < (diagram.node(n).crossing ? 2 : 1); ++strand)
        chi_[root(2 * n + strand)] += 2;
    for (int d = 0; d < diagram.dart_count(); ++d) {
      const Fate& fate = marked_.fates[d];
      chi_[root(point(d))] -= !fate ? 1 : *fate == 0 ? 1 : 1 - 1 / *fate;
    }
  }

  /// Whether the dart's end is a cusp, or on the way through a crossing.
  bool is_flat(int dart) {
    constexpr double rounding = 1e-9;
    return std::abs(chi_[root(point(dart))]) < rounding;
  }

private:
  int point(int dart) const {
    const Diagram& diagram = marked_.diagram;
    return 2 * diagram.node_of(dart) + (diagram.at_crossing(dart) ? diagram.place_of(dart) % 2 : 0);
  }
  int root(int p) { return numeric::find_root(parent_, p); }

  const MarkedDiagram& marked_;
  std::vector<int> parent_;
  std::vector<double> chi_;
};

/// Null edges between cusps are drilled. A point on a null edge is a cusp of the same kind. Drilling such an
/// edge leaves a cusp in place of two, so nothing new arises.
MarkedDiagram without_flat_null_edges(MarkedDiagram marked) {
  Blobs blobs(marked);
  const Classes edge = edges(marked);
  std::vector<bool> flat(static_cast<std::size_t>(edge.count), true);
  for (int d = 0; d < marked.diagram.dart_count(); ++d)
    if (!marked.fates[d] || *marked.fates[d] != 0 || !blobs.is_flat(d)) flat[edge.of[d]] = false;
  for (int d = 0; d < marked.diagram.dart_count(); ++d)
    if (flat[edge.of[d]]) marked.fates[d].reset();
  return marked;
}

void require_fates(const MarkedDiagram& marked) {
  const Diagram& diagram = marked.diagram;
  if (static_cast<int>(marked.fates.size()) != diagram.dart_count())
    throw PreconditionError("a marked diagram needs a fate for each dart");
  for (int d = 0; d < diagram.dart_count(); ++d) {
    const Fate& fate = marked.fates[d];
    if (fate && !is_edge_order(*fate)) throw PreconditionError("an order is 0, 1 or above 1");
    if (fate != marked.fates[diagram.opposite(d)] ||
        (diagram.at_crossing(d) && fate != marked.fates[diagram.turned(d, 2)]))
      throw PreconditionError("the fate of an edge changes along it");
  }
}

} // namespace

MarkedDiagram all_drilled(Diagram diagram) {
  std::vector<Fate> fates(static_cast<std::size_t>(diagram.dart_count()));
  return {std::move(diagram), std::move(fates)};
}

bool keeps_edges(const MarkedDiagram& marked) {
  return std::any_of(marked.fates.begin(), marked.fates.end(), [](const Fate& f) { return f.has_value(); });
}

Classes edges(const MarkedDiagram& marked) {
  const Diagram& diagram = marked.diagram;
  std::vector<int> parent(static_cast<std::size_t>(diagram.dart_count()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto join = [&parent](int d, int e) {
    parent[numeric::find_root(parent, d)] = numeric::find_root(parent, e);
  };
  for (int d = 0; d < diagram.dart_count(); ++d) {
    join(d, diagram.opposite(d));
    if (diagram.at_crossing(d)) join(d, diagram.turned(d, 2));
    const int beyond = diagram.turned(d, 1);
    if (diagram.node(diagram.node_of(d)).darts.size() == 2 && marked.fates[d] == marked.fates[beyond])
      join(d, beyond);
  }
  Classes classes;
  std::vector<int> number(parent.size(), -1);
  for (int d = 0; d < diagram.dart_count(); ++d) {
    int& n = number[numeric::find_root(parent, d)];
    if (n < 0) n = classes.count++;
    classes.of.push_back(n);
  }
  return classes;
}

std::vector<Fate> fates_of_edges(const MarkedDiagram& marked) {
  const Classes edge = edges(marked);
  std::vector<Fate> out(static_cast<std::size_t>(edge.count));
  for (int d = 0; d < marked.diagram.dart_count(); ++d) out[edge.of[d]] = marked.fates[d];
  return out;
}

moves::MarkedTriangulation marked_exterior(const MarkedDiagram& marked, const ExteriorOptions& options,
                                           const Progress& progress) {
  if (marked.diagram.dart_count() == 0) throw PreconditionError("the diagram has no arcs");
  require_fates(marked);
  const MarkedDiagram given = without_flat_null_edges(marked);
  if (!keeps_edges(given)) return {exterior(given.diagram, options, progress), {}};
  Diagram whole = connected(given.diagram);
  std::vector<Fate> fates = carried(given.fates, whole);
  const MarkedDiagram drawn = with_kinks_for_crushing({std::move(whole), std::move(fates)});
  const Sphere sphere = sphere_over(drawn.diagram);
  const Skeleton skeleton(sphere.tri);
  Table<EdgeId, bool> drilled(skeleton.edge_count(), false);
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  std::size_t arc = 0;
  for (int d = 0; d < drawn.diagram.dart_count(); ++d) {
    if (drawn.diagram.opposite(d) < d) continue;
    const EdgeId e = skeleton.edge(sphere.arcs[arc++]);
    if (const Fate& fate = drawn.fates[d])
      orders[e] = *fate;
    else
      drilled[e] = true;
  }
  const auto crushed = moves::crushed(sphere.tri, skeleton, orders, drilled);
  const auto* rest = std::get_if<moves::MarkedTriangulation>(&crushed);
  if (rest == nullptr)
    throw PreconditionError("marked_exterior: " +
                            std::string(moves::to_string(std::get<moves::Obstacle>(crushed))));
  const Skeleton rest_skeleton(rest->tri);
  moves::MarkedComplex complex(rest->tri, rest_skeleton, edge_orders(rest_skeleton, rest->marks));
  moves::reduce(complex, progress);
  return complex.compact();
}

moves::MarkedTriangulation marked_exterior(const MarkedDiagram& marked) {
  return marked_exterior(marked, ExteriorOptions());
}

} // namespace tetrarch::diagram
