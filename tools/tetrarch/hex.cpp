// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "embedding.hpp"
#include "hexahedra_files.hpp"
#include "in_file.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/workshop/filling.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace tetrarch::program {
namespace {

struct HexArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string start = "grid";
  std::string polycube_output;
  std::optional<double> edge;
  std::optional<std::int64_t> cells;
  double sharp = hex::FillOptions{}.sharp;
  double volume_tolerance = hex::FillOptions{}.volume_tolerance;
  double hausdorff_tolerance = hex::FillOptions{}.hausdorff_tolerance;
  Doctor doctor;
};

product::Solid read_filled(const HexArguments& options, Result& result, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  for (std::string& done : mend(soup, options.doctor)) result.warnings.push_back(std::move(done));
  return in_file(options.input, [&] { return workshop::solid_of(std::move(soup), context.progress); });
}

hex::FillOptions wanted(const HexArguments& options, const product::Solid& solid, const Context& context) {
  hex::FillOptions result;
  result.edge = options.edge;
  result.cells = options.cells;
  result.sharp = options.sharp;
  result.volume_tolerance = options.volume_tolerance;
  result.hausdorff_tolerance = options.hausdorff_tolerance;
  const std::int64_t cells = options.cells.value_or(hex::usual_cells);
  const double edge = options.edge                  ? *options.edge
                      : options.start == "polycube" ? workshop::polycube_edge_for(solid, cells)
                                                    : hex::edge_for(solid, cells);
  constexpr double bytes_of_gigabyte = 1e9;
  result.most_bytes = bytes_of_gigabyte * allowed_gigabytes(context);
  require_memory(options.edge ? "--edge " + rounded(edge) : "--cells " + std::to_string(cells),
                 hex::bytes_for_edge(solid, edge), allowed_gigabytes(context));
  return result;
}

void add_hex_files(Result& result, const workshop::FilledSolid& found, const HexArguments& options) {
  if (options.outputs.empty()) return;
  format::MeshDocument document = document_of(found);
  add_provenance(document, {{"command", "hex"}, {"input", options.input}});
  const product::HexQuality& quality = found.search.best->quality;
  const std::vector<int> no_layers(document.hexahedra.size(), -1);
  for (const std::string& path : options.outputs)
    result.files.push_back(
        {path, hexahedra_file(path, document, {quality.scaled_jacobian, no_layers}, options.input)});
}

void require_known_extension(const std::string& path) {
  if (format::has_extension(path, ".mesh") || format::has_extension(path, ".json") ||
      scene::scene_format_for_extension(path))
    return;
  throw InputError({path, 0},
                   "no known format of hexahedra (expected .mesh, .vtu, .json, .glb, .ply or .obj)");
}

Result run_hex(const HexArguments& options, const Context& context) {
  if (options.edge && options.cells) throw InputError("--edge and --cells exclude each other");
  for (const std::string& path : options.outputs) require_known_extension(path);
  if (!options.polycube_output.empty() && !format::has_extension(options.polycube_output, ".json"))
    throw InputError({options.polycube_output, 0}, "no known format of polycubes (expected .json)");
  if (!options.polycube_output.empty() && options.start != "polycube")
    throw InputError("--polycube-output needs --start polycube");
  Result result;
  const product::Solid solid = read_filled(options, result, context);
  const hex::FillOptions wish = wanted(options, solid, context);
  const workshop::FilledSolid found = options.start == "polycube"
                                          ? workshop::polycube_filled_solid(solid, wish, context.progress)
                                          : workshop::filled_solid(solid, wish, context.progress);
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = block(rows_of(found));
  if (found.verdict() != workshop::Verdict::yes)
    result.warnings.push_back("the result is not to be relied on: " + joined(found.doubts(), "; "));
  if (found.search.best) add_hex_files(result, found, options);
  if (!options.polycube_output.empty() && found.polycube) {
    format::MeshDocument document = document_of(*found.polycube);
    add_provenance(document, {{"command", "hex"}, {"input", options.input}});
    result.files.push_back({options.polycube_output, write_mesh_json(document)});
  }
  return result;
}

} // namespace

Run declare_hex(OptionTable& table) {
  const auto o = std::make_shared<HexArguments>();
  table.add("SOLID", o->input, "tetrahedra, or a closed surface, which TetGen fills; one boundary component")
      .required();
  table
      .add("-o,--output", o->outputs,
           "write hexahedra (.mesh, .vtu, .json), or what is to be seen of them (.glb, .ply, .obj); may be "
           "repeated")
      .output_file();
  table
      .add("--start", o->start,
           "what hexahedra begin with: cells of a grid, or cubes of a polycube that is made for the solid")
      .one_of({"grid", "polycube"})
      .with_default();
  table
      .add("--polycube-output", o->polycube_output,
           "write the polycube (.json): tetrahedra at their places on it, labels of its boundary, and the "
           "places "
           "in the solid")
      .output_file();
  table
      .add("--cells", o->cells,
           "about how many hexahedra to make (default: " + std::to_string(hex::usual_cells) +
               "); more, if the solid's parts are thin")
      .in_range(1, 2e9);
  table.add("--edge", o->edge, "wanted length of edges").positive();
  table
      .add("--sharp", o->sharp,
           "degrees between the normals of two triangles, from which their edge is kept as a ridge")
      .in_range(1.0, 180.0)
      .with_default();
  table
      .add("--volume-tolerance", o->volume_tolerance,
           "greatest relative difference of volumes; beyond, the exit status is 4")
      .in_range(0.0, 1.0)
      .with_default();
  table
      .add("--hausdorff-tolerance", o->hausdorff_tolerance,
           "greatest distance between the surfaces in terms of the diagonal of the solid's box; beyond, the "
           "exit status is 4")
      .in_range(0.0, 1.0)
      .with_default();
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_hex(*o, context); };
}

} // namespace tetrarch::program
