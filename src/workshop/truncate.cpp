// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/truncate.hpp"

#include "move_run.hpp"
#include "with_info.hpp"

#include "tetrarch/workshop/text.hpp"

#include <utility>

namespace tetrarch::workshop {
namespace {

bool is_filled_in(const moves::BoundaryImage& image) {
  return image.vertex.tet < 0;
}

std::string image_text(const moves::BoundaryImage& image) {
  if (is_filled_in(image)) return image.type.str() + ", filled in";
  return image.type.str() + ", at vertex " + std::to_string(image.vertex.vertex) + " of tetrahedron " +
         std::to_string(image.vertex.tet);
}

Tree boundary_map_tree(const Truncation& t) {
  Tree list = Tree::array();
  for (const moves::BoundaryImage& image : t.boundary)
    list.push_back({{"input_component", list.size()},
                    {"type", image.type.str()},
                    {"triangles", image.triangles},
                    {"vertex", is_filled_in(image) ? Tree() : Tree{image.vertex.tet, image.vertex.vertex}}});
  return list;
}

Tree steps_tree(const Truncation& t) {
  Tree list = Tree::array();
  for (const moves::TruncateStep& s : t.steps)
    list.push_back(
        {{"name", s.name}, {"tetrahedra", s.tetrahedra}, {"vertices", s.vertices}, {"edges", s.edges}});
  return list;
}

} // namespace

std::vector<std::string> Truncation::remarks() const {
  if (finite_vertices == 0) return {};
  return {"the result has " + counted(finite_vertices, "finite vertex") +
          ", because there is no other boundary to truncate at"};
}

Truncation truncate(const Triangulation& tri, const TruncateOptions& options, const Progress& progress) {
  Truncation found;
  const moves::TruncateOptions how{options.keep_spheres, moves_for(tri, options, found)};
  moves::Truncation made = timed(found, [&] { return moves::truncate(tri, how, progress); });
  found.triangulation = std::move(made.tri);
  found.boundary = std::move(made.boundary);
  found.steps = std::move(made.steps);
  found.finite_vertices = made.finite_vertices;
  found.info = info(found.triangulation, options.name, false, progress);
  return found;
}

Rows rows_of(const Truncation& found, const std::string& signature) {
  Rows rows;
  for (const moves::TruncateStep& s : found.steps)
    rows.emplace_back(rows.empty() ? "steps" : "", counted(s.tetrahedra, "tetrahedron") + ", " +
                                                       counted(s.vertices, "vertex") + ": " + s.name);
  for (std::size_t k = 0; k < found.boundary.size(); ++k)
    rows.emplace_back("component " + std::to_string(k), image_text(found.boundary[k]));
  const Rows info = rows_of(found.info, signature);
  rows.insert(rows.end(), info.begin(), info.end());
  return rows;
}

template <>
const FieldList<Truncation>& fields_of<Truncation>() {
  using T = const Truncation&;
  static const auto run = fields_of_run<Truncation>();
  static const FieldList<Truncation> fields{
      {{"boundary_map", "",
        "of each component of the input's boundary: input_component, type, triangles, and the vertex that is "
        "truncated along it, as [tetrahedron, vertex]; null: it was filled in",
        type::list(type::object({{"input_component", type::integer},
                                 {"type", type::text},
                                 {"triangles", type::integer},
                                 {"vertex", type::or_null(type::list(type::integer, 2))}}))},
       boundary_map_tree},
      {{"finite_vertices", "", "number of vertices that are not to be truncated", type::integer},
       [](T t) -> Tree { return t.finite_vertices; }},
      {{"steps", "", "name, tetrahedra, vertices and edges after each step of the conversion",
        type::list(type::object({{"name", type::text},
                                 {"tetrahedra", type::integer},
                                 {"vertices", type::integer},
                                 {"edges", type::integer}}))},
       steps_tree},
      run[0],
      run[1]};
  return fields;
}

template <>
Tree tree_of<Truncation>(const Truncation& found) {
  return tree_with_info(found);
}

template <>
std::vector<FieldNote> notes_of<Truncation>() {
  return notes_with_info<Truncation>();
}

} // namespace tetrarch::workshop
