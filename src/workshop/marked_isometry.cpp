// SPDX-License-Identifier: GPL-2.0-or-later
#include "marked_isometry.hpp"

#include "tetrarch/algebra/covers.hpp"
#include "tetrarch/algebra/group.hpp"
#include "tetrarch/canonical/marked_canonize.hpp"
#include "tetrarch/core/marked_isomorphism.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/moves/drill.hpp"
#include "tetrarch/moves/marked.hpp"
#include "tetrarch/moves/truncate.hpp"
#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tetrarch::workshop {
namespace {

using canonical::IsometryAnswer;
using moves::MarkedTriangulation;
using IsometryProof = IsometryAnswer::Proof;
using Says = IsometryAnswer::Verdict;

std::string mark_order_text(double order) {
  return order == 0 ? "null" : format::to_text(order);
}

/// What a homeomorphism of marked manifolds leaves alone: the orders of the graph's edges, and at each of its
/// vertices. A point where two ends of equal order meet, and nothing else, lies on an edge and is no vertex.
struct GraphOrders {
  std::vector<std::string> edges;    ///< sorted
  std::vector<std::string> vertices; ///< sorted: the link, then the orders
};

GraphOrders graph_orders(const MarkedTriangulation& marked) {
  const Skeleton skeleton(marked.tri);
  const EdgeOrders orders = edge_orders(skeleton, marked.marks);
  Table<VertexId, std::vector<EdgeId>> at(skeleton.vertex_count());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (orders[e] != 1) {
      at[skeleton.ends(e).first].push_back(e);
      at[skeleton.ends(e).second].push_back(e);
    }
  GraphOrders out;
  std::vector<int> parent(static_cast<std::size_t>(skeleton.edge_count()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const std::vector<EdgeId>& ends = at[v];
    if (skeleton.link(v).is_sphere() && ends.size() == 2 && orders[ends[0]] == orders[ends[1]]) {
      parent[numeric::find_root(parent, ends[0].value)] = numeric::find_root(parent, ends[1].value);
      continue;
    }
    if (ends.empty()) continue;
    std::vector<std::string> words;
    words.reserve(ends.size());
    for (const EdgeId e : ends) words.push_back(mark_order_text(orders[e]));
    std::sort(words.begin(), words.end());
    out.vertices.push_back(skeleton.link(v).str() + " with " + joined(words, ", "));
  }
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (orders[e] != 1 && parent[e.value] == e.value) out.edges.push_back(mark_order_text(orders[e]));
  std::sort(out.edges.begin(), out.edges.end());
  std::sort(out.vertices.begin(), out.vertices.end());
  return out;
}

/// The group of the orbifold: going n times round an edge of order n is trivial. Where n is 0 or no whole
/// number, nothing follows: the group is still one that a homeomorphism of marked manifolds leaves alone.
algebra::Presentation orbifold_group(const MarkedTriangulation& marked, const Progress& progress) {
  const Skeleton skeleton(marked.tri);
  const EdgeOrders orders = edge_orders(skeleton, marked.marks);
  const algebra::DualPresentation dual = algebra::dual_presentation(marked.tri, skeleton);
  algebra::Presentation group = dual.presentation;
  group.relators.clear();
  constexpr double most = 1000; // times round
  for (std::size_t r = 0; r < dual.relator_edge.size(); ++r) {
    const double order = orders[dual.relator_edge[r]];
    if (order < 1 || order > most || order != std::floor(order)) continue;
    algebra::Word word;
    for (int k = 0; k < static_cast<int>(order); ++k)
      word.insert(word.end(), dual.presentation.relators[r].begin(), dual.presentation.relators[r].end());
    group.relators.push_back(std::move(word));
  }
  return algebra::simplified(group, {}, progress);
}

IsometryAnswer marks_differ(IsometryProof proof, std::string reason) {
  return {Says::not_isometric, proof, std::move(reason), {}};
}

std::optional<IsometryAnswer> differ_in_orders(const MarkedTriangulation& x, const MarkedTriangulation& y) {
  const GraphOrders a = graph_orders(x);
  const GraphOrders b = graph_orders(y);
  const auto listed = [](const std::vector<std::string>& words) {
    return words.empty() ? std::string("none") : joined(words, ", ");
  };
  if (a.edges != b.edges)
    return marks_differ(IsometryProof::marks,
                        "the orders of the edges differ: " + listed(a.edges) + " against " + listed(b.edges));
  if (a.vertices == b.vertices) return std::nullopt;
  return marks_differ(IsometryProof::marks, "the orders at the vertices differ: " + joined(a.vertices, "; ") +
                                                " against " + joined(b.vertices, "; "));
}

std::optional<IsometryAnswer> differ_in_group(const algebra::Presentation& x, const algebra::Presentation& y,
                                              const Progress& progress) {
  const auto h_x = algebra::abelianized(x);
  const auto h_y = algebra::abelianized(y);
  if (!(h_x == h_y))
    return marks_differ(IsometryProof::homology, "the first homology of the orbifolds' groups differs: " +
                                                     h_x.str() + " against " + h_y.str());
  constexpr int most_sheets = 6;
  constexpr long long most_steps = 50'000;
  const algebra::CoverDifference found =
      algebra::difference_of_covers(x, y, most_sheets, most_steps, progress);
  if (found.what.empty()) return std::nullopt;
  return marks_differ(IsometryProof::covers, "of the orbifolds' groups " + found.what);
}

MarkedTriangulation reduced_marked(const Compared& x, const Progress& progress) {
  const Skeleton skeleton(x.tri);
  moves::MarkedComplex complex(x.tri, skeleton, edge_orders(skeleton, x.marks));
  moves::reduce(complex, progress);
  return complex.compact();
}

/// A yes, if the two are isomorphic, marks included.
bool agree(const MarkedTriangulation& x, const MarkedTriangulation& y, const char* between, Isometry& found) {
  auto isometry = find_marked_isomorphism({x.tri, x.marks}, {y.tri, y.marks});
  if (!isometry) return false;
  found.answer = {Says::isometric, IsometryProof::isomorphism,
                  "the " + std::string(between) + " are isomorphic, marks included", *std::move(isometry)};
  found.between = between;
  found.from = marked_signature({x.tri, x.marks});
  return true;
}

/// Wanders from both by moves that keep marks, and looks for a triangulation that was met from either side.
bool meet(const MarkedTriangulation& x, const MarkedTriangulation& y, std::uint64_t seed, Isometry& found,
          const Progress& progress) {
  constexpr int most_extra = 3;
  constexpr int small =
      20; // tetrahedra; of more, a walk takes a time that grows with the square of their number
  const int largest = std::max({small, x.tri.size(), y.tri.size()});
  const int walks = 10 + 150 * small * small / (largest * largest);
  std::array<std::map<std::string, MarkedTriangulation>, 2> met;
  SplitMix64 random(seed);
  for (int k = 0; k < walks; ++k)
    for (int side = 0; side < 2; ++side) {
      progress.step("looking for a common triangulation", static_cast<double>(k) / walks);
      const MarkedTriangulation& from = side == 0 ? x : y;
      const Skeleton skeleton(from.tri);
      moves::MarkedComplex trial(from.tri, skeleton, edge_orders(skeleton, from.marks));
      moves::shake(trial, k == 0 ? 0 : 1 + random.below(4 + k / 10), random);
      moves::reduce(trial, progress.silent());
      MarkedTriangulation here = trial.compact();
      if (here.tri.size() > from.tri.size() + most_extra) continue;
      const std::string text = marked_signature({here.tri, here.marks});
      const auto other = met[1 - side].find(text);
      if (other != met[1 - side].end())
        return agree(side == 0 ? here : other->second, side == 0 ? other->second : here,
                     "triangulations made from those given", found);
      met[side].emplace(text, std::move(here));
    }
  return false;
}

/// The exterior of the marked edges, all drilled.
Triangulation exterior_of_marks(const MarkedTriangulation& marked, const Progress& progress) {
  const Skeleton skeleton(marked.tri);
  const EdgeOrders orders = edge_orders(skeleton, marked.marks);
  Table<EdgeId, bool> drilled(skeleton.edge_count(), false);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) drilled[e] = orders[e] != 1;
  return moves::truncate(moves::drill(marked.tri, skeleton, drilled).tri, {}, progress).tri;
}

std::optional<IsometryAnswer> differ_in_exteriors(const MarkedTriangulation& x, const std::string& name_x,
                                                  const MarkedTriangulation& y, const std::string& name_y,
                                                  const CanonicalOptions& options, const Progress& progress) {
  const Triangulation exterior_x = exterior_of_marks(x, progress);
  const Triangulation exterior_y = exterior_of_marks(y, progress);
  CanonicalOptions how = options;
  how.marks.clear();
  constexpr int most_attempts = 20;
  how.attempts = std::min(how.attempts, most_attempts);
  const Isometry found = isometry({exterior_x, name_x}, {exterior_y, name_y}, how, progress);
  if (found.answer.verdict != Says::not_isometric) return std::nullopt;
  return marks_differ(found.answer.proof,
                      "the exteriors of the marked edges are not homeomorphic: " + found.answer.reason);
}

canonical::MarkedCanonical colored_cells(const MarkedTriangulation& marked, const CanonicalOptions& options,
                                         const Progress& progress) {
  canonical::MarkedCanonizeOptions how;
  how.seed = options.seed;
  how.attempts = std::min(how.attempts, options.attempts);
  return canonical::canonize_marked(marked.tri, marked.marks, how, progress);
}

/// By colored cells: a yes, or what is left to say.
bool agree_in_cells(const MarkedTriangulation& x, const MarkedTriangulation& y,
                    const CanonicalOptions& options, Isometry& found, const Progress& progress) {
  const canonical::MarkedCanonical a = colored_cells(x, options, progress);
  const canonical::MarkedCanonical b = colored_cells(y, options, progress);
  for (const auto& [cells, name] : {std::pair{&a, &found.x}, std::pair{&b, &found.y}})
    if (!cells->why_not.empty()) {
      found.answer.reason = *name + " with parabolic meridians: " + cells->why_not;
      return false;
    }
  const canonical::Canonical& p = a.canonical;
  const canonical::Canonical& q = b.canonical;
  if (agree({p.canonical_triangulation, p.canonical_marks}, {q.canonical_triangulation, q.canonical_marks},
            "canonical triangulations", found))
    return true;
  found.answer.reason =
      "the canonical cells, colored by orders, differ, but with marked edges they are not proved";
  return false;
}

} // namespace

