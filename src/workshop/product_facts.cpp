// SPDX-License-Identifier: GPL-2.0-or-later
// What is said of a product: rows, fields and the file. Vertices go by the names of the input; those put in
// by splitting edges have the numbers after them. Flipped tetrahedra go by their numbers in the files
// written.
#include "tetrarch/workshop/product.hpp"

#include "hexahedra_facts.hpp"
#include "question.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/text.hpp"

#include <utility>

namespace tetrarch::workshop {
namespace {

using product::Point;
using Sides = const SolidSides&;
using Fibered = const FiberedSolid&;

/// Of long lists, so many are told.
constexpr std::size_t most_told = 10;

/// The first of them, and how many more there are; no row where there are none.
template <class Item, class Text>
void add_places(Rows& rows, const std::vector<Item>& items, const Text& text) {
  if (items.empty()) return;
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < items.size() && k < most_told; ++k) texts.push_back(text(items[k]));
  rows.emplace_back("",
                    joined(texts, ", ") + (items.size() > most_told
                                               ? ", and " + std::to_string(items.size() - most_told) + " more"
                                               : ""));
}

std::string count_text(std::size_t count, const char* noun) {
  return counted(static_cast<long long>(count), noun);
}

std::vector<int> wall_sizes(Sides s) {
  return {s.triangles.begin() + product::first_wall, s.triangles.end()};
}

Rows rows_of(Sides s) {
  if (!s.is_divided()) return {{"solid", counted(s.tetrahedra, "tetrahedron")}};
  std::vector<std::string> walls;
  for (const int size : wall_sizes(s)) walls.push_back(std::to_string(size));
  return {{"solid", counted(s.tetrahedra, "tetrahedron") + ", " + counted(s.holes(), "hole")},
          {"partition", s.how},
          {"triangles", "floor " + std::to_string(s.triangles[product::floor_patch]) + ", ceiling " +
                            std::to_string(s.triangles[product::ceiling_patch]) + ", walls " +
                            joined(walls, ", ")}};
}

Question product_of(Fibered f) {
  return {"a product", "no critical point, no flipped tetrahedron, and every fiber arrives both ways",
          f.doubts()};
}

void add_floor_rows(Rows& rows, const product::FloorMap& floor) {
  rows.emplace_back("floor", std::string(floor.found ? "found" : "not found within the budget") +
                                 ", flipped " + std::to_string(floor.flipped) + " of " +
                                 counted(floor.mesh.surface.triangle_count(), "triangle"));
  if (floor.height > 0) rows.emplace_back("rectangle", "1 x " + fixed(floor.height, 6));
}

void add_field_rows(Rows& rows, Fibered f) {
  rows.emplace_back("height", fixed(f.height, 6));
  rows.emplace_back("edges split", std::to_string(f.at.splits));
  rows.emplace_back(
      "field", "residual " + scientific(f.field.residual, 1) + ", " +
                   (f.field.iterations > 0 ? counted(f.field.iterations, "iteration") : "direct") + ", " +
                   counted(f.field.negative_weights, "negative weight") + (f.clamped ? ", clamped" : ""));
}

void add_critical_rows(Rows& rows, Fibered f) {
  const product::CriticalPlaces& places = f.critical;
  rows.emplace_back("critical places", places.none()
                                           ? "none"
                                           : count_text(places.flat.size(), "flat tetrahedron") + ", " +
                                                 count_text(places.vertices.size(), "critical vertex"));
  add_places(rows, places.vertices, [&](const product::CriticalVertex& v) {
    return "v" + std::to_string(v.vertex) + " " + text_of(f.at.solid.point(v.vertex));
  });
}

Point center_of(const product::Solid& solid, int tetrahedron) {
  Point center{};
  for (const int v : solid.corners(tetrahedron))
    for (std::size_t c = 0; c < 3; ++c) center[c] += solid.point(v)[c] / 4;
  return center;
}

void add_stuck_rows(Rows& rows, const product::Coordinates& of) {
  rows.emplace_back("stuck fibres",
                    std::to_string(of.stuck.size()) +
                        (of.by_gradient > 0 ? ", by the gradient " + std::to_string(of.by_gradient) : ""));
  add_places(rows, of.stuck, [](const product::StuckFiber& s) {
    return "v" + std::to_string(s.vertex) + " at " + text_of(s.at);
  });
}

void add_quality_rows(Rows& rows, const product::Solid& solid, const product::Quality& quality) {
  rows.emplace_back("flipped", count_text(quality.flipped.size(), "tetrahedron"));
  add_places(rows, quality.flipped,
             [&](int t) { return "t" + std::to_string(t) + " " + text_of(center_of(solid, t)); });
  rows.emplace_back("w to u and v", "cosine " + scientific(quality.mean_orthogonality_error, 1) +
                                        " on average, " + scientific(quality.max_orthogonality_error, 1) +
                                        " at most");
  rows.emplace_back("u to v", "cosine " + scientific(quality.mean_uv, 1) + " on average, " +
                                  scientific(quality.max_uv, 1) + " at most");
}

void add_confirmation_rows(Rows& rows, const product::Confirmation& c) {
  rows.emplace_back("the opposite way", scientific(c.mean_distance, 1) + " mean edges off on average, " +
                                            scientific(c.max_distance, 1) + " at most (v" +
                                            std::to_string(c.worst) + "), " + counted(c.off, "vertex") +
                                            " off by more than an edge, " + std::to_string(c.not_arrived) +
                                            " lost on the way");
}

Rows rows_of(Fibered f) {
  Rows rows;
  add_floor_rows(rows, f.floor);
  add_field_rows(rows, f);
  add_critical_rows(rows, f);
  if (!f.coordinates) return rows;
  add_stuck_rows(rows, f.coordinates->of);
  add_quality_rows(rows, f.at.solid, f.coordinates->quality);
  add_confirmation_rows(rows, f.coordinates->confirmation);
  rows.push_back(row_of(product_of(f)));
  return rows;
}

Tree partition_tree(Sides s) {
  return {{"how", s.how},
          {"floor", s.triangles[product::floor_patch]},
          {"ceiling", s.triangles[product::ceiling_patch]},
          {"walls", wall_sizes(s)}};
}

Tree rectangle_tree(Fibered f) {
  Tree holes = Tree::array();
  for (const auto& [low, high] : f.floor.rectangles)
    holes.push_back({low.real(), low.imag(), high.real(), high.imag()});
  return {{"height", f.floor.height}, {"holes", std::move(holes)}};
}

Tree critical_tree(Fibered f) {
  Tree vertices = Tree::array();
  for (const product::CriticalVertex& v : f.critical.vertices)
    vertices.push_back({{"vertex", v.vertex},
                        {"at", f.at.solid.point(v.vertex)},
                        {"lower", v.lower},
                        {"upper", v.upper},
                        {"on_wall", v.on_wall}});
  return {{"flat_tetrahedra", f.critical.flat}, {"vertices", std::move(vertices)}};
}

Tree stuck_tree(Fibered f) {
  Tree list = Tree::array();
  for (const product::StuckFiber& s : f.coordinates->of.stuck)
    list.push_back({{"vertex", s.vertex},
                    {"at", s.at},
                    {"why", s.end == product::FiberEnd::budget ? "too many steps" : "no way on"}});
  return list;
}

Tree flipped_tree(Fibered f) {
  Tree list = Tree::array();
  for (const int t : f.coordinates->quality.flipped)
    list.push_back({{"tetrahedron", t}, {"at", center_of(f.at.solid, t)}});
  return list;
}

Tree confirmation_tree(Fibered f) {
  const product::Confirmation& c = f.coordinates->confirmation;
  return {{"mean_distance", c.mean_distance},
          {"max_distance", c.max_distance},
          {"worst_vertex", c.worst},
          {"farther_than_an_edge", c.off},
          {"not_arrived", c.not_arrived}};
}

bool has_coordinates(Fibered f) {
  return f.coordinates.has_value();
}

FieldList<FiberedSolid> floor_and_field_fields() {
  using F = Fibered;
  return {
      {{"floor_found", "", "whether the floor's map was found within the budget", type::truth},
       [](F f) -> Tree { return f.floor.found; }},
      {{"floor_flipped", "", "triangles of the floor that its map turns over", type::integer},
       [](F f) -> Tree { return f.floor.flipped; }},
      {{"rectangle", "",
        "the floor's image, of width 1: height, and each of its holes as [u, v, u, v], the lower left "
        "and the "
        "upper right corner",
        type::object({{"height", type::number}, {"holes", type::list(type::list(type::number, 4))}})},
       rectangle_tree,
       [](F f) { return f.floor.height > 0; }},
      {{"height", "", "of the domain above the unit disk, or above a rectangle of width 1", type::number},
       [](F f) -> Tree { return f.height; }},
      {{"splits", "", "edges split because they were short cuts between vertices of one base", type::integer},
       [](F f) -> Tree { return f.at.splits; }},
      {{"flow", "", "of the field from ceiling to floor: its energy over the height", type::number},
       [](F f) -> Tree { return f.field.flow; }},
      {{"residual", "", "the greatest flow left at a vertex, in terms of the whole flow", type::number},
       [](F f) -> Tree { return f.field.residual; }},
      {{"iterations", "", "of conjugate gradients; 0: the equations were solved directly", type::integer},
       [](F f) -> Tree { return f.field.iterations; }},
      {{"negative_weights", "", "edges of negative cotangent weight, clamped or not", type::integer},
       [](F f) -> Tree { return f.field.negative_weights; }},
      {{"weights", "", "cotangent or clamped", type::one_of({"cotangent", "clamped"})},
       [](F f) -> Tree { return f.clamped ? "clamped" : "cotangent"; }},
      {{"critical", "",
        "where the field has no direction: flat_tetrahedra, and vertices with the parts of their links "
        "below (lower) and above (upper)",
        type::object({{"flat_tetrahedra", type::list(type::integer)},
                      {"vertices", type::list(type::object({{"vertex", type::integer},
                                                            {"at", type::list(type::number, 3)},
                                                            {"lower", type::integer},
                                                            {"upper", type::integer},
                                                            {"on_wall", type::truth}}))}})},
       critical_tree}};
}

FieldList<FiberedSolid> coordinates_fields() {
  using F = Fibered;
  return {{{"stuck_fibers", "", "fibers that failed to reach the floor", type::integer},
           [](F f) -> Tree { return f.coordinates->of.stuck.size(); },
           has_coordinates},
          {{"stuck", "", "each of them: the vertex where it began, the point at which it ended, why",
            type::list(type::object({{"vertex", type::integer},
                                     {"at", type::list(type::number, 3)},
                                     {"why", type::one_of({"too many steps", "no way on"})}}))},
           stuck_tree,
           has_coordinates},
          {{"fibers_by_gradient", "", "fibers for which smoothed vectors led nowhere", type::integer},
           [](F f) -> Tree { return f.coordinates->of.by_gradient; },
           has_coordinates},
          {{"flipped", "", "tetrahedra whose image in the domain has no positive volume", type::integer},
           [](F f) -> Tree { return f.coordinates->quality.flipped.size(); },
           has_coordinates},
          {{"flipped_tetrahedra", "", "each of them: tetrahedron, numbered as in the files written, and at",
            type::list(type::object({{"tetrahedron", type::integer}, {"at", type::list(type::number, 3)}}))},
           flipped_tree,
           has_coordinates},
          {{"orthogonality_error", "cosine", "of w to u and v, the mean by volume; 0: right angles",
            type::number},
           [](F f) -> Tree { return f.coordinates->quality.mean_orthogonality_error; },
           has_coordinates},
          {{"max_orthogonality_error", "cosine", "the same, the greatest", type::number},
           [](F f) -> Tree { return f.coordinates->quality.max_orthogonality_error; },
           has_coordinates},
          {{"uv_error", "cosine", "of u to v, the mean by volume", type::number},
           [](F f) -> Tree { return f.coordinates->quality.mean_uv; },
           has_coordinates},
          {{"max_uv_error", "cosine", "the same, the greatest", type::number},
           [](F f) -> Tree { return f.coordinates->quality.max_uv; },
           has_coordinates},
          {{"opposite_way", "mean edge",
            "how far from a vertex the way back from the floor ends: mean_distance, max_distance, "
            "worst_vertex, farther_than_an_edge (vertices) and not_arrived (fibers)",
            type::object({{"mean_distance", type::number},
                          {"max_distance", type::number},
                          {"worst_vertex", type::integer},
                          {"farther_than_an_edge", type::integer},
                          {"not_arrived", type::integer}})},
           confirmation_tree,
           has_coordinates},
          {{"product", "", "whether the coordinates show a product: verdict (yes or undecided) and doubts",
            question_type()},
           [](F f) { return tree_of(product_of(f)); },
           has_coordinates}};
}

void append(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

} // namespace

Rows rows_of(const SolidProduct& found) {
  Rows rows;
  if (found.why_undivided.empty()) append(rows, rows_of(found.sides));
  if (found.is_of_polycube()) append(rows, rows_of(*found.hexahedra));
  if (found.fibered) append(rows, rows_of(*found.fibered));
  if (found.hexahedra && !found.is_of_polycube()) append(rows, rows_of(*found.hexahedra));
  return rows;
}

format::MeshDocument document_of(const SolidProduct& found) {
  if (found.hexahedra) return document_of(found.hexahedra->of.mesh, found.hexahedra->quality.scaled_jacobian);
  if (!found.fibered || !found.fibered->coordinates)
    throw PreconditionError("document_of: there are neither hexahedra nor coordinates");
  format::MeshDocument document;
  document.soup = labelled_mesh(found.fibered->at);
  document.fields = {field_of("uvw", format::MeshField::On::vertices, found.fibered->coordinates->of.uvw)};
  return document;
}

template <>
const FieldList<SolidSides>& fields_of<SolidSides>() {
  static const FieldList<SolidSides> fields{
      {{"holes", "", "of floor and ceiling: inner walls", type::integer},
       [](Sides s) -> Tree { return s.holes(); },
       [](Sides s) { return s.is_divided(); }},
      {{"tetrahedra", "", "of the solid, those of edges split by the search for a partition included",
        type::integer},
       [](Sides s) -> Tree { return s.tetrahedra; }},
      {{"partition", "", "how it was found; triangles of floor and ceiling, and of each of the walls",
        type::object({{"how", type::text},
                      {"floor", type::integer},
                      {"ceiling", type::integer},
                      {"walls", type::list(type::integer)}})},
       partition_tree,
       [](Sides s) { return s.is_divided(); }}};
  return fields;
}

template <>
const FieldList<FiberedSolid>& fields_of<FiberedSolid>() {
  static const FieldList<FiberedSolid> fields = [] {
    FieldList<FiberedSolid> all = floor_and_field_fields();
    for (const Field<FiberedSolid>& field : coordinates_fields()) all.push_back(field);
    return all;
  }();
  return fields;
}

template <>
const FieldList<SolidProduct>& fields_of<SolidProduct>() {
  static const FieldList<SolidProduct> fields{{{"seconds", "seconds", "time taken", type::number},
                                               [](const SolidProduct& p) -> Tree { return p.seconds; }}};
  return fields;
}

template <>
Tree tree_of<SolidProduct>(const SolidProduct& found) {
  Tree tree = Tree::object();
  if (found.why_undivided.empty()) tree.update(tree_of(found.sides));
  if (found.is_of_polycube()) tree.update(tree_of(*found.hexahedra));
  if (found.fibered) tree.update(tree_of(*found.fibered));
  if (found.hexahedra && !found.is_of_polycube()) tree.update(tree_of(*found.hexahedra));
  tree["seconds"] = found.seconds;
  return tree;
}

template <>
std::vector<FieldNote> notes_of<SolidProduct>() {
  std::vector<FieldNote> notes;
  for (const auto& part : {notes_of<SolidSides>(), notes_of<FiberedSolid>(), notes_of<MeasuredHexahedra>()})
    notes = both_of(std::move(notes), sometimes(part));
  return both_of(std::move(notes), notes_of(fields_of<SolidProduct>()));
}

} // namespace tetrarch::workshop
