// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "in_file.hpp"
#include "output.hpp"
#include "slit_openings.hpp"
#include "slit_report.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/quads.hpp"
#include "tetrarch/show/slit.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/workshop/element.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

namespace tetrarch::program {
namespace {

using show::SlitDomain;

struct Options {
  std::string input;
  std::vector<std::string> outputs;
  std::string domain = "concentric";
  std::string outer;
  std::string inner;
  std::string center;
  std::string method = "harmonic";
  Openings openings;
  bool list_loops = false;
  bool fingerprint = false;
  std::string distance;
  bool mirror = false;
  bool unflip = false;
  bool balance = false;
  bool allow_flips = false;
  bool intrinsic = false;
  int stage = -1;
  int basis = -1;
  int quads = 0;
  double quad_edge = 0;
  std::string corners;
  Doctor doctor;

  bool has_quads() const { return quads > 0 || quad_edge > 0; }
  bool is_rectangle() const { return domain == "rectangle"; }
  bool is_free() const { return domain == "free"; }
  /// Whether the map begins with round holes.
  bool is_circular() const { return domain == "circular" || is_free(); }
  bool is_ricci() const { return method == "ricci"; }
};

bool is_json(const std::string& path) {
  return format::has_extension(path, ".json");
}

/// Of one of the names that are allowed.
SlitDomain domain_named(const std::string& name) {
  if (name == "cylindric") return SlitDomain::cylindric;
  return name == "parallel" ? SlitDomain::parallel : SlitDomain::concentric;
}

void check(const Options& options) {
  for (const std::string& path : options.outputs) {
    require_folder(path);
    const auto format = scene::scene_format_for_extension(path);
    if (!options.has_quads() && is_json(path)) continue;
    if (options.has_quads() && (!format || format == scene::SceneFormat::vtu))
      throw InputError({path, 0}, "quads are written as .obj, .glb or .ply");
    if (!format && !format::has_extension(path, ".svg") && !format::has_extension(path, ".html"))
      throw InputError({path, 0}, "this command writes no file with this extension (expected .json, .obj, "
                                  ".vtu, .svg, .glb, .ply or .html)");
  }
  if (options.is_free() && options.balance)
    throw InputError("--balance is for the other domains; --domain free is balanced as it is");
  if (options.is_free() && options.stage >= 0) throw InputError("--stage needs --domain circular");
  if (!options.is_circular() && options.stage >= 0) throw InputError("--stage needs --domain circular");
  if (!options.is_circular() && options.is_ricci())
    throw InputError("--method ricci needs --domain circular");
  if (options.is_ricci() && options.stage >= 0) throw InputError("--stage needs --method harmonic");
  if (!options.is_circular() && !options.center.empty()) throw InputError("--center needs --domain circular");
  if (!options.corners.empty() && !options.is_rectangle())
    throw InputError("--corners needs --domain rectangle");
  if (options.is_rectangle() && (options.balance || options.unflip))
    throw InputError("--domain rectangle takes neither --balance nor --unflip");
  if (options.quads > 0 && options.quad_edge > 0) throw InputError("give --quads or --quad-edge, not both");
  if ((options.is_circular() || options.is_rectangle()) && options.has_quads())
    throw InputError("--quads needs a domain with slits, and --domain " + options.domain + " has none");
}

/// A map with everything that is told of it.
struct Made {
  mesh::TriangleMesh mesh;
  show::Layout layout;
  show::Fields fields;
  Report report;
  std::optional<slit::QuadMesh> quads;
  std::size_t flipped = 0;    ///< triangles
  double quasi_conformal = 0; ///< the mean
  bool found = true;
};

/// Told, and kept for files.
void add(Made& made, const slit::Distortion& distortion) {
  made.report.add(distortion_report(distortion));
  made.flipped = distortion.flipped.size();
  made.quasi_conformal = distortion.mean_quasi_conformal;
  made.fields.triangles = {{"quasi_conformal", distortion.quasi_conformal},
                           {"log_factor", distortion.log_factor}};
}

/// What was balanced, and how it was before.
void add(Made& made, const slit::Balanced& balanced, const slit::Distortion& before) {
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

Made make_slits(const slit::OneForms& forms, slit::SlitMap map, const Options& options,
                const Progress& progress) {
  const SlitDomain domain = domain_named(options.domain);
  const bool on_ring = domain == SlitDomain::concentric;
  if (on_ring) in_file(options.input, [&] { slit::require_radii(map); });
  Made made;
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
    add(made,
        on_ring ? slit::balance_on_ring(forms, map, progress)
                : slit::balance_on_cylinder(forms, map, progress),
        before);
  }
  add(made, distortion());
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
void make_free(Made& made, const slit::CircularMap& map, const Progress& progress) {
  const slit::Distortion before = slit::distortion_in_plane(made.mesh, map.position);
  const slit::FreeMap free = slit::free_map(made.mesh, map.position, progress);
  add(made, free.balanced, before);
  add(made, slit::distortion_in_plane(made.mesh, free.position));
  made.report.json["crossings"] = free.crossings;
  if (free.crossings > 0) {
    made.report.warnings.push_back("the domain overlaps itself: " + counted(free.crossings, "pair") +
                                   " of its boundary edges cross");
    made.found = false;
  }
  made.layout = show::plane_layout(made.mesh, free.position, "free domain");
}

Made make_circles(mesh::TriangleMesh mesh, slit::CircularMap map, const Options& options,
                  const Progress& progress) {
  Made made;
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
    add(made, slit::balance_in_disk(made.mesh, map, progress), before);
  }
  add(made, slit::distortion_in_disk(made.mesh, map));
  made.layout = show::disk_layout(made.mesh, map.position);
  return made;
}

Made make_disk(const mesh::OpenedMesh& surface, const Options& options, const Progress& progress) {
  const int center = options.center.empty() ? slit::innermost_vertex(surface.mesh)
                                            : vertex_named(options.center, "--center", surface);
  if (center < 0)
    throw InputError({options.input, 0},
                     "all vertices are on the boundary; the disk needs an interior vertex");
  slit::CircularMap map = in_file(options.input, [&] {
    return options.is_ricci() ? slit::ricci_circles(surface.mesh, 0, -1).map
                              : slit::disk_map(surface.mesh, center);
  });
  Made made = make_circles(surface.mesh, std::move(map), options, progress);
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

/// The loops that become circles.
slit::LoopPair chosen(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                      const Options& options) {
  return {loop_named(options.outer.empty() ? "0" : options.outer, "--outer", surface, loops),
          loop_named(options.inner.empty() ? "1" : options.inner, "--inner", surface, loops)};
}

Made make_rectangle(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
                    const Options& options, const Progress& progress) {
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
  Made made;
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
  add(made, slit::distortion_in_plane(mesh, found.position));
  made.layout = show::plane_layout(mesh, found.position, "rectangular domain");
  return made;
}

Made make_once(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
               const Options& options, const Progress& progress) {
  if (options.is_rectangle()) return make_rectangle(surface, loops, options, progress);
  if (loops.size() == 1) return make_disk(surface, options, progress);
  const slit::LoopPair circles = chosen(surface, loops, options);
  if (options.is_ricci()) {
    Made made = make_circles(
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
    Made made = make_slits(forms, std::move(map), options, progress);
    made.layout = show::basis_layout(forms, options.basis);
    return made;
  }
  if (!options.is_circular()) return make_slits(forms, std::move(map), options, progress);
  const slit::CircularMap circular =
      in_file(options.input, [&] { return slit::circular_map(forms, map, {}, progress); });
  Made made = make_circles(surface.mesh, circular, options, progress);
  if (options.is_free()) return made;
  Report slits = map_report(map, true);
  slits.add(std::move(made.report));
  made.report = std::move(slits);
  if (options.stage >= 0) made.layout = stage_layout(forms, map, circular, options.stage);
  return made;
}

/// Obtuse triangles make harmonic maps turn some of them over. Either a few vertices are moved, or the map of
/// the intrinsic Delaunay triangulation, which has no such triangles, is drawn with the mesh's own ones and
/// vertices are moved then: whichever leaves fewer inverted, or else distorts less.
Made make(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops,
          const Options& options, const Progress& progress) {
  Made best = make_once(surface, loops, options, progress);
  const bool has_other_ways = loops.size() > 1 && !options.allow_flips && !options.is_ricci() &&
                              !options.is_rectangle() && options.basis < 0 && options.stage < 0;
  if (!has_other_ways || best.flipped == 0) return best;
  const std::size_t flipped_at_first = best.flipped;
  for (const bool intrinsic : {false, true}) {
    if ((options.intrinsic && !intrinsic) || (options.unflip && options.intrinsic == intrinsic)) continue;
    Options other = options;
    other.unflip = true;
    other.intrinsic = intrinsic;
    Made made = make_once(surface, loops, other, progress);
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

/// Spheres with two holes, or one where that will do.
/// Which option leads on from a surface that has no slit map.
std::string way_on(const SurfaceType& type) {
  if (!type.orientable) return {};
  if (type.genus() > 0) return "; --open-handles cuts it open";
  return type.boundary_curves == 0 ? "; --punch makes holes"
                                   : "; --domain circular maps it, --punch makes more holes";
}

void check_type(const mesh::Surface& surface, const Options& options) {
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
                       const Options& options, Report report, const Context& context) {
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

std::string quads_file(const slit::QuadMesh& quads, scene::SceneFormat format) {
  return format == scene::SceneFormat::obj ? show::quads_obj(quads)
                                           : scene::write_scene(show::quad_scene(quads), format);
}

std::string page(const Made& made, const Options& options) {
  scene::InfoTable table{"Map", {}, {}};
  for (const auto& [name, value] : made.report.rows) table.rows.push_back({name, value});
  return scene::write_page(scene::TexturePage{options.input + ": " + made.layout.name,
                                              {std::move(table)},
                                              show::textured_surface(made.mesh, made.layout),
                                              show::slit_domain(made.mesh, made.layout)});
}

/// The surface with its map: of each corner the place in the domain and the texture coordinates, as vertices
/// on a seam have two; and what is known at vertices and triangles.
format::MeshDocument document(const Made& made, const Options& options) {
  using enum format::MeshField::On;
  format::MeshDocument mesh;
  mesh.soup.points = made.mesh.points;
  std::vector<std::array<double, 2>> places;
  std::vector<std::array<double, 2>> textures;
  for (int t = 0; t < made.mesh.surface.triangle_count(); ++t) {
    mesh.soup.triangles.push_back(made.mesh.surface.corners(t));
    for (const int place : made.layout.corners[t]) {
      places.push_back(made.layout.places[place]);
      textures.push_back(made.layout.textures[place]);
    }
  }
  mesh.fields = {field_of("place", triangle_corners, places),
                 field_of("texture", triangle_corners, textures)};
  for (const scene::Field& f : made.fields.vertices)
    mesh.fields.push_back(field_of(f.name, vertices, f.values));
  for (const scene::Field& f : made.fields.triangles)
    mesh.fields.push_back(field_of(f.name, triangles, f.values));
  mesh.provenance = format::JsonValue::parse(
      Json{{"command", "slit"}, {"input", options.input}, {"domain", made.layout.name}}.dump());
  return mesh;
}

std::string file(const std::string& path, const Made& made, const Options& options) {
  if (is_json(path)) return write_mesh_json(document(made, options));
  if (format::has_extension(path, ".svg"))
    return scene::write_svg(show::slit_drawing(made.mesh, made.layout));
  if (format::has_extension(path, ".html")) return page(made, options);
  const scene::SceneFormat format = *scene::scene_format_for_extension(path);
  if (made.quads) return quads_file(*made.quads, format);
  if (format == scene::SceneFormat::obj) return show::textured_obj(made.mesh, made.layout);
  return scene::write_scene(format == scene::SceneFormat::vtu
                                ? show::textured_surface(made.mesh, made.layout, made.fields)
                                : show::slit_domain(made.mesh, made.layout),
                            format);
}

Result run_slit(const Options& options, const Context& context) {
  check(options);
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
  const Made made = make(surface, loops, options, context.progress);
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
  for (const std::string& path : options.outputs) result.files.push_back({path, file(path, made, options)});
  if (context.values != nullptr) result.value = std::make_shared<Value>(document(made, options));
  return result;
}

} // namespace

Run declare_slit(OptionTable& table) {
  const auto o = std::make_shared<Options>();
  table.add("SURFACE", o->input, "a sphere with holes: OBJ, OFF, PLY or STL").required();
  table
      .add("--domain", o->domain,
           "the domain: a cylinder with slits, its unrolling to a rectangle, a ring with slits, a disk with "
           "round holes, a rectangle with rectangular holes, or a flat shape of least distortion in the unit "
           "of "
           "the surface")
      .one_of({"cylindric", "parallel", "concentric", "circular", "rectangle", "free"})
      .with_default();
  table
      .add("--outer", o->outer,
           "the loop that becomes the outer circle: its number, from 0 by decreasing length, or v17 for the "
           "loop through vertex 17, counted from 0 (default: 0; for --fingerprint and --distance the two "
           "loops "
           "of greatest modulus)")
      .value_name("LOOP");
  table.add("--inner", o->inner, "the loop that becomes the inner circle, named as for --outer (default: 1)")
      .value_name("LOOP");
  table
      .add("--method", o->method,
           "method for the circular domain: harmonic functions and opened slits, or discrete Ricci flow")
      .one_of({"harmonic", "ricci"})
      .with_default();
  table
      .add("--center", o->center,
           "the vertex that goes to 0, for a surface with one loop (default: the innermost)")
      .value_name("VERTEX");
  table
      .add("--punch", o->openings.punch,
           "first punch a hole; v17:0.5 is a hole of radius 0.5 around vertex 17; may be repeated")
      .value_name("HOLE");
  table
      .add("--slice", o->openings.slice,
           "first slice along shortest paths through vertices, such as 3,17,20; may be repeated")
      .value_name("LIST");
  table.add("--open-handles", o->openings.open_handles, "first cut a surface of genus g along g short loops");
  table.add("--list-loops", o->list_loops, "list the boundary loops and stop");
  table.add("--fingerprint", o->fingerprint,
            "print the conformal invariants with their errors, extrapolated from finer triangulations");
  table
      .add("--distance", o->distance,
           "print the distance between the fingerprints of this surface and of another, the least over all "
           "matchings of their loops")
      .value_name("SURFACE");
  table.add("--mirror", o->mirror,
            "let --distance compare with the mirror image of the other surface as well");
  table.add("--unflip", o->unflip, "move vertices near inverted triangles until no triangle is inverted");
  table.add("--balance", o->balance,
            "distort areas less at the cost of angles: move vertices, those of loops along their circles and "
            "slits, until the symmetric Dirichlet energy is least");
  table.add("--allow-flips", o->allow_flips, "status 0 although triangles are inverted (without it: 4)");
  table.add("--intrinsic", o->intrinsic,
            "solve on the intrinsic Delaunay triangulation, which is better for obtuse triangles");
  table
      .add("--stage", o->stage,
           "write the circular domain with this many slits open, before its circles become round")
      .not_negative();
  table.add("--basis", o->basis, "write the one-form of this loop instead of the domain").not_negative();
  table.add("--quads", o->quads, "make quads, this many around the ring; written as .obj, .glb or .ply")
      .in_range(3, 1'000'000);
  table
      .add("--quad-edge", o->quad_edge,
           "make quads with edges of about this length, in the unit of the surface")
      .positive();
  table
      .add("--corners", o->corners,
           "the four vertices of the outer loop that become the corners of --domain rectangle, such as "
           "3,17,20,8 "
           "(default: the sharpest, or quarters of its length)")
      .value_name("LIST");
  table
      .add("-o,--output", o->outputs,
           "write the surface with the domain as texture coordinates (.json, .obj, .vtu), the domain (.svg; "
           "as a surface, .glb or .ply), or a page with both side by side (.html); may be repeated")
      .value_name("FILE");
  declare_doctor(table, o->doctor);
  return [o](const Context& context) { return run_slit(*o, context); };
}

} // namespace tetrarch::program
