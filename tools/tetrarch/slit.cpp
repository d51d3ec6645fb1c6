// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "in_file.hpp"
#include "slit_files.hpp"
#include "slit_maps.hpp"
#include "slit_options.hpp"
#include "slit_report.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace tetrarch::program {
namespace {

/// Which option leads on from a surface that has no slit map.
std::string way_on(const SurfaceType& type) {
  if (!type.orientable) return {};
  if (type.genus() > 0) return "; --open-handles cuts it open";
  return type.boundary_curves == 0 ? "; --punch makes holes"
                                   : "; --domain circular maps it, --punch makes more holes";
}

void check_type(const mesh::Surface& surface, const SlitOptions& options) {
  const SurfaceType type = mesh::type_of(surface);
  const int least = (options.is_circular() || options.is_rectangle()) && !options.fingerprint ? 1 : 2;
  if (type.orientable && type.euler + type.boundary_curves == 2 && type.boundary_curves >= least) return;
  throw InputError({options.input, 0},
                   std::string("slit maps need a sphere with ") + (least == 1 ? "a hole" : "two holes") +
                       " at least, but this surface has type " + type.str() + way_on(type));
}

slit::Fingerprint fingerprint(const mesh::OpenedMesh& surface, std::optional<slit::LoopPair> pair,
                              const std::string& path, const Progress& progress) {
  constexpr int most_triangles = 500'000;
  return in_file(path, [&] { return slit::fingerprint(surface.mesh, pair, most_triangles, progress); });
}

/// Told: the distance, and which loop is which.
Report distance_report(const slit::Fingerprint& own, const slit::Fingerprint& other, bool with_mirror) {
  slit::MatchingOptions how;
  how.with_mirror_images = with_mirror;
  const std::vector<slit::Matching> found =
      slit::best_matchings(slit::circles(own), slit::circles(other), how);
  const slit::Matching& best = found.front();
  std::vector<int> matching(own.loops.size());
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k < own.loops.size(); ++k)
    matching[own.loops[k]] = other.loops[static_cast<std::size_t>(best.to[k])];
  for (std::size_t k = 0; k < matching.size(); ++k)
    pairs.push_back(std::to_string(k) + " to " + std::to_string(matching[k]));
  Report report;
  report.json = {{"distance", best.distance},
                 {"matching", matching},
                 {"mirrored", best.mirrored},
                 {"second_distance", found.size() > 1 ? Json(found[1].distance) : Json()}};
  report.rows = {{"distance", fixed(best.distance, 6)},
                 {"loops", joined(pairs, ", ") + (best.mirrored ? ", mirrored" : "")}};
  if (found.size() > 1)
    report.rows.emplace_back("next best", fixed(found[1].distance, 6) + ", by another matching");
  return report;
}

Result run_fingerprint(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                       const SlitOptions& options, Report report, const Context& context) {
  std::optional<slit::LoopPair> pair;
  if (!options.outer.empty() || !options.inner.empty()) pair = chosen(surface, loops, options);
  const slit::Fingerprint own = fingerprint(surface, pair, options.input, context.progress);
  report.rows.clear();
  report.add(fingerprint_report(own));
  Result result;
  if (!options.distance.empty()) {
    const SurfaceInput input = read_surface(options.distance, context, options.doctor);
    const mesh::OpenedMesh other = opened(input, {}, context.progress);
    check_type(other.mesh.surface, options);
    const slit::Fingerprint theirs = fingerprint(other, {}, options.distance, context.progress);
    report.add(distance_report(own, theirs, options.mirror));
    report.warnings.insert(report.warnings.end(), input.warnings.begin(), input.warnings.end());
    if (!theirs.found) result.status = Status::undecided;
  }
  result.text = block(report.rows);
  result.json = std::move(report.json);
  result.warnings = std::move(report.warnings);
  if (!own.found) result.status = Status::undecided;
  return result;
}

Result run_slit(const SlitOptions& options, const Context& context) {
  require_sense(options);
  const SurfaceInput input = read_surface(options.input, context, options.doctor);
  const mesh::OpenedMesh surface =
      in_file(options.input, [&] { return opened(input, options.openings, context.progress); });
  const std::vector<mesh::BoundaryLoop> loops = mesh::boundary_loops(surface.mesh);
  Report report = loops_report(surface, loops);
  report.warnings = input.warnings;
  Result result;
  if (options.list_loops) {
    result.text = loops.empty() ? "no boundary\n" : block(report.rows);
    result.json = std::move(report.json);
    result.warnings = std::move(report.warnings);
    return result;
  }
  // What the map would refuse, said before a loop is missed.
  check_type(surface.mesh.surface, options);
  if (options.fingerprint || !options.distance.empty())
    return run_fingerprint(surface, loops, options, std::move(report), context);
  const auto start = std::chrono::steady_clock::now();
  const MadeSlitMap made = slit_map(surface, loops, options, context.progress);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.json["domain"] = options.domain;
  report.rows = {{"surface", mesh::type_of(surface.mesh.surface).str() + ", " +
                                 counted(surface.mesh.surface.triangle_count(), "triangle")},
                 {"domain", options.domain}};
  report.add(made.report);
  report.json["seconds"] = seconds; // from the mesh to the map, files apart
  const auto [scale, shift] = std::pair(made.layout.texture_scale, made.layout.texture_shift);
  report.json["texture"] = {{"scale", scale}, {"shift", shift}};
  if (!options.outputs.empty())
    report.rows.emplace_back("texture", "the domain times " + rounded(scale) +
                                            (shift == 0 ? "" : ", plus " + rounded(shift)));
  result.text = block(report.rows);
  result.json = std::move(report.json);
  result.warnings = std::move(report.warnings);
  const bool folds = made.flipped > 0 && !options.allow_flips;
  if (!made.found || folds) result.status = Status::undecided;
  for (const std::string& path : options.outputs)
    result.files.push_back({path, slit_file(path, made, options)});
  if (context.values != nullptr) result.value = std::make_shared<Value>(slit_document(made, options));
  return result;
}

} // namespace

Run declare_slit(OptionTable& table) {
  const auto options = std::make_shared<SlitOptions>();
  declare(table, *options);
  return [options](const Context& context) { return run_slit(*options, context); };
}

} // namespace tetrarch::program
