// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/bundle.hpp"

#include "with_info.hpp"

#include "tetrarch/bundle/gluable.hpp"
#include "tetrarch/bundle/section.hpp"
#include "tetrarch/bundle/vector_field.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/surface/canonical_loops.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tetrarch::workshop {
namespace {

using bundle::Plan;
using bundle::PlanOptions;
using MadeBundle = SurfaceBundle::Made;

const char* cut_name(Plan::Method method) {
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

/// Nothing if the bundle over so many triangles is allowed to take what it takes.
std::optional<double> bytes_beyond(double triangles, const BundleOptions& options) {
  const double tetrahedra = 3.0 * options.plan.fiber * triangles;
  const double bytes = bundle::bundle_bytes(tetrahedra, triangles) + options.bytes_a_tetrahedron * tetrahedra;
  return bytes <= options.most_bytes ? std::nullopt : std::optional(bytes);
}

/// Triangles of the refined surface, before it is refined: a twisted edge has two sides, a triangle three.
double expected_triangles(const surface::Surface& surface, const SurfaceType& type, const PlanOptions& plan) {
  const int euler = plan.euler.value_or(type.is_closed() ? type.euler : 0);
  return std::max<double>(surface.triangle_count(), 2.0 * std::abs(euler) * plan.fiber / 3);
}

SurfaceBundle::Obstructed obstructed(const bundle::Obstruction& found, const NumberedSurface& surface) {
  SurfaceBundle::Obstructed part{found.forbidding, {}, {}};
  format::Soup soup;
  soup.points = surface.mesh.points;
  for (const int t : found.triangles) {
    part.triangles.push_back(surface.triangle_number(t));
    soup.triangles.push_back(surface.mesh.surface.corners(t));
  }
  part.mesh = doctor::repair(std::move(soup)).soup;
  return part;
}

/// What the dissertation proves of its gluings, asked of ours.
void audit_gluings(const Plan& plan) {
  if (plan.method == Plan::Method::canonical_loops)
    if (const std::string why = surface::why_not_canonical(plan.cut); !why.empty())
      throw PreconditionError(why);
  for (const auto& pair : bundle::bands(plan.cut))
    if (const std::string why = bundle::why_not_gluable(pair, plan.recipe); !why.empty())
      throw PreconditionError(why);
}

/// A bundle that is proved to be what was planned; a failure here is ours.
void assemble_and_prove(MadeBundle& made, const Progress& progress) {
  audit_gluings(made.plan);
  made.bundle = bundle::assemble(made.plan.recipe, progress);
  made.proof = bundle::prove(made.bundle, Skeleton(made.bundle.total), progress);
  if (!made.proof.failure.empty()) throw PreconditionError(made.proof.failure);
  if (made.proof.has_euler_number && made.proof.euler_number != made.plan.euler)
    throw PreconditionError("the Euler number counted is " + std::to_string(made.proof.euler_number));
}

/// The singularities of a field of directions on the surface, and of a section of the bundle at random.
void find_singularities(MadeBundle& made, const BundleOptions& options) {
  const bundle::CircleBundle& bundle = made.bundle;
  SplitMix64 random(options.seed);
  std::vector<double> direction(static_cast<std::size_t>(bundle.base.vertex_count()));
  for (double& d : direction) d = random.uniform() * 2 * std::numbers::pi;
  if (options.field) direction = bundle::projected_field(bundle.base, made.plan.cut.points, *options.field);
  std::vector<double> place(direction.size());
  for (double& p : place) p = random.uniform() * bundle.fiber;
  made.field = bundle::field_indices(bundle.base, made.plan.cut.points, direction);
  made.section = bundle::indices(bundle, made.proof.fibers,
                                 bundle::short_section(bundle, made.proof.fibers, std::move(place)));
}

/// A tangent field is a section of the unit tangent bundle alone.
bool is_tangent(const MadeBundle& made) {
  return made.proof.has_euler_number && made.proof.euler_number == surface::type_of(made.bundle.base).euler;
}

struct IndexCount {
  int singular = 0; ///< triangles whose index is not 0
  int sum = 0;
};

IndexCount counted_indices(const std::vector<int>& index) {
  IndexCount count;
  for (const int i : index) {
    count.sum += i;
    count.singular += i != 0 ? 1 : 0;
  }
  return count;
}

Tree index_tree(const std::vector<int>& index) {
  const IndexCount count = counted_indices(index);
  return {{"singular_triangles", count.singular}, {"index_sum", count.sum}};
}

Type index_type() {
  return type::object({{"singular_triangles", type::integer}, {"index_sum", type::integer}});
}

Tree cut_tree(const SurfaceBundle& found) {
  const Plan& plan = found.made->plan;
  Tree curves = Tree::array();
  for (const auto& pair : bundle::bands(plan.cut))
    curves.push_back({{"edges", pair[0].sides.size()}, {"twist", bundle::twist_along(pair[0], plan.recipe)}});
  Tree tree{{"along", cut_name(plan.method)}, {"curves", std::move(curves)}};
  if (plan.method == Plan::Method::canonical_loops) tree["word"] = surface::boundary_word(plan.cut);
  return tree;
}

Type cut_type() {
  return type::object(
      {{"along", type::text},
       {"curves", type::list(type::object({{"edges", type::integer}, {"twist", type::integer}}))},
       {"word", type::list(type::integer), type::sometimes}});
}

Tree obstruction_tree(const SurfaceBundle& found) {
  return {{"triangles", found.obstruction->triangles}, {"forbidding", found.obstruction->forbidding}};
}

bool is_made(const SurfaceBundle& found) {
  return found.made.has_value();
}
bool is_obstructed(const SurfaceBundle& found) {
  return found.obstruction.has_value();
}

const MadeBundle& the_made(const SurfaceBundle& found) {
  if (!found.made) throw PreconditionError("there is no bundle");
  return *found.made;
}

Rows details(const SurfaceBundle& found) {
  const MadeBundle& made = the_made(found);
  Rows rows{{"cut along", cut_name(made.plan.method)},
            {"refined by", counted(made.plan.splits(), "split")},
            {"fibres", counted(made.bundle.base.vertex_count(), "circle") + " of " +
                           counted(made.bundle.fiber, "edge")},
            {"Euler number",
             made.proof.has_euler_number ? std::to_string(made.proof.euler_number) : "none (boundary)"}};
  if (!is_tangent(made)) return rows;
  const IndexCount count = counted_indices(made.field);
  rows.emplace_back(found.field_given ? "field" : "random field",
                    counted(count.singular, "singular triangle") + ", indices adding up to " +
                        std::to_string(count.sum));
  return rows;
}

} // namespace

Verdict SurfaceBundle::verdict() const {
  if (made) return Verdict::yes;
  return obstruction ? Verdict::proved_no : Verdict::undecided;
}

SurfaceBundle circle_bundle(const NumberedSurface& surface, const BundleOptions& options,
                            const Progress& progress) {
  const surface::Surface& given = surface.mesh.surface;
  SurfaceBundle found;
  found.surface = surface::type_of(given);
  found.triangles = given.triangle_count();
  found.field_given = options.field.has_value();
  found.bytes_needed = bytes_beyond(expected_triangles(given, found.surface, options.plan), options);
  if (found.bytes_needed) return found;
  auto planned = bundle::plan(surface::MarkedSurface(given, surface.mesh.points), options.plan, progress);
  if (const auto* obstruction = std::get_if<bundle::Obstruction>(&planned)) {
    found.obstruction = obstructed(*obstruction, surface);
    return found;
  }
  MadeBundle made;
  made.plan = std::get<Plan>(std::move(planned));
  found.bytes_needed = bytes_beyond(made.plan.cut.surface.triangle_count(), options);
  if (found.bytes_needed) return found;
  assemble_and_prove(made, progress);
  constexpr int small = 2'000; // tetrahedra; beyond, nobody reads a signature or a group
  made.info = info(made.bundle.total, "", made.bundle.total.size() > small, progress);
  find_singularities(made, options);
  found.made = std::move(made);
  return found;
}

Rows rows_of(const SurfaceBundle& found) {
  Rows rows{{"surface", found.surface.str() + ", " + counted(found.triangles, "triangle") +
                            ", Euler characteristic " + std::to_string(found.surface.euler)}};
  const Rows more = details(found);
  rows.insert(rows.end(), more.begin(), more.end());
  Rows info = rows_of(found.made->info, found.made->info.signature);
  constexpr std::size_t longest = 100; // a signature as long as a page is for programs
  if (!info.empty() && info.back().second.size() > longest) info.pop_back();
  rows.insert(rows.end(), info.begin(), info.end());
  return rows;
}

std::string text_of(const SurfaceBundle& found) {
  if (!found.obstruction) return block(rows_of(found));
  return "no solution: the values given on the boundary of " +
         counted(static_cast<long long>(found.obstruction->triangles.size()), "triangle") + " are all " +
         (found.obstruction->forbidding > 0 ? "+1" : "-1") + ", and no vertex lies inside\n";
}

format::Document document_of(const SurfaceBundle& found) {
  const bundle::CircleBundle& bundle = the_made(found).bundle;
  format::Document document = format::document_of(bundle.total);
  format::FiberCoordinates& fibers = document.bundle.emplace();
  fibers.fiber = bundle.fiber;
  if (found.made->proof.has_euler_number) fibers.euler_number = found.made->proof.euler_number;
  fibers.base_vertices = found.made->plan.cut.points;
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

template <>
const FieldList<SurfaceBundle>& fields_of<SurfaceBundle>() {
  using F = const SurfaceBundle&;
  static const FieldList<SurfaceBundle> fields{
      {{"solvable", "", "false: the values given on the boundary allow no bundle", type::truth},
       [](F) -> Tree { return false; },
       is_obstructed},
      {{"obstruction", "",
        "the part of the surface that allows none: triangles by their numbers in the file, and forbidding, "
        "the value of all its boundary edges",
        type::object({{"triangles", type::list(type::integer)}, {"forbidding", type::integer}})},
       obstruction_tree,
       is_obstructed},
      {{"surface", "", "what was given: type, triangles, euler (its Euler characteristic)",
        type::object({{"type", type::text}, {"triangles", type::integer}, {"euler", type::integer}})},
       [](F f) -> Tree {
         return {{"type", f.surface.str()}, {"triangles", f.triangles}, {"euler", f.surface.euler}};
       },
       is_made},
      {{"fiber", "", "number of edges of a fiber", type::integer},
       [](F f) -> Tree { return f.made->bundle.fiber; },
       is_made},
      {{"euler_number", "", "of the bundle, counted in the result; null: the surface has boundary",
        type::or_null(type::integer)},
       [](F f) { return f.made->proof.has_euler_number ? Tree(f.made->proof.euler_number) : Tree(); },
       is_made},
      {{"closed", "", "whether the surface is closed", type::truth},
       [](F f) -> Tree { return f.made->proof.has_euler_number; },
       is_made},
      {{"refined", "", "the surface below the bundle: triangles, and splits of edges that made them",
        type::object({{"triangles", type::integer}, {"splits", type::integer}})},
       [](F f) -> Tree {
         return {{"triangles", f.made->bundle.base.triangle_count()}, {"splits", f.made->plan.splits()}};
       },
       is_made},
      {{"cut", "",
        "along what the surface was cut, curves (edges, and twist in steps of a fiber's edge), and of "
        "canonical loops the word that they are read as",
        cut_type()},
       cut_tree,
       is_made},
      {{"field", "",
        "singular_triangles and index_sum of a field of directions; null: this is no unit tangent bundle",
        type::or_null(index_type())},
       [](F f) { return is_tangent(*f.made) ? index_tree(f.made->field) : Tree(); },
       is_made},
      {{"section", "", "the same of a section of the bundle at random; null: the surface has boundary",
        type::or_null(index_type())},
       [](F f) { return f.made->proof.has_euler_number ? index_tree(f.made->section) : Tree(); },
       is_made}};
  return fields;
}

template <>
Tree tree_of<SurfaceBundle>(const SurfaceBundle& found) {
  Tree tree = found.made ? tree_of(found.made->info) : Tree::object();
  for (const Field<SurfaceBundle>& field : fields_of<SurfaceBundle>())
    if (field.present(found)) tree[field.name] = field.value(found);
  return tree;
}

template <>
std::vector<FieldNote> notes_of<SurfaceBundle>() {
  return both_of(sometimes(notes_of<Info>()), notes_of(fields_of<SurfaceBundle>()));
}

} // namespace tetrarch::workshop
