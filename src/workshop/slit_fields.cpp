// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/slit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tetrarch::workshop {
namespace {

using MapRef = const ConformalMap&;

constexpr std::array<const char*, 6> domain_names{"cylindric", "parallel",  "concentric",
                                                  "circular",  "rectangle", "free"};

Tree slits_tree(MapRef m) {
  const char* const place = m.slits->on_ring ? "radius" : "height";
  Tree list = Tree::array();
  for (const slit::Slit& s : m.slits->slits)
    list.push_back({{"loop", s.loop},
                    {place, m.slits->on_ring ? s.radius : -std::log(s.radius)},
                    {"start", s.start},
                    {"end", s.end}});
  return list;
}

Tree circles_tree(MapRef m) {
  Tree list = Tree::array();
  for (std::size_t k = 0; k < m.circles->loops.size(); ++k) {
    const slit::Circle& c = m.circles->circles[k];
    list.push_back({{"loop", m.circles->loops[k]},
                    {"center", {c.center.real(), c.center.imag()}},
                    {"radius", c.radius},
                    {"circularity", c.circularity}});
  }
  return list;
}

Tree rectangular_holes_tree(MapRef m) {
  Tree list = Tree::array();
  for (const auto& hole : m.rectangle->holes)
    list.push_back({{"loop", hole.loop},
                    {"left", hole.left},
                    {"right", hole.right},
                    {"bottom", hole.bottom},
                    {"top", hole.top}});
  return list;
}

Tree softened_tree(MapRef m) {
  return {{"moved", m.softened->moved},
          {"max_quasiconformal_before", m.softened->before},
          {"max_quasiconformal", m.softened->after}};
}

Tree finite_tree(double x) {
  return std::isfinite(x) ? Tree(x) : Tree();
}

Tree balance_tree(MapRef m) {
  const auto& [balanced, before] = *m.balance;
  return {{"energy_before", finite_tree(balanced.before)},
          {"energy", finite_tree(balanced.after)},
          {"steps", balanced.steps},
          {"settled", balanced.settled},
          {"left_out", balanced.left_out},
          {"mean_area_error_before", before.mean_area_error},
          {"max_area_error_before", before.max_area_error},
          {"mean_angle_error_before", before.mean_angle_error},
          {"mean_quasiconformal_before", before.mean_quasi_conformal}};
}

Tree harmonic_residuals_tree(MapRef m) {
  const slit::Residuals& r = *m.residuals;
  return {{"period", r.period}, {"flux", r.flux}, {"harmonic", r.harmonic}, {"radius", r.radius}};
}

Tree quads_tree(MapRef m) {
  const auto& [mesh, q] = *m.quads;
  return {{"count", mesh.quads.size()},
          {"vertices", mesh.points.size()},
          {"thinnest_line", mesh.thinnest},
          {"mean_edge", q.mean_edge},
          {"mean_angle_error", q.mean_angle_error},
          {"max_angle_error", q.max_angle_error},
          {"mean_warp", q.mean_warp},
          {"max_warp", q.max_warp},
          {"min_edge", q.min_edge},
          {"max_edge", q.max_edge}};
}

Tree mended_tree(MapRef m) {
  return {{"flipped_before", m.mended->flipped_before}, {"intrinsic", m.mended->intrinsic}};
}

bool has_slits(MapRef m) {
  return m.slits.has_value();
}
bool has_rectangle(MapRef m) {
  return m.rectangle.has_value();
}
bool has_circles(MapRef m) {
  return m.circles && m.domain == MapDomain::circular;
}
/// Two loops or more became circles by Ricci flow.
bool has_flow_circles(MapRef m) {
  return m.circles && m.circles->by_ricci_flow && m.circles->loops.size() > 1;
}

FieldList<ConformalMap> shape_fields() {
  return {
      {{"outer", "", "the loop that became the outer circle or the outer rectangle", type::integer},
       [](MapRef m) -> Tree { return m.slits ? m.slits->circles.outer : m.rectangle->outer; },
       [](MapRef m) { return has_slits(m) || has_rectangle(m); }},
      {{"inner", "", "the loop that became the inner circle", type::integer},
       [](MapRef m) -> Tree { return m.slits->circles.inner; },
       has_slits},
      {{"modulus", "", "of the ring: the log of the ratio of its radii, the height of the cylinder",
        type::number},
       [](MapRef m) -> Tree { return m.slits->modulus; },
       has_slits},
      {{"modulus_bounds", "", "between these lies the modulus of the surface", type::list(type::number, 2)},
       [](MapRef m) -> Tree {
         return {m.slits->modulus, m.slits->modulus_bound};
       },
       has_slits},
      {{"radii", "", "of the ring: outer, inner",
        type::object({{"outer", type::number}, {"inner", type::number}})},
       [](MapRef m) -> Tree {
         return {{"outer", 1.0}, {"inner", std::exp(-m.slits->modulus)}};
       },
       [](MapRef m) { return has_slits(m) && m.slits->on_ring; }},
      {{"slits", "radians", "of each other loop: loop, radius or height (pure numbers), start, end",
        type::list(type::object({{"loop", type::integer},
                                 {"radius", type::number, type::sometimes},
                                 {"height", type::number, type::sometimes},
                                 {"start", type::number},
                                 {"end", type::number}}))},
       slits_tree,
       has_slits},
      {{"corners", "", "of the rectangle: the four vertices, counted from 0", type::list(type::integer, 4)},
       [](MapRef m) -> Tree { return m.rectangle->corners; },
       has_rectangle},
      {{"height", "", "of the rectangle, whose width is 1", type::number},
       [](MapRef m) -> Tree { return m.rectangle->height; },
       has_rectangle},
      {{"holes", "", "of the rectangle: loop, left, right, bottom, top",
        type::list(type::object({{"loop", type::integer},
                                 {"left", type::number},
                                 {"right", type::number},
                                 {"bottom", type::number},
                                 {"top", type::number}}))},
       rectangular_holes_tree,
       has_rectangle},
      {{"holonomy", "",
        "what would be 0 in a rectangle without rounding: how far a way around a hole leads from its start",
        type::number},
       [](MapRef m) -> Tree { return m.rectangle->holonomy; },
       has_rectangle},
      {{"residual", "radians", "of the rectangle: greatest deviation of a curvature", type::number},
       [](MapRef m) -> Tree { return m.rectangle->residual; },
       has_rectangle},
      {{"rounds", "", "of the rectangle: how often corners of holes were moved", type::integer},
       [](MapRef m) -> Tree { return m.rectangle->rounds; },
       has_rectangle},
      {{"circles", "", "of each loop: loop, center, radius, circularity (deviation of the loop, in radii)",
        type::list(type::object({{"loop", type::integer},
                                 {"center", type::list(type::number, 2)},
                                 {"radius", type::number},
                                 {"circularity", type::number}}))},
       circles_tree,
       has_circles},
      {{"circularity", "", "the greatest of all circles", type::number},
       [](MapRef m) -> Tree { return m.circles->circularity; },
       has_circles},
      {{"iterations", "", "rounds or steps until the circles were round", type::integer},
       [](MapRef m) -> Tree { return m.circles->rounds; },
       has_circles},
      {{"converged", "", "whether the circles or the rectangle were found", type::truth},
       [](MapRef m) -> Tree { return m.rectangle ? m.rectangle->found : m.circles->found; },
       [](MapRef m) { return has_circles(m) || has_rectangle(m); }}};
}

FieldList<ConformalMap> quality_fields() {
  return {
      {{"unflipped", "", "vertices moved so that fewer triangles are inverted: moved, farthest",
        type::object({{"moved", type::integer}, {"farthest", type::number}})},
       [](MapRef m) -> Tree {
         return {{"moved", m.unflipped->moved}, {"farthest", m.unflipped->farthest}};
       },
       [](MapRef m) { return m.unflipped.has_value(); }},
      {{"slit_ends", "",
        "vertices moved beside ends of slits: moved, and the greatest ratio of axes there, "
        "max_quasiconformal_before and max_quasiconformal",
        type::object({{"moved", type::integer},
                      {"max_quasiconformal_before", type::number},
                      {"max_quasiconformal", type::number}})},
       softened_tree,
       [](MapRef m) { return m.softened.has_value(); }},
      {{"balanced", "",
        "energy_before and energy (1: an isometry; null: not finite), steps, settled, left_out (triangles), "
        "and the means and the greatest of errors before",
        type::object({{"energy_before", type::or_null(type::number)},
                      {"energy", type::or_null(type::number)},
                      {"steps", type::integer},
                      {"settled", type::truth},
                      {"left_out", type::integer},
                      {"mean_area_error_before", type::number},
                      {"max_area_error_before", type::number},
                      {"mean_angle_error_before", type::number},
                      {"mean_quasiconformal_before", type::number}})},
       balance_tree,
       [](MapRef m) { return m.balance.has_value(); }},
      {{"max_angle_error", "radians", "the greatest over all corners", type::number},
       [](MapRef m) -> Tree { return m.distortion.max_angle_error; }},
      {{"mean_angle_error", "radians", "the mean over all corners", type::number},
       [](MapRef m) -> Tree { return m.distortion.mean_angle_error; }},
      {{"max_quasiconformal", "", "ratio of the axes of the ellipse that a circle becomes: the greatest",
        type::number},
       [](MapRef m) -> Tree { return m.distortion.max_quasi_conformal; }},
      {{"mean_quasiconformal", "", "the mean of these ratios by area", type::number},
       [](MapRef m) -> Tree { return m.distortion.mean_quasi_conformal; }},
      {{"max_area_error", "", "of the log of the ratio of areas: the greatest distance from the whole's",
        type::number},
       [](MapRef m) -> Tree { return m.distortion.max_area_error; }},
      {{"mean_area_error", "", "the mean of these distances by area", type::number},
       [](MapRef m) -> Tree { return m.distortion.mean_area_error; }},
      {{"flipped", "", "number of triangles inverted or flat", type::integer},
       [](MapRef m) -> Tree { return m.flipped(); }},
      {{"ears", "", "number of triangles with all corners on one loop, for which there is no room",
        type::integer},
       [](MapRef m) -> Tree { return m.distortion.ears; }},
      {{"crossings", "", "of a free domain: pairs of boundary edges that cross", type::integer},
       [](MapRef m) -> Tree { return *m.crossings; },
       [](MapRef m) { return m.crossings.has_value(); }},
      {{"residuals", "",
        "what would be 0 without rounding: period (radians), flux, harmonic, radius of the harmonic "
        "functions",
        type::object({{"period", type::number},
                      {"flux", type::number},
                      {"harmonic", type::number},
                      {"radius", type::number}})},
       harmonic_residuals_tree,
       [](MapRef m) { return m.residuals.has_value(); }},
      {{"quads", "",
        "count, vertices, thinnest_line (as a part of the distance wanted), edges in the mesh's own unit, "
        "errors of angles in radians, warps (distance of the diagonals over their length)",
        type::object({{"count", type::integer},
                      {"vertices", type::integer},
                      {"thinnest_line", type::number},
                      {"mean_edge", type::number},
                      {"mean_angle_error", type::number},
                      {"max_angle_error", type::number},
                      {"mean_warp", type::number},
                      {"max_warp", type::number},
                      {"min_edge", type::number},
                      {"max_edge", type::number}})},
       quads_tree,
       [](MapRef m) { return m.quads.has_value(); }},
      {{"center", "", "of a surface with one loop: the vertex that went to 0, counted from 0", type::integer},
       [](MapRef m) -> Tree { return m.surface.opened.number[*m.center]; },
       [](MapRef m) { return m.center.has_value(); }},
      {{"outer", "", "the same of circles by Ricci flow", type::integer},
       [](MapRef m) -> Tree { return m.circles->loops[0]; },
       has_flow_circles},
      {{"inner", "", "the same of circles by Ricci flow", type::integer},
       [](MapRef m) -> Tree { return m.circles->loops[1]; },
       has_flow_circles},
      {{"mended", "",
        "triangles would have been inverted and vertices were moved: flipped_before, and whether the map was "
        "solved on the intrinsic Delaunay triangulation",
        type::object({{"flipped_before", type::integer}, {"intrinsic", type::truth}})},
       mended_tree,
       [](MapRef m) { return m.mended.has_value(); }},
      {{"seconds", "seconds", "from the surface to the map, files apart", type::number},
       [](MapRef m) -> Tree { return m.seconds; }},
      {{"texture", "", "texture coordinates are scale times the place in the domain, plus shift",
        type::object({{"scale", type::number}, {"shift", type::number}})},
       [](MapRef m) -> Tree {
         return {{"scale", m.layout.texture_scale}, {"shift", m.layout.texture_shift}};
       }}};
}

FieldList<ConformalMap> all_map_fields() {
  FieldList<ConformalMap> fields{
      {notes_of<HoledSurface>().front(), [](MapRef m) -> Tree { return tree_of(m.surface)["boundaries"]; }},
      {{"domain", "", "cylindric, parallel, concentric, circular, rectangle or free",
        type::one_of({domain_names.begin(), domain_names.end()})},
       [](MapRef m) -> Tree { return name_of(m.domain); }}};
  for (const auto& part : {shape_fields(), quality_fields()})
    fields.insert(fields.end(), part.begin(), part.end());
  return fields;
}

} // namespace

const char* name_of(MapDomain domain) {
  return domain_names[static_cast<std::size_t>(domain)];
}

std::optional<MapDomain> map_domain_named(std::string_view name) {
  const auto* const found = std::find(domain_names.begin(), domain_names.end(), name);
  if (found == domain_names.end()) return std::nullopt;
  return static_cast<MapDomain>(found - domain_names.begin());
}

template <>
const FieldList<ConformalMap>& fields_of<ConformalMap>() {
  static const FieldList<ConformalMap> fields = all_map_fields();
  return fields;
}

template <>
std::vector<FieldNote> notes_of<ConformalMap>() {
  return each_once(notes_of(fields_of<ConformalMap>()));
}

} // namespace tetrarch::workshop
