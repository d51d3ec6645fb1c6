// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/slit.hpp"

#include "slit_rectangle.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/workshop/in_file.hpp"
#include "tetrarch/workshop/text.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

/// A slit map whose vertices are moved about: on the ring, where edges are straight, or on the cylinder.
struct MovedSlits {
  const slit::OneForms& forms;
  slit::SlitMap& map;
  bool on_ring;

  slit::Unflipped unflip(slit::Unflip which, const Progress& progress) const {
    return on_ring ? slit::unflip_on_ring(forms, map, which, progress)
                   : slit::unflip_on_cylinder(forms, map, which, progress);
  }
  slit::Softened soften() const {
    return on_ring ? slit::soften_ends_on_ring(forms, map) : slit::soften_ends_on_cylinder(forms, map);
  }
  slit::Balanced balance(const Progress& progress) const {
    return on_ring ? slit::balance_on_ring(forms, map, progress)
                   : slit::balance_on_cylinder(forms, map, progress);
  }
  slit::Distortion distortion() const {
    return on_ring ? slit::distortion_on_ring(forms, map) : slit::distortion_on_cylinder(forms, map);
  }
};

/// The same of a disk with round holes.
struct MovedCircles {
  const surface::TriangleMesh& mesh;
  slit::CircularMap& map;

  slit::Unflipped unflip(slit::Unflip which, const Progress& progress) const {
    return slit::unflip_in_disk(mesh, map, which, progress);
  }
  slit::Balanced balance(const Progress& progress) const {
    return slit::balance_in_disk(mesh, map, progress);
  }
  slit::Distortion distortion() const { return slit::distortion_in_disk(mesh, map); }
};

/// A slit turns back between vertices, whatever the mesh is: that much is always put right.
template <class Moved>
void unflip(ConformalMap& made, const Moved& moved, bool everywhere, const Progress& progress) {
  const slit::Unflipped done =
      moved.unflip(everywhere ? slit::Unflip::everywhere : slit::Unflip::at_slits, progress);
  if (everywhere || done.moved > 0) made.unflipped = done;
}

template <class Moved>
void balance(ConformalMap& made, const Moved& moved, const Progress& progress) {
  slit::Distortion before = moved.distortion();
  made.balance = ConformalMap::Balance{moved.balance(progress), std::move(before)};
}

/// A basis is drawn on the ring, whatever the domain is.
bool is_on_ring(MapDomain domain) {
  return domain != MapDomain::cylindric && domain != MapDomain::parallel;
}

show::SlitDomain shown_domain(MapDomain domain) {
  if (domain == MapDomain::cylindric) return show::SlitDomain::cylindric;
  return domain == MapDomain::parallel ? show::SlitDomain::parallel : show::SlitDomain::concentric;
}

ConformalMap::Slits slits_of(const slit::SlitMap& map, bool on_ring) {
  return {{map.outer, map.inner}, map.modulus, map.modulus_bound, map.slits, on_ring};
}

ConformalMap::Circles circles_of(const slit::CircularMap& map, bool by_ricci_flow) {
  return {map.loop,          map.domain.circles, map.domain.circularity,
          map.domain.rounds, map.domain.found,   by_ricci_flow};
}

/// Quads, or why there are none.
void add_quads(ConformalMap& made, const slit::OneForms& forms, const slit::SlitMap& map,
               const MapOptions& options) {
  double around = options.quads_around;
  if (options.quads_around <= 0) {
    around = slit::quads_around(forms.mesh(), map, options.quad_edge);
    if (!(around > fewest_quads_around - 0.5 && around < most_quads_around)) {
      made.impossible_quads = around;
      return;
    }
  }
  slit::QuadMesh quads = slit::quads(forms, map, static_cast<int>(std::lround(around)));
  const slit::QuadQuality quality = slit::quality(quads);
  made.quads = ConformalMap::Quads{std::move(quads), quality};
}

void keep_potentials(ConformalMap& made, const slit::OneForms& forms, const slit::SlitMap& map) {
  made.fields.vertices = {{"log_radius", map.log_radius}, {"angle", map.angle}};
  for (int k = 0; k < forms.loop_count(); ++k)
    made.fields.vertices.push_back({"potential_" + std::to_string(k), forms.potential(k)});
}

