// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "output.hpp"
#include "slit_openings.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/workshop/registration.hpp"

#include <memory>
#include <sstream>

namespace tetrarch::program {
namespace {

using Points = std::vector<std::array<double, 3>>;

struct RegisterArguments {
  std::string first;
  std::string second;
  std::string outer;
  std::string inner;
  std::string match;
  std::string resampled;
  std::string average;
  bool unflip = false;
  bool as_placed = false;
  Doctor doctor;
};

bool is_json(const std::string& path) {
  return format::has_extension(path, ".json");
}

void require_register_outputs(const RegisterArguments& options) {
  for (const std::string& path : {options.resampled, options.average}) {
    if (path.empty()) continue;
    if (!scene::scene_format_for_extension(path) && !is_json(path))
      throw InputError(
          {path, 0},
          "this command writes no file with this extension (expected .json, .obj, .ply, .vtu or .glb)");
  }
}

workshop::HoledSurface read_input(const std::string& path, const Doctor& doctor, Result& result,
                                  const Context& context) {
  const SurfaceInput input = read_surface(path, context, doctor);
  result.warnings.insert(result.warnings.end(), input.warnings.begin(), input.warnings.end());
  return workshop::opened(input);
}

/// Of each loop of the first surface the loop of the second one.
std::vector<int> matching_named(const RegisterArguments& options, const workshop::HoledSurface& first,
                                const workshop::HoledSurface& second) {
  std::vector<int> result;
  std::istringstream words(options.match);
  for (std::string word; std::getline(words, word, ',');)
    result.push_back(loop_named(word, "--match", second));
  if (result.size() != first.loops.size())
    throw InputError("--match " + in_quotes(options.match) + ": expected a loop of " + options.second +
                     " for each of the " +
                     counted(static_cast<long long>(first.loops.size()), "boundary loop") + " of " +
                     options.first);
  return result;
}

workshop::RegisterOptions register_options(const RegisterArguments& options,
                                           const workshop::HoledSurface& first,
                                           const workshop::HoledSurface& second) {
  workshop::RegisterOptions how;
  how.names = {options.first, options.second};
  how.unflip = options.unflip;
  how.as_placed = options.as_placed;
  if (first.loops.size() != second.loops.size()) return how; // which is refused before a loop is missed
  if (!options.outer.empty() || !options.inner.empty())
    how.circles = circles_named(options.outer, options.inner, first);
  if (!options.match.empty()) how.matching = matching_named(options, first, second);
  return how;
}

/// Where it came from, too.
format::MeshDocument register_document(const workshop::SurfaceRegistration& found, const Points& points,
                                       const RegisterArguments& options) {
  format::MeshDocument mesh = document_of(found, points);
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "register"}, {"first", options.first}, {"second", options.second}}.dump());
  return mesh;
}

std::string register_file(const std::string& path, const workshop::SurfaceRegistration& found,
                          const Points& points, const RegisterArguments& options) {
  if (is_json(path)) return write_mesh_json(register_document(found, points, options));
  scene::Scene scene;
  scene::Surface& surface = scene.surfaces.emplace_back();
  surface.name = "surface";
  surface.points = points;
  surface.triangles = found.first.mesh().surface.triangles();
  return scene::write_scene(scene, *scene::scene_format_for_extension(path));
}

Result run_register(const RegisterArguments& options, const Context& context) {
  require_register_outputs(options);
  Result result;
  workshop::HoledSurface first = read_input(options.first, options.doctor, result, context);
  const workshop::HoledSurface second = read_input(options.second, options.doctor, result, context);
  const workshop::RegisterOptions how = register_options(options, first, second);
  const workshop::SurfaceRegistration found =
      workshop::registration(std::move(first), second, how, context.progress);
  result.status = status_of(found.verdict());
  result.json = tree_of(found);
  result.text = block(rows_of(found));
  for (const std::string& remark : found.remarks()) result.warnings.push_back(remark);
  const slit::Registration& r = found.points;
  if (context.values != nullptr)
    result.value = std::make_shared<Value>(register_document(found, r.resampled, options));
  if (!options.resampled.empty())
    result.files.push_back(
        {options.resampled, register_file(options.resampled, found, r.resampled, options)});
  if (!options.average.empty())
    result.files.push_back({options.average, register_file(options.average, found, r.average, options)});
  return result;
}

} // namespace

Run declare_register(OptionTable& table) {
  const auto o = std::make_shared<RegisterArguments>();
  table.add("FIRST", o->first, "a sphere with two or more holes: OBJ, OFF, PLY or STL").required();
  table.add("SECOND", o->second, "a surface with equally many holes").required();
  table
      .add("--match", o->match,
           "the loop of SECOND that matches each boundary loop of FIRST, such as 0,2,1 or v3,v17,v20 "
           "(default: found by the circles of both)")
      .value_name("LIST");
  table
      .add("--outer", o->outer,
           "the loop of FIRST that becomes the outer circle of the disk, named as for slit (default: with "
           "--inner, the two loops of greatest modulus)")
      .value_name("LOOP");
  table.add("--inner", o->inner, "the loop of FIRST that becomes a circle about the center of the disk")
      .value_name("LOOP");
  table.add("--unflip", o->unflip, "move vertices in the disks until no triangle is inverted");
  table.add("--as-placed", o->as_placed,
            "compare and average the surfaces in place, without moving SECOND to FIRST");
  table
      .add("-o,--output", o->resampled,
           "write SECOND's shape with FIRST's vertices and triangles (.json, .obj, .ply, .vtu or .glb)")
      .output_file();
  table.add("--average", o->average, "write the shape halfway between the two surfaces, in the same formats")
      .output_file();
  declare_doctor(table, o->doctor);
  o->doctor.split_pinches = true;
  return [o](const Context& context) { return run_register(*o, context); };
}

} // namespace tetrarch::program
