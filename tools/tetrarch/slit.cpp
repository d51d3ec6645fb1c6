// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "output.hpp"
#include "surface_input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/slit.hpp"
#include "tetrarch/slit/quality.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <memory>

namespace tetrarch::program {
namespace {

using scene::SlitDomain;

struct Options {
  std::string input;
  std::vector<std::string> outputs;
  std::string domain = "concentric";
  std::string outer = "0";
  std::string inner = "1";
  bool list_loops = false;
  bool repair = false;
};

/// Of one of the names that are allowed.
SlitDomain domain_named(const std::string& name) {
  if (name == "cylindric") return SlitDomain::cylindric;
  return name == "parallel" ? SlitDomain::parallel : SlitDomain::concentric;
}

void require_outputs(const Options& options) {
  for (const std::string& path : options.outputs) {
    require_folder(path);
    if (!format::has_extension(path, ".svg") && !scene::scene_format_for_extension(path))
      throw InputError({path, 0}, "nothing that can be written has this extension (expected .obj, .vtu, "
                                  ".svg, .glb or .ply)");
  }
}

/// The number of a vertex in the file, counted from 0.
long long number_in_file(const SurfaceInput& surface, int vertex) {
  return format::point_number(surface.labels, vertex) - surface.labels.first_number;
}

/// The loop that "2" or "v17" means.
int loop_named(const std::string& name, const char* option, const SurfaceInput& surface,
               const std::vector<mesh::BoundaryLoop>& loops) {
  const auto fail = [&](const std::string& why) -> InputError {
    return InputError(std::string(option) + " " + in_quotes(name) + ": " + why);
  };
  const bool by_vertex = name.starts_with('v');
  const char* const first = name.data() + (by_vertex ? 1 : 0);
  const char* const last = name.data() + name.size();
  int number = -1;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last || number < 0)
    throw fail("expected the number of a loop, or v17 for the loop through vertex 17");
  if (by_vertex) {
    for (std::size_t k = 0; k < loops.size(); ++k)
      for (const mesh::SideEnd e : loops[k].sides)
        if (number_in_file(surface, surface.mesh.surface.vertex(e)) == number) return static_cast<int>(k);
    throw fail("no boundary loop runs through this vertex");
  }
  if (number >= static_cast<int>(loops.size()))
    throw fail("there is no such loop; the surface has " +
               counted(static_cast<long long>(loops.size()), "boundary loop") + ", counted from 0");
  return number;
}

Json loops_json(const SurfaceInput& surface, const std::vector<mesh::BoundaryLoop>& loops) {
  Json list = Json::array();
  for (const mesh::BoundaryLoop& loop : loops)
    list.push_back({{"index", list.size()},
                    {"edges", loop.sides.size()},
                    {"length", loop.length},
                    {"area", loop.area},
                    {"vertex", number_in_file(surface, surface.mesh.surface.vertex(loop.sides.front()))}});
  return list;
}

Result listed(const SurfaceInput& surface, const std::vector<mesh::BoundaryLoop>& loops) {
  Result result;
  result.warnings = surface.warnings;
  result.json["boundaries"] = loops_json(surface, loops);
  for (const Json& loop : result.json["boundaries"])
    result.text += "boundary loop " + loop["index"].dump() + ": " +
                   counted(loop["edges"].get<long long>(), "edge") + ", length " +
                   rounded(loop["length"].get<double>()) + ", area " + rounded(loop["area"].get<double>()) +
                   ", through v" + loop["vertex"].dump() + "\n";
  if (loops.empty()) result.text = "no boundary\n";
  return result;
}

/// A map with everything that is told of it.
struct Made {
  slit::OneForms forms;
  slit::SlitMap map;
  slit::Distortion distortion;
  slit::Residuals residuals;
};

/// What is wrong with a triangle is wrong in a file.
slit::OneForms one_forms(mesh::TriangleMesh mesh, const std::string& path, const Progress& progress) {
  try {
    return slit::OneForms(std::move(mesh), progress);
  } catch (const InputError& e) {
    throw InputError({path, 0}, e.what());
  }
}

Made make(slit::OneForms forms, int outer, int inner, SlitDomain domain) {
  slit::SlitMap map = slit::slit_map(forms, outer, inner);
  slit::Distortion distortion = domain == SlitDomain::concentric ? slit::distortion_on_ring(forms, map)
                                                                 : slit::distortion_on_cylinder(forms, map);
  const slit::Residuals residuals = slit::residuals(forms, map);
  return {std::move(forms), std::move(map), std::move(distortion), residuals};
}

Json map_json(const Made& made, const std::string& domain) {
  const slit::SlitMap& map = made.map;
  const bool is_ring = domain == "concentric";
  Json json{{"domain", domain},
            {"outer", map.outer},
            {"inner", map.inner},
            {"modulus", map.modulus},
            {"modulus_bounds", {map.modulus, map.modulus_bound}}};
  if (is_ring) json["radii"] = {{"outer", 1.0}, {"inner", std::exp(-map.modulus)}};
  Json slits = Json::array();
  for (const slit::Slit& s : map.slits) {
    Json one{{"loop", s.loop}};
    if (is_ring)
      one["radius"] = s.radius;
    else
      one["height"] = -map.log_radius[s.start_vertex];
    one["start"] = s.start;
    one["end"] = s.end;
    slits.push_back(std::move(one));
  }
  json["slits"] = std::move(slits);
  const slit::Distortion& d = made.distortion;
  json["max_angle_error"] = d.max_angle_error;
  json["mean_angle_error"] = d.mean_angle_error;
  json["max_quasiconformal"] = d.max_quasi_conformal;
  json["mean_quasiconformal"] = d.mean_quasi_conformal;
  json["flipped"] = d.flipped.size();
  json["ears"] = d.ears;
  const slit::Residuals& r = made.residuals;
  json["residuals"] = {
      {"period", r.period}, {"flux", r.flux}, {"harmonic", r.harmonic}, {"radius", r.radius}};
  return json;
}

std::string map_text(const Made& made, const std::string& domain, const std::string& type) {
  const slit::SlitMap& map = made.map;
  const slit::Distortion& d = made.distortion;
  const slit::Residuals& r = made.residuals;
  const bool is_ring = domain == "concentric";
  std::vector<std::pair<std::string, std::string>> rows{
      {"surface", type + ", " + counted(made.forms.mesh().surface.triangle_count(), "triangle")},
      {"domain", domain + ", from loop " + std::to_string(map.outer) + " (outer) to " +
                     std::to_string(map.inner) + " (inner)"},
      {"modulus", fixed(map.modulus, 6) + ", at most " + fixed(map.modulus_bound, 6)}};
  if (is_ring) rows.emplace_back("inner radius", fixed(std::exp(-map.modulus), 6));
  for (const slit::Slit& s : map.slits)
    rows.emplace_back(
        "slit of loop " + std::to_string(s.loop),
        (is_ring ? "radius " + fixed(s.radius, 6) : "height " + fixed(-map.log_radius[s.start_vertex], 6)) +
            ", angle " + fixed(s.start, 6) + " to " + fixed(s.end, 6));
  rows.emplace_back("angle errors", "mean " + scientific(d.mean_angle_error, 1) + ", greatest " +
                                        scientific(d.max_angle_error, 1));
  rows.emplace_back("quasi-conformal", "mean " + fixed(d.mean_quasi_conformal, 4) + ", greatest " +
                                           fixed(d.max_quasi_conformal, 4));
  rows.emplace_back(
      "flipped", d.flipped.empty() ? "none" : counted(static_cast<long long>(d.flipped.size()), "triangle"));
  rows.emplace_back("residuals", "periods " + scientific(r.period, 1) + ", fluxes " + scientific(r.flux, 1) +
                                     ", harmonic " + scientific(r.harmonic, 1) + ", radii " +
                                     scientific(r.radius, 1));
  return block(rows);
}

void warn(Result& result, const Made& made) {
  const std::vector<int>& flipped = made.distortion.flipped;
  if (!flipped.empty())
    result.warnings.push_back(counted(static_cast<long long>(flipped.size()), "triangle") +
                              (flipped.size() == 1 ? " is" : " are") + " flipped or flat, the first is " +
                              std::to_string(flipped.front()) + " (counted from 0)");
  if (const int ears = made.distortion.ears; ears > 0)
    result.warnings.push_back(counted(ears, "triangle") + (ears == 1 ? " has" : " have") +
                              " all corners on one loop and no room on the domain");
  for (const slit::Slit& s : made.map.slits)
    if (s.turns != 2)
      result.warnings.push_back("loop " + std::to_string(s.loop) + " turns back " + std::to_string(s.turns) +
                                " times on its slit instead of twice");
}

void add_outputs(Result& result, const Made& made, const Options& options) {
  const SlitDomain domain = domain_named(options.domain);
  for (const std::string& path : options.outputs) {
    const auto content = [&] {
      if (format::has_extension(path, ".svg"))
        return scene::write_svg(scene::slit_drawing(made.forms, made.map, domain));
      const scene::SceneFormat format = *scene::scene_format_for_extension(path);
      if (format == scene::SceneFormat::obj) return scene::textured_obj(made.forms, made.map, domain);
      if (format == scene::SceneFormat::vtu)
        return scene::write_scene(scene::textured_surface(made.forms, made.map, domain), format);
      return scene::write_scene(scene::slit_domain(made.forms, made.map, domain), format);
    };
    result.files.push_back({path, content()});
  }
}

Result run_slit(const Options& options, const Context& context) {
  require_outputs(options);
  SurfaceInput surface = read_surface(options.input, options.repair);
  const std::vector<mesh::BoundaryLoop> loops = mesh::boundary_loops(surface.mesh);
  Result result = listed(surface, loops);
  if (options.list_loops) return result;
  const SurfaceType type = mesh::type_of(surface.mesh.surface);
  // What the map would refuse, said before a loop is missed.
  if (!type.orientable || type.euler + type.boundary_curves != 2 || loops.size() < 2)
    throw InputError({options.input, 0},
                     "slit maps need a sphere with two holes at least, but this surface has type " +
                         type.str());
  const int outer = loop_named(options.outer, "--outer", surface, loops);
  const int inner = loop_named(options.inner, "--inner", surface, loops);
  const auto start = std::chrono::steady_clock::now();
  const Made made = make(one_forms(std::move(surface.mesh), options.input, context.progress), outer, inner,
                         domain_named(options.domain));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.text = map_text(made, options.domain, type.str());
  result.json.update(map_json(made, options.domain));
  result.json["seconds"] = seconds; // from the mesh to the map, files apart
  warn(result, made);
  add_outputs(result, made, options);
  return result;
}

} // namespace

Run declare_slit(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("SURFACE", o->input, "a sphere with two holes or more: OBJ, OFF, PLY or STL")->required();
  app.add_option("--domain", o->domain, "a cylinder with slits, the same unrolled, or a ring with slits")
      ->check(CLI::IsMember({"cylindric", "parallel", "concentric"}))
      ->capture_default_str();
  app.add_option("--outer", o->outer,
                 "the loop that becomes the outer circle: its number, from 0 by decreasing length, or v17: "
                 "the loop through vertex 17, counted from 0")
      ->capture_default_str();
  app.add_option("--inner", o->inner, "the loop that becomes the inner circle, likewise")
      ->capture_default_str();
  app.add_flag("--list-loops", o->list_loops, "list the boundary loops, and no more");
  app.add_option("-o,--output", o->outputs,
                 "the surface with the domain as texture coordinates (.obj, .vtu), or the domain: .svg, or "
                 ".glb or .ply as a surface; may be repeated")
      ->allow_extra_args(false);
  app.add_flag("--repair", o->repair,
               "mend orientation, unused vertices, duplicates, degenerate triangles first");
  return [o](const Context& context) { return run_slit(*o, context); };
}

} // namespace tetrarch::program
