// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "in_file.hpp"
#include "input.hpp"
#include "output.hpp"
#include "product_files.hpp"
#include "product_hexahedra.hpp"
#include "product_partition.hpp"
#include "product_report.hpp"
#include "text.hpp"
#include "vertex_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/validate.hpp"
#include "tetrarch/scene/files.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

using product::Point;

struct ProductArguments {
  std::string input;
  std::vector<std::string> outputs;
  PartitionOptions partition;
  std::string floor_map = "circular";
  std::string corners;
  double height = 0; ///< 0: the one that keeps the floor's aspect ratio
  std::string follow = "smoothed";
  std::string show = "solid";
  int fibers = 60;
  HexahedraOptions hexahedra;
  std::string weights = "auto";
  bool anyway = false;
  Doctor doctor;
};

void check_outputs(const ProductArguments& options) {
  for (const std::string& path : options.outputs) {
    require_folder(path);
    if (!scene::scene_format_for_extension(path) && !format::has_extension(path, ".json") &&
        !format::has_extension(path, ".mesh") && !format::has_extension(path, ".html"))
      throw InputError({path, 0}, "this command writes no file with this extension (expected .json, .vtu, "
                                  ".mesh, .glb, .ply, .obj or .html)");
  }
  const HexahedraOptions& hex = options.hexahedra;
  if (hex.across == 0 && hex.layers > 0) throw InputError("--layers needs --hex");
  if (hex.across > 0 && !hex.polycube.empty())
    throw InputError("--hex and --polycube exclude each other: expected one of them");
  if (hex.across == 0 && hex.polycube.empty() && hex.smooth)
    throw InputError("--smooth needs --hex or --polycube");
  if (options.floor_map != "rectangle" && !options.corners.empty())
    throw InputError("--corners needs --floor-map rectangle");
}

format::Soup read_solid(const ProductArguments& options, Report& report, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  for (std::string& done : mend(soup, options.doctor)) report.warnings.push_back(std::move(done));
  return soup;
}

/// Tetrahedra without volume are told by the numbers and lines of the file.
void refuse_volumes(const format::Soup& soup, const mesh::Report& report) {
  const auto bad = [](const mesh::Finding& f) {
    return f.kind == mesh::Kind::inverted || f.kind == mesh::Kind::folded || f.kind == mesh::Kind::flat;
  };
  const auto found = std::find_if(report.findings.begin(), report.findings.end(), bad);
  if (found == report.findings.end()) return;
  const std::int64_t count =
      report.count(mesh::Kind::inverted) + report.count(mesh::Kind::folded) + report.count(mesh::Kind::flat);
  throw InputError(
      mesh::place_of(*found, soup),
      found->text + (count > 1 ? ", and " + std::to_string(count - 1) + " more of this kind" : "") +
          (found->kind == mesh::Kind::inverted ? " (--repair turns inverted tetrahedra over)" : ""));
}

/// Bad elements are told by the file's own numbers and lines.
mesh::TetMesh mesh_of(format::Soup soup, Report& report) {
  const mesh::Report findings = mesh::validate(soup, 1);
  if (findings.count(mesh::Severity::fatal) == 0) refuse_volumes(soup, findings);
  if (const std::int64_t unused = findings.count(mesh::Kind::unused_vertex); unused > 0)
    report.warnings.push_back("passed over: " + counted(unused, "vertex") + " in no tetrahedron");
  return mesh::build(std::move(soup), findings);
}

product::FloorOptions floor_options(const ProductArguments& options) {
  product::FloorOptions floor;
  if (options.floor_map == "rectangle" || options.hexahedra.across > 0)
    floor.domain = product::FloorDomain::rectangle;
  if (options.corners.empty()) return floor;
  const std::vector<long long> corners = vertices_in("--corners", options.corners);
  if (corners.size() != floor.corners.size())
    throw refusal("--corners", options.corners, "expected four vertices");
  for (std::size_t c = 0; c < corners.size(); ++c) floor.corners[c] = static_cast<int>(corners[c]);
  return floor;
}

/// Some of the fibres, from vertices of the floor that are spread over it.
void add_fibers(SolidProduct& made, const product::FiberField& field, const product::FloorMap& floor,
                int count) {
  const std::size_t all = floor.vertex.size();
  const std::size_t wanted = std::min(all, static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t v = k * all / wanted;
    std::vector<Point> path;
    const product::Fiber fiber = field.trace(field.at_vertex(floor.vertex[v]), product::Way::up, path);
    if (path.size() < 2) continue;
    made.fibers.push_back(std::move(path));
    const std::complex<double> uv = floor.position[v];
    made.straight.push_back({{uv.real(), uv.imag(), 0},
                             {uv.real(), uv.imag(), product::value_at(field.solid(), field.w(), fiber.at)}});
  }
}

