// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/registration.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/slit/matching.hpp"
#include "tetrarch/slit/unflip.hpp"
#include "tetrarch/workshop/in_file.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <complex>
#include <utility>

namespace tetrarch::workshop {
namespace {

slit::OneForms harmonic_forms(const HoledSurface& surface, const std::string& name,
                              const Progress& progress) {
  return in_file(name,
                 [&] { return slit::OneForms(surface.mesh(), progress, slit::Edges::intrinsic_delaunay); });
}

/// The disk with round holes. A slit turns back between vertices: that much is always put right.
slit::CircularMap round_disk(const slit::OneForms& forms, slit::LoopPair circles, bool unflip,
                             SurfaceRegistration& found, const Progress& progress) {
  slit::CircularMap map =
      slit::circular_map(forms, slit::slit_map(forms, circles.outer, circles.inner), {}, progress);
  slit::unflip_in_disk(forms.mesh(), map, unflip ? slit::Unflip::everywhere : slit::Unflip::at_slits,
                       progress);
  if (!map.domain.found) ++found.unround_disks;
  return map;
}

/// Of each loop of the first surface the loop of the second one, with what is known of it.
struct LoopMatching {
  std::vector<int> to;
  double distance = 0; ///< between the circular domains
};

/// All that are known, the best one first.
std::vector<LoopMatching> loop_matchings(const slit::CircularMap& a, const slit::CircularMap& b) {
  std::vector<LoopMatching> result;
  for (const slit::Matching& m : slit::best_matchings(a.domain.circles, b.domain.circles)) {
    LoopMatching one{std::vector<int>(a.loop.size()), m.distance};
    for (std::size_t k = 0; k < a.loop.size(); ++k)
      one.to[a.loop[k]] = b.loop[static_cast<std::size_t>(m.to[k])];
    result.push_back(std::move(one));
  }
  return result;
}

/// Circles of surfaces that are the same come as near as triangles let them.
bool is_as_good(const LoopMatching& one, const LoopMatching& best) {
  constexpr double noise = 2e-3;
  return one.distance < 2 * best.distance + noise;
}

/// How far from conformal; 0: conformal.
double fault_of(const slit::Registration& r) {
  constexpr double flipped = 10; // stands for the ratio of axes of a flipped triangle
  const auto n = static_cast<double>(std::max<std::size_t>(r.quasi_conformal.size(), 1));
  return r.mean_quasi_conformal - 1 + flipped * static_cast<double>(r.flipped.size()) / n;
}

/// Whether a registration is clearly more conformal than another, or about as conformal and closer in space.
/// Angles come first, as the sizes of the surfaces may differ and bends are no fault.
bool is_closer(const slit::Registration& r, const slit::Registration& than) {
  constexpr double clearly = 0.9;
  constexpr double rounding = 1e-9;
  if (fault_of(r) < clearly * fault_of(than) - rounding) return true;
  return fault_of(than) >= clearly * fault_of(r) - rounding && r.mean_distance < than.mean_distance;
}

/// The surfaces while loops are matched: the first in its disk, the second about to be laid into one.
struct Registering {
  const slit::OneForms& a;
  const slit::CircularMap& disk;
  const slit::OneForms& b;
  slit::RegistrationOptions how;

  /// By the matching of `how`.
  slit::Registration points(SurfaceRegistration& found, const Progress& progress) const {
    const slit::LoopPair circles{how.matching[disk.loop[0]], how.matching[disk.loop[1]]};
    const slit::CircularMap other = round_disk(b, circles, how.unflip, found, progress);
    return slit::registered(a, disk, b.mesh(), other, how, progress);
  }
};

/// Tries all matchings that circles allow.
void search_matching(SurfaceRegistration& found, Registering job, const Progress& progress) {
  const std::vector<LoopMatching> all =
      loop_matchings(job.disk, round_disk(job.b, slit::farthest_loops(job.b), false, found, progress));
  const auto end = std::find_if(all.begin(), all.end(),
                                [&](const LoopMatching& one) { return !is_as_good(one, all.front()); });
  SurfaceRegistration::Search search{0, static_cast<std::size_t>(end - all.begin()), {}};
  if (end != all.end()) search.next_distance = end->distance;
  for (auto one = all.begin(); one != end; ++one) {
    job.how.matching = one->to;
    slit::Registration points = job.points(found, progress);
    if (one != all.begin() && !is_closer(points, found.points)) continue;
    found.points = std::move(points);
    found.matching = one->to;
    search.distance = one->distance;
  }
  found.search = search;
}

void require_as_many_loops(const HoledSurface& first, const HoledSurface& second,
                           const RegisterOptions& options) {
  if (first.loops.size() != second.loops.size())
    throw InputError({options.names[1], 0},
                     "has " + counted(static_cast<long long>(second.loops.size()), "boundary loop") +
                         ", but " + options.names[0] + " has " + std::to_string(first.loops.size()));
  if (options.matching && options.matching->size() != first.loops.size())
    throw PreconditionError("there are " + std::to_string(first.loops.size()) + " loops to match");
}

std::string matching_text(const SurfaceRegistration& found) {
  if (!found.search) return "given";
  std::string text = "circles differ by " + scientific(found.search->distance, 1);
  if (found.search->next_distance)
    text += ", by the next best matching by " + scientific(*found.search->next_distance, 1);
  return text;
}

std::string matched_loops_text(const std::vector<int>& matching) {
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k < matching.size(); ++k)
    pairs.push_back(std::to_string(k) + " to " + std::to_string(matching[k]));
  return joined(pairs, ", ");
}

Tree search_tree(const SurfaceRegistration& found) {
  if (!found.search) return {};
  const auto& [distance, tried, next] = *found.search;
  return {{"distance", distance}, {"tried", tried}, {"next_distance", next ? Tree(*next) : Tree()}};
}

} // namespace