ConformalMap map_to_slits(const slit::OneForms& forms, slit::SlitMap map, const MapOptions& options,
                          const Progress& progress) {
  const bool on_ring = is_on_ring(options.domain);
  if (on_ring) in_file(options.name, [&] { slit::require_radii(map); });
  ConformalMap made;
  made.slits = slits_of(map, on_ring);
  made.residuals = slit::residuals(forms, map); // vertices that are moved are no longer harmonic
  const MovedSlits moved{forms, map, on_ring};
  unflip(made, moved, options.unflip, progress);
  if (const slit::Softened softened = moved.soften(); softened.moved > 0) made.softened = softened;
  if (options.balance) balance(made, moved, progress);
  made.distortion = moved.distortion();
  keep_potentials(made, forms, map);
  made.layout = show::layout(forms, map, shown_domain(options.domain));
  if (options.has_quads()) add_quads(made, forms, map, options);
  return made;
}

/// The domain's shape is that of least distortion.
void free_shape(ConformalMap& made, const surface::TriangleMesh& mesh, const slit::CircularMap& map,
                const Progress& progress) {
  slit::Distortion before = slit::distortion_in_plane(mesh, map.position);
  const slit::FreeMap free = slit::free_map(mesh, map.position, progress);
  made.balance = ConformalMap::Balance{free.balanced, std::move(before)};
  made.distortion = slit::distortion_in_plane(mesh, free.position);
  made.crossings = free.crossings;
  made.layout = show::plane_layout(mesh, free.position, "free domain");
}

ConformalMap map_to_circles(const surface::TriangleMesh& mesh, slit::CircularMap map,
                            const MapOptions& options, const Progress& progress) {
  ConformalMap made;
  made.circles = circles_of(map, options.by_ricci_flow);
  const MovedCircles moved{mesh, map};
  unflip(made, moved, options.unflip, progress);
  if (options.domain == MapDomain::free) {
    free_shape(made, mesh, map, progress);
    return made;
  }
  if (options.balance) balance(made, moved, progress);
  made.distortion = moved.distortion();
  made.layout = show::disk_layout(mesh, map.position);
  return made;
}

/// Of a surface with one loop.
ConformalMap map_to_disk(const surface::TriangleMesh& mesh, const MapOptions& options,
                         const Progress& progress) {
  const int center = options.center ? *options.center : slit::innermost_vertex(mesh);
  if (center < 0)
    throw InputError({options.name, 0},
                     "all vertices are on the boundary; the disk needs an interior vertex");
  slit::CircularMap map = in_file(options.name, [&] {
    return options.by_ricci_flow ? slit::ricci_circles(mesh, 0, -1).map : slit::disk_map(mesh, center);
  });
  ConformalMap made = map_to_circles(mesh, std::move(map), options, progress);
  made.center = center;
  return made;
}

/// The picture after so many openings instead of the circular domain.
show::Layout stage_layout(const slit::OneForms& forms, const slit::SlitMap& map,
                          const slit::CircularMap& circular, int stage) {
  if (stage < 0 || stage > static_cast<int>(map.slits.size()))
    throw PreconditionError("there is no stage " + std::to_string(stage));
  show::Layout layout = show::disk_layout(
      forms.mesh(), slit::opening_stage(forms, map, circular, static_cast<std::size_t>(stage)));
  layout.name = "circular domain, " + counted(stage, "slit") + " open";
  return layout;
}

ConformalMap map_by_ricci_flow(const surface::TriangleMesh& mesh, const MapOptions& options,
                               const Progress& progress) {
  const auto [outer, inner] = options.circles;
  slit::CircularMap map = in_file(
      options.name, [&, o = outer, i = inner] { return slit::ricci_circles(mesh, o, i, {}, progress).map; });
  return map_to_circles(mesh, std::move(map), options, progress);
}

/// Of one loop.
ConformalMap map_of_basis(const slit::OneForms& forms, slit::SlitMap map, const MapOptions& options,
                          const Progress& progress) {
  if (*options.basis < 0 || *options.basis >= forms.loop_count())
    throw PreconditionError("there is no loop " + std::to_string(*options.basis));
  ConformalMap made = map_to_slits(forms, std::move(map), options, progress);
  made.layout = show::basis_layout(forms, *options.basis);
  return made;
}

