// SPDX-License-Identifier: GPL-2.0-or-later
#include "sphere.hpp"

#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <array>
#include <numeric>
#include <utility>

namespace tetrarch::diagram {
namespace {

/// 1: the dart's end passes over.
int level(const Diagram& diagram, int dart) {
  return diagram.at_crossing(dart) && diagram.is_over(dart) ? 1 : 0;
}

MarkedDiagram with_kinks_on(const MarkedDiagram& marked, const std::vector<Kink>& kinks) {
  Diagram diagram = with_kinks(marked.diagram, kinks);
  std::vector<Fate> fates = carried(marked.fates, diagram);
  return {std::move(diagram), std::move(fates)};
}

/// A kink for every region whose boundary is drilled and has no corner at a crossing.
MarkedDiagram with_crossing_corners(const MarkedDiagram& marked) {
  const Diagram& diagram = marked.diagram;
  const Classes region = regions(diagram);
  std::vector<bool> good(static_cast<std::size_t>(region.count), false);
  for (int d = 0; d < diagram.dart_count(); ++d)
    if (diagram.at_crossing(d) || marked.fates[d]) good[region.of[d]] = true;
  std::vector<Kink> kinks;
  for (int d = 0; d < diagram.dart_count(); ++d) {
    if (good[region.of[d]]) continue;
    good[region.of[d]] = good[region.of[diagram.opposite(d)]] = true; // a kink has corners on either side
    kinks.push_back({d});
  }
  return with_kinks_on(marked, kinks);
}

/// A kink on every arc that closes a cycle of drilled arcs on one level.
MarkedDiagram with_trees_on_levels(const MarkedDiagram& marked) {
  const Diagram& diagram = marked.diagram;
  std::vector<int> parent(2 * static_cast<std::size_t>(diagram.node_count()));
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<Kink> kinks;
  for (int d = 0; d < diagram.dart_count(); ++d) {
    const int e = diagram.opposite(d);
    if (e < d || marked.fates[d] || level(diagram, d) != level(diagram, e)) continue;
    const auto point = [&](int dart) { return 2 * diagram.node_of(dart) + level(diagram, dart); };
    const int a = numeric::find_root(parent, point(d));
    const int b = numeric::find_root(parent, point(e));
    if (a == b) kinks.push_back({d});
    parent[a] = b;
  }
  return with_kinks_on(marked, kinks);
}

/// The tetrahedra over the triangle of a dart, whose corners are x, y (the ends of the arc, in an order that
/// both its darts share) and the region's center z; level 0 is below level 1.
enum Piece {
  low,    ///< x0 y0 z0 z1
  middle, ///< x0 y0 y1 z1
  high,   ///< x0 x1 y1 z1
  bottom, ///< x0 y0 z0, and the cone point below
  top,    ///< x1 y1 z1, and the cone point above
  pieces
};

class SphereBuilder {
public:
  explicit SphereBuilder(const Diagram& diagram) : diagram_(diagram), tri_(pieces * diagram.dart_count()) {}

  Sphere run() {
    for (int d = 0; d < diagram_.dart_count(); ++d) {
      glue_column(d);
      if (d < diagram_.opposite(d)) glue_wall(d);
      glue_spoke(d);
    }
    // x y z run counterclockwise where x is the dart's own node, and then x0 y0 z0 z1 is right-handed.
    Sphere out{std::move(tri_), {}, {}, starts_at_x(0) ? 1 : -1};
    for (int d = 0; d < diagram_.dart_count(); ++d)
      if (d < diagram_.opposite(d)) out.arcs.push_back(arc(d));
    for (const Node& node : diagram_.nodes())
      if (!node.crossing && node.darts.size() > 2)
        // x0 or y0 of the column over any of its darts.
        out.vertices.push_back({tet(node.darts.front(), low), starts_at_x(node.darts.front()) ? 0 : 1});
    return out;
  }

private:
  int tet(int dart, Piece piece) const { return pieces * dart + piece; }

