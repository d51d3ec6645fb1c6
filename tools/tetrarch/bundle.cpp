// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "embedding.hpp"
#include "info.hpp"
#include "output.hpp"
#include "surface_input.hpp"
#include "text.hpp"

#include "tetrarch/bundle/gluable.hpp"
#include "tetrarch/bundle/plan.hpp"
#include "tetrarch/bundle/proof.hpp"
#include "tetrarch/bundle/section.hpp"
#include "tetrarch/bundle/vector_field.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/canonical_loops.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/show/bundle.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace tetrarch::program {
namespace {

using bundle::Plan;
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
    require_folder(path);
    if (!format::has_extension(path, ".svg") && !scene::scene_format_for_extension(path) &&
        !format::format_for_extension(path))
      throw InputError({path, 0}, "this command writes no file with this extension (expected .json, .tri, "
                                  ".sig, .txt or .fmp; .vtu, .glb, .ply, .obj or .svg)");
  }
  if (options.obstruction.empty()) return;
  require_folder(options.obstruction);
  if (!format::mesh_format_for_extension(options.obstruction))
    throw InputError({options.obstruction, 0}, "no mesh format has this extension");
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
  const SurfaceType type = mesh::type_of(surface.mesh.surface);
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

const char* name_of(Plan::Method method) {
  switch (method) {
  case Plan::Method::disk:
    return "nothing: a disk";
  case Plan::Method::equator:
    return "an equator";
  case Plan::Method::canonical_loops:
    return "canonical loops";
  case Plan::Method::cut_graph:
    return "a cut graph";
  }
  return "";
}

/// The sub-mesh on which no pattern exists.
Result obstructed(const bundle::Obstruction& found, const SurfaceInput& surface,
                  const BundleArguments& options) {
  Result result;
  result.status = Status::proved_no;
  result.warnings = surface.warnings;
  Json triangles = Json::array();
  format::Soup part;
  part.points = surface.mesh.points;
  for (const int t : found.triangles) {
    triangles.push_back(surface.labels.triangle_labels.number(t, surface.labels.first_number));
    part.triangles.push_back(surface.mesh.surface.corners(t));
  }
  result.text = "no solution: the values given on the boundary of " +
                counted(static_cast<long long>(found.triangles.size()), "triangle") + " are all " +
                (found.forbidding > 0 ? "+1" : "-1") + ", and no vertex lies inside\n";
  result.json = {{"solvable", false},
                 {"obstruction", {{"triangles", std::move(triangles)}, {"forbidding", found.forbidding}}}};
  if (!options.obstruction.empty()) {
    mesh::Repaired tidy = mesh::repair(std::move(part));
    result.files.push_back(
        {options.obstruction,
         format::write_soup(tidy.soup, *format::mesh_format_for_extension(options.obstruction))});
  }
  return result;
}

/// What the dissertation proves of its gluings, asked of ours.
void audit(const Plan& plan) {
  if (plan.method == Plan::Method::canonical_loops)
    if (const std::string why = mesh::why_not_canonical(plan.cut); !why.empty()) throw PreconditionError(why);
  for (const auto& pair : bundle::bands(plan.cut))
    if (const std::string why = bundle::why_not_gluable(pair, plan.recipe); !why.empty())
      throw PreconditionError(why);
}

Json cut_json(const Plan& plan) {
  Json curves = Json::array();
  for (const auto& pair : bundle::bands(plan.cut))
    curves.push_back({{"edges", pair[0].sides.size()}, {"twist", bundle::twist_along(pair[0], plan.recipe)}});
  Json json{{"along", name_of(plan.method)}, {"curves", std::move(curves)}};
  if (plan.method == Plan::Method::canonical_loops) json["word"] = mesh::boundary_word(plan.cut);
  return json;
}

/// A field of directions on the surface, and a section of the bundle at random.
struct Singularities {
  std::vector<int> field;
  std::vector<int> section;
};

