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
#include "tetrarch/slit/matching.hpp"
#include "tetrarch/slit/registration.hpp"
#include "tetrarch/slit/unflip.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>

namespace tetrarch::program {
namespace {

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

workshop::HoledSurface read_input(const std::string& path, const Doctor& doctor, Result& result,
                                  const Context& context) {
  const SurfaceInput input = read_surface(path, context, doctor);
  result.warnings.insert(result.warnings.end(), input.warnings.begin(), input.warnings.end());
  return workshop::opened(input);
}

/// Of each loop of the first surface the loop of the second one.
std::vector<int> matching(const RegisterArguments& options, const workshop::HoledSurface& first,
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

slit::OneForms one_forms(const workshop::HoledSurface& input, const std::string& path,
                         const Progress& progress) {
  try {
    return slit::OneForms(input.mesh(), progress, slit::Edges::intrinsic_delaunay);
  } catch (const InputError& e) {
    throw InputError({path, 0}, e.what());
  }
}

slit::CircularMap circles(const slit::OneForms& forms, int outer, int inner, bool unflip, Result& result) {
  slit::CircularMap map = slit::circular_map(forms, slit::slit_map(forms, outer, inner));
  slit::unflip_in_disk(forms.mesh(), map, unflip ? slit::Unflip::everywhere : slit::Unflip::at_slits);
  if (!map.domain.found) {
    result.status = Status::undecided;
    result.warnings.emplace_back("the budget of rounds ended before the circles became round");
  }
  return map;
}

/// Of each loop of the first surface the loop of the second one, with what is known of it.
struct Candidate {
  std::vector<int> match;
  double distance = 0; ///< between the circular domains
};

/// The matchings between which circles do not decide, the best one first, and one more.
std::vector<Candidate> loop_candidates(const slit::CircularMap& a, const slit::CircularMap& b) {
  std::vector<Candidate> result;
  for (const slit::Matching& m : slit::best_matchings(a.domain.circles, b.domain.circles)) {
    Candidate c{std::vector<int>(a.loop.size()), m.distance};
    for (std::size_t k = 0; k < a.loop.size(); ++k)
      c.match[a.loop[k]] = b.loop[static_cast<std::size_t>(m.to[k])];
    result.push_back(std::move(c));
  }
  return result;
}

/// Circles of surfaces that are the same come as near as triangles let them.
bool is_as_good(const Candidate& c, const Candidate& best) {
  constexpr double noise = 2e-3;
  return c.distance < 2 * best.distance + noise;
}

/// A registration, how its loops were matched, and what to say of that.
struct Found {
  slit::Registration registration;
  std::vector<int> match;
  Json search; ///< null if the matching was given
  std::string text;
};

/// Whether a registration is clearly more conformal than another, or about as conformal and closer in space.
/// Angles come first, as the sizes of the surfaces may differ and bends are no fault.
bool is_better(const slit::Registration& r, const slit::Registration& than) {
  const auto score = [](const slit::Registration& one) {
    constexpr double flipped = 10; // stands for the ratio of axes of a flipped triangle
    const auto n = static_cast<double>(std::max<std::size_t>(one.quasi_conformal.size(), 1));
    return one.mean_quasi_conformal - 1 + flipped * static_cast<double>(one.flipped.size()) / n;
  };
  constexpr double clearly = 0.9;
  constexpr double rounding = 1e-9;
  if (score(r) < clearly * score(than) - rounding) return true;
  return score(than) >= clearly * score(r) - rounding && r.mean_distance < than.mean_distance;
}

/// Tries all matchings that circles allow, and takes the most conformal one; of equal ones that by which the
/// surfaces come closest in space.
Found searched(const slit::OneForms& a, const slit::CircularMap& map_a, const slit::OneForms& b,
               slit::RegistrationOptions how, Result& result) {
  const slit::LoopPair pair = slit::farthest_loops(b);
  std::vector<Candidate> all = loop_candidates(map_a, circles(b, pair.outer, pair.inner, false, result));
  const auto end =
      std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return !is_as_good(c, all.front()); });
  const std::size_t tried = static_cast<std::size_t>(end - all.begin());
  std::optional<Found> best;
  for (std::size_t k = 0; k < tried; ++k) {
    how.matching = all[k].match;
    const slit::CircularMap map_b =
        circles(b, how.matching[map_a.loop[0]], how.matching[map_a.loop[1]], how.unflip, result);
    slit::Registration r = slit::registered(a, map_a, b.mesh(), map_b, how);
    if (best && !is_better(r, best->registration)) continue;
    best = Found{std::move(r),
                 all[k].match,
                 {{"distance", all[k].distance},
                  {"tried", tried},
                  {"next_distance", end == all.end() ? Json() : Json(end->distance)}},
                 "circles differ by " + scientific(all[k].distance, 1)};
  }
  if (end != all.end()) best->text += ", by the next best matching by " + scientific(end->distance, 1);
  if (tried > 1)
    result.warnings.push_back(
        counted(static_cast<long long>(tried), "matching") +
        " of the loops fit the circles; the most conformal one was taken, or of equal ones "
        "the closest in space (--match chooses another)");
  return std::move(*best);
}

void tell(Result& result, const Found& found) {
  const slit::Registration& r = found.registration;
  const std::vector<int>& match = found.match;
  result.json = {{"matching", match},
                 {"search", found.search},
                 {"mean_quasiconformal", r.mean_quasi_conformal},
                 {"max_quasiconformal", r.max_quasi_conformal},
                 {"mean_distance", r.mean_distance},
                 {"max_distance", r.max_distance},
                 {"flipped", r.flipped.size()},
                 {"outside", r.outside},
                 {"moved", r.moved}};
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k < match.size(); ++k)
    pairs.push_back(std::to_string(k) + " to " + std::to_string(match[k]));
  const auto flipped = static_cast<long long>(r.flipped.size());
  result.text =
      block({{"loops", joined(pairs, ", ")},
             {"matching", found.text},
             {"quasi-conformal",
              "mean " + fixed(r.mean_quasi_conformal, 4) + ", greatest " + fixed(r.max_quasi_conformal, 4)},
             {"distances", "mean " + rounded(r.mean_distance) + ", greatest " + rounded(r.max_distance)},
             {"flipped", flipped == 0 ? "none" : counted(flipped, "triangle")}});
  if (flipped > 0)
    result.warnings.push_back(counted(flipped, "triangle") + (flipped == 1 ? " is" : " are") +
                              " inverted; --unflip moves vertices until no triangle is inverted");
}

