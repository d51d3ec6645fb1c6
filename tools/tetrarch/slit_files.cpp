// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_files.hpp"

#include "json.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/quads.hpp"

#include <utility>

namespace tetrarch::program {
namespace {

std::string quads_file(const slit::QuadMesh& quads, scene::SceneFormat format) {
  return format == scene::SceneFormat::obj ? show::quads_obj(quads)
                                           : scene::write_scene(show::quad_scene(quads), format);
}

std::string slit_page(const workshop::ConformalMap& found, const std::string& input) {
  const surface::TriangleMesh& mesh = found.surface.mesh();
  scene::InfoTable table{"Map", {}, {}};
  for (const auto& [name, value] : map_rows(found)) table.rows.push_back({name, value});
  return scene::write_page(scene::TexturePage{input + ": " + found.layout.name,
                                              {std::move(table)},
                                              show::textured_surface(mesh, found.layout),
                                              show::slit_domain(mesh, found.layout)});
}

} // namespace

format::MeshDocument slit_document(const workshop::ConformalMap& found, const std::string& input) {
  format::MeshDocument mesh = document_of(found);
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "slit"}, {"input", input}, {"domain", found.layout.name}}.dump());
  return mesh;
}

std::string slit_file(const std::string& path, const workshop::ConformalMap& found,
                      const std::string& input) {
  const surface::TriangleMesh& mesh = found.surface.mesh();
  if (format::has_extension(path, ".json")) return write_mesh_json(slit_document(found, input));
  if (format::has_extension(path, ".svg")) return scene::write_svg(show::slit_drawing(mesh, found.layout));
  if (format::has_extension(path, ".html")) return slit_page(found, input);
  const scene::SceneFormat format = *scene::scene_format_for_extension(path);
  if (found.quads) return quads_file(found.quads->mesh, format);
  if (format == scene::SceneFormat::obj) return show::textured_obj(mesh, found.layout);
  return scene::write_scene(format == scene::SceneFormat::vtu
                                ? show::textured_surface(mesh, found.layout, found.fields)
                                : show::slit_domain(mesh, found.layout),
                            format);
}

} // namespace tetrarch::program
