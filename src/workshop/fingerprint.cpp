// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/fingerprint.hpp"

#include "tetrarch/slit/matching.hpp"
#include "tetrarch/workshop/in_file.hpp"
#include "tetrarch/workshop/slit.hpp"
#include "tetrarch/workshop/text.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

using TypeRef = const ConformalType&;

/// "0.293527 +- 2e-04"; without a bound the number alone.
std::string with_error(double value, double error) {
  return fixed(value, 6) + (std::isfinite(error) ? " +- " + scientific(error, 0) : "");
}

/// Numbers of the ring or of the disk: the inner radius, then three for each loop that is neither outer nor
/// inner.
struct Invariants {
  const std::vector<double>& value;
  const std::vector<double>& error;

  std::string text(std::size_t k) const { return with_error(value[k], error[k]); }
  Tree tree(std::size_t k) const {
    return {{"value", value[k]}, {"error", std::isfinite(error[k]) ? Tree(error[k]) : Tree()}};
  }
};

Invariants ring_of(const slit::Fingerprint& f) {
  return {f.ring, f.ring_error};
}
Invariants disk_of(const slit::Fingerprint& f) {
  return {f.disk, f.disk_error};
}

/// Where the numbers of loop `k`, the outer one counted as 0, begin.
std::size_t invariants_of_loop(std::size_t k) {
  return 3 * (k - 2) + 1;
}

Tree invariants_tree(const slit::Fingerprint& f, const Invariants& invariants,
                     const std::array<const char*, 3>& names) {
  Tree list = Tree::array();
  for (std::size_t k = 2; k < f.loops.size(); ++k) {
    const std::size_t at = invariants_of_loop(k);
    list.push_back({{"loop", f.loops[k]},
                    {names[0], invariants.tree(at)},
                    {names[1], invariants.tree(at + 1)},
                    {names[2], invariants.tree(at + 2)}});
  }
  return list;
}

Tree fingerprint_tree(TypeRef t) {
  const slit::Fingerprint& f = t.fingerprint;
  const Invariants ring = ring_of(f);
  const Invariants disk = disk_of(f);
  return {
      {"outer", f.loops[0]},
      {"inner", f.loops[1]},
      {"ring",
       {{"inner_radius", ring.tree(0)}, {"slits", invariants_tree(f, ring, {"radius", "start", "end"})}}},
      {"disk", {{"inner_radius", disk.tree(0)}, {"circles", invariants_tree(f, disk, {"x", "y", "radius"})}}},
      {"triangles", f.triangles}};
}

Type fingerprint_type() {
  const Type known = type::object({{"value", type::number}, {"error", type::or_null(type::number)}});
  const auto loops = [&known](const char* first, const char* second, const char* third) {
    return type::list(
        type::object({{"loop", type::integer}, {first, known}, {second, known}, {third, known}}));
  };
  return type::object(
      {{"outer", type::integer},
       {"inner", type::integer},
       {"ring", type::object({{"inner_radius", known}, {"slits", loops("radius", "start", "end")}})},
       {"disk", type::object({{"inner_radius", known}, {"circles", loops("x", "y", "radius")}})},
       {"triangles", type::list(type::integer)}});
}

void add_fingerprint(Rows& rows, const slit::Fingerprint& f) {
  const Invariants ring = ring_of(f);
  const Invariants disk = disk_of(f);
  rows.emplace_back("outer, inner loop", std::to_string(f.loops[0]) + ", " + std::to_string(f.loops[1]));
  rows.emplace_back("inner radius, ring", ring.text(0));
  for (std::size_t k = 2; k < f.loops.size(); ++k) {
    const std::size_t at = invariants_of_loop(k);
    rows.emplace_back("slit of loop " + std::to_string(f.loops[k]), "radius " + ring.text(at) + ", angle " +
                                                                        ring.text(at + 1) + " to " +
                                                                        ring.text(at + 2));
  }
  rows.emplace_back("inner radius, disk", disk.text(0));
  for (std::size_t k = 2; k < f.loops.size(); ++k) {
    const std::size_t at = invariants_of_loop(k);
    rows.emplace_back("circle of loop " + std::to_string(f.loops[k]),
                      "centre " + disk.text(at) + ", " + disk.text(at + 1) + ", radius " + disk.text(at + 2));
  }
  std::vector<std::string> sizes;
  for (const int n : f.triangles) sizes.push_back(std::to_string(n));
  rows.emplace_back("triangles", joined(sizes, ", "));
}