/// The shape, with the places of its vertices in SECOND's disk and on FIRST.
format::MeshDocument document(const std::vector<std::array<double, 3>>& points,
                              const mesh::TriangleMesh& first, const slit::Registration& r,
                              const RegisterArguments& options) {
  using enum format::MeshField::On;
  format::MeshDocument mesh;
  mesh.soup.points = points;
  mesh.soup.triangles = first.surface.triangles();
  std::vector<std::array<double, 2>> places;
  places.reserve(r.position.size());
  for (const std::complex<double> z : r.position) places.push_back({z.real(), z.imag()});
  mesh.fields = {field_of("place", vertices, places), field_of("first", vertices, first.points),
                 field_of("quasi_conformal", triangles, r.quasi_conformal)};
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "register"}, {"first", options.first}, {"second", options.second}}.dump());
  return mesh;
}

std::string file(const std::string& path, const std::vector<std::array<double, 3>>& points,
                 const mesh::TriangleMesh& first, const slit::Registration& r,
                 const RegisterArguments& options) {
  if (is_json(path)) return write_mesh_json(document(points, first, r, options));
  scene::Scene scene;
  scene::Surface& surface = scene.surfaces.emplace_back();
  surface.name = "surface";
  surface.points = points;
  surface.triangles = first.surface.triangles();
  return scene::write_scene(scene, *scene::scene_format_for_extension(path));
}

Result run_register(const RegisterArguments& options, const Context& context) {
  for (const std::string& path : {options.resampled, options.average}) {
    if (path.empty()) continue;
    require_folder(path);
    if (!scene::scene_format_for_extension(path) && !is_json(path))
      throw InputError(
          {path, 0},
          "this command writes no file with this extension (expected .json, .obj, .ply, .vtu or .glb)");
  }
  Result result;
  const workshop::HoledSurface first = read_input(options.first, options.doctor, result, context);
  const workshop::HoledSurface second = read_input(options.second, options.doctor, result, context);
  if (first.loops.size() != second.loops.size())
    throw InputError({options.second, 0},
                     "has " + counted(static_cast<long long>(second.loops.size()), "boundary loop") +
                         ", but " + options.first + " has " + std::to_string(first.loops.size()));
  const slit::OneForms a = one_forms(first, options.first, context.progress);
  const slit::OneForms b = one_forms(second, options.second, context.progress);
  slit::LoopPair pair = slit::farthest_loops(a);
  if (!options.outer.empty() || !options.inner.empty())
    pair = {loop_named(options.outer.empty() ? "0" : options.outer, "--outer", first),
            loop_named(options.inner.empty() ? "1" : options.inner, "--inner", first)};
  slit::RegistrationOptions how;
  how.aligned = !options.as_placed;
  how.unflip = options.unflip;
  how.unflip_at_slits = true;
  const slit::CircularMap map_a = circles(a, pair.outer, pair.inner, options.unflip, result);
  Found found;
  if (options.match.empty()) {
    found = searched(a, map_a, b, how, result);
  } else {
    how.matching = found.match = matching(options, first, second);
    found.text = "given";
    const slit::CircularMap map_b =
        circles(b, how.matching[pair.outer], how.matching[pair.inner], options.unflip, result);
    found.registration = slit::registered(a, map_a, b.mesh(), map_b, how);
  }
  const slit::Registration& r = found.registration;
  tell(result, found);
  if (context.values != nullptr)
    result.value = std::make_shared<Value>(document(r.resampled, a.mesh(), r, options));
  if (!options.resampled.empty())
    result.files.push_back({options.resampled, file(options.resampled, r.resampled, a.mesh(), r, options)});
  if (!options.average.empty())
    result.files.push_back({options.average, file(options.average, r.average, a.mesh(), r, options)});
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
      .value_name("FILE");
  table.add("--average", o->average, "write the shape halfway between the two surfaces, in the same formats")
      .value_name("FILE");
  declare_doctor(table, o->doctor);
  o->doctor.split_pinches = true;
  return [o](const Context& context) { return run_register(*o, context); };
}

} // namespace tetrarch::program
