// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_files.hpp"

#include "json.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/quads.hpp"

#include <array>
#include <utility>
#include <vector>

namespace tetrarch::program {
namespace {

std::string quads_file(const slit::QuadMesh& quads, scene::SceneFormat format) {
  return format == scene::SceneFormat::obj ? show::quads_obj(quads)
                                           : scene::write_scene(show::quad_scene(quads), format);
}

std::string slit_page(const MadeSlitMap& made, const SlitOptions& options) {
  scene::InfoTable table{"Map", {}, {}};
  for (const auto& [name, value] : made.report.rows) table.rows.push_back({name, value});
  return scene::write_page(scene::TexturePage{options.input + ": " + made.layout.name,
                                              {std::move(table)},
                                              show::textured_surface(made.mesh, made.layout),
                                              show::slit_domain(made.mesh, made.layout)});
}

} // namespace

format::MeshDocument slit_document(const MadeSlitMap& made, const SlitOptions& options) {
  using enum format::MeshField::On;
  format::MeshDocument mesh;
  mesh.soup.points = made.mesh.points;
  std::vector<std::array<double, 2>> places;
  std::vector<std::array<double, 2>> textures;
  for (int t = 0; t < made.mesh.surface.triangle_count(); ++t) {
    mesh.soup.triangles.push_back(made.mesh.surface.corners(t));
    for (const int place : made.layout.corners[t]) {
      places.push_back(made.layout.places[place]);
      textures.push_back(made.layout.textures[place]);
    }
  }
  mesh.fields = {field_of("place", triangle_corners, places),
                 field_of("texture", triangle_corners, textures)};
  for (const scene::Field& f : made.fields.vertices)
    mesh.fields.push_back(field_of(f.name, vertices, f.values));
  for (const scene::Field& f : made.fields.triangles)
    mesh.fields.push_back(field_of(f.name, triangles, f.values));
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "slit"}, {"input", options.input}, {"domain", made.layout.name}}.dump());
  return mesh;
}

std::string slit_file(const std::string& path, const MadeSlitMap& made, const SlitOptions& options) {
  if (format::has_extension(path, ".json")) return write_mesh_json(slit_document(made, options));
  if (format::has_extension(path, ".svg"))
    return scene::write_svg(show::slit_drawing(made.mesh, made.layout));
  if (format::has_extension(path, ".html")) return slit_page(made, options);
  const scene::SceneFormat format = *scene::scene_format_for_extension(path);
  if (made.quads) return quads_file(*made.quads, format);
  if (format == scene::SceneFormat::obj) return show::textured_obj(made.mesh, made.layout);
  return scene::write_scene(format == scene::SceneFormat::vtu
                                ? show::textured_surface(made.mesh, made.layout, made.fields)
                                : show::slit_domain(made.mesh, made.layout),
                            format);
}

} // namespace tetrarch::program
