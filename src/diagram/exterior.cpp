// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/exterior.hpp"

#include "sphere.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/marked.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/moves/drill.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <variant>

namespace tetrarch::diagram {
namespace {

Table<EdgeId, bool> edges_of(const Skeleton& skeleton, const std::vector<TetEdge>& arcs) {
  Table<EdgeId, bool> edges(skeleton.edge_count(), false);
  for (const TetEdge e : arcs) edges[skeleton.edge(e)] = true;
  return edges;
}

/// The exterior of these edges, simplified.
Triangulation drilled(const Triangulation& tri, const std::vector<TetEdge>& arcs,
                      const ExteriorOptions& options, const Progress& progress) {
  const Skeleton skeleton(tri);
  const moves::Drilling drilling = moves::drill(tri, skeleton, edges_of(skeleton, arcs));
  moves::TruncateOptions how;
  how.simplify.seed = options.seed;
  return moves::truncate(drilling.tri, how, progress).tri;
}

/// How many moves lead to a triangulation of so many tetrahedra and the fewest vertices. The rest only wander
/// among such, which may wind the words round the manifold without end.
std::size_t moves_needed(const Triangulation& from, const moves::MoveLog& log, int tets) {
  moves::Complex complex(from);
  std::size_t needed = log.size();
  int fewest = complex.vertex_count() + 1;
  for (std::size_t k = 0; k < log.size(); ++k) {
    if (moves::apply(complex, log[k])) throw PreconditionError("pair_exterior: a move of the log is illegal");
    if (complex.size() > tets || complex.vertex_count() >= fewest) continue;
    fewest = complex.vertex_count();
    needed = k + 1;
  }
  return needed;
}

} // namespace

Sphere sphere_with(const Diagram& diagram) {
  if (diagram.dart_count() == 0) throw PreconditionError("the diagram has no arcs");
  return sphere_over(with_kinks_for_crushing(all_drilled(connected(diagram))).diagram);
}

Triangulation doubled_exterior(const Diagram& diagram, const ExteriorOptions& options,
                               const Progress& progress) {
  const Sphere sphere = sphere_with(diagram);
  if (sphere.vertices.empty()) throw PreconditionError("the graph has no vertex of valence 3 or more");
  const Skeleton skeleton(sphere.tri);
  Table<VertexId, bool> vertices(skeleton.vertex_count(), false);
  for (const TetVertex v : sphere.vertices) vertices[skeleton.vertex(v)] = true;
  const moves::Punctured half =
      moves::punctured(sphere.tri, skeleton, vertices, edges_of(skeleton, sphere.arcs));
  std::vector<TetEdge> arcs = half.edges;
  for (const TetEdge e : half.edges) arcs.push_back({e.tet + half.tri.size(), e.edge});
  return drilled(moves::doubled(half.tri), arcs, options, progress);
}

Triangulation exterior(const Diagram& diagram, const ExteriorOptions& options, const Progress& progress) {
  const Sphere sphere = sphere_with(diagram);
  return drilled(sphere.tri, sphere.arcs, options, progress);
}

std::optional<PairExterior> pair_exterior(const Diagram& diagram, const ExteriorOptions& options,
                                          const Progress& progress) {
  const Sphere sphere = sphere_with(diagram);
  const Skeleton skeleton(sphere.tri);
  const Table<EdgeId, bool> edges = edges_of(skeleton, sphere.arcs);
  std::vector<int> hands = orientation(sphere.tri).value();
  for (int& hand : hands) hand *= sphere.hand;
  auto crushed = moves::crushed_with_monodromy(sphere.tri, skeleton, edges,
                                               moves::graph_letters(skeleton, edges), hands);
  auto* drilled = std::get_if<moves::Crushed>(&crushed);
  if (drilled == nullptr) return std::nullopt;
  moves::MoveLog log;
  moves::TruncateOptions how;
  how.simplify.seed = options.seed;
  how.simplify.log = &log;
  const Triangulation tri = moves::truncate(drilled->tri, how, progress).tri;
  log.resize(moves_needed(drilled->tri, log, tri.size()));
  moves::Complex complex(drilled->tri);
  constexpr std::size_t between = 50; // moves after which words are made short again
  constexpr long long most_letters = 1'000'000;
  for (std::size_t k = 0; k < log.size(); ++k) {
    progress.step("meridians carried", static_cast<double>(k) / static_cast<double>(log.size()));
    if (!moves::carry(complex, drilled->monodromy, log[k])) return std::nullopt;
    if (k % between != 0) continue;
    moves::shorten(complex, drilled->monodromy);
    if (drilled->monodromy.letter_count() > most_letters) return std::nullopt;
  }
  moves::shorten(complex, drilled->monodromy);
  const moves::Complex::Compact end = complex.compact();
  return PairExterior{end.tri, moves::compacted(drilled->monodromy, end)};
}

} // namespace tetrarch::diagram
