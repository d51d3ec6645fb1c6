// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "in_file.hpp"
#include "input.hpp"
#include "output.hpp"
#include "product_files.hpp"
#include "product_partition.hpp"
#include "text.hpp"
#include "vertex_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/workshop/product.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

struct ProductArguments {
  std::string input;
  std::vector<std::string> outputs;
  PartitionOptions partition;
  std::string floor_map = "circular";
  std::string corners;
  std::string follow = "smoothed";
  std::string show = "solid";
  std::string weights = "auto";
  workshop::PolycubeImage polycube; ///< its name, a file, and its lattice; no name: none
  workshop::ProductOptions how;     ///< what is an option as it is
  Doctor doctor;
};

void check_outputs(const ProductArguments& options) {
  for (const std::string& path : options.outputs) {
    if (!scene::scene_format_for_extension(path) && !format::has_extension(path, ".json") &&
        !format::has_extension(path, ".mesh") && !format::has_extension(path, ".html"))
      throw InputError({path, 0}, "this command writes no file with this extension (expected .json, .vtu, "
                                  ".mesh, .glb, .ply, .obj or .html)");
  }
  const workshop::ProductOptions& how = options.how;
  const bool is_polycube = !options.polycube.name.empty();
  if (how.across == 0 && how.layers > 0) throw InputError("--layers needs --hex");
  if (how.across > 0 && is_polycube)
    throw InputError("--hex and --polycube exclude each other: expected one of them");
  if (how.across == 0 && !is_polycube && how.hexahedra.smooth)
    throw InputError("--smooth needs --hex or --polycube");
  if (options.floor_map != "rectangle" && !options.corners.empty())
    throw InputError("--corners needs --floor-map rectangle");
}

/// Tetrahedra without volume are told by the numbers and lines of the file.
void refuse_volumes(const format::Soup& soup, const doctor::Report& report) {
  const auto bad = [](const doctor::Finding& f) {
    return f.kind == doctor::Kind::inverted || f.kind == doctor::Kind::folded || f.kind == doctor::Kind::flat;
  };
  const auto found = std::find_if(report.findings.begin(), report.findings.end(), bad);
  if (found == report.findings.end()) return;
  const std::int64_t count = report.count(doctor::Kind::inverted) + report.count(doctor::Kind::folded) +
                             report.count(doctor::Kind::flat);
  throw InputError(
      doctor::place_of(*found, soup),
      found->text + (count > 1 ? ", and " + std::to_string(count - 1) + " more of this kind" : "") +
          (found->kind == doctor::Kind::inverted ? " (--repair turns inverted tetrahedra over)" : ""));
}

/// Bad elements are told by the file's own numbers and lines.
solid::TetMesh mesh_of(format::Soup soup, std::vector<std::string>& warnings) {
  const doctor::Report findings = doctor::validate(soup, 1);
  if (findings.count(doctor::Severity::fatal) == 0) refuse_volumes(soup, findings);
  if (const std::int64_t unused = findings.count(doctor::Kind::unused_vertex); unused > 0)
    warnings.push_back("passed over: " + counted(unused, "vertex") + " in no tetrahedron");
  return doctor::build(std::move(soup), findings);
}

product::FloorOptions floor_options(const ProductArguments& options) {
  product::FloorOptions floor;
  if (options.floor_map == "rectangle") floor.domain = product::FloorDomain::rectangle;
  if (options.corners.empty()) return floor;
  const std::vector<long long> corners = vertices_in("--corners", options.corners);
  if (corners.size() != floor.corners.size())
    throw refusal("--corners", options.corners, "expected four vertices");
  for (std::size_t c = 0; c < corners.size(); ++c) floor.corners[c] = static_cast<int>(corners[c]);
  return floor;
}

/// A page shows the solid beside its domain.
bool wants_page(const ProductArguments& options) {
  return std::any_of(options.outputs.begin(), options.outputs.end(),
                     [](const std::string& path) { return format::has_extension(path, ".html"); });
}

