// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/structure.hpp"

#include "cusp_rows.hpp"
#include "orbifold_rows.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/verified/certificate.hpp"
#include "tetrarch/workshop/reason.hpp"
#include "tetrarch/workshop/text.hpp"

#include <array>
#include <cmath>

namespace tetrarch::workshop {
namespace {

using hyperbolic::Outcome;

bool is_geometric(const Structure& s) {
  return s.search.structure.outcome == Outcome::geometric;
}
bool is_turned_over(const Structure& s) {
  return s.orbifold && s.orbifold->structure.outcome == hyperbolic::OrbifoldOutcome::turned_over;
}
bool has_bad_vertex(const Structure& s) {
  return s.orbifold && s.orbifold->structure.outcome == hyperbolic::OrbifoldOutcome::bad_vertex;
}

/// The word users see first; `reason` keeps the finer one.
std::string outcome_word(const Structure& s) {
  const Outcome outcome = s.search.structure.outcome;
  if (outcome == Outcome::geometric) return "geometric";
  if (outcome == Outcome::projective_plane || has_bad_vertex(s) || s.why) return "not hyperbolic";
  return is_turned_over(s) ? "turned over" : "not found";
}

std::string reason_word(const Structure& s) {
  if (s.why) return reasons::to_string(s.why->kind);
  return s.orbifold ? to_string(s.orbifold->structure.outcome) : to_string(s.search.structure.outcome);
}
std::string reason(const Structure& s) {
  if (s.why) return s.why->text;
  return s.orbifold ? describe(s.orbifold->structure, s.skeleton)
                    : hyperbolic::describe(s.search.structure, s.skeleton);
}
std::string tried(const Structure& s) {
  return s.orbifold ? describe(*s.orbifold) : hyperbolic::describe(s.search);
}

bool has_cusps(const Structure& s) {
  return is_geometric(s) && !s.orbifold;
}
bool has_orbifold(const Structure& s) {
  return s.orbifold.has_value();
}
bool has_marks(const Structure& s) {
  return s.orbifold && !s.orbifold->marks.empty();
}
bool is_solved(const Structure& s) {
  return s.search.structure.outcome == Outcome::geometric || is_turned_over(s);
}

Table<VertexId, hyperbolic::VertexType> types_of(const Structure& s) {
  return s.orbifold ? s.orbifold->structure.types : hyperbolic::vertex_types(s.skeleton);
}

bool has_reason(const Structure& s) {
  return s.why.has_value();
}
bool is_not_geometric(const Structure& s) {
  return !is_geometric(s);
}

bool is_certified(const Structure& s) {
  return s.certified && s.certified->proof;
}
bool was_to_be_certified(const Structure& s) {
  return s.certified.has_value();
}
bool is_not_certified(const Structure& s) {
  return was_to_be_certified(s) && !is_certified(s);
}
bool has_digits(const Structure& s) {
  return is_certified(s) && s.digits > 0;
}

std::string digits_of_volume(const Structure& s) {
  const numeric::WorkingPrecision precision(s.certified->proof->bits);
  return numeric::certain_digits(s.certified->proof->volume, s.digits);
}

Tree volume_interval(const Structure& s) {
  const auto [low, high] = verified::volume_interval(*s.certified->proof);
  return Tree{low, high};
}

/// An end of the edge lies in a cusp: its length depends on the horosphere there.
bool into_a_cusp(const Skeleton& skeleton, const Table<VertexId, hyperbolic::VertexType>& types, EdgeId e) {
  const auto [p, q] = skeleton.ends(e);
  return types[p] == hyperbolic::VertexType::ideal || types[q] == hyperbolic::VertexType::ideal;
}

/// Half of the last digit that a volume is printed with: a larger bound of its error is printed too.
constexpr double last_digit_of_volume = 5e-13;

/// Whose structure it is, where that is not the manifold given.
std::string filling(int spheres) {
  return spheres == 1
             ? "1 boundary sphere is filled with a ball: this is another manifold than the given one"
             : std::to_string(spheres) +
                   " boundary spheres are filled with balls: this is another manifold than the given one";
}

Rows no_structure(const Structure& s) {
  const auto& found = s.search.structure;
  Rows rows{{"outcome", outcome_word(s)}};
  if (s.why) {
    const Rows proof = rows_of(*s.why);
    rows.insert(rows.end(), proof.begin(), proof.end());
    return rows;
  }
  rows.insert(rows.end(), {{"reason", reason(s)},
                           {"tried", tried(s)},
                           {"residual", scientific(found.residual, 1)},
                           {"iterations", std::to_string(found.iterations)}});
  return rows;
}

/// ", order 3"; nothing of an unmarked edge.
std::string order_of(const Structure& s, EdgeId e) {
  if (!has_marks(s) || s.orbifold->structure.orders[e] == 1) return {};
  const double order = s.orbifold->structure.orders[e];
  return order == 0 ? ", null" : ", order " + rounded(order);
}

void add_edges(const Structure& s, Rows& rows) {
  const auto types = types_of(s);
  const auto& lengths = s.search.structure.lengths;
  for (const EdgeId e : all<EdgeId>(lengths.size()))
    rows.emplace_back("edge " + std::to_string(e.value),
                      "length " + fixed(lengths[e], 10) +
                          (into_a_cusp(s.skeleton, types, e) ? " to the horosphere" : "") + ", valence " +
                          std::to_string(s.skeleton.valence(e)) + order_of(s, e));
}

Tree edges_into_cusps(const Structure& s) {
  const auto types = types_of(s);
  Tree edges = Tree::array();
  for (const EdgeId e : all<EdgeId>(s.search.structure.lengths.size()))
    if (into_a_cusp(s.skeleton, types, e)) edges.push_back(e.value);
  return edges;
}

Tree error_of_volume(const Structure& s) {
  const double error = s.search.structure.volume_error;
  return is_solved(s) && std::isfinite(error) ? Tree(error) : Tree();
}

Tree lengths_of(const Structure& s) {
  Tree list = Tree::array();
  for (const double length : s.search.structure.lengths) list.push_back(length);
  return list;
}

hyperbolic::Search solved_as_given(const Triangulation& tri) {
  hyperbolic::Search found;
  found.triangulation = tri;
  found.attempts = 1;
  return found;
}

/// The search with Newton's method; then, if that is asked for, the flow on the triangulation that it found.
Searched solve(const Triangulation& tri, const StructureOptions& options, const Progress& progress) {
  hyperbolic::SearchOptions how;
  how.seed = options.seed;
  how.attempts = options.as_given ? 1 : options.attempts;
  Searched result = options.as_given ? Searched{solved_as_given(tri), {}} : searched(tri, how, progress);
  if (!options.as_given && options.method == hyperbolic::Method::newton) return result;
  hyperbolic::Search& found = result.search;
  hyperbolic::HyperbolizeOptions once;
  once.method = options.method;
  found.structure =
      hyperbolic::hyperbolize(found.triangulation, Skeleton(found.triangulation), once, progress);
  if (found.structure.outcome == Outcome::stopped) throw Stopped();
  if (options.as_given) ++found.seen[static_cast<std::size_t>(found.structure.outcome)];
  return result;
}

/// From lengths of more bits, since balls lose some thirty while a cusp is unrolled; where there are none,
/// from the certified lengths.
void prove_shapes(Structure& s, const Progress& progress) {
  if (s.cusps.empty()) return;
  constexpr int spare = 64;
  const int bits = s.certified->proof->bits + spare;
  const Triangulation& tri = s.search.triangulation;
  const auto finer = verified::certify(tri, s.skeleton, s.search.structure, {bits, bits, false}, progress);
  s.shape_bits = finer.proof ? bits : s.certified->proof->bits;
  const numeric::WorkingPrecision precision(s.shape_bits);
  s.proved_shapes = hyperbolic::cusp_shapes(tri, s.skeleton,
                                            finer.proof ? finer.proof->lengths : s.certified->proof->lengths);
}

void certify(Structure& s, const Progress& progress) {
  const Triangulation& tri = s.search.triangulation;
  const auto& structure = s.search.structure;
  s.certified = s.digits > 0 ? verified::certify_to(s.digits, tri, s.skeleton, structure, progress)
                             : verified::certify(tri, s.skeleton, structure, {}, progress);
  if (!is_certified(s)) return;
  s.certificate = verified::certificate(tri, s.skeleton, *s.certified->proof);
  prove_shapes(s, progress);
}

void add_certified(const Structure& s, Rows& rows) {
  if (is_not_certified(s)) rows.emplace_back("certified", "no: " + s.certified->why_not);
  if (!is_certified(s)) return;
  const auto [low, high] = verified::volume_interval(*s.certified->proof);
  rows.emplace_back("certified", "yes, with " + std::to_string(s.certified->proof->bits) + " bits");
  rows.emplace_back("volume in", "[" + low + ", " + high + "]");
  rows.emplace_back("certificate", "sha256 " + verified::digest(s.certificate));
}

} // namespace

Verdict Structure::verdict() const {
  const Outcome outcome = search.structure.outcome;
  if (has_bad_vertex(*this)) return Verdict::proved_no;
  if (outcome == Outcome::geometric) return is_not_certified(*this) ? Verdict::undecided : Verdict::yes;
  return outcome == Outcome::projective_plane || why ? Verdict::proved_no : Verdict::undecided;
}

std::optional<reasons::Reason> proved_no(const Triangulation& tri, std::uint64_t seed,
                                         const Progress& progress) {
  reasons::ReasonOptions how;
  how.seed = seed;
  return reasons::why_not_hyperbolic(tri, how, progress);
}

Searched searched(const Triangulation& tri, hyperbolic::SearchOptions options, const Progress& progress) {
  Searched found;
  options.has_none = [&](const Triangulation& simple) {
    found.why = reasons::quick_reason(simple, tri, options.seed, progress);
    return found.why.has_value();
  };
  found.search = find_structure(tri, options, progress);
  return found;
}

namespace {

Structure without_marks(const Triangulation& tri, const StructureOptions& options, const Progress& progress) {
  Searched found = solve(tri, options, progress);
  Skeleton skeleton(found.search.triangulation);
  Structure result{std::move(found.search), std::move(skeleton), {}, {}, {}, options.digits};
  result.why = std::move(found.why);
  return result;
}

/// By the ways to orbifolds, which serve closed manifolds too.
Structure as_orbifold(const Triangulation& tri, const StructureOptions& options, const Progress& progress) {
  hyperbolic::OrbifoldSearch found = find_marked(tri, options, progress);
  hyperbolic::Search search = as_search(found);
  Skeleton skeleton(search.triangulation);
  return {std::move(search), std::move(skeleton), {}, {}, {}, options.digits, std::move(found)};
}

bool is_closed_manifold(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (!skeleton.link(v).is_sphere()) return false;
  return !skeleton.has_boundary_faces();
}

Structure found_any_way(const Triangulation& tri, const StructureOptions& options, const Progress& progress) {
  if (!options.marks.empty()) return as_orbifold(tri, options, progress);
  const bool may_be_closed = options.method == hyperbolic::Method::newton;
  if (may_be_closed && is_worth_trying(tri) && is_closed_manifold(Skeleton(tri)))
    return as_orbifold(tri, options, progress);
  Structure found = without_marks(tri, options, progress);
  if (!may_be_closed || found.search.structure.outcome != Outcome::finite_vertices ||
      !is_worth_trying(found.search.triangulation) || !is_closed_manifold(found.skeleton))
    return found;
  const int spheres = found.search.filled_spheres;
  Structure closed = as_orbifold(found.search.triangulation, options, progress);
  closed.search.filled_spheres = spheres;
  closed.search.changed = true;
  closed.orbifold->changed = true;
  return closed;
}

} // namespace

Structure structure(const Triangulation& tri, const StructureOptions& options, const Progress& progress) {
  Structure found = found_any_way(tri, options, progress);
  const bool certifies = options.certify || options.digits > 0;
  if (!is_geometric(found)) {
    if (!found.why && !options.as_given && options.marks.empty() && !is_turned_over(found))
      found.why = proved_no(found.search.triangulation, options.seed, progress);
    if (certifies) found.certified = verified::Certification{std::nullopt, "no structure was found"};
    return found;
  }
  if (has_marks(found)) {
    if (certifies)
      found.certified =
          verified::Certification{std::nullopt, "structures with marked edges are not certified yet"};
    return found;
  }
  if (found.orbifold) {
    if (certifies) certify(found, progress);
    return found;
  }
  found.cusps = hyperbolic::cusps(found.search.triangulation, found.skeleton, found.search.structure.lengths);
  if (certifies) certify(found, progress);
  return found;
}

Rows rows_of(const Structure& s) {
  const auto& found = s.search.structure;
  Rows rows;
  if (is_solved(s)) {
    rows = {{"outcome", tried(s)},
            {"signature", signature(s.search.triangulation)},
            {"volume", has_digits(s) ? digits_of_volume(s) : fixed(found.volume, 12)}};
    add_certified(s, rows);
    if (s.orbifold) add_orbifold(*s.orbifold, s.skeleton, rows);
    if (!(found.volume_error < last_digit_of_volume))
      rows.emplace_back("error", "volume right to within " + scientific(found.volume_error, 1));
    rows.emplace_back("residual", scientific(found.residual, 1));
    rows.emplace_back("iterations", std::to_string(found.iterations));
    add_edges(s, rows);
    add_cusps(s, rows);
    for (std::size_t t = 0; t < found.dihedral_angles.size(); ++t) {
      std::vector<std::string> angles;
      for (const double a : found.dihedral_angles[t]) angles.push_back(fixed(a, 10));
      rows.emplace_back("angles " + std::to_string(t), joined(angles, " "));
    }
  } else {
    rows = no_structure(s);
  }
  const int spheres = s.search.filled_spheres;
  if (spheres > 0) rows.insert(rows.begin() + 1, {"filled", filling(spheres)});
  return rows;
}

format::Document document_of(const Structure& s) {
  format::Document document = format::document_of(s.search.triangulation);
  const auto& found = s.search.structure;
  const auto types = types_of(s);
  if (s.orbifold) document.marks = s.orbifold->marks;
  format::Metric metric;
  for (int t = 0; t < document.triangulation.size(); ++t) {
    metric.edge_lengths.emplace_back();
    metric.dihedral_angles.emplace_back();
    for (int e = 0; e < 6; ++e) {
      const EdgeId edge = s.skeleton.edge({t, e});
      if (!into_a_cusp(s.skeleton, types, edge))
        metric.edge_lengths.back()[e] = format::Number(found.lengths[edge]);
      metric.dihedral_angles.back()[e] = format::Number(found.dihedral_angles[t][e]);
    }
  }
  metric.volume = format::Number(found.volume);
  document.metric = std::move(metric);
  return document;
}

template <>
const FieldList<Structure>& fields_of<Structure>() {
  using S = const Structure&;
  static const FieldList<Structure> fields{
      {{"outcome", "",
        "geometric, turned over (solved, but some tetrahedra are flat or inside out), not "
        "hyperbolic (proved), or not found",
        type::one_of({"geometric", "turned over", "not hyperbolic", "not found"})},
       [](S s) -> Tree { return outcome_word(s); }},
      {{"reason", "", "why there is no structure, in a word", type::text},
       [](S s) -> Tree { return reason_word(s); },
       is_not_geometric},
      {{"explanation", "", "the same with its place", type::text},
       [](S s) -> Tree { return reason(s); },
       is_not_geometric},
      {{"why", "", "the proof that the manifold is not hyperbolic: kind, text, theorem, and what shows it",
        reason_type()},
       [](S s) -> Tree { return tree_of(*s.why); },
       has_reason},
      {{"tried", "", "how structures were sought", type::text},
       [](S s) -> Tree { return tried(s); },
       is_not_geometric},
      {{"solved_by", "", "newton or homotopy: how marked edges or a closed manifold were solved", type::text},
       [](S s) -> Tree { return to_string(s.orbifold->structure.method); },
       has_orbifold},
      {{"marks", "", "of each marked edge a tetrahedron, its edge, and the order; 0: parabolic",
        marks_type()},
       [](S s) -> Tree { return marks_tree(s.orbifold->marks); },
       has_marks},
      {{"vertices", "",
        "of each vertex its type, its link, and the link's Euler characteristic with the marks",
        type::list(type::object({{"vertex", type::integer},
                                 {"type", type::text},
                                 {"link", type::text},
                                 {"euler", type::number}}))},
       [](S s) -> Tree { return vertices_tree(*s.orbifold, s.skeleton); },
       has_orbifold},
      {{"orientation", "", "of each tetrahedron 1, 0 (flat) or -1 (turned over)", type::list(type::integer)},
       [](S s) -> Tree { return s.orbifold->structure.orientation; },
       has_orbifold},
      {{"volume", "curvature -1", "the volume; null without a structure", type::or_null(type::number)},
       [](S s) { return is_solved(s) ? Tree(s.search.structure.volume) : Tree(); }},
      {{"volume_error", "curvature -1", "a bound of its error, given that the structure exists",
        type::or_null(type::number)},
       error_of_volume},
      {{"certified", "", "whether the structure is proved to exist", type::truth},
       [](S s) -> Tree { return is_certified(s); },
       was_to_be_certified},
      {{"why_not_certified", "", "what failed; no proof that there is no structure", type::text},
       [](S s) -> Tree { return s.certified->why_not; },
       is_not_certified},
      {{"bits", "", "binary digits that it was proved with", type::integer},
       [](S s) -> Tree { return s.certified->proof->bits; },
       is_certified},
      {{"volume_interval", "curvature -1", "two decimal numbers, as texts, between which the volume lies",
        type::list(type::text, 2)},
       volume_interval,
       is_certified},
      {{"volume_digits", "curvature -1", "the volume to the digits asked for, as a text", type::text},
       [](S s) -> Tree { return digits_of_volume(s); },
       has_digits},
      {{"certificate", "", "SHA-256 of the file that proves it", type::text},
       [](S s) -> Tree { return verified::digest(s.certificate); },
       is_certified},
      {{"signature", "", "isomorphism signature of the triangulation that carries the structure", type::text},
       [](S s) -> Tree { return signature(s.search.triangulation); }},
      {{"changed", "", "whether that is another triangulation than the given one", type::truth},
       [](S s) -> Tree { return s.search.changed; }},
      {{"filled_spheres", "", "number of boundary spheres that were filled with balls", type::integer},
       [](S s) -> Tree { return s.search.filled_spheres; }},
      {{"attempts", "", "number of triangulations tried", type::integer},
       [](S s) -> Tree { return s.search.attempts; }},
      {{"edge_lengths", "curvature -1", "length of each edge; of one into a cusp, to the horosphere there",
        type::list(type::number)},
       lengths_of},
      {{"dihedral_angles", "radians", "of each tetrahedron, at its edges 01, 02, 03, 12, 13, 23",
        type::list(type::list(type::number, 6))},
       [](S s) -> Tree { return s.search.structure.dihedral_angles; }},
      {{"into_cusps", "", "numbers of the edges that run into a cusp", type::list(type::integer)},
       edges_into_cusps,
       is_geometric},
      {{"cusps", "",
        "of each cusp its vertex, type, shape, the area of its cross-section, and a residual; certified, "
        "also "
        "intervals of decimal numbers, as texts, that hold both parts of the shape",
        cusps_type()},
       cusps_tree,
       has_cusps},
      {{"residual", "radians", "greatest angle defect of an edge", type::number},
       [](S s) -> Tree { return s.search.structure.residual; }},
      {{"iterations", "", "steps of the method", type::integer},
       [](S s) -> Tree { return s.search.structure.iterations; }}};
  return fields;
}

} // namespace tetrarch::workshop
