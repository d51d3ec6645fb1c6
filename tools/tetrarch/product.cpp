// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "in_file.hpp"
#include "input.hpp"
#include "output.hpp"
#include "product_files.hpp"
#include "product_partition.hpp"
#include "product_report.hpp"
#include "text.hpp"
#include "vertex_names.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/validate.hpp"
#include "tetrarch/product/polycube.hpp"
#include "tetrarch/scene/files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

namespace tetrarch::program {
namespace {

using product::Point;

struct Options {
  std::string input;
  std::vector<std::string> outputs;
  PartitionOptions partition;
  std::string floor_map = "circular";
  std::string corners;
  double height = 0; ///< 0: the one that keeps the floor's aspect ratio
  std::string follow = "smoothed";
  std::string show = "solid";
  int fibers = 60;
  int hex = 0;
  int layers = 0; ///< 0: cells as high as wide
  bool smooth = false;
  std::string polycube;
  double step = 1; ///< of the polycube's lattice
  int cells = 4;
  std::string weights = "auto";
  bool anyway = false;
  bool repair = false;
};

void check(const Options& options) {
  for (const std::string& path : options.outputs) {
    require_folder(path);
    if (!scene::scene_format_for_extension(path) && !format::has_extension(path, ".json") &&
        !format::has_extension(path, ".mesh") && !format::has_extension(path, ".html"))
      throw InputError({path, 0},
                       "nothing that can be written has this extension (expected .json, .vtu, .mesh, "
                       ".glb, .ply, .obj or .html)");
  }
  if (options.hex == 0 && options.layers > 0) throw InputError("--layers needs --hex");
  if (options.hex > 0 && !options.polycube.empty())
    throw InputError("--hex and --polycube are two ways to hexahedra: expected one of them");
  if (options.hex == 0 && options.polycube.empty() && options.smooth)
    throw InputError("--smooth needs --hex or --polycube");
  if (options.floor_map != "rectangle" && !options.corners.empty())
    throw InputError("--corners needs --floor-map rectangle");
}

format::Soup read(const Options& options, Report& report, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  report.warnings = soup.warnings;
  if (!options.repair) return soup;
  mesh::Repaired repaired = mesh::repair(std::move(soup));
  report.warnings.insert(report.warnings.end(), repaired.done.begin(), repaired.done.end());
  return std::move(repaired.soup);
}

/// Tetrahedra without volume are told by the numbers and lines of the file.
void refuse_volumes(const format::Soup& soup, const mesh::Report& report) {
  const auto bad = [](const mesh::Finding& f) {
    return f.kind == mesh::Kind::inverted || f.kind == mesh::Kind::flat;
  };
  const auto found = std::find_if(report.findings.begin(), report.findings.end(), bad);
  if (found == report.findings.end()) return;
  const std::int64_t count = report.count(mesh::Kind::inverted) + report.count(mesh::Kind::flat);
  throw InputError(mesh::place_of(*found, soup),
                   found->text + (count > 1 ? ", and " + std::to_string(count - 1) + " more like it" : "") +
                       (found->kind == mesh::Kind::inverted ? " (--repair turns inverted ones)" : ""));
}

/// Bad elements are told by the file's own numbers and lines.
mesh::TetMesh mesh_of(format::Soup soup) {
  const mesh::Report findings = mesh::validate(soup, 1);
  if (findings.count(mesh::Severity::fatal) == 0) refuse_volumes(soup, findings);
  return mesh::build(std::move(soup), findings);
}

product::FloorOptions floor_options(const Options& options) {
  product::FloorOptions floor;
  if (options.floor_map == "rectangle" || options.hex > 0) floor.domain = product::FloorDomain::rectangle;
  if (options.corners.empty()) return floor;
  const std::vector<long long> corners = vertices_in("--corners", options.corners);
  if (corners.size() != floor.corners.size())
    throw refusal("--corners", options.corners, "expected four vertices");
  for (std::size_t c = 0; c < corners.size(); ++c) floor.corners[c] = static_cast<int>(corners[c]);
  return floor;
}

/// Some of the fibres, from vertices of the floor that are spread over it.
void add_fibers(ProductMade& made, const product::FiberField& field, const product::FloorMap& floor,
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

/// Smoothed if wanted, measured and told.
void add_quality(ProductMade& made, const Options& options, const Progress& progress) {
  product::HexQuality quality = product::quality(made.hexahedra->mesh);
  if (options.smooth) {
    const product::HexQuality before = std::move(quality);
    const product::Smoothed smoothed =
        product::smooth(made.hexahedra->mesh, made.hexahedra->on_boundary, {}, progress);
    made.report.add(smoothed_report(smoothed, before));
    quality = product::quality(made.hexahedra->mesh);
  }
  made.report.add(hexahedra_report(*made.hexahedra, quality));
  made.scaled_jacobian = std::move(quality.scaled_jacobian);
}

void add_hexahedra(ProductMade& made, const product::FiberField& field, const product::FloorMap& floor,
                   const Options& options, const Context& context) {
  const product::FloorGrid grid =
      product::floor_grid(floor.height, floor.rectangles, {.across = options.hex});
  product::HexOptions hex;
  hex.threads = context.threads;
  hex.layers = options.layers > 0 ? options.layers
                                  : std::max(1, static_cast<int>(std::lround(options.hex * field.height())));
  made.hexahedra = product::hexahedra(field, grid, product::nodes_on_floor(field.solid(), floor, grid), hex,
                                      context.progress);
  made.cells = static_cast<int>(grid.cells.size());
  made.report.add(grid_report(grid));
  add_quality(made, options, context.progress);
}

/// Vertex k of the file is the image of vertex k of the solid; those inside are passed over.
void add_polycube(ProductMade& made, const product::Solid& solid, const product::Partition& partition,
                  const Options& options, const Context& context) {
  const format::Soup soup = read_soup(options.polycube, context);
  std::vector<Point> image;
  image.reserve(solid.vertex.size());
  for (const int v : solid.vertex) {
    if (v >= static_cast<int>(soup.points.size()))
      throw InputError({options.polycube, 0},
                       "there is no image of vertex v" + std::to_string(v) + ": the file has " +
                           counted(static_cast<long long>(soup.points.size()), "vertex"));
    image.push_back(soup.points[v]);
  }
  std::vector<int> base;
  base.reserve(partition.patch.size());
  for (const int patch : partition.patch) base.push_back(patch < product::first_wall ? patch : -1);
  product::PolycubeOptions polycube;
  polycube.step = options.step;
  polycube.cells = options.cells;
  polycube.threads = context.threads;
  product::PolycubeHexahedra found = in_file(options.polycube, [&] {
    return product::polycube_hexahedra(solid, image, base, polycube, context.progress);
  });
  made.hexahedra = std::move(found.solid);
  add_quality(made, options, context.progress);
}

/// Fibres and what hangs on them, of a field without critical places.
void add_coordinates(ProductMade& made, const product::FloorMap& floor, const product::HarmonicField& field,
                     const Options& options, const Context& context) {
  const product::FiberField fibers(made.at.solid, made.at.partition, field.w,
                                   options.follow == "gradient" ? product::Direction::gradient
                                                                : product::Direction::smoothed);
  product::Coordinates coordinates = product::coordinates(fibers, floor, context.threads, context.progress);
  made.report.add(coordinates_report(coordinates));
  made.uvw = std::move(coordinates.uvw);
  made.report.add(quality_report(product::quality(made.at.solid, made.uvw)));
  made.report.add(confirmation_report(product::confirm(fibers, context.threads, context.progress)));
  add_fibers(made, fibers, floor, options.fibers);
  if (options.hex > 0 && floor.found) add_hexahedra(made, fibers, floor, options, context);
}

struct Field {
  product::HarmonicField harmonic;
  product::CriticalPlaces critical;
  bool clamped = false;
};

/// With cotangent weights; where they leave critical places, and nobody asked for them, with clamped ones.
Field solved(const product::Prepared& at, double height, const Options& options, const Context& context) {
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

ProductMade make(const Options& options, const Context& context) {
  ProductMade made;
  const format::Soup soup = read(options, made.report, context);
  mesh::TetMesh mesh = mesh_of(soup);
  PartitionedSolid start = in_file(options.input, [&] {
    return partitioned(product::solid(std::move(mesh)), soup, options.partition, context);
  });
  made.report.add(partition_report(start.solid, start.partition, start.how));
  if (!options.polycube.empty()) add_polycube(made, start.solid, start.partition, options, context);
  made.at = product::prepared(std::move(start.solid), std::move(start.partition));

  const product::FloorMap floor = in_file(options.input, [&] {
    return product::floor_map(made.at.solid, made.at.partition, floor_options(options), context.progress);
  });
  made.report.add(floor_report(floor));
  const double height =
      options.height > 0 ? options.height : product::natural_height(made.at.solid, made.at.partition, floor);
  const Field field = solved(made.at, height, options, context);
  made.report.add(field_report(field.harmonic, height, made.at.splits, field.clamped));
  made.report.add(critical_report(made.at.solid, field.critical));
  if (!floor.found) made.status = Status::undecided;
  if (!field.critical.none()) {
    made.status = Status::proved_no;
    if (!options.anyway) {
      made.report.warnings.emplace_back(
          "the field has critical places, so it makes no product; nothing is written (--anyway goes on)");
      return made;
    }
  }
  if (floor.flipped == floor.mesh.surface.triangle_count()) {
    made.report.warnings.emplace_back("there is no map of the floor to start from; nothing is written");
    return made;
  }
  add_coordinates(made, floor, field.harmonic, options, context);
  return made;
}

Result run_product(const Options& options, const Context& context) {
  check(options);
  const auto start = std::chrono::steady_clock::now();
  ProductMade made = make(options, context);
  made.report.json["seconds"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Result result;
  result.status = made.status;
  const ProductTitle title{options.input, options.floor_map};
  if (!made.uvw.empty())
    for (const std::string& path : options.outputs)
      result.files.push_back({path, product_file(path, made, title, options.show == "domain")});
  if (!made.uvw.empty() && context.values != nullptr)
    result.value = std::make_shared<Value>(product_document(made, title));
  result.text = block(made.report.rows);
  result.json = std::move(made.report.json);
  result.warnings = std::move(made.report.warnings);
  return result;
}

} // namespace

Run declare_product(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("MESH", o->input, "a handlebody of tetrahedra: .mesh, .msh, .node/.ele, .vtk or .vtu")
      ->required();
  app.add_option(
         "--labels", o->partition.labels,
         "labels of floor and ceiling among the triangles of the file, such as 1,2; walls have others "
         "or none")
      ->type_name("F,C");
  app.add_option("--floor", o->partition.floor,
                 "a seed for the floor, v17: vertex 17, counted from 0; from there on, triangles are flooded")
      ->type_name("VERTEX");
  app.add_option("--ceiling", o->partition.ceiling, "a seed for the ceiling")->type_name("VERTEX");
  app.add_option("--threshold", o->partition.threshold,
                 "of flooding: how far normals may differ from that at the seed, as 1 - cosine")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--cycle", o->partition.cycles,
                 "a rim between floor or ceiling and wall: vertices along boundary edges, 3,17,20; repeated")
      ->type_name("LIST")
      ->allow_extra_args(false);
  app.add_option("--tunnel", o->partition.tunnels,
                 "a loop around a wall, likewise; with --extend; repeated, once for each wall")
      ->type_name("LIST")
      ->allow_extra_args(false);
  app.add_option("--extend", o->partition.extend, "how far tunnel loops are extended to both sides");
  app.add_option("--outer", o->partition.outer,
                 "a vertex on the wall that is to be the outer one (default: that with the longest rim)")
      ->type_name("VERTEX");
  app.add_option("--floor-map", o->floor_map,
                 "the unit disk with round holes, or a rectangle with rectangular ones")
      ->check(CLI::IsMember({"circular", "rectangle"}))
      ->capture_default_str();
  app.add_option("--corners", o->corners,
                 "of the rectangle: four vertices of the outer rim, such as 3,17,20,8")
      ->type_name("LIST");
  app.add_option("--height", o->height, "of the domain (default: that which keeps the floor's aspect ratio)")
      ->check(CLI::PositiveNumber);
  app.add_option("--follow", o->follow,
                 "what fibres follow: means of the gradient at vertices, or the gradient itself")
      ->check(CLI::IsMember({"smoothed", "gradient"}))
      ->capture_default_str();
  app.add_option("--weights", o->weights,
                 "of the field: cotangents, or those with negative ones set to 0, so that it has no extrema "
                 "inside; auto takes these where cotangents leave critical places")
      ->check(CLI::IsMember({"auto", "cotangent", "clamped"}))
      ->capture_default_str();
  app.add_flag("--anyway", o->anyway, "go on where the field has critical places");
  app.add_option("--hex", o->hex,
                 "make hexahedra, so many across the rectangle's width (implies --floor-map rectangle)")
      ->check(CLI::Range(1, 100'000));
  app.add_option("--layers", o->layers, "of hexahedra (default: as high as wide)")
      ->check(CLI::Range(1, 100'000));
  app.add_flag("--smooth", o->smooth, "improve hexahedra, moving points inside");
  app.add_option(
         "--polycube", o->polycube,
         "make hexahedra by a polycube: a mesh whose vertex k is the image, on a surface of cubes, of the "
         "solid's vertex k; those inside do not matter")
      ->type_name("MESH");
  app.add_option("--step", o->step, "of the lattice of the polycube's corners")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--cells", o->cells, "hexahedra along a step")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--show", o->show, "what is written: the solid, or its domain")
      ->check(CLI::IsMember({"solid", "domain"}))
      ->capture_default_str();
  app.add_option("--fibers", o->fibers, "so many fibres are drawn")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  app.add_option(
         "-o,--output", o->outputs,
         "tetrahedra or hexahedra with their data (.json, .vtu, .mesh), the surface with fibres (.glb, .ply, "
         ".obj), or a page with solid and domain (.html); may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_flag("--repair", o->repair, "turn inverted tetrahedra, remove duplicates and unused points first");
  return [o](const Context& context) { return run_product(*o, context); };
}

} // namespace tetrarch::program
