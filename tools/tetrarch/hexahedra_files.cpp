// SPDX-License-Identifier: GPL-2.0-or-later
#include "hexahedra_files.hpp"

#include "tetrarch/format/medit.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"

namespace tetrarch::program {

void add_provenance(format::MeshDocument& document, const Json& provenance) {
  document.provenance = format::JsonValue::parse(provenance.dump());
}

std::string hexahedra_file(const std::string& path, const format::MeshDocument& document,
                           const show::HexahedraData& data, const std::string& title) {
  if (format::has_extension(path, ".mesh"))
    return format::write_medit_hexahedra(document.soup.points, document.hexahedra);
  if (format::has_extension(path, ".json")) return write_mesh_json(document);
  const scene::SceneFormat format = *scene::scene_format_for_extension(path);
  scene::Scene scene{title, {}, {}, {}, {}};
  scene.cells.push_back(show::hexahedra(document.soup.points, document.hexahedra, data));
  if (format != scene::SceneFormat::vtu) scene.tubes.push_back(show::outer_edges(scene.cells.front()));
  return scene::write_scene(scene, format);
}

} // namespace tetrarch::program