/// `soup` is that of the solid, and stays where it is.
workshop::ProductOptions product_options(const ProductArguments& options, const format::Soup& soup,
                                         const Context& context) {
  using Weights = workshop::ProductOptions::Weights;
  workshop::ProductOptions how = options.how;
  how.name = options.input;
  how.partition = [&](product::Solid solid) {
    return partitioned(std::move(solid), soup, options.partition, context);
  };
  how.is_partition_given = is_given(options.partition);
  how.wants_coordinates = wants_page(options);
  if (options.weights != "auto")
    how.weights = options.weights == "clamped" ? Weights::clamped : Weights::cotangent;
  if (options.follow == "gradient") how.follow = product::Direction::gradient;
  how.threads = context.threads;
  if (!options.polycube.name.empty()) {
    how.polycube = options.polycube;
    how.polycube->image = read_soup(options.polycube.name, context).points;
  }
  how.floor = [&](const product::SplitSolid&) { return floor_options(options); };
  return how;
}

/// Of hexahedra beside stuck fibers.
void add_left_out(std::vector<std::string>& warnings, const workshop::MeasuredHexahedra& hexahedra) {
  if (hexahedra.of.left_out > 0)
    warnings.push_back(counted(hexahedra.of.left_out, "hexahedron") +
                       " left out beside fibers that failed to arrive");
}

/// What went wrong from the floor up, and which option may help.
void add_fibered(std::vector<std::string>& warnings, const workshop::SolidProduct& found, bool anyway) {
  const workshop::FiberedSolid& fibered = *found.fibered;
  const std::string without = found.is_of_polycube() ? "there are no coordinates" : "nothing was written";
  if (!fibered.floor.found)
    warnings.emplace_back("no map of the floor was found within the budget; the mesh of the floor may be too "
                          "coarse, or its corners badly placed (--corners)");
  if (!fibered.critical.none() && !anyway)
    warnings.push_back("the field has critical points, so the solid is no product with this partition; " +
                       without + " (--anyway goes on)");
  else if (!fibered.has_map())
    warnings.push_back("there is no map of the floor; " + without);
  else if (const std::size_t stuck = fibered.coordinates->of.stuck.size(); stuck > 0)
    warnings.push_back(counted(static_cast<long long>(stuck), "fiber") +
                       " failed to reach the floor; the places are listed, and --weights clamped may help");
}

void add_warnings(std::vector<std::string>& warnings, const workshop::SolidProduct& found, bool anyway) {
  if (!found.why_undivided.empty()) warnings.push_back(found.why_undivided);
  if (found.is_of_polycube()) add_left_out(warnings, *found.hexahedra);
  if (found.fibered) add_fibered(warnings, found, anyway);
  if (found.hexahedra && !found.is_of_polycube()) add_left_out(warnings, *found.hexahedra);
  const bool has_floor = found.is_of_polycube() || found.fibered->floor.found;
  const std::vector<std::string> doubts = found.doubts();
  if (found.verdict() == workshop::Verdict::undecided && has_floor)
    warnings.push_back("the result is not to be relied on: " + joined(doubts, "; "));
}

void add_product_files(Result& result, const workshop::SolidProduct& found, const ProductArguments& options,
                       const Context& context) {
  const ProductTitle title{options.input, options.floor_map};
  const bool has_coordinates = found.fibered && found.fibered->coordinates;
  if (!has_coordinates && !found.hexahedra) return;
  for (const std::string& path : options.outputs)
    if (has_coordinates || !format::has_extension(path, ".html"))
      result.files.push_back({path, product_file(path, found, title, options.show == "domain")});
  if (context.values != nullptr) result.value = std::make_shared<Value>(product_document(found, title));
}

Result run_product(const ProductArguments& options, const Context& context) {
  check_outputs(options);
  Result result;
  format::Soup soup = read_soup(options.input, context);
  result.warnings = mend(soup, options.doctor);
  product::Solid solid =
      in_file(options.input, [&] { return product::solid_of(mesh_of(soup, result.warnings)); });
  const workshop::SolidProduct found =
      workshop::solid_product(std::move(solid), product_options(options, soup, context), context.progress);
  result.status = status_of(found.verdict());
  result.text = block(rows_of(found));
  result.json = tree_of(found);
  add_warnings(result.warnings, found, options.how.passes_critical_points);
  add_product_files(result, found, options, context);
  return result;
}

} // namespace