struct Field {
  product::HarmonicField harmonic;
  product::CriticalPlaces critical;
  bool clamped = false;
};

constexpr const char* product_because =
    "no critical point, no flipped tetrahedron, and every fiber arrives both ways";

/// Fibres and what hangs on them, of a field without critical places.
void add_coordinates(SolidProduct& made, const product::FloorMap& floor, const Field& field,
                     const ProductArguments& options, const Context& context) {
  const product::FiberField fibers(made.at.solid, made.at.partition, field.harmonic.w,
                                   options.follow == "gradient" ? product::Direction::gradient
                                                                : product::Direction::smoothed);
  product::Coordinates coordinates = product::coordinates(fibers, floor, context.threads, context.progress);
  made.report.add(coordinates_report(coordinates));
  made.uvw = std::move(coordinates.uvw);
  const product::Quality quality = product::quality(made.at.solid, made.uvw);
  made.report.add(quality_report(made.at.solid, quality));
  const product::Confirmation confirmation = product::confirm(fibers, context.threads, context.progress);
  made.report.add(confirmation_report(confirmation));
  std::vector<std::string> doubts = doubts_about(coordinates, quality, confirmation);
  if (!field.critical.none()) doubts.emplace_back("the field has critical points");
  made.report.add(verdict_report({"product", "a product", doubts, product_because}));
  if (options.hexahedra.polycube.empty()) made.doubts.insert(made.doubts.end(), doubts.begin(), doubts.end());
  add_fibers(made, fibers, floor, options.fibers);
  if (options.hexahedra.across > 0 && floor.found)
    add_hexahedra(made, fibers, floor, options.hexahedra, context);
}

/// With cotangent weights; where they leave critical places, and nobody asked for them, with clamped ones.
Field solved(const product::SplitSolid& at, double height, const ProductArguments& options,
             const Context& context) {
  Field field;
  for (const bool clamped : {false, true}) {
    if (options.weights == (clamped ? "cotangent" : "clamped")) continue;
    field.harmonic = product::harmonic_field(at.solid, at.partition, {.height = height, .clamped = clamped},
                                             context.progress);
    field.critical = product::critical_places(at.solid, at.partition, field.harmonic.w);
    field.clamped = clamped;
    if (field.critical.none()) break;
  }
  return field;
}

/// A page shows the solid beside its domain.
bool wants_page(const ProductArguments& options) {
  return std::any_of(options.outputs.begin(), options.outputs.end(),
                     [](const std::string& path) { return format::has_extension(path, ".html"); });
}

/// The solid with its partition, and with the hexahedra of a polycube if there is one. Where the map alone
/// carries these well, no partition is sought that nobody asked for. Nothing where there are hexahedra and no
/// partition.
std::optional<PartitionedSolid> started(SolidProduct& made, const ProductArguments& options,
                                        const Context& context) {
  const format::Soup soup = read_solid(options, made.report, context);
  product::Solid solid = in_file(options.input, [&] { return product::solid(mesh_of(soup, made.report)); });
  const std::string& path = options.hexahedra.polycube;
  CarriedCubes carried;
  format::Soup polycube;
  const MeasuredSolid original = measured(solid);
  if (!path.empty()) {
    polycube = read_soup(path, context);
    carried = carried_by_map(solid, polycube, options.hexahedra, context);
  }
  std::optional<PartitionedSolid> start;
  if (carried.is_good() && !is_given(options.partition) && !wants_page(options)) {
    made.report.json["tetrahedra"] = solid.size();
    made.report.rows.emplace_back("solid", counted(solid.size(), "tetrahedron"));
    add_polycube(made, std::move(carried), original, options.hexahedra, context);
    return start;
  }
  try {
    start = in_file(options.input,
                    [&] { return partitioned(std::move(solid), soup, options.partition, context); });
  } catch (const InputError& e) {
    if (!carried.hexahedra || is_given(options.partition)) throw;
    made.report.warnings.emplace_back(e.what());
  }
  if (start) made.report.add(partition_report(start->solid, start->partition, start->how));
  if (path.empty()) return start;
  if (start && !carried.is_good()) try_fibers(carried, *start, polycube, options.hexahedra, context);
  add_polycube(made, std::move(carried), original, options.hexahedra, context);
  return start;
}

