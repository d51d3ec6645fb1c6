// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "embedding.hpp"
#include "output.hpp"
#include "surface_input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/show/bundle.hpp"
#include "tetrarch/workshop/bundle.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

using bundle::PlanOptions;

struct BundleArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string boundary = "free";
  std::string obstruction;
  std::string show = "tori";
  std::string cut = "dissertation";
  std::vector<double> field; ///< a constant vector to be projected; none: random directions
  PlanOptions plan;
  std::optional<int> twist;
  Doctor doctor;
};

void require_outputs(const BundleArguments& options) {
  for (const std::string& path : options.outputs) {
    if (!format::has_extension(path, ".svg") && !scene::scene_format_for_extension(path) &&
        !format::format_for_extension(path))
      throw InputError({path, 0}, "this command writes no file with this extension (expected .json, .tri, "
                                  ".sig, .txt or .fmp; .vtu, .glb, .ply, .obj or .svg)");
  }
  if (!options.obstruction.empty()) mesh_output_format(options.obstruction);
}

/// Options that this surface gives nothing to do.
void require_used(const BundleArguments& options, const SurfaceType& type, std::optional<int> euler) {
  if (!options.field.empty()) {
    for (const double x : options.field)
      if (!std::isfinite(x)) throw InputError("--field: expected three finite numbers");
    if (options.field == std::vector<double>{0, 0, 0})
      throw InputError("--field 0 0 0: the vector has no direction");
    if (!type.is_closed() || !type.orientable)
      throw InputError({options.input, 0},
                       "--field needs a closed orientable surface, on which the indices of "
                       "a field add up, but this surface is " +
                           type.str());
    if (euler.value_or(type.euler) != type.euler)
      throw InputError("--field: a tangent field belongs to the unit tangent bundle, of Euler number " +
                       std::to_string(type.euler));
  }
  if (!options.obstruction.empty() && type.is_closed())
    throw InputError({options.input, 0},
                     "--obstruction: only a surface with boundary can have one, but this is " + type.str());
  for (const std::string& path : options.outputs) {
    if (!format::has_extension(path, ".svg")) continue;
    if (options.show == "surface")
      throw InputError({path, 0}, "--show surface has no flat picture (expected .glb, .ply, .obj or .vtu)");
    if (type.is_disk())
      throw InputError({path, 0},
                       "a disk is not cut, so that there are no bands to draw (expected .glb, .ply, "
                       ".obj or .vtu)");
  }
}

/// Says what a caller asked for that cannot be had.
PlanOptions plan_options(const BundleArguments& options, const SurfaceInput& surface) {
  PlanOptions plan = options.plan;
  plan.cut = options.cut == "any" ? PlanOptions::Cut::any : PlanOptions::Cut::dissertation;
  const SurfaceType type = surface::type_of(surface.mesh.surface);
  if (plan.fiber < 1 || plan.fiber > 1'000'000)
    throw InputError("--fiber " + std::to_string(plan.fiber) + ": expected 1 to 1000000 edges");
  if (options.twist) {
    if (plan.euler) throw InputError("--twist and --euler exclude each other: expected one of them");
    if (*options.twist % plan.fiber != 0)
      throw InputError("--twist " + std::to_string(*options.twist) + ": expected a multiple of the fiber's " +
                       counted(plan.fiber, "edge") + ", because otherwise one fiber is exceptional");
    plan.euler = *options.twist / plan.fiber;
  }
  if (plan.euler && !type.is_closed())
    throw InputError({options.input, 0}, "a surface with boundary has no Euler number");
  if (plan.euler && std::abs(static_cast<long long>(*plan.euler)) * plan.fiber > 10'000'000)
    throw InputError("--euler " + std::to_string(*plan.euler) +
                     ": the total twist is more than 10000000 steps");
  require_used(options, type, plan.euler);
  if (options.boundary != "free") {
    if (type.is_closed())
      throw InputError({options.input, 0},
                       "the surface is closed, so it has no boundary edge to take a value");
    plan.boundary = read_boundary_values(options.boundary, surface);
  }
  return plan;
}

/// Files of the bundle: gluings, cells, pictures.
void add_outputs(Result& result, const workshop::SurfaceBundle::Made& made, const format::Document& document,
                 const BundleArguments& options) {
  const auto scene_of = [&](const std::string& path) {
    if (options.show == "surface") return show::cut_surface(made.plan, made.field);
    const bool cells = format::has_extension(path, ".vtu") || made.plan.method == bundle::Plan::Method::disk;
    return cells ? show::solid_tori(made.plan, made.bundle) : show::gluable_tori(made.plan);
  };
  for (const std::string& path : options.outputs) {
    if (format::has_extension(path, ".svg"))
      result.files.push_back({path, write_svg(show::gluable_bands(made.plan))});
    else if (const auto format = scene::scene_format_for_extension(path))
      result.files.push_back({path, write_scene(scene_of(path), *format)});
    else
      add_file(result, path, document);
  }
}