Run declare_product(OptionTable& table) {
  const auto o = std::make_shared<ProductArguments>();
  table.add("MESH", o->input, "a handlebody of tetrahedra: .mesh, .msh, .node/.ele, .vtk or .vtu").required();
  table
      .add("--labels", o->partition.labels,
           "labels of floor and ceiling on the triangles of the file, such as 1,2; walls have other labels "
           "or none")
      .value_name("F,C");
  table
      .add("--floor", o->partition.floor,
           "a seed from which the floor is flooded; v17 is vertex 17, counted from 0")
      .value_name("VERTEX");
  table.add("--ceiling", o->partition.ceiling, "a seed from which the ceiling is flooded")
      .value_name("VERTEX");
  table
      .add("--threshold", o->partition.threshold,
           "greatest 1 - cosine between a normal and the normal at the seed, while flooding")
      .in_range(0.0, 2.0)
      .with_default();
  table
      .add("--cycle", o->partition.cycles,
           "a rim between a wall and the floor or ceiling: vertices along boundary edges, such as 3,17,20; "
           "repeated")
      .value_name("LIST");
  table
      .add("--tunnel", o->partition.tunnels,
           "a loop around a wall, given as for --cycle; needs --extend; repeated, once for each wall")
      .value_name("LIST");
  table.add("--extend", o->partition.extend, "distance by which tunnel loops extend to both sides");
  table
      .add("--outer", o->partition.outer,
           "a vertex on the outer wall (default: the wall with the longest rim)")
      .value_name("VERTEX");
  table
      .add("--floor-map", o->floor_map,
           "image of the floor: the unit disk with round holes, or a rectangle with rectangular holes")
      .one_of({"circular", "rectangle"})
      .with_default();
  table
      .add("--corners", o->corners,
           "corners of the rectangle: four vertices of the outer rim, such as 3,17,20,8")
      .value_name("LIST");
  table
      .add("--height", o->how.height,
           "height of the domain (default: the height that keeps the floor's aspect ratio)")
      .positive();
  table
      .add("--follow", o->follow,
           "direction of the fibers: means of the gradient at vertices, or the gradient itself")
      .one_of({"smoothed", "gradient"})
      .with_default();
  table
      .add("--weights", o->weights,
           "weights of the field: cotangents, or cotangents with negative ones set to 0, which allow no "
           "extrema inside; auto changes to the second if the first leave critical points")
      .one_of({"auto", "cotangent", "clamped"})
      .with_default();
  table.add("--anyway", o->how.passes_critical_points, "go on in spite of critical points");
  table
      .add("--hex", o->how.across,
           "make hexahedra, this many across the rectangle's width (implies --floor-map rectangle)")
      .in_range(1, 100'000);
  table.add("--layers", o->how.layers, "number of layers of hexahedra (default: as high as wide)")
      .in_range(1, 100'000);
  table.add(
      "--smooth", o->how.hexahedra.smooth,
      "improve hexahedra by moving points inside the solid and along its flat sides and straight ridges");
  table
      .add("--polycube", o->polycube.name,
           "make hexahedra from a polycube: a mesh whose vertex k is the image of the solid's vertex k on a "
           "surface of cubes; images of vertices inside the solid are used where no tetrahedron is flipped")
      .value_name("MESH");
  table.add("--step", o->polycube.step, "lattice step of the polycube's corners").positive().with_default();
  table.add("--cells", o->polycube.cells, "number of hexahedra along a lattice step")
      .in_range(1, 1000)
      .with_default();
  table
      .add("--volume-tolerance", o->how.hexahedra.volume_tolerance,
           "greatest relative difference between the volumes of the hexahedra and of the solid; beyond, the "
           "exit status is 4")
      .in_range(0.0, 1.0)
      .with_default();
  table.add("--show", o->show, "content of the files: the solid, or its domain")
      .one_of({"solid", "domain"})
      .with_default();
  table.add("--fibers", o->how.fibers, "number of fibers to draw").in_range(0, 100'000).with_default();
  table
      .add("-o,--output", o->outputs,
           "write tetrahedra or hexahedra with their data (.json, .vtu, .mesh), the surface with fibers "
           "(.glb, .ply, .obj), or a page with solid and domain (.html); may be repeated")
      .output_file();
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_product(*o, context); };
}

} // namespace tetrarch::program
