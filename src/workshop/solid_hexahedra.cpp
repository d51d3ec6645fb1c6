// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/solid_hexahedra.hpp"

#include "hexahedra_facts.hpp"
#include "question.hpp"

#include "tetrarch/workshop/text.hpp"

#include <cmath>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Measured = const MeasuredHexahedra&;

/// Meshes with a lesser scaled Jacobian are untangled before they are smoothed.
constexpr double smooth_enough = 0.2;

void improve(MeasuredHexahedra& found, const Progress& progress) {
  product::HexQuality before = product::quality(found.of.mesh);
  // Points move one at a time in smoothing, which seldom undoes a tangle.
  if (before.minimum < smooth_enough) found.untangled = product::untangle(found.of.mesh, {}, progress);
  const product::Smoothed done = product::smooth(found.of.mesh, found.of.on_boundary, {}, progress);
  found.smoothing = {done, std::move(before)};
}

Tree histogram_tree(const product::HexQuality& quality) {
  return {{"from", -1}, {"step", 0.1}, {"counts", quality.histogram}};
}

Type histogram_type() {
  return type::object(
      {{"from", type::number}, {"step", type::number}, {"counts", type::list(type::integer)}});
}

/// "0.0: 3, 0.1: 5, 0.9: 112": bins that hold something, by their lower end.
std::string histogram_text(const product::HexQuality& quality) {
  std::vector<std::string> bins;
  for (int k = 0; k < static_cast<int>(quality.histogram.size()); ++k)
    if (quality.histogram[k] > 0)
      bins.push_back(fixed(0.1 * (k - 10), 1) + ": " + std::to_string(quality.histogram[k]));
  return joined(bins, ", ");
}

Question filling_of(Measured m) {
  return {"a mesh of it", "no hexahedron is inverted or left out, and the volume agrees", m.doubts()};
}

void add_grid_rows(Rows& rows, const product::FloorGrid& grid) {
  rows.emplace_back("grid", std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + ", " +
                                counted(static_cast<long long>(grid.cells.size()), "cell") + ", stretch " +
                                fixed(grid.mean_stretch, 3) + " on average, " + fixed(grid.max_stretch, 3) +
                                " at most");
}

void add_untangling_rows(Rows& rows, const product::Untangled& u) {
  rows.emplace_back("untangling", counted(u.iterations, "iteration") + ", " + counted(u.sliding, "point") +
                                      " sliding; 0 or less in " + std::to_string(u.bad_before) +
                                      " before, in " + std::to_string(u.bad_after) + " after; " +
                                      fixed(u.minimum_before, 4) + " at least before, " +
                                      fixed(u.minimum_after, 4) + " after");
}

void add_smoothing_rows(Rows& rows, const MeasuredHexahedra::Smoothing& s) {
  rows.emplace_back("smoothing", counted(s.done.sweeps, "sweep") + ", " + counted(s.done.moved, "point") +
                                     " moved; before: " + fixed(s.done.minimum_before, 4) +
                                     " at least, 0 or less in " + std::to_string(s.done.bad_before));
  rows.emplace_back("", histogram_text(s.before));
}

void add_measure_rows(Rows& rows, Measured m) {
  const int left_out = m.of.left_out;
  rows.emplace_back("hexahedra", std::to_string(m.of.mesh.hexahedra.size()) +
                                     (left_out > 0 ? ", left out " + std::to_string(left_out) : ""));
  rows.emplace_back("volume", rounded(m.volume) + ", of the solid " + rounded(m.solid_volume) +
                                  ", relative error " + scientific(m.volume_error(), 1));
  rows.emplace_back("distance", scientific(m.deviation.relative(), 1) +
                                    " of the diagonal between the surfaces, at " + text_of(m.deviation.at()));
  rows.emplace_back("scaled Jacobian", fixed(m.quality.minimum, 4) + " at least, " +
                                           fixed(m.quality.mean, 4) + " on average, 0 or less in " +
                                           std::to_string(m.quality.bad.size()));
  rows.emplace_back("", histogram_text(m.quality));
  rows.emplace_back("worst", text_of(m.quality.worst));
}

Tree grid_tree(Measured m) {
  return {{"columns", m.grid->columns},
          {"rows", m.grid->rows},
          {"cells", m.grid->cells.size()},
          {"mean_stretch", m.grid->mean_stretch},
          {"max_stretch", m.grid->max_stretch}};
}

Tree untangling_tree(Measured m) {
  const product::Untangled& u = *m.untangled;
  return {{"bad_before", u.bad_before},
          {"bad_after", u.bad_after},
          {"min_scaled_jacobian_before", u.minimum_before},
          {"min_scaled_jacobian_after", u.minimum_after},
          {"sliding", u.sliding},
          {"iterations", u.iterations}};
}

Tree smoothing_tree(Measured m) {
  const product::Smoothed& s = m.smoothing->done;
  return {{"sweeps", s.sweeps},
          {"moved", s.moved},
          {"min_scaled_jacobian_before", s.minimum_before},
          {"bad_before", s.bad_before},
          {"histogram_before", histogram_tree(m.smoothing->before)}};
}

Tree volume_tree(Measured m) {
  return {{"hexahedra", m.volume}, {"solid", m.solid_volume}, {"relative_error", m.volume_error()}};
}

} // namespace

SolidMeasure measure_of(const product::Solid& solid) {
  return {product::volume(solid), hex::boundary_triangles(solid)};
}

double MeasuredHexahedra::volume_error() const {
  return std::abs(volume - solid_volume) / solid_volume;
}