Verdict SurfaceRegistration::verdict() const {
  return unround_disks == 0 ? Verdict::yes : Verdict::undecided;
}

std::vector<std::string> SurfaceRegistration::remarks() const {
  std::vector<std::string> remarks(static_cast<std::size_t>(unround_disks),
                                   "the budget of rounds ended before the circles became round");
  if (search && search->tried > 1)
    remarks.push_back(counted(static_cast<long long>(search->tried), "matching") +
                      " of the loops fit the circles; the most conformal one was taken, or of equal ones the "
                      "closest in space (--match chooses another)");
  const auto flipped = static_cast<long long>(points.flipped.size());
  if (flipped > 0)
    remarks.push_back(counted(flipped, "triangle") + (flipped == 1 ? " is" : " are") +
                      " inverted; --unflip moves vertices until no triangle is inverted");
  return remarks;
}

SurfaceRegistration registration(HoledSurface first, const HoledSurface& second,
                                 const RegisterOptions& options, const Progress& progress) {
  require_as_many_loops(first, second, options);
  const slit::OneForms a = harmonic_forms(first, options.names[0], progress);
  const slit::OneForms b = harmonic_forms(second, options.names[1], progress);
  SurfaceRegistration found;
  const slit::LoopPair circles = options.circles ? *options.circles : slit::farthest_loops(a);
  const slit::CircularMap disk = round_disk(a, circles, options.unflip, found, progress);
  Registering job{a, disk, b, {}};
  job.how.aligned = !options.as_placed;
  job.how.unflip = options.unflip;
  job.how.unflip_at_slits = true;
  if (options.matching) {
    job.how.matching = found.matching = *options.matching;
    found.points = job.points(found, progress);
  } else {
    search_matching(found, job, progress);
  }
  found.first = std::move(first);
  return found;
}

Rows rows_of(const SurfaceRegistration& found) {
  const slit::Registration& r = found.points;
  return {{"loops", matched_loops_text(found.matching)},
          {"matching", matching_text(found)},
          {"quasi-conformal",
           "mean " + fixed(r.mean_quasi_conformal, 4) + ", greatest " + fixed(r.max_quasi_conformal, 4)},
          {"distances", "mean " + rounded(r.mean_distance) + ", greatest " + rounded(r.max_distance)},
          {"flipped",
           r.flipped.empty() ? "none" : counted(static_cast<long long>(r.flipped.size()), "triangle")}};
}

format::MeshDocument document_of(const SurfaceRegistration& found,
                                 const std::vector<std::array<double, 3>>& points) {
  using enum format::MeshField::On;
  const surface::TriangleMesh& first = found.first.mesh();
  format::MeshDocument mesh;
  mesh.soup.points = points;
  mesh.soup.triangles = first.surface.triangles();
  std::vector<std::array<double, 2>> places;
  places.reserve(found.points.position.size());
  for (const std::complex<double> z : found.points.position) places.push_back({z.real(), z.imag()});
  mesh.fields = {field_of("place", vertices, places), field_of("first", vertices, first.points),
                 field_of("quasi_conformal", triangles, found.points.quasi_conformal)};
  return mesh;
}

template <>
const FieldList<SurfaceRegistration>& fields_of<SurfaceRegistration>() {
  using S = const SurfaceRegistration&;
  static const FieldList<SurfaceRegistration> fields{
      {{"matching", "", "of each loop of the first surface, the loop of the second",
        type::list(type::integer)},
       [](S s) -> Tree { return s.matching; }},
      {{"search", "",
        "how the matching was found: distance of the circles, tried (matchings that fit as well), "
        "next_distance (null: there is no other); null: it was given",
        type::or_null(type::object({{"distance", type::number},
                                    {"tried", type::integer},
                                    {"next_distance", type::or_null(type::number)}}))},
       search_tree},
      {{"mean_quasiconformal", "",
        "ratio of the axes of the ellipse that a circle on the first surface becomes on the second: the mean "
        "by area",
        type::number},
       [](S s) -> Tree { return s.points.mean_quasi_conformal; }},
      {{"max_quasiconformal", "", "the greatest of these ratios", type::number},
       [](S s) -> Tree { return s.points.max_quasi_conformal; }},
      {{"mean_distance", "", "of the surfaces in space, point by point: the mean by area", type::number},
       [](S s) -> Tree { return s.points.mean_distance; }},
      {{"max_distance", "", "the greatest of these distances", type::number},
       [](S s) -> Tree { return s.points.max_distance; }},
      {{"flipped", "", "number of triangles inverted in the second surface's disk", type::integer},
       [](S s) -> Tree { return s.points.flipped.size(); }},
      {{"outside", "", "number of vertices whose place is beside that disk; the nearest one was taken",
        type::integer},
       [](S s) -> Tree { return s.points.outside; }},
      {{"moved", "", "number of vertices moved so that fewer triangles are inverted", type::integer},
       [](S s) -> Tree { return s.points.moved; }}};
  return fields;
}

} // namespace tetrarch::workshop