/// The file of the part without a solution, if it was asked for.
void add_obstruction(Result& result, const workshop::SurfaceBundle& found, const std::string& path) {
  if (path.empty()) return;
  if (found.obstruction)
    result.files.push_back({path, format::write_soup(found.obstruction->mesh, mesh_output_format(path))});
  else
    result.warnings.push_back("there is no obstruction: " + in_quotes(path) + " was not written");
}

/// Memory for the texts of files beyond what is free again when they are written, as measured. Of a disk
/// pictures show every tetrahedron, else the surfaces of the solid tori, which take less than the work
/// before.
double file_bytes_a_tetrahedron(const std::vector<std::string>& outputs, bool is_disk) {
  struct Kind {
    const char* extension;
    double bytes; ///< a tetrahedron
    bool is_picture;
  };
  constexpr std::array kinds{Kind{".json", 200, false}, Kind{".tri", 420, false}, Kind{".fmp", 100, false},
                             Kind{".glb", 85, true},    Kind{".ply", 76, true},   Kind{".obj", 490, true}};
  double bytes = 0;
  for (const std::string& path : outputs)
    for (const Kind& kind : kinds)
      if (format::has_extension(path, kind.extension) && (is_disk || !kind.is_picture)) bytes += kind.bytes;
  return bytes;
}

workshop::BundleOptions bundle_options(const BundleArguments& options, const SurfaceInput& surface,
                                       const Context& context) {
  workshop::BundleOptions how;
  how.plan = plan_options(options, surface);
  if (!options.field.empty()) how.field = {options.field[0], options.field[1], options.field[2]};
  how.seed = context.seed;
  constexpr double bytes_of_gigabyte = 1e9;
  how.most_bytes = bytes_of_gigabyte * allowed_gigabytes(context);
  how.bytes_a_tetrahedron =
      file_bytes_a_tetrahedron(options.outputs, surface::type_of(surface.mesh.surface).is_disk());
  return how;
}

Result run_bundle(const BundleArguments& options, const Context& context) {
  require_outputs(options);
  const SurfaceInput surface = read_surface(options.input, context, options.doctor);
  const workshop::BundleOptions how = bundle_options(options, surface, context);
  const workshop::SurfaceBundle found = workshop::circle_bundle(surface, how, context.progress);
  if (found.bytes_needed)
    require_memory("--fiber " + std::to_string(how.plan.fiber), *found.bytes_needed,
                   allowed_gigabytes(context));
  Result result;
  result.status = status_of(found.verdict());
  result.warnings = surface.warnings;
  result.json = tree_of(found);
  result.text = text_of(found);
  add_obstruction(result, found, options.obstruction);
  if (!found.made) return result;
  format::Document document = document_of(found);
  add_outputs(result, *found.made, document, options);
  result.value = std::make_shared<Value>(std::move(document));
  return result;
}

} // namespace

Run declare_bundle(OptionTable& table) {
  const auto o = std::make_shared<BundleArguments>();
  table.add("SURFACE", o->input, "a surface: OBJ, OFF, PLY or STL").required();
  table
      .add("-o,--output", o->outputs,
           "write the triangulation (.json with fiber coordinates, .tri, .sig ...), the mesh with its "
           "coordinates (.vtu), or a picture: the solid tori as .glb, .ply or .obj, the bands as .svg; may "
           "be repeated")
      .output_file();
  table.add("--fiber", o->plan.fiber, "number of edges of a fiber; 1 is the least that works").with_default();
  table.add("--euler", o->plan.euler,
            "the Euler number of the bundle (default: chi, which gives the unit tangent bundle)");
  table.add("--twist", o->twist, "total twist in steps, an alternative to --euler: --fiber times --euler");
  table
      .add("--boundary", o->boundary,
           "free, or a file of lines 'u v value': the two vertices of a boundary edge, numbered as in the "
           "surface's file, and +1 or -1")
      .value_name("FILE")
      .with_default();
  table
      .add("--cut", o->cut,
           "cut along an equator or canonical loops (dissertation), or along a short cut graph (any)")
      .one_of({"dissertation", "any"})
      .with_default();
  table
      .add("--show", o->show,
           "content of pictures: the solid tori, or the surface with its cut and singularities")
      .one_of({"tori", "surface"})
      .with_default();
  table
      .add("--field", o->field,
           "project the vector X Y Z to the surface instead of drawing random directions")
      .takes(3);
  table.add("--obstruction", o->obstruction, "write the part of a disk that has no solution to this file")
      .output_file();
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_bundle(*o, context); };
}

} // namespace tetrarch::program