SolidProduct make_product(const ProductArguments& options, const Context& context) {
  SolidProduct made;
  std::optional<PartitionedSolid> start = started(made, options, context);
  if (!start) return made;
  made.at = product::split_shortcuts(std::move(start->solid), std::move(start->partition));
  const bool is_polycube = made.hexahedra.has_value(); // the hexahedra are the result, whatever else there is

  const product::FloorMap floor = in_file(options.input, [&] {
    return product::floor_map(made.at.solid, made.at.partition, floor_options(options), context.progress);
  });
  made.report.add(floor_report(floor));
  const double height =
      options.height > 0 ? options.height : product::natural_height(made.at.solid, made.at.partition, floor);
  const Field field = solved(made.at, height, options, context);
  made.report.add(field_report(field.harmonic, height, made.at.splits, field.clamped));
  made.report.add(critical_report(made.at.solid, field.critical));
  if (!floor.found && !is_polycube) made.status = Status::undecided;
  const std::string without = is_polycube ? "there are no coordinates" : "nothing was written";
  if (!field.critical.none()) {
    if (!is_polycube) made.status = Status::proved_no;
    if (!options.anyway) {
      made.report.warnings.push_back("the field has critical points, so the solid is no product with this "
                                     "partition; " +
                                     without + " (--anyway goes on)");
      return made;
    }
  }
  if (floor.flipped == floor.mesh.surface.triangle_count()) {
    made.report.warnings.push_back("there is no map of the floor; " + without);
    return made;
  }
  add_coordinates(made, floor, field, options, context);
  return made;
}

Result run_product(const ProductArguments& options, const Context& context) {
  check_outputs(options);
  const auto start = std::chrono::steady_clock::now();
  SolidProduct made = make_product(options, context);
  made.report.json["seconds"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Result result;
  if (made.status == Status::done && !made.doubts.empty()) {
    made.status = Status::undecided;
    made.report.warnings.push_back("the result is not to be relied on: " + joined(made.doubts, "; "));
  }
  result.status = made.status;
  const ProductTitle title{options.input, options.floor_map};
  for (const std::string& path : options.outputs) {
    if (made.uvw.empty() && (!made.hexahedra || format::has_extension(path, ".html"))) continue;
    result.files.push_back({path, product_file(path, made, title, options.show == "domain")});
  }
  if ((!made.uvw.empty() || made.hexahedra) && context.values != nullptr)
    result.value = std::make_shared<Value>(product_document(made, title));
  result.text = block(made.report.rows);
  result.json = std::move(made.report.json);
  result.warnings = std::move(made.report.warnings);
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
      .add("--height", o->height,
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
  table.add("--anyway", o->anyway, "go on in spite of critical points");
  table
      .add("--hex", o->hexahedra.across,
           "make hexahedra, this many across the rectangle's width (implies --floor-map rectangle)")
      .in_range(1, 100'000);
  table.add("--layers", o->hexahedra.layers, "number of layers of hexahedra (default: as high as wide)")
      .in_range(1, 100'000);
  table.add(
      "--smooth", o->hexahedra.smooth,
      "improve hexahedra by moving points inside the solid and along its flat sides and straight ridges");
  table
      .add("--polycube", o->hexahedra.polycube,
           "make hexahedra from a polycube: a mesh whose vertex k is the image of the solid's vertex k on a "
           "surface of cubes; images of vertices inside the solid are used where no tetrahedron is flipped")
      .value_name("MESH");
  table.add("--step", o->hexahedra.step, "lattice step of the polycube's corners").positive().with_default();
  table.add("--cells", o->hexahedra.cells, "number of hexahedra along a lattice step")
      .in_range(1, 1000)
      .with_default();
  table
      .add("--volume-tolerance", o->hexahedra.volume_tolerance,
           "greatest relative difference between the volumes of the hexahedra and of the solid; beyond, the "
           "exit status is 4")
      .in_range(0.0, 1.0)
      .with_default();
  table.add("--show", o->show, "content of the files: the solid, or its domain")
      .one_of({"solid", "domain"})
      .with_default();
  table.add("--fibers", o->fibers, "number of fibers to draw").in_range(0, 100'000).with_default();
  table
      .add("-o,--output", o->outputs,
           "write tetrahedra or hexahedra with their data (.json, .vtu, .mesh), the surface with fibers "
           "(.glb, .ply, .obj), or a page with solid and domain (.html); may be repeated")
      .value_name("FILE");
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_product(*o, context); };
}

} // namespace tetrarch::program