std::string orders_text(const Marks& marks) {
  std::vector<std::string> words;
  words.reserve(marks.size());
  for (const EdgeMark& mark : marks) words.push_back(mark_order_text(mark.order));
  return "orders " + joined(words, ", ");
}

Cells cells_with_marks(const Triangulation& tri, const CanonicalOptions& options, const Progress& progress) {
  canonical::MarkedCanonical made = colored_cells({tri, options.marks}, options, progress);
  Cells found;
  found.why_not = made.why_not;
  found.volume = made.volume;
  if (!found.why_not.empty()) return found;
  found.outcome = hyperbolic::Outcome::geometric;
  found.canonical = std::move(made.canonical);
  return found;
}

Isometry isometry_with_marks(const Compared& x, const Compared& y, const CanonicalOptions& options,
                             const Progress& progress) {
  Isometry found{{}, "canonical triangulations", {}, 0, x.name, y.name};
  const MarkedTriangulation given_x{x.tri, x.marks};
  const MarkedTriangulation given_y{y.tri, y.marks};
  const auto decided = [&found](std::optional<IsometryAnswer> answer) {
    if (answer) found.answer = *std::move(answer);
    return found.answer.verdict != Says::undecided;
  };
  if (decided(differ_without_structure(x.tri, y.tri)) || decided(differ_in_orders(given_x, given_y)) ||
      agree(given_x, given_y, "triangulations given", found))
    return found;
  const MarkedTriangulation small_x = reduced_marked(x, progress);
  const MarkedTriangulation small_y = reduced_marked(y, progress);
  if (agree(small_x, small_y, "simplified triangulations", found) ||
      agree_in_cells(small_x, small_y, options, found, progress))
    return found;
  const std::string doubt = found.answer.reason;
  if (meet(small_x, small_y, options.seed, found, progress) ||
      decided(differ_in_exteriors(small_x, x.name, small_y, y.name, options, progress)) ||
      decided(
          differ_in_group(orbifold_group(small_x, progress), orbifold_group(small_y, progress), progress)))
    return found;
  found.answer.reason = doubt + "; exteriors, the orbifolds' groups and their covers do not tell them apart";
  return found;
}

} // namespace tetrarch::workshop