ConformalMap map_harmonically(const surface::TriangleMesh& mesh, const MapOptions& options,
                              const Progress& progress) {
  const slit::Edges edges = options.intrinsic ? slit::Edges::intrinsic_delaunay : slit::Edges::own;
  const slit::OneForms forms = in_file(options.name, [&] { return slit::OneForms(mesh, progress, edges); });
  slit::SlitMap map = slit::slit_map(forms, options.circles.outer, options.circles.inner);
  if (options.basis) return map_of_basis(forms, std::move(map), options, progress);
  if (!has_round_holes(options.domain)) return map_to_slits(forms, std::move(map), options, progress);
  const slit::CircularMap circular =
      in_file(options.name, [&] { return slit::circular_map(forms, map, {}, progress); });
  ConformalMap made = map_to_circles(mesh, circular, options, progress);
  if (options.domain == MapDomain::free) return made;
  made.slits = slits_of(map, true);
  if (options.stage) made.layout = stage_layout(forms, map, circular, *options.stage);
  return made;
}

/// All of the map but the surface.
ConformalMap map_once(const HoledSurface& surface, const MapOptions& options, const Progress& progress) {
  if (options.domain == MapDomain::rectangle) return map_to_rectangle(surface, options, progress);
  if (surface.loops.size() == 1) return map_to_disk(surface.mesh(), options, progress);
  if (options.by_ricci_flow) return map_by_ricci_flow(surface.mesh(), options, progress);
  return map_harmonically(surface.mesh(), options, progress);
}

bool has_other_ways(const HoledSurface& surface, const MapOptions& options) {
  return surface.loops.size() > 1 && !options.flips_allowed && !options.by_ricci_flow &&
         options.domain != MapDomain::rectangle && !options.basis && !options.stage;
}

/// Fewer triangles are inverted, or else it distorts less, if it is better.
bool is_no_better(const ConformalMap& made, const ConformalMap& than) {
  return std::pair(made.flipped(), made.distortion.mean_quasi_conformal) >=
         std::pair(than.flipped(), than.distortion.mean_quasi_conformal);
}

ConformalMap least_flipped(const HoledSurface& surface, const MapOptions& options, const Progress& progress) {
  ConformalMap best = map_once(surface, options, progress);
  if (best.impossible_quads || best.flipped() == 0 || !has_other_ways(surface, options)) return best;
  const std::size_t flipped_at_first = best.flipped();
  for (const bool intrinsic : {false, true}) {
    if ((options.intrinsic && !intrinsic) || (options.unflip && options.intrinsic == intrinsic)) continue;
    MapOptions other = options;
    other.unflip = true;
    other.intrinsic = intrinsic;
    ConformalMap made = map_once(surface, other, progress);
    if (made.flipped() >= flipped_at_first || is_no_better(made, best)) continue;
    made.mended = ConformalMap::Mended{flipped_at_first, intrinsic};
    best = std::move(made);
  }
  return best;
}

} // namespace

bool has_round_holes(MapDomain domain) {
  return domain == MapDomain::circular || domain == MapDomain::free;
}

bool ConformalMap::found() const {
  return (!circles || circles->found) && (!rectangle || rectangle->found) &&
         (!balance || balance->balanced.settled) && crossings.value_or(0) == 0;
}

Verdict ConformalMap::verdict() const {
  return found() && (flips_allowed || flipped() == 0) ? Verdict::yes : Verdict::undecided;
}

std::string why_not_mapped(const surface::Surface& surface, int least_holes) {
  const SurfaceType type = surface::type_of(surface);
  if (type.orientable && type.euler + type.boundary_curves == 2 && type.boundary_curves >= least_holes)
    return "";
  return std::string("slit maps need a sphere with ") + (least_holes == 1 ? "a hole" : "two holes") +
         " at least, but this surface has type " + type.str();
}

ConformalMap conformal_map(HoledSurface surface, const MapOptions& options, const Progress& progress) {
  const bool one_is_enough = has_round_holes(options.domain) || options.domain == MapDomain::rectangle;
  if (const std::string why = why_not_mapped(surface.mesh().surface, one_is_enough ? 1 : 2); !why.empty())
    throw InputError({options.name, 0}, why);
  const auto start = std::chrono::steady_clock::now();
  ConformalMap found = least_flipped(surface, options, progress);
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  found.fields.triangles = {{"quasi_conformal", found.distortion.quasi_conformal},
                            {"log_factor", found.distortion.log_factor}};
  found.surface = std::move(surface);
  found.domain = options.domain;
  found.flips_allowed = options.flips_allowed;
  return found;
}

} // namespace tetrarch::workshop
