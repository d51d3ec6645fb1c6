// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_files.hpp"

#include "hexahedra_files.hpp"

#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/product.hpp"

namespace tetrarch::program {
namespace {

using scene::SceneFormat;
using workshop::SolidProduct;

show::HexahedraData hexahedra_data(const workshop::MeasuredHexahedra& hexahedra) {
  show::HexahedraData data{hexahedra.quality.scaled_jacobian, {}};
  // Where some are left out a layer has no fixed number of cells, and polycubes have none; then -1 is told.
  const bool in_layers = hexahedra.grid && !hexahedra.grid->cells.empty() && hexahedra.of.left_out == 0;
  const int in_layer = in_layers ? static_cast<int>(hexahedra.grid->cells.size()) : 0;
  const int count = static_cast<int>(hexahedra.of.mesh.hexahedra.size());
  for (int k = 0; k < count; ++k) data.layer.push_back(in_layers ? k / in_layer : -1);
  return data;
}

scene::Scene product_scene(const SolidProduct& found, const std::string& title, bool in_domain,
                           bool with_cells) {
  scene::Scene scene{title, {}, {}, {}, {}};
  const product::Solid& solid = found.fibered->at.solid;
  const product::Partition& partition = found.fibered->at.partition;
  const workshop::FiberedSolid::Coordinates& coordinates = *found.fibered->coordinates;
  const std::vector<product::Point>& uvw = coordinates.of.uvw;
  scene.surfaces.push_back(in_domain ? show::domain_surface(solid, partition, uvw)
                                     : show::boundary_surface(solid, partition, uvw));
  if (!coordinates.fibers.empty())
    scene.tubes.push_back(show::fibers(in_domain ? coordinates.straight : coordinates.fibers));
  if (with_cells)
    scene.cells.push_back(in_domain ? show::domain_cells(solid, uvw) : show::product_cells(solid, uvw));
  return scene;
}

std::string product_page(const SolidProduct& found, const std::string& title) {
  scene::InfoTable table{"Product", {}, {}};
  for (const auto& [name, value] : rows_of(found)) table.rows.push_back({name, value});
  // How far walls are from conformal says nothing: u and v run along the floor.
  return scene::write_page(scene::TexturePage{title,
                                              {std::move(table)},
                                              product_scene(found, "solid", false, false),
                                              product_scene(found, "domain", true, false),
                                              "Fibres",
                                              1.0});
}

} // namespace

format::MeshDocument product_document(const SolidProduct& found, const ProductTitle& title) {
  format::MeshDocument document = document_of(found);
  add_provenance(document, {{"command", "product"}, {"input", title.input}, {"floor_map", title.floor_map}});
  return document;
}

std::string product_file(const std::string& path, const SolidProduct& found, const ProductTitle& title,
                         bool in_domain) {
  if (format::has_extension(path, ".html")) return product_page(found, title.input);
  if (found.hexahedra)
    return hexahedra_file(path, product_document(found, title), hexahedra_data(*found.hexahedra),
                          title.input);
  if (format::has_extension(path, ".mesh"))
    return format::write_medit(workshop::labelled_mesh(found.fibered->at));
  if (format::has_extension(path, ".json")) return write_mesh_json(product_document(found, title));
  const SceneFormat format = *scene::scene_format_for_extension(path);
  return scene::write_scene(product_scene(found, title.input, in_domain, format == SceneFormat::vtu), format);
}

} // namespace tetrarch::program