Singularities singularities(const Plan& plan, const bundle::CircleBundle& bundle, const bundle::Proof& proof,
                            const std::vector<double>& field, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<double> direction(static_cast<std::size_t>(bundle.base.vertex_count()));
  for (double& d : direction) d = random.uniform() * 2 * std::numbers::pi;
  if (!field.empty())
    direction = bundle::projected_field(bundle.base, plan.cut.points, {field[0], field[1], field[2]});
  std::vector<double> place(direction.size());
  for (double& p : place) p = random.uniform() * bundle.fiber;
  return {bundle::field_indices(bundle.base, plan.cut.points, direction),
          bundle::indices(bundle, proof.fibers, bundle::short_section(bundle, proof.fibers, place))};
}

Json index_json(const std::vector<int>& index) {
  int sum = 0;
  int broken = 0;
  for (const int i : index) {
    sum += i;
    broken += i != 0 ? 1 : 0;
  }
  return {{"singular_triangles", broken}, {"index_sum", sum}};
}

/// The total space with its projection.
format::Document document_of(const Plan& plan, const bundle::CircleBundle& bundle,
                             const bundle::Proof& proof) {
  format::Document document = format::document_of(bundle.total);
  format::FiberCoordinates& fibers = document.bundle.emplace();
  fibers.fiber = bundle.fiber;
  if (proof.has_euler_number) fibers.euler_number = proof.euler_number;
  fibers.base_vertices = plan.cut.points;
  for (int t = 0; t < bundle.base.triangle_count(); ++t)
    fibers.base_triangles.push_back(bundle.base.corners(t));
  for (int t = 0; t < bundle.total.size(); ++t) {
    fibers.triangle_of.push_back(bundle.triangle(t));
    std::array<int, 4>& vertices = fibers.vertices.emplace_back();
    std::array<int, 4>& levels = fibers.levels.emplace_back();
    for (int v = 0; v < 4; ++v) {
      vertices[v] = bundle.base.corners(bundle.triangle(t))[bundle.corner({t, v})];
      levels[v] = bundle.level({t, v});
    }
  }
  return document;
}

void add_outputs(Result& result, const Plan& plan, const bundle::CircleBundle& bundle,
                 const format::Document& document, const std::vector<int>& index,
                 const BundleArguments& options) {
  const auto scene_of = [&](const std::string& path) {
    const bool cells = format::has_extension(path, ".vtu") || plan.method == Plan::Method::disk;
    if (options.show == "surface") return show::cut_surface(plan, index);
    return cells ? show::solid_tori(plan, bundle) : show::gluable_tori(plan);
  };
  for (const std::string& path : options.outputs) {
    if (format::has_extension(path, ".svg"))
      result.files.push_back({path, write_svg(show::gluable_bands(plan))});
    else if (const auto format = scene::scene_format_for_extension(path))
      result.files.push_back({path, write_scene(scene_of(path), *format)});
    else
      add_file(result, path, document);
  }
}

void require_room(const PlanOptions& wanted, double triangles, const Context& context) {
  require_memory("--fiber " + std::to_string(wanted.fiber),
                 bundle::bundle_bytes(3.0 * wanted.fiber * triangles), allowed_gigabytes(context));
}

/// Before anything is computed: a twisted edge has two sides, a triangle three.
void require_room(const PlanOptions& wanted, const SurfaceInput& surface, const SurfaceType& type,
                  const Context& context) {
  const int euler = wanted.euler.value_or(type.is_closed() ? type.euler : 0);
  const double twisted = 2.0 * std::abs(euler) * wanted.fiber / 3;
  require_room(wanted, std::max<double>(surface.mesh.surface.triangle_count(), twisted), context);
}

/// A bundle that is proved to be what was planned; a failure here is ours.
struct ProvedBundle {
  bundle::CircleBundle bundle;
  bundle::Proof proof;
};

ProvedBundle make_bundle(const Plan& plan, const Context& context) {
  audit(plan);
  bundle::CircleBundle bundle = bundle::assemble(plan.recipe, context.progress);
  bundle::Proof proof = bundle::prove(bundle, Skeleton(bundle.total), context.progress);
  if (!proof.failure.empty()) throw PreconditionError(proof.failure);
  if (proof.has_euler_number && proof.euler_number != plan.euler)
    throw PreconditionError("the Euler number counted is " + std::to_string(proof.euler_number));
  return {std::move(bundle), std::move(proof)};
}

