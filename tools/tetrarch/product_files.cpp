// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_files.hpp"

#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/product.hpp"

namespace tetrarch::program {
namespace {

using scene::SceneFormat;

scene::Scene hexahedra_scene(const SolidProduct& made, const std::string& title, SceneFormat format) {
  show::HexahedraData data{made.scaled_jacobian, {}};
  // Where some are left out a layer has no fixed number of cells, and polycubes have none; then -1 is told.
  const std::size_t count = made.hexahedra->mesh.hexahedra.size();
  for (std::size_t k = 0; k < count; ++k)
    data.layer.push_back(made.cells > 0 && made.hexahedra->left_out == 0 ? static_cast<int>(k) / made.cells
                                                                         : -1);
  scene::Scene scene{title, {}, {}, {}, {}};
  scene.cells.push_back(show::hexahedra(made.hexahedra->mesh.points, made.hexahedra->mesh.hexahedra, data));
  if (format != SceneFormat::vtu) scene.tubes.push_back(show::outer_edges(scene.cells.front()));
  return scene;
}

scene::Scene product_scene(const SolidProduct& made, const std::string& title, bool in_domain,
                           bool with_cells) {
  scene::Scene scene{title, {}, {}, {}, {}};
  const product::Solid& solid = made.at.solid;
  scene.surfaces.push_back(in_domain ? show::domain_surface(solid, made.at.partition, made.uvw)
                                     : show::boundary_surface(solid, made.at.partition, made.uvw));
  if (!made.fibers.empty()) scene.tubes.push_back(show::fibers(in_domain ? made.straight : made.fibers));
  if (with_cells)
    scene.cells.push_back(in_domain ? show::domain_cells(solid, made.uvw)
                                    : show::product_cells(solid, made.uvw));
  return scene;
}

/// The tetrahedra, those of edges split included, and the boundary with its patches: 1 floor, 2 ceiling, 3
/// and on walls.
format::Soup labelled_mesh(const SolidProduct& made) {
  const product::Solid& solid = made.at.solid;
  format::Soup soup;
  soup.points = solid.mesh.points;
  soup.tetrahedra = solid.mesh.tetrahedra;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    soup.triangles.push_back({solid.corner(t, 0), solid.corner(t, 1), solid.corner(t, 2)});
    soup.triangle_tags.push_back(made.at.partition.patch[t] + 1);
  }
  return soup;
}

std::string product_page(const SolidProduct& made, const std::string& title) {
  scene::InfoTable table{"Product", {}, {}};
  for (const auto& [name, value] : made.report.rows) table.rows.push_back({name, value});
  // How far walls are from conformal says nothing: u and v run along the floor.
  return scene::write_page(scene::TexturePage{title,
                                              {std::move(table)},
                                              product_scene(made, "solid", false, false),
                                              product_scene(made, "domain", true, false),
                                              "Fibres",
                                              1.0});
}

} // namespace

format::MeshDocument product_document(const SolidProduct& made, const ProductTitle& title) {
  using On = format::MeshField::On;
  format::MeshDocument mesh;
  if (made.hexahedra) {
    mesh.soup.points = made.hexahedra->mesh.points;
    mesh.hexahedra = made.hexahedra->mesh.hexahedra;
    mesh.fields = {field_of("scaled_jacobian", On::hexahedra, made.scaled_jacobian)};
  } else {
    mesh.soup = labelled_mesh(made);
    mesh.fields = {field_of("uvw", On::vertices, made.uvw)};
  }
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "product"}, {"input", title.input}, {"floor_map", title.floor_map}}.dump());
  return mesh;
}

std::string product_file(const std::string& path, const SolidProduct& made, const ProductTitle& title,
                         bool in_domain) {
  if (format::has_extension(path, ".mesh"))
    return made.hexahedra
               ? format::write_medit_hexahedra(made.hexahedra->mesh.points, made.hexahedra->mesh.hexahedra)
               : format::write_medit(labelled_mesh(made));
  if (format::has_extension(path, ".json")) return write_mesh_json(product_document(made, title));
  if (format::has_extension(path, ".html")) return product_page(made, title.input);
  const SceneFormat format = *scene::scene_format_for_extension(path);
  return scene::write_scene(made.hexahedra
                                ? hexahedra_scene(made, title.input, format)
                                : product_scene(made, title.input, in_domain, format == SceneFormat::vtu),
                            format);
}

} // namespace tetrarch::program