std::vector<std::string> MeasuredHexahedra::doubts() const {
  std::vector<std::string> clauses;
  if (of.mesh.hexahedra.empty()) return {"there are no hexahedra"};
  if (!quality.bad.empty())
    clauses.push_back(counted(static_cast<long long>(quality.bad.size()), "hexahedron") +
                      " of scaled Jacobian 0 or less");
  if (of.left_out > 0) clauses.push_back(counted(of.left_out, "hexahedron") + " left out");
  if (!(volume_error() <= volume_tolerance))
    clauses.push_back("the volume is " + rounded(volume) + " and that of the solid " + rounded(solid_volume) +
                      ", off by more than the tolerance of " + rounded(volume_tolerance));
  return clauses;
}

void improve_and_measure(MeasuredHexahedra& found, const SolidMeasure& solid, const HexahedraOptions& options,
                         const Progress& progress) {
  if (options.smooth) improve(found, progress);
  found.quality = product::quality(found.of.mesh);
  found.volume = product::volume(found.of.mesh);
  found.solid_volume = solid.volume;
  found.deviation = hex::deviation(solid.boundary, found.of.mesh);
  found.volume_tolerance = options.volume_tolerance;
}

Rows rows_of(const MeasuredHexahedra& found) {
  Rows rows;
  if (found.grid)
    add_grid_rows(rows, *found.grid);
  else
    rows.emplace_back("cubes carried by", found.carried_by);
  if (found.untangled) add_untangling_rows(rows, *found.untangled);
  if (found.smoothing) add_smoothing_rows(rows, *found.smoothing);
  add_measure_rows(rows, found);
  rows.push_back(row_of(filling_of(found)));
  return rows;
}

template <>
const FieldList<MeasuredHexahedra>& fields_of<MeasuredHexahedra>() {
  using M = Measured;
  static const FieldList<MeasuredHexahedra> fields{
      {{"carried_by", "", "of a polycube: the map, in words, by which its cubes came into the solid",
        type::text},
       [](M m) -> Tree { return m.carried_by; },
       [](M m) { return !m.grid; }},
      {{"grid", "",
        "on the floor: columns, rows, cells, and how far from squares the cells are (mean_stretch, "
        "max_stretch)",
        type::object({{"columns", type::integer},
                      {"rows", type::integer},
                      {"cells", type::integer},
                      {"mean_stretch", type::number},
                      {"max_stretch", type::number}})},
       grid_tree,
       [](M m) { return m.grid.has_value(); }},
      {{"untangling", "",
        "inverted hexahedra and the least scaled Jacobian before and after; points of the surface that "
        "slide; "
        "iterations",
        type::object({{"bad_before", type::integer},
                      {"bad_after", type::integer},
                      {"min_scaled_jacobian_before", type::number},
                      {"min_scaled_jacobian_after", type::number},
                      {"sliding", type::integer},
                      {"iterations", type::integer}})},
       untangling_tree,
       [](M m) { return m.untangled.has_value(); }},
      {{"smoothing", "",
        "sweeps, points moved, and as it was before: the least scaled Jacobian, inverted hexahedra, "
        "histogram",
        type::object({{"sweeps", type::integer},
                      {"moved", type::integer},
                      {"min_scaled_jacobian_before", type::number},
                      {"bad_before", type::integer},
                      {"histogram_before", histogram_type()}})},
       smoothing_tree,
       [](M m) { return m.smoothing.has_value(); }},
      {{"hexahedra", "", "how many", type::integer}, [](M m) -> Tree { return m.of.mesh.hexahedra.size(); }},
      {{"left_out", "", "hexahedra beside fibers that failed to arrive", type::integer},
       [](M m) -> Tree { return m.of.left_out; }},
      {{"volume", "cube of the mesh's unit", "of the hexahedra, of the solid, and their relative_error",
        type::object(
            {{"hexahedra", type::number}, {"solid", type::number}, {"relative_error", type::number}})},
       volume_tree},
      {{"min_scaled_jacobian", "", "the least of all hexahedra, in [-1, 1]", type::number},
       [](M m) -> Tree { return m.quality.minimum; }},
      {{"mean_scaled_jacobian", "", "the mean over all hexahedra", type::number},
       [](M m) -> Tree { return m.quality.mean; }},
      {{"inverted", "", "hexahedra of scaled Jacobian 0 or less", type::integer},
       [](M m) -> Tree { return m.quality.bad.size(); }},
      {{"below_0.2", "", "hexahedra of lesser scaled Jacobian", type::integer},
       [](M m) -> Tree { return count_below_good(m.quality); }},
      {{"volume_ratio", "", "volume of the hexahedra over that of the solid", type::number},
       [](M m) -> Tree { return m.volume / m.solid_volume; }},
      {{"hausdorff", "diagonal of the box", "greatest distance between the surfaces, either way; sampled",
        type::number},
       [](M m) -> Tree { return m.deviation.relative(); }},
      {{"hausdorff_at", "", "the point where the distance is greatest", type::list(type::number, 3)},
       [](M m) -> Tree { return m.deviation.at(); }},
      {{"histogram", "",
        "hexahedra by their scaled Jacobian: counts of bins of width step, the first at from",
        histogram_type()},
       [](M m) { return histogram_tree(m.quality); }},
      {{"bad", "", "the inverted ones: hexahedron, scaled_jacobian, at", bad_hexahedra_type()},
       [](M m) { return tree_of(m.quality.bad); }},
      {{"worst", "", "the ten of least scaled Jacobian, likewise", bad_hexahedra_type()},
       [](M m) { return tree_of(m.quality.worst); }},
      {{"filling", "", "whether they are a mesh of the solid: verdict (yes or undecided) and doubts",
        question_type()},
       [](M m) { return tree_of(filling_of(m)); }}};
  return fields;
}

} // namespace tetrarch::workshop