Json details_json(const Plan& plan, const ProvedBundle& made, const Singularities& singular) {
  Json json;
  json["fiber"] = made.bundle.fiber;
  json["euler_number"] = made.proof.has_euler_number ? Json(made.proof.euler_number) : Json();
  json["closed"] = made.proof.has_euler_number;
  json["refined"] = {{"triangles", made.bundle.base.triangle_count()}, {"splits", plan.splits()}};
  json["cut"] = cut_json(plan);
  // A tangent field is a section of the unit tangent bundle alone.
  const bool tangent =
      made.proof.has_euler_number && made.proof.euler_number == mesh::type_of(made.bundle.base).euler;
  json["field"] = tangent ? index_json(singular.field) : Json();
  json["section"] = made.proof.has_euler_number ? index_json(singular.section) : Json();
  return json;
}

using Rows = std::vector<std::pair<std::string, std::string>>;

Rows details_rows(const Plan& plan, const Json& details, const ProvedBundle& made,
                  const BundleArguments& options) {
  Rows rows{{"cut along", name_of(plan.method)},
            {"refined by", counted(plan.splits(), "split")},
            {"fibres", counted(made.bundle.base.vertex_count(), "circle") + " of " +
                           counted(made.bundle.fiber, "edge")},
            {"Euler number",
             made.proof.has_euler_number ? std::to_string(made.proof.euler_number) : "none (boundary)"}};
  if (const Json& field = details["field"]; !field.is_null())
    rows.emplace_back(options.field.empty() ? "random field" : "field",
                      counted(field["singular_triangles"].integer(), "singular triangle") +
                          ", indices adding up to " + std::to_string(field["index_sum"].integer()));
  return rows;
}

Result run_bundle(const BundleArguments& options, const Context& context) {
  require_outputs(options);
  const SurfaceInput surface = read_surface(options.input, context, options.doctor);
  const PlanOptions wanted = plan_options(options, surface);
  const SurfaceType type = mesh::type_of(surface.mesh.surface);
  require_room(wanted, surface, type, context);
  const auto planned =
      bundle::plan(mesh::MarkedSurface(surface.mesh.surface, surface.mesh.points), wanted, context.progress);
  if (const auto* found = std::get_if<bundle::Obstruction>(&planned))
    return obstructed(*found, surface, options);
  const Plan& plan = std::get<Plan>(planned);
  require_room(wanted, plan.cut.surface.triangle_count(), context);
  const ProvedBundle made = make_bundle(plan, context);

  constexpr int small = 2'000; // tetrahedra; beyond, nobody reads a signature or a group
  Info info = info_of(made.bundle.total, "", context, made.bundle.total.size() > small);
  // A signature as long as a page is for programs.
  if (!info.rows.empty() && info.rows.back().second.size() > 100) info.rows.pop_back();
  const Singularities singular = singularities(plan, made.bundle, made.proof, options.field, context.seed);
  const Json details = details_json(plan, made, singular);
  const int triangles = surface.mesh.surface.triangle_count();
  Rows rows{{"surface", type.str() + ", " + counted(triangles, "triangle") + ", Euler characteristic " +
                            std::to_string(type.euler)}};
  for (const Rows& more : {details_rows(plan, details, made, options), info.rows})
    rows.insert(rows.end(), more.begin(), more.end());
  Result result;
  result.warnings = surface.warnings;
  if (!options.obstruction.empty())
    result.warnings.push_back("there is no obstruction: " + in_quotes(options.obstruction) +
                              " was not written");
  result.text = block(rows);
  result.json = std::move(info.json);
  result.json["surface"] = {{"type", type.str()}, {"triangles", triangles}, {"euler", type.euler}};
  result.json.update(details);
  format::Document document = document_of(plan, made.bundle, made.proof);
  add_outputs(result, plan, made.bundle, document, singular.field, options);
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
      .value_name("FILE");
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
      .value_name("FILE");
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_bundle(*o, context); };
}

} // namespace tetrarch::program
