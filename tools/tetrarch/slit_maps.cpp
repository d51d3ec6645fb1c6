// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_maps.hpp"

#include "in_file.hpp"
#include "slit_report.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/slit/ricci.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace tetrarch::program {
namespace {

using show::SlitDomain;

/// Of one of the names that are allowed.
SlitDomain domain_named(const std::string& name) {
  if (name == "cylindric") return SlitDomain::cylindric;
  return name == "parallel" ? SlitDomain::parallel : SlitDomain::concentric;
}

/// Told, and kept for files.
void add_distortion(MadeSlitMap& made, const slit::Distortion& distortion) {
  made.report.add(distortion_report(distortion));
  made.flipped = distortion.flipped.size();
  made.quasi_conformal = distortion.mean_quasi_conformal;
  made.fields.triangles = {{"quasi_conformal", distortion.quasi_conformal},
                           {"log_factor", distortion.log_factor}};
}

/// What was balanced, and how it was before.
void add_distortion(MadeSlitMap& made, const slit::Balanced& balanced, const slit::Distortion& before) {
  made.report.add(balanced_report(balanced, before));
  made.found = made.found && balanced.settled;
}

/// How many quads around the ring have edges of this length in the mean.
int around_for(const mesh::TriangleMesh& mesh, const slit::SlitMap& map, double edge) {
  const double around = slit::quads_around(mesh, map, edge);
  constexpr double fewest = 3;
  constexpr double most = 1'000'000;
  if (!(around > fewest - 0.5 && around < most))
    throw InputError("--quad-edge " + rounded(edge) + ": this makes " + rounded(around) +
                     " quads around the ring, and 3 to 1000000 are possible");
  return static_cast<int>(std::lround(around));
}

MadeSlitMap make_slits(const slit::OneForms& forms, slit::SlitMap map, const SlitOptions& options,
                       const Progress& progress) {
  const SlitDomain domain = domain_named(options.domain);
  const bool on_ring = domain == SlitDomain::concentric;
  if (on_ring) in_file(options.input, [&] { slit::require_radii(map); });
  MadeSlitMap made;
  made.mesh = forms.mesh();
  made.report = map_report(map, on_ring);
  // Vertices that are moved later are no longer harmonic.
  const slit::Residuals residuals = slit::residuals(forms, map);
  // A slit turns back between vertices, whatever the mesh is: that much is always put right.
  const slit::Unflip which = options.unflip ? slit::Unflip::everywhere : slit::Unflip::at_slits;
  const slit::Unflipped moved =
      on_ring ? slit::unflip_on_ring(forms, map, which) : slit::unflip_on_cylinder(forms, map, which);
  if (options.unflip || moved.moved > 0) made.report.add(unflipped_report(moved));
  const slit::Softened softened =
      on_ring ? slit::soften_ends_on_ring(forms, map) : slit::soften_ends_on_cylinder(forms, map);
  if (softened.moved > 0) made.report.add(softened_report(softened));
  const auto distortion = [&] {
    return on_ring ? slit::distortion_on_ring(forms, map) : slit::distortion_on_cylinder(forms, map);
  };
  if (options.balance) {
    const slit::Distortion before = distortion();
    add_distortion(made,
                   on_ring ? slit::balance_on_ring(forms, map, progress)
                           : slit::balance_on_cylinder(forms, map, progress),
                   before);
  }
  add_distortion(made, distortion());
  made.report.add(residuals_report(residuals));
  made.fields.vertices = {{"log_radius", map.log_radius}, {"angle", map.angle}};
  for (int k = 0; k < forms.loop_count(); ++k)
    made.fields.vertices.push_back({"potential_" + std::to_string(k), forms.potential(k)});
  made.layout = show::layout(forms, map, domain);
  if (options.has_quads()) {
    const int around = options.quads > 0 ? options.quads : around_for(forms.mesh(), map, options.quad_edge);
    made.quads = slit::quads(forms, map, around);
    made.report.add(quads_report(*made.quads));
  }
  return made;
}

/// The domain's shape is that of least distortion.
void make_free(MadeSlitMap& made, const slit::CircularMap& map, const Progress& progress) {
  const slit::Distortion before = slit::distortion_in_plane(made.mesh, map.position);
  const slit::FreeMap free = slit::free_map(made.mesh, map.position, progress);
  add_distortion(made, free.balanced, before);
  add_distortion(made, slit::distortion_in_plane(made.mesh, free.position));
  made.report.json["crossings"] = free.crossings;
  if (free.crossings > 0) {
    made.report.warnings.push_back("the domain overlaps itself: " + counted(free.crossings, "pair") +
                                   " of its boundary edges cross");
    made.found = false;
  }
  made.layout = show::plane_layout(made.mesh, free.position, "free domain");
}

MadeSlitMap make_circles(mesh::TriangleMesh mesh, slit::CircularMap map, const SlitOptions& options,
                         const Progress& progress) {
  MadeSlitMap made;
  made.mesh = std::move(mesh);
  if (!options.is_free()) made.report = circles_report(map);
  made.found = map.domain.found;
  if (!made.found)
    made.report.warnings.emplace_back("the budget of rounds ended before the circles became round");
  const slit::Unflip which = options.unflip ? slit::Unflip::everywhere : slit::Unflip::at_slits;
  const slit::Unflipped moved = slit::unflip_in_disk(made.mesh, map, which);
  if (options.unflip || moved.moved > 0) made.report.add(unflipped_report(moved));
  if (options.is_free()) {
    make_free(made, map, progress);
    return made;
  }
  if (options.balance) {
    const slit::Distortion before = slit::distortion_in_disk(made.mesh, map);
    add_distortion(made, slit::balance_in_disk(made.mesh, map, progress), before);
  }
  add_distortion(made, slit::distortion_in_disk(made.mesh, map));
  made.layout = show::disk_layout(made.mesh, map.position);
  return made;
}

MadeSlitMap make_disk(const mesh::OpenedMesh& surface, const SlitOptions& options, const Progress& progress) {
  const int center = options.center.empty() ? slit::innermost_vertex(surface.mesh)
                                            : vertex_named(options.center, "--center", surface);
  if (center < 0)
    throw InputError({options.input, 0},
                     "all vertices are on the boundary; the disk needs an interior vertex");
  slit::CircularMap map = in_file(options.input, [&] {
    return options.is_ricci() ? slit::ricci_circles(surface.mesh, 0, -1).map
                              : slit::disk_map(surface.mesh, center);
  });
  MadeSlitMap made = make_circles(surface.mesh, std::move(map), options, progress);
  made.report.json["center"] = surface.number[center];
  return made;
}

/// The picture after so many openings instead of the circular domain.
show::Layout stage_layout(const slit::OneForms& forms, const slit::SlitMap& map,
                          const slit::CircularMap& circular, int stage) {
  const auto last = static_cast<int>(map.slits.size());
  if (stage > last)
    throw InputError("--stage " + std::to_string(stage) + ": the last stage is " + std::to_string(last) +
                     ", with all slits open");
  show::Layout layout = show::disk_layout(
      forms.mesh(), slit::opening_stage(forms, map, circular, static_cast<std::size_t>(stage)));
  layout.name = "circular domain, " + counted(stage, "slit") + " open";
  return layout;
}

MadeSlitMap make_rectangle(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                           const SlitOptions& options, const Progress& progress) {
  const mesh::TriangleMesh& mesh = surface.mesh;
  std::array<int, 4> corners{};
  int outer = loop_named(options.outer.empty() ? "0" : options.outer, "--outer", surface, loops);
  if (options.corners.empty()) {
    corners = in_file(options.input, [&] { return slit::corners_of(mesh, loops[outer]); });
  } else {
    std::vector<std::string> words;
    std::istringstream list(options.corners);
    for (std::string word; std::getline(list, word, ',');) words.push_back(word);
    if (words.size() != corners.size())
      throw InputError("--corners " + in_quotes(options.corners) + ": expected four vertices");
    for (std::size_t c = 0; c < corners.size(); ++c)
      corners[c] = vertex_named(words[c].starts_with('v') ? words[c] : "v" + words[c], "--corners", surface);
    if (const int loop = mesh::loop_through(loops, mesh.surface, corners[0]); loop >= 0) outer = loop;
  }
  const slit::RicciRectangles found = in_file(options.input, [&] {
    return slit::ricci_rectangles(mesh, slit::rectangle_hints(mesh, corners, {}, progress), {}, progress);
  });
  MadeSlitMap made;
  made.mesh = mesh;
  made.found = found.found;
  std::vector<int> order{outer};
  for (int k = 0; k < static_cast<int>(loops.size()); ++k)
    if (k != outer) order.push_back(k);
  made.report = rectangle_report(found, surface, loops, order);
  if (!made.found)
    made.report.warnings.emplace_back(
        "the rectangle was not found: holes do not close, or triangles beside short "
        "loops break down (a finer mesh or other --corners may help)");
  add_distortion(made, slit::distortion_in_plane(mesh, found.position));
  made.layout = show::plane_layout(mesh, found.position, "rectangular domain");
  return made;
}

MadeSlitMap make_once(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                      const SlitOptions& options, const Progress& progress) {
  if (options.is_rectangle()) return make_rectangle(surface, loops, options, progress);
  if (loops.size() == 1) return make_disk(surface, options, progress);
  const slit::LoopPair circles = chosen(surface, loops, options);
  if (options.is_ricci()) {
    MadeSlitMap made = make_circles(
        surface.mesh,
        in_file(options.input,
                [&] {
                  return slit::ricci_circles(surface.mesh, circles.outer, circles.inner, {}, progress).map;
                }),
        options, progress);
    made.report.json["outer"] = circles.outer;
    made.report.json["inner"] = circles.inner;
    return made;
  }
  const slit::OneForms forms = in_file(options.input, [&] {
    return slit::OneForms(surface.mesh, progress,
                          options.intrinsic ? slit::Edges::intrinsic_delaunay : slit::Edges::own);
  });
  slit::SlitMap map = slit::slit_map(forms, circles.outer, circles.inner);
  if (options.basis >= forms.loop_count())
    throw InputError("--basis " + std::to_string(options.basis) + ": the last loop is " +
                     std::to_string(forms.loop_count() - 1));
  if (options.basis >= 0) {
    MadeSlitMap made = make_slits(forms, std::move(map), options, progress);
    made.layout = show::basis_layout(forms, options.basis);
    return made;
  }
  if (!options.is_circular()) return make_slits(forms, std::move(map), options, progress);
  const slit::CircularMap circular =
      in_file(options.input, [&] { return slit::circular_map(forms, map, {}, progress); });
  MadeSlitMap made = make_circles(surface.mesh, circular, options, progress);
  if (options.is_free()) return made;
  Report slits = map_report(map, true);
  slits.add(std::move(made.report));
  made.report = std::move(slits);
  if (options.stage >= 0) made.layout = stage_layout(forms, map, circular, options.stage);
  return made;
}

} // namespace

