// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/diagram.hpp"

#include "orbifold_rows.hpp"
#include "with_info.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/marked.hpp"
#include "tetrarch/diagram/names.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/write.hpp"
#include "tetrarch/format/orb.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/moves/marked.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>

namespace tetrarch::workshop {
namespace {

/// Every arc passes over at one of its crossings and under at the other.
bool is_alternating(const diagram::Diagram& diagram) {
  for (int d = 0; d < diagram.dart_count(); ++d) {
    const int e = diagram.opposite(d);
    if (diagram.at_crossing(d) && diagram.at_crossing(e) && diagram.is_over(d) == diagram.is_over(e))
      return false;
  }
  return true;
}

bool has_vertices(const diagram::Diagram& diagram) {
  return std::any_of(diagram.nodes().begin(), diagram.nodes().end(),
                     [](const diagram::Node& n) { return !n.crossing && n.darts.size() > 2; });
}

/// Half of the double's structure; of a link that of the exterior, whose meridians are parabolic anyway.
Exterior::Parabolic parabolic(const diagram::Diagram& diagram, const Exterior& x,
                              const ExteriorOptions& options, const Progress& progress) {
  const bool halves = has_vertices(diagram);
  const Triangulation tri =
      halves && !x.is_double ? diagram::doubled_exterior(diagram, {options.seed}, progress) : x.triangulation;
  hyperbolic::SearchOptions how;
  how.seed = options.seed;
  const hyperbolic::Search found = hyperbolic::find_structure(tri, how, progress);
  const bool good = found.structure.outcome == hyperbolic::Outcome::geometric && found.filled_spheres == 0;
  return {good, good ? found.structure.volume / (halves ? 2 : 1) : 0,
          (halves ? "half of the double: " : "") + describe(found)};
}

Tree meridians_tree(const Exterior& x) {
  Tree list = Tree::array();
  for (const int g : x.wirtinger.meridians)
    list.push_back(algebra::word_str({g + 1}, x.wirtinger.group.generators));
  return list;
}

std::string fates_text(const std::vector<diagram::Fate>& fates) {
  std::vector<std::string> words;
  words.reserve(fates.size());
  for (const diagram::Fate& fate : fates)
    words.push_back(!fate        ? "drilled"
                    : *fate == 0 ? "null"
                    : *fate == 1 ? "order 1"
                                 : "order " + format::to_text(*fate));
  return joined(words, ", ");
}

Tree fates_tree(const Exterior& x) {
  Tree list = Tree::array();
  for (const diagram::Fate& fate : x.fates) list.push_back(fate ? Tree(*fate) : Tree());
  return list;
}

Tree wirtinger_tree(const Exterior& x) {
  const algebra::Presentation& group = x.wirtinger.group;
  Tree tree{{"generators", Tree::array()}, {"relators", Tree::array()}};
  for (int g = 0; g < group.generators; ++g)
    tree["generators"].push_back(algebra::word_str({g + 1}, group.generators));
  for (const algebra::Word& r : group.relators)
    tree["relators"].push_back(algebra::word_str(r, group.generators));
  return tree;
}

} // namespace

namespace {

constexpr std::string_view codes = "expected embedding, PD, X[...], braid, DT, Gauss or Conway";

/// `drilled`: all edges of an Orb file's graph.
diagram::MarkedDiagram opened_diagram(const std::string& what, const OpenOptions& options, bool drilled,
                                      std::uint64_t seed, const Progress& progress) {
  using diagram::all_drilled;
  if (diagram::looks_like_diagram(what)) return all_drilled(diagram::read_diagram(what, "the code given"));
  if (!is_file(what, options.samples)) {
    if (std::optional<diagram::Diagram> named = diagram::named_diagram(what))
      return all_drilled(std::move(*named));
    throw InputError(in_quotes(what) +
                     " is no file, no name of a knot, link or graph and no code of a "
                     "diagram (" +
                     std::string(codes) + ")");
  }
  const std::string source = format::source_name(what);
  const std::string text = format::read_file(located(what, options.samples));
  if (text.starts_with(format::orb_header)) {
    if (std::optional<diagram::MarkedDiagram> drawn = diagram::read_orb_diagram(text, source, drilled))
      return std::move(*drawn);
    throw InputError({source, 0}, "the file has a triangulation and no drawing of a graph");
  }
  if (diagram::looks_like_diagram(text) || !diagram::looks_like_curve(text))
    return all_drilled(diagram::read_diagram(text, source));
  const diagram::Curve curve = diagram::read_curve(text, source);
  // Whether it meets itself is asked of the curve as it is given.
  diagram::Diagram whole = diagram::project(curve, source, {seed, 1}, progress);
  const diagram::Curve shorter = diagram::reduced(curve, progress);
  diagram::Diagram small = diagram::project(shorter, source, {seed}, progress);
  return all_drilled(diagram::crossing_count(small) <= diagram::crossing_count(whole) ? std::move(small)
                                                                                      : std::move(whole));
}

} // namespace

diagram::Diagram open_diagram(const std::string& what, const OpenOptions& options, std::uint64_t seed,
                              const Progress& progress) {
  return opened_diagram(what, options, true, seed, progress).diagram;
}

diagram::MarkedDiagram open_marked_diagram(const std::string& what, const OpenOptions& options,
                                           std::uint64_t seed, const Progress& progress) {
  return opened_diagram(what, options, false, seed, progress);
}

DiagramFacts facts(const diagram::Diagram& diagram) {
  DiagramFacts found;
  found.code = diagram::planar_diagram_code(diagram);
  found.crossings = diagram::crossing_count(diagram);
  found.vertices = diagram::vertex_count(diagram);
  found.edges = diagram::edges(diagram).count;
  found.components = diagram::components(diagram).count;
  found.parts = diagram::parts(diagram).count;
  // The outer regions of separate parts are one.
  found.regions = diagram::regions(diagram).count - found.parts + 1;
  found.alternating = is_alternating(diagram);
  return found;
}

Rows rows_of(const DiagramFacts& f) {
  Rows rows{{"crossings", std::to_string(f.crossings)}};
  if (f.vertices > 0) {
    rows.emplace_back("vertices", std::to_string(f.vertices));
    rows.emplace_back("edges", std::to_string(f.edges));
  }
  rows.emplace_back("components", std::to_string(f.components));
  if (f.parts > 1) rows.emplace_back("parts", std::to_string(f.parts));
  rows.emplace_back("regions", std::to_string(f.regions));
  rows.emplace_back("alternating", f.alternating ? "yes" : "no");
  return rows;
}

int tree_count(const diagram::Diagram& diagram) {
  return tree_count(diagram::all_drilled(diagram));
}

/// Components with one vertex more than edges.
int tree_count(const diagram::MarkedDiagram& marked) {
  const diagram::Diagram& diagram = marked.diagram;
  const diagram::Classes component = diagram::components(diagram);
  std::vector<int> twice_euler(static_cast<std::size_t>(component.count), 0);
  for (const diagram::Node& node : diagram.nodes())
    if (!node.crossing)
      twice_euler[component.of[node.darts.front()]] += 2 - static_cast<int>(node.darts.size());
  for (int d = 0; d < diagram.dart_count(); ++d)
    if (marked.fates[d]) twice_euler[component.of[d]] = 0;
  return static_cast<int>(std::count(twice_euler.begin(), twice_euler.end(), 2));
}

Exterior exterior(const diagram::Diagram& diagram, const ExteriorOptions& options, const Progress& progress) {
  return exterior(diagram::all_drilled(diagram), options, progress);
}

Exterior exterior(const diagram::MarkedDiagram& marked, const ExteriorOptions& options,
                  const Progress& progress) {
  const diagram::Diagram& diagram = marked.diagram;
  const bool keeps = diagram::keeps_edges(marked);
  if (options.doubled && !has_vertices(diagram))
    throw InputError("there is no vertex of valence 3 or more, along whose sphere a double could be glued");
  if (keeps && (options.doubled || options.parabolic))
    throw InputError(
        "a double, or the structure with parabolic meridians, is that of a graph all of whose edges "
        "are drilled; here some stay, with orders of their own");
  Exterior x;
  x.diagram = facts(diagram);
  x.wirtinger = diagram::wirtinger(diagram);
  x.is_double = options.doubled;
  x.filled_spheres = tree_count(marked);
  if (keeps) {
    moves::MarkedTriangulation found = diagram::marked_exterior(marked, {options.seed}, progress);
    x.fates = diagram::fates_of_edges(marked);
    x.triangulation = std::move(found.tri);
    x.marks = std::move(found.marks);
  } else {
    x.triangulation = options.doubled ? diagram::doubled_exterior(diagram, {options.seed}, progress)
                                      : diagram::exterior(diagram, {options.seed}, progress);
  }
  if (options.parabolic) x.parabolic = parabolic(diagram, x, options, progress);
  x.info = info(x.triangulation, options.name, false, progress);
  return x;
}

Rows rows_of(const Exterior& x, const std::string& signature) {
  Rows rows{{"crossings", std::to_string(x.diagram.crossings)},
            {"components", std::to_string(x.diagram.components)}};
  const Rows info = rows_of(x.info, signature);
  rows.insert(rows.end(), info.begin(), info.end());
  if (!x.fates.empty()) rows.emplace_back("edges of graph", fates_text(x.fates));
  if (x.parabolic)
    rows.insert(rows.end(), {{"parabolic", x.parabolic->found ? "volume " + fixed(x.parabolic->volume, 12)
                                                              : std::string("no structure found")},
                             {"", x.parabolic->how}});
  return rows;
}

template <>
const FieldList<DiagramFacts>& fields_of<DiagramFacts>() {
  using F = const DiagramFacts&;
  static const FieldList<DiagramFacts> fields{
      {{"crossings", "", "number of crossings", type::integer}, [](F f) -> Tree { return f.crossings; }},
      {{"vertices", "", "number of vertices of the graph whose valence is not 2", type::integer},
       [](F f) -> Tree { return f.vertices; }},
      {{"edges", "", "number of edges of the graph; a component of a link is one", type::integer},
       [](F f) -> Tree { return f.edges; }},
      {{"components", "", "number of connected components of the graph or link", type::integer},
       [](F f) -> Tree { return f.components; }},
      {{"parts", "", "number of connected components of the plane picture", type::integer},
       [](F f) -> Tree { return f.parts; }},
      {{"regions", "", "number of regions of the plane", type::integer},
       [](F f) -> Tree { return f.regions; }},
      {{"alternating", "", "whether each arc between two crossings passes over at one and under at the other",
        type::truth},
       [](F f) -> Tree { return f.alternating; }},
      {{"code", "", "planar diagram code", type::text}, [](F f) -> Tree { return f.code; }}};
  return fields;
}

template <>
const FieldList<Exterior>& fields_of<Exterior>() {
  using X = const Exterior&;
  static const FieldList<Exterior> fields{
      {{"crossings", "", "number of crossings of the diagram", type::integer},
       [](X x) -> Tree { return x.diagram.crossings; }},
      {{"components", "", "number of connected components of the graph or link", type::integer},
       [](X x) -> Tree { return x.diagram.components; }},
      {{"meridians", "", "of each edge of the graph its meridian, a word in the group \"wirtinger\"",
        type::list(type::text)},
       meridians_tree},
      {{"orders", "",
        "of each edge of the graph its order (0: its meridian is parabolic); null: it is drilled. An edge "
        "ends "
        "where it begins to be drilled",
        type::list(type::or_null(type::integer))},
       fates_tree,
       [](X x) { return !x.fates.empty(); }},
      {{"marks", "", "edges of the triangulation that stay: tetrahedron, edge, order", marks_type()},
       [](X x) { return marks_tree(x.marks); },
       [](X x) { return !x.fates.empty(); }},
      {{"filled_spheres", "", "trees among the components, the ball round each of which was filled in again",
        type::integer},
       [](X x) -> Tree { return x.filled_spheres; },
       [](X x) { return x.filled_spheres > 0; }},
      {{"parabolic_volume", "curvature -1",
        "volume of the structure whose meridians are parabolic, with totally geodesic spheres at the "
        "vertices; "
        "null where none was found",
        type::or_null(type::number)},
       [](X x) { return x.parabolic->found ? Tree(x.parabolic->volume) : Tree(); },
       [](X x) { return x.parabolic.has_value(); }},
      {{"wirtinger", "", "the group as the diagram gives it; generators are meridians", group_type()},
       wirtinger_tree}};
  return fields;
}

template <>
Tree tree_of<Exterior>(const Exterior& x) {
  return tree_with_info(x);
}

template <>
std::vector<FieldNote> notes_of<Exterior>() {
  return notes_with_info<Exterior>();
}

} // namespace tetrarch::workshop
