// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_options.hpp"

#include "output.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"

#include <array>
#include <optional>
#include <sstream>

namespace tetrarch::program {
namespace {

/// The vertices that the list names. Those of --corners may do without their v.
std::array<int, 4> corners_named(const std::string& list, const workshop::HoledSurface& surface) {
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  std::array<int, 4> corners{};
  if (words.size() != corners.size())
    throw InputError("--corners " + in_quotes(list) + ": expected four vertices");
  for (std::size_t c = 0; c < corners.size(); ++c)
    corners[c] = vertex_named(words[c].starts_with('v') ? words[c] : "v" + words[c], "--corners", surface);
  return corners;
}

std::optional<int> if_given(int number) {
  return number < 0 ? std::nullopt : std::optional(number);
}

/// Loops, vertices and counts, as far as this way of mapping asks for them: the others are passed over.
void choose_parts(workshop::MapOptions& how, const SlitArguments& options,
                  const workshop::HoledSurface& surface) {
  if (options.is_rectangle()) {
    how.circles.outer = loop_named(options.outer.empty() ? "0" : options.outer, "--outer", surface);
    if (!options.corners.empty()) how.corners = corners_named(options.corners, surface);
  } else if (surface.loops.size() == 1) {
    if (!options.center.empty()) how.center = vertex_named(options.center, "--center", surface);
  } else {
    how.circles = circles_named(options.outer, options.inner, surface);
    if (options.is_ricci()) return;
    how.basis = if_given(options.basis);
    if (!how.basis) how.stage = if_given(options.stage);
  }
}

/// Loops and slits are counted from 0. Where the two circles are the same loop, the map says so instead.
void require_last(const workshop::MapOptions& how, const workshop::HoledSurface& surface) {
  if (how.circles.outer == how.circles.inner) return;
  const auto loops = static_cast<int>(surface.loops.size());
  if (how.basis && *how.basis >= loops)
    throw InputError("--basis " + std::to_string(*how.basis) + ": the last loop is " +
                     std::to_string(loops - 1));
  if (how.stage && *how.stage > loops - 2)
    throw InputError("--stage " + std::to_string(*how.stage) + ": the last stage is " +
                     std::to_string(loops - 2) + ", with all slits open");
}

} // namespace

workshop::MapOptions map_options(const SlitArguments& options, const workshop::HoledSurface& surface) {
  workshop::MapOptions how;
  how.name = options.input;
  how.domain = *workshop::map_domain_named(options.domain);
  how.by_ricci_flow = options.is_ricci();
  how.unflip = options.unflip;
  how.balance = options.balance;
  how.flips_allowed = options.allow_flips;
  how.intrinsic = options.intrinsic;
  how.quads_around = options.quads;
  how.quad_edge = options.quad_edge;
  choose_parts(how, options, surface);
  require_last(how, surface);
  return how;
}

void require_sense(const SlitArguments& options) {
  for (const std::string& path : options.outputs) {
    const auto format = scene::scene_format_for_extension(path);
    if (!options.has_quads() && format::has_extension(path, ".json")) continue;
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
  if (options.is_ricci() && !options.center.empty()) throw InputError("--center needs --method harmonic");
  if (options.basis >= 0 && (options.is_ricci() || options.is_rectangle()))
    throw InputError(
        "--basis: the one-forms are those of harmonic functions (--method harmonic, a domain with "
        "slits or round holes)");
  if (options.mirror && options.distance.empty()) throw InputError("--mirror needs --distance");
  if (!options.corners.empty() && !options.is_rectangle())
    throw InputError("--corners needs --domain rectangle");
  if (options.is_rectangle() && (options.balance || options.unflip))
    throw InputError("--domain rectangle takes neither --balance nor --unflip");
  if (options.quads > 0 && options.quad_edge > 0) throw InputError("give --quads or --quad-edge, not both");
  if ((options.is_circular() || options.is_rectangle()) && options.has_quads())
    throw InputError("--quads needs a domain with slits, and --domain " + options.domain + " has none");
}

void declare(OptionTable& table, SlitArguments& o) {
  table.add("SURFACE", o.input, "a sphere with holes: OBJ, OFF, PLY or STL").required();
  table
      .add("--domain", o.domain,
           "the domain: a cylinder with slits, its unrolling to a rectangle, a ring with slits, a disk with "
           "round holes, a rectangle with rectangular holes, or a flat shape of least distortion in the unit "
           "of "
           "the surface")
      .one_of({"cylindric", "parallel", "concentric", "circular", "rectangle", "free"})
      .with_default();
  table
      .add("--outer", o.outer,
           "the loop that becomes the outer circle: its number, from 0 by decreasing length, or v17 for the "
           "loop through vertex 17, counted from 0 (default: 0; for --fingerprint and --distance the two "
           "loops "
           "of greatest modulus)")
      .value_name("LOOP");
  table.add("--inner", o.inner, "the loop that becomes the inner circle, named as for --outer (default: 1)")
      .value_name("LOOP");
  table
      .add("--method", o.method,
           "method for the circular domain: harmonic functions and opened slits, or discrete Ricci flow")
      .one_of({"harmonic", "ricci"})
      .with_default();
  table
      .add("--center", o.center,
           "the vertex that goes to 0, for a surface with one loop (default: the innermost)")
      .value_name("VERTEX");
  table
      .add("--punch", o.openings.punch,
           "first punch a hole; v17:0.5 is a hole of radius 0.5 around vertex 17; may be repeated")
      .value_name("HOLE");
  table
      .add("--slice", o.openings.slice,
           "first slice along shortest paths through vertices, such as 3,17,20; may be repeated")
      .value_name("LIST");
  table.add("--open-handles", o.openings.open_handles, "first cut a surface of genus g along g short loops");
  table.add("--list-loops", o.list_loops, "list the boundary loops and stop");
  table.add("--fingerprint", o.fingerprint,
            "print the conformal invariants with their errors, extrapolated from finer triangulations");
  table
      .add("--distance", o.distance,
           "print the distance between the fingerprints of this surface and of another, the least over all "
           "matchings of their loops")
      .value_name("SURFACE");
  table.add("--mirror", o.mirror,
            "let --distance compare with the mirror image of the other surface as well");
  table.add("--unflip", o.unflip, "move vertices near inverted triangles until no triangle is inverted");
  table.add("--balance", o.balance,
            "distort areas less at the cost of angles: move vertices, those of loops along their circles and "
            "slits, until the symmetric Dirichlet energy is least");
  table.add("--allow-flips", o.allow_flips, "status 0 although triangles are inverted (without it: 4)");
  table.add("--intrinsic", o.intrinsic,
            "solve on the intrinsic Delaunay triangulation, which is better for obtuse triangles");
  table
      .add("--stage", o.stage,
           "write the circular domain with this many slits open, before its circles become round")
      .not_negative();
  table.add("--basis", o.basis, "write the one-form of this loop instead of the domain").not_negative();
  table.add("--quads", o.quads, "make quads, this many around the ring; written as .obj, .glb or .ply")
      .in_range(workshop::fewest_quads_around, workshop::most_quads_around);
  table
      .add("--quad-edge", o.quad_edge,
           "make quads with edges of about this length, in the unit of the surface")
      .positive();
  table
      .add("--corners", o.corners,
           "the four vertices of the outer loop that become the corners of --domain rectangle, such as "
           "3,17,20,8 "
           "(default: the sharpest, or quarters of its length)")
      .value_name("LIST");
  table
      .add("-o,--output", o.outputs,
           "write the surface with the domain as texture coordinates (.json, .obj, .vtu), the domain (.svg; "
           "as a surface, .glb or .ply), or a page with both side by side (.html); may be repeated")
      .output_file();
  declare_doctor(table, o.doctor);
  o.doctor.split_pinches = true; // holes that meet in a vertex are one
}

} // namespace tetrarch::program