slit::LoopPair chosen(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                      const SlitOptions& options) {
  return {loop_named(options.outer.empty() ? "0" : options.outer, "--outer", surface, loops),
          loop_named(options.inner.empty() ? "1" : options.inner, "--inner", surface, loops)};
}

MadeSlitMap slit_map(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                     const SlitOptions& options, const Progress& progress) {
  MadeSlitMap best = make_once(surface, loops, options, progress);
  const bool has_other_ways = loops.size() > 1 && !options.allow_flips && !options.is_ricci() &&
                              !options.is_rectangle() && options.basis < 0 && options.stage < 0;
  if (!has_other_ways || best.flipped == 0) return best;
  const std::size_t flipped_at_first = best.flipped;
  for (const bool intrinsic : {false, true}) {
    if ((options.intrinsic && !intrinsic) || (options.unflip && options.intrinsic == intrinsic)) continue;
    SlitOptions other = options;
    other.unflip = true;
    other.intrinsic = intrinsic;
    MadeSlitMap made = make_once(surface, loops, other, progress);
    if (made.flipped >= flipped_at_first ||
        std::pair(made.flipped, made.quasi_conformal) >= std::pair(best.flipped, best.quasi_conformal))
      continue;
    made.report.json["mended"] = {{"flipped_before", flipped_at_first}, {"intrinsic", intrinsic}};
    made.report.rows.emplace_back(
        "mended", counted(static_cast<long long>(flipped_at_first), "triangle") + " would be inverted; " +
                      (intrinsic ? "solved on the intrinsic Delaunay triangulation, then vertices moved"
                                 : "vertices moved"));
    best = std::move(made);
  }
  return best;
}

} // namespace tetrarch::program