void add_comparison(Rows& rows, const ConformalType::Comparison& c) {
  std::vector<std::string> pairs;
  for (std::size_t k = 0; k < c.matching.size(); ++k)
    pairs.push_back(std::to_string(k) + " to " + std::to_string(c.matching[k]));
  rows.emplace_back("distance", fixed(c.distance, 6));
  rows.emplace_back("loops", joined(pairs, ", ") + (c.mirrored ? ", mirrored" : ""));
  if (c.second_distance)
    rows.emplace_back("next best", fixed(*c.second_distance, 6) + ", by another matching");
}

bool is_compared(TypeRef t) {
  return t.comparison.has_value();
}

} // namespace

Verdict ConformalType::verdict() const {
  return fingerprint.found && (!comparison || comparison->other_found) ? Verdict::yes : Verdict::undecided;
}

ConformalType conformal_type(HoledSurface surface, const FingerprintOptions& options,
                             const Progress& progress) {
  slit::Fingerprint found = in_file(options.name, [&] {
    return slit::fingerprint(surface.mesh(), options.circles, options.most_triangles, progress);
  });
  return {std::move(surface), std::move(found), {}};
}

ConformalType::Comparison comparison(const ConformalType& own, const ConformalType& other, bool with_mirror) {
  slit::MatchingOptions how;
  how.with_mirror_images = with_mirror;
  const std::vector<slit::Matching> found =
      slit::best_matchings(slit::circles(own.fingerprint), slit::circles(other.fingerprint), how);
  const slit::Matching& best = found.front();
  const std::vector<int>& loops = own.fingerprint.loops;
  ConformalType::Comparison c{
      best.distance, std::vector<int>(loops.size()), best.mirrored, {}, other.fingerprint.found};
  for (std::size_t k = 0; k < loops.size(); ++k)
    c.matching[loops[k]] = other.fingerprint.loops[static_cast<std::size_t>(best.to[k])];
  if (found.size() > 1) c.second_distance = found[1].distance;
  return c;
}

Rows rows_of(const ConformalType& found) {
  Rows rows;
  add_fingerprint(rows, found.fingerprint);
  if (found.comparison) add_comparison(rows, *found.comparison);
  return rows;
}

template <>
const FieldList<ConformalType>& fields_of<ConformalType>() {
  static const FieldList<ConformalType> fields{
      {notes_of<HoledSurface>().front(), [](TypeRef t) -> Tree { return tree_of(t.surface)["boundaries"]; }},
      {{"fingerprint", "radians",
        "with --fingerprint or --distance: outer and inner (loops), ring (inner_radius, and of each slit "
        "loop, radius, start, end), disk (inner_radius, and of each circle loop, x, y, radius), triangles; "
        "each number (lengths are those of a unit disk) as value and error, null where none is known",
        fingerprint_type()},
       fingerprint_tree},
      {{"distance", "", "with --distance: the least over all matchings of the loops", type::number},
       [](TypeRef t) -> Tree { return t.comparison->distance; },
       is_compared},
      {{"matching", "", "with --distance: of each loop, the loop of the other surface",
        type::list(type::integer)},
       [](TypeRef t) -> Tree { return t.comparison->matching; },
       is_compared},
      {{"mirrored", "", "with --distance: whether the other surface's mirror image is nearer", type::truth},
       [](TypeRef t) -> Tree { return t.comparison->mirrored; },
       is_compared},
      {{"second_distance", "", "with --distance: by the next best matching; null: there is no other",
        type::or_null(type::number)},
       [](TypeRef t) {
         return t.comparison->second_distance ? Tree(*t.comparison->second_distance) : Tree();
       },
       is_compared}};
  return fields;
}

std::vector<FieldNote> notes_of_maps_and_types() {
  return either_of(notes_of<ConformalMap>(), notes_of<ConformalType>());
}

} // namespace tetrarch::workshop
