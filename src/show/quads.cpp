// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/quads.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/palette.hpp"

namespace tetrarch::show {

using namespace scene;

std::string quads_obj(const slit::QuadMesh& mesh) {
  std::string out;
  const auto append_line = [&out](char keyword, const auto& numbers, int first) {
    out += keyword;
    for (const auto x : numbers) {
      out += ' ';
      format::append_number(out, x + first);
    }
    out += '\n';
  };
  for (const Point& point : mesh.points) append_line('v', point, 0);
  for (const auto& quad : mesh.quads) append_line('f', quad, 1);
  return out;
}

Scene quad_scene(const slit::QuadMesh& mesh) {
  constexpr Color pale{225, 225, 220};
  Scene scene;
  scene.title = "quads";
  Tubes tubes;
  tubes.name = "lines";
  Data line{"line", {}};
  for (const slit::QuadEdge& e : edges(mesh)) {
    tubes.points.insert(tubes.points.end(), {mesh.points[e.from], mesh.points[e.to]});
    tubes.starts.push_back(static_cast<int>(tubes.points.size()));
    line.values.push_back(static_cast<int>(e.line));
    tubes.colors.push_back(qualitative(line.values.back()));
  }
  // A tenth of a quad, if they were all of one size.
  const double radius = numeric::extent(mesh.points) / (10 * static_cast<double>(mesh.angles.size()));
  tubes.radii.assign(tubes.points.size(), radius);
  tubes.data.push_back(std::move(line));
  scene.tubes.push_back(std::move(tubes));
  Surface surface;
  surface.name = scene.title;
  surface.points = mesh.points;
  for (const auto& [a, b, c, d] : mesh.quads) {
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({a, c, d});
  }
  surface.colors = {pale};
  scene.surfaces.push_back(std::move(surface));
  return scene;
}

} // namespace tetrarch::show