  /// Whether the dart's own node is x: the end on the lower level.
  bool starts_at_x(int d) const {
    const int e = diagram_.opposite(d);
    const int here = level(diagram_, d);
    const int there = level(diagram_, e);
    return here != there ? here < there : d < e;
  }

  TetEdge arc(int d) const {
    const int x = level(diagram_, starts_at_x(d) ? d : diagram_.opposite(d));
    const int y = level(diagram_, starts_at_x(d) ? diagram_.opposite(d) : d);
    if (y == 0) return {tet(d, low), edge_number[0][1]};
    return x == 0 ? TetEdge{tet(d, middle), edge_number[0][2]} : TetEdge{tet(d, high), edge_number[1][2]};
  }

  void glue_column(int d) {
    const auto over = [&](Piece a, std::array<int, 4> p, int face, Piece b) {
      tri_.glue({tet(d, a), face}, tet(d, b), Perm4(p[0], p[1], p[2], p[3]));
    };
    over(low, {0, 1, 2, 3}, 2, middle);  // x0 y0 z1
    over(middle, {0, 1, 2, 3}, 1, high); // x0 y1 z1
    over(low, {0, 1, 2, 3}, 3, bottom);  // x0 y0 z0
    over(high, {3, 0, 1, 2}, 0, top);    // x1 y1 z1
  }

  /// The wall over the arc, between the columns of its two darts.
  void glue_wall(int d) {
    const int e = diagram_.opposite(d);
    for (const auto& [piece, face] : {std::pair{middle, 3}, {high, 3}, {bottom, 2}, {top, 2}})
      tri_.glue({tet(d, piece), face}, tet(e, piece), Perm4());
  }

  /// A triangle of a column over the way from an end of the arc to the region's center: its tetrahedron and
  /// its vertices, from the node to the center.
  struct Triangle {
    int tet;
    std::array<int, 3> corner;
  };
  std::array<Triangle, 4> spoke(int d, bool at_x) const {
    if (at_x)
      return {{{tet(d, low), {0, 2, 3}},
               {tet(d, high), {0, 1, 3}},
               {tet(d, bottom), {0, 2, 3}},
               {tet(d, top), {0, 2, 3}}}};
    return {{{tet(d, low), {1, 2, 3}},
             {tet(d, middle), {1, 2, 3}},
             {tet(d, bottom), {1, 2, 3}},
             {tet(d, top), {1, 2, 3}}}};
  }

  /// Where the arc of d ends, its column meets that of the next dart round the region.
  void glue_spoke(int d) {
    const int next = diagram_.next_on_left(d);
    const auto here = spoke(d, !starts_at_x(d));
    const auto there = spoke(next, starts_at_x(next));
    for (std::size_t k = 0; k < here.size(); ++k) {
      std::array<int, 4> to{};
      for (std::size_t c = 0; c < 3; ++c) to[here[k].corner[c]] = there[k].corner[c];
      const int face = off(here[k]);
      to[face] = off(there[k]);
      tri_.glue({here[k].tet, face}, there[k].tet, Perm4(to[0], to[1], to[2], to[3]));
    }
  }

  static int off(const Triangle& t) { return 6 - t.corner[0] - t.corner[1] - t.corner[2]; }

  const Diagram& diagram_;
  Triangulation tri_;
};

} // namespace

std::vector<Fate> carried(const std::vector<Fate>& fates, const Diagram& after) {
  std::vector<Fate> out = fates;
  out.resize(static_cast<std::size_t>(after.dart_count()));
  const int before = static_cast<int>(fates.size());
  for (int d = 0; d < before; ++d)
    for (int e = after.opposite(d); e >= before; e = after.opposite(after.turned(e, 2)))
      out[e] = out[after.turned(e, 2)] = fates[d];
  return out;
}

MarkedDiagram with_kinks_for_crushing(const MarkedDiagram& marked) {
  return with_trees_on_levels(with_crossing_corners(marked));
}

Sphere sphere_over(const Diagram& diagram) {
  return SphereBuilder(diagram).run();
}

} // namespace tetrarch::diagram
