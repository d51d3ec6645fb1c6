// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/verify.hpp"

#include "tetrarch/workshop/text.hpp"

namespace tetrarch::workshop {
namespace {

using checker::Report;

bool is_accepted(const Report& r) {
  return r.accepted;
}
bool is_refused(const Report& r) {
  return !r.accepted;
}

std::string links_text(const Report& r) {
  std::vector<std::string> links;
  for (const int euler : r.links) links.push_back(std::to_string(euler));
  return joined(links, ", ");
}

std::string cells_text(const Report& r) {
  std::string text = counted(r.walls, "wall") + " proved to be strictly convex";
  if (!r.cusp_area.empty()) text += ", with cusps of area " + r.cusp_area;
  if (r.unchecked.empty()) return text + ": the tetrahedra are the canonical cells";
  for (const auto& [criterion, faces] : r.unchecked)
    text += "; not checked: " + counted(faces, "face") + " inside cells, said to be flat by " + criterion;
  return text;
}

bool has_accepted_cells(const Report& r) {
  return r.accepted && r.has_cells;
}

Tree unchecked(const Report& r) {
  Tree tree = Tree::object();
  for (const auto& [criterion, faces] : r.unchecked) tree[criterion] = faces;
  return tree;
}

} // namespace

Rows rows_of(const Report& r) {
  if (!r.accepted) return {{"refused", r.why_not}};
  Rows rows{{"accepted", "a hyperbolic structure exists, and only one near the lengths given"},
            {"tetrahedra", std::to_string(r.tetrahedra)},
            {"edges", std::to_string(r.edges)},
            {"orientable", r.orientable ? "yes" : "no"},
            {"links", "Euler characteristic " + links_text(r)},
            {"volume in", "[" + r.volume[0] + ", " + r.volume[1] + "]"}};
  if (r.has_cells) rows.emplace_back("cells", cells_text(r));
  return rows;
}

template <>
const FieldList<Report>& fields_of<Report>() {
  using R = const Report&;
  static const FieldList<Report> fields{
      {{"accepted", "", "whether the certificate proves what it claims, but for what `unchecked` lists",
        type::truth},
       [](R r) -> Tree { return r.accepted; }},
      {{"reason", "", "the first thing that is not proved", type::text},
       [](R r) -> Tree { return r.why_not; },
       is_refused},
      {{"tetrahedra", "", "number of tetrahedra", type::integer}, [](R r) -> Tree { return r.tetrahedra; }},
      {{"edges", "", "number of edge classes", type::integer},
       [](R r) -> Tree { return r.edges; },
       is_accepted},
      {{"cusps", "", "number of cusps", type::integer}, [](R r) -> Tree { return r.cusps; }, is_accepted},
      {{"orientable", "", "whether the manifold is orientable", type::truth},
       [](R r) -> Tree { return r.orientable; },
       is_accepted},
      {{"links", "", "Euler characteristics of the vertex links, increasing", type::list(type::integer)},
       [](R r) -> Tree { return r.links; },
       is_accepted},
      {{"volume_interval", "curvature -1", "two decimal numbers, as texts, between which the volume lies",
        type::list(type::text, 2)},
       [](R r) -> Tree {
         return {r.volume[0], r.volume[1]};
       },
       is_accepted},
      {{"walls", "", "of canonical cells: number of faces between two, each proved to be strictly convex",
        type::integer},
       [](R r) -> Tree { return r.walls; },
       has_accepted_cells},
      {{"unchecked", "",
        "of canonical cells: by criterion, the number of faces inside them that are said to be flat, which "
        "is "
        "not checked; empty: the cells are proved",
        type::table(type::integer)},
       unchecked,
       has_accepted_cells},
      {{"cusp_area", "",
        "of canonical cells: the area of each cusp's cross-section, as a text; null: no cusps",
        type::or_null(type::text)},
       [](R r) { return r.cusp_area.empty() ? Tree() : Tree(r.cusp_area); },
       has_accepted_cells},
      {{"bits", "", "binary digits that the proof was found with; the check takes 128 more", type::integer},
       [](R r) -> Tree { return r.bits; }}};
  return fields;
}

} // namespace tetrarch::workshop
