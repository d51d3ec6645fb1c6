// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/slit.hpp"

#include <array>
#include <vector>

namespace tetrarch::workshop {

format::MeshDocument document_of(const ConformalMap& found) {
  using enum format::MeshField::On;
  const surface::TriangleMesh& surface = found.surface.mesh();
  format::MeshDocument mesh;
  mesh.soup.points = surface.points;
  std::vector<std::array<double, 2>> places;
  std::vector<std::array<double, 2>> textures;
  for (int t = 0; t < surface.surface.triangle_count(); ++t) {
    mesh.soup.triangles.push_back(surface.surface.corners(t));
    for (const int place : found.layout.corners[t]) {
      places.push_back(found.layout.places[place]);
      textures.push_back(found.layout.textures[place]);
    }
  }
  mesh.fields = {field_of("place", triangle_corners, places),
                 field_of("texture", triangle_corners, textures)};
  for (const scene::Field& f : found.fields.vertices)
    mesh.fields.push_back(field_of(f.name, vertices, f.values));
  for (const scene::Field& f : found.fields.triangles)
    mesh.fields.push_back(field_of(f.name, triangles, f.values));
  return mesh;
}

} // namespace tetrarch::workshop
