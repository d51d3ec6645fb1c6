// SPDX-License-Identifier: GPL-2.0-or-later
#include "orbifold_rows.hpp"

#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::workshop {
namespace {

using hyperbolic::OrbifoldOutcome;
using hyperbolic::Outcome;

/// The homotopy takes (2 n)^3 operations a step: beyond, a try takes minutes.
constexpr int most_tets = 150;
/// Of the 40 tries that small ones get, so many are left to large ones: seconds in all.
int tries_for(int tets) {
  return std::clamp(30'000 / (tets * tets + 1), 2, 40);
}

Outcome outcome_of(OrbifoldOutcome outcome) {
  switch (outcome) {
  case OrbifoldOutcome::geometric:
    return Outcome::geometric;
  case OrbifoldOutcome::turned_over:
    return Outcome::degenerate;
  case OrbifoldOutcome::low_valence:
    return Outcome::low_valence;
  case OrbifoldOutcome::boundary_faces:
    return Outcome::boundary_faces;
  case OrbifoldOutcome::bad_vertex:
  case OrbifoldOutcome::invalid:
    return Outcome::invalid;
  case OrbifoldOutcome::null_edge:
  case OrbifoldOutcome::not_found:
    break;
  }
  return Outcome::budget_exhausted;
}

/// The orders of the marked ends at a vertex: "3, 3, null".
std::string orders_at(const hyperbolic::OrbifoldStructure& s, const Skeleton& skeleton, VertexId v) {
  std::vector<double> orders;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (s.orders[e] == 1) continue;
    const auto [a, b] = skeleton.ends(e);
    for (const VertexId end : {a, b})
      if (end == v) orders.push_back(s.orders[e]);
  }
  std::sort(orders.begin(), orders.end());
  std::vector<std::string> words;
  words.reserve(orders.size());
  for (const double order : orders) words.push_back(order == 0 ? "null" : rounded(order));
  return joined(words, ", ");
}

} // namespace

hyperbolic::OrbifoldSearch find_marked(const Triangulation& tri, const StructureOptions& options,
                                       const Progress& progress) {
  hyperbolic::OrbifoldSearchOptions how;
  how.seed = options.seed;
  how.attempts = options.as_given                                  ? 1
                 : options.attempts == StructureOptions{}.attempts ? tries_for(tri.size())
                                                                   : options.attempts;
  return find_orbifold(tri, options.marks, how, progress);
}

bool is_worth_trying(const Triangulation& tri) {
  return tri.size() <= most_tets;
}

hyperbolic::Search as_search(const hyperbolic::OrbifoldSearch& found) {
  hyperbolic::Search search;
  search.triangulation = found.triangulation;
  search.changed = found.changed;
  search.attempts = found.attempts;
  const hyperbolic::OrbifoldStructure& s = found.structure;
  search.structure.outcome = outcome_of(s.outcome);
  search.structure.lengths = s.lengths;
  search.structure.dihedral_angles = s.dihedral_angles;
  search.structure.volume = s.volume;
  search.structure.volume_error = s.volume_error;
  search.structure.residual = s.residual;
  search.structure.last_step = s.last_step;
  search.structure.iterations = s.iterations;
  search.structure.edge = s.edge;
  search.structure.vertex = s.vertex;
  return search;
}

void add_orbifold(const hyperbolic::OrbifoldSearch& found, const Skeleton& skeleton, Rows& rows) {
  const hyperbolic::OrbifoldStructure& s = found.structure;
  if (!s.solved()) return;
  rows.emplace_back("solved by", s.method == hyperbolic::OrbifoldMethod::newton
                                     ? "Newton's method from lengths 1"
                                     : "the homotopy from smaller cone angles");
  if (s.outcome == OrbifoldOutcome::turned_over)
    rows.emplace_back("tetrahedra",
                      std::to_string(static_cast<int>(s.orientation.size()) - s.negative() - s.flat()) +
                          " positive, " + std::to_string(s.negative()) + " turned over, " +
                          std::to_string(s.flat()) + " flat: no proof of a structure");
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const std::string orders = orders_at(s, skeleton, v);
    rows.emplace_back("vertex " + std::to_string(v.value), std::string(to_string(s.types[v])) + ", link " +
                                                               skeleton.link(v).str() +
                                                               (orders.empty() ? "" : ", orders " + orders));
  }
}

Tree vertices_tree(const hyperbolic::OrbifoldSearch& found, const Skeleton& skeleton) {
  Tree list = Tree::array();
  const hyperbolic::OrbifoldStructure& s = found.structure;
  if (s.types.size() == 0) return list;
  const auto euler = hyperbolic::orbifold_euler(skeleton, s.orders);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    list.push_back({{"vertex", v.value},
                    {"type", to_string(s.types[v])},
                    {"link", skeleton.link(v).str()},
                    {"euler", euler[v]}});
  return list;
}

Tree marks_tree(const Marks& marks) {
  Tree list = Tree::array();
  for (const EdgeMark& mark : marks) {
    const auto [i, j] = edge_vertex[mark.edge.edge];
    list.push_back(Tree{mark.edge.tet, std::to_string(i) + std::to_string(j), mark.order});
  }
  return list;
}

Type marks_type() {
  return type::list(type::tuple({type::integer, type::text, type::integer}));
}

} // namespace tetrarch::workshop
