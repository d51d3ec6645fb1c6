// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/openings.hpp"

#include "tetrarch/surface/open_handles.hpp"
#include "tetrarch/surface/slice.hpp"
#include "tetrarch/workshop/surface.hpp"
#include "tetrarch/workshop/text.hpp"

#include <utility>

namespace tetrarch::workshop {
namespace {

/// The first vertex of a loop, by its number.
long long first_number(const HoledSurface& surface, const surface::BoundaryLoop& loop) {
  return surface.opened.number[surface.mesh().surface.vertex(loop.sides.front())];
}

Tree boundaries_tree(const HoledSurface& surface) {
  Tree list = Tree::array();
  for (const surface::BoundaryLoop& loop : surface.loops)
    list.push_back({{"index", list.size()},
                    {"edges", loop.sides.size()},
                    {"length", loop.length},
                    {"area", loop.area},
                    {"vertex", first_number(surface, loop)}});
  return list;
}

} // namespace

HoledSurface opened(const NumberedSurface& surface, const Openings& openings, const Progress& progress) {
  std::vector<long long> numbers;
  numbers.reserve(surface.mesh.points.size());
  for (int v = 0; v < surface.mesh.surface.vertex_count(); ++v)
    numbers.push_back(surface.vertex_number(v) - surface.labels.first_number);
  return opened(HoledSurface{surface::OpenedMesh(surface.mesh, std::move(numbers)), {}}, openings, progress);
}

HoledSurface opened(HoledSurface surface, const Openings& openings, const Progress& progress) {
  surface::OpenedMesh& mesh = surface.opened;
  if (!openings.punched.empty()) mesh = surface::punch(mesh, openings.punched);
  if (!openings.sliced.empty()) mesh = surface::slice(mesh, openings.sliced);
  if (openings.handles) mesh = surface::open_handles(mesh, progress).opened;
  surface.loops = surface::boundary_loops(mesh.mesh);
  return surface;
}

Rows rows_of(const HoledSurface& surface) {
  Rows rows;
  for (const surface::BoundaryLoop& loop : surface.loops)
    rows.emplace_back("boundary loop " + std::to_string(rows.size()),
                      counted(static_cast<long long>(loop.sides.size()), "edge") + ", length " +
                          rounded(loop.length) + ", area " + rounded(loop.area) + ", through v" +
                          std::to_string(first_number(surface, loop)));
  return rows;
}

std::string text_of(const HoledSurface& surface) {
  return surface.loops.empty() ? "no boundary\n" : block(rows_of(surface));
}

template <>
const FieldList<HoledSurface>& fields_of<HoledSurface>() {
  static const FieldList<HoledSurface> fields{
      {{"boundaries", "",
        "loops by decreasing length, those punched and sliced included: index, edges, length, area (of the "
        "largest shadow), vertex (one of the loop, counted from 0)",
        type::list(type::object({{"index", type::integer},
                                 {"edges", type::integer},
                                 {"length", type::number},
                                 {"area", type::number},
                                 {"vertex", type::integer}}))},
       boundaries_tree}};
  return fields;
}

} // namespace tetrarch::workshop
