// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_report.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tetrarch::program {
namespace {

/// Of long lists, so many are told.
constexpr std::size_t most_told = 10;

std::string at(const product::Point& p) {
  return "(" + rounded(p[0]) + ", " + rounded(p[1]) + ", " + rounded(p[2]) + ")";
}

std::string more(std::size_t all) {
  return all > most_told ? ", and " + std::to_string(all - most_told) + " more" : "";
}

Json histogram_json(const product::HexQuality& quality) {
  return {{"from", -1}, {"step", 0.1}, {"counts", quality.histogram}};
}

/// "0.0 3, 0.1 5, 0.9 112": bins that hold something, by their lower end.
std::string histogram_text(const product::HexQuality& quality) {
  std::vector<std::string> bins;
  for (int k = 0; k < static_cast<int>(quality.histogram.size()); ++k)
    if (quality.histogram[k] > 0)
      bins.push_back(fixed(0.1 * (k - 10), 1) + ": " + std::to_string(quality.histogram[k]));
  return joined(bins, ", ");
}

Json cells_json(const std::vector<product::BadHexahedron>& cells) {
  Json list = Json::array();
  for (const product::BadHexahedron& b : cells)
    list.push_back({{"hexahedron", b.hexahedron}, {"scaled_jacobian", b.scaled_jacobian}, {"at", b.center}});
  return list;
}

std::string_view end_word(product::FiberEnd end) {
  return end == product::FiberEnd::budget ? "too many steps" : "no way on";
}

} // namespace

Report partition_report(const product::Solid& solid, const product::Partition& partition,
                        const std::string& how) {
  std::vector<int> triangles(static_cast<std::size_t>(product::first_wall + partition.walls), 0);
  for (const int patch : partition.patch) ++triangles[patch];
  Report report;
  Json walls = Json::array();
  std::vector<std::string> texts;
  for (std::size_t k = product::first_wall; k < triangles.size(); ++k) {
    walls.push_back(triangles[k]);
    texts.push_back(std::to_string(triangles[k]));
  }
  report.json = {{"holes", partition.holes()},
                 {"tetrahedra", solid.size()},
                 {"partition",
                  {{"how", how},
                   {"floor", triangles[product::floor_patch]},
                   {"ceiling", triangles[product::ceiling_patch]},
                   {"walls", std::move(walls)}}}};
  report.rows = {{"solid", counted(solid.size(), "tetrahedron") + ", " + counted(partition.holes(), "hole")},
                 {"partition", how},
                 {"triangles", "floor " + std::to_string(triangles[product::floor_patch]) + ", ceiling " +
                                   std::to_string(triangles[product::ceiling_patch]) + ", walls " +
                                   joined(texts, ", ")}};
  return report;
}

Report floor_report(const product::FloorMap& floor) {
  Report report;
  report.json = {{"floor_found", floor.found}, {"floor_flipped", floor.flipped}};
  report.rows.emplace_back("floor", std::string(floor.found ? "found" : "not found within the budget") +
                                        ", flipped " + std::to_string(floor.flipped) + " of " +
                                        counted(floor.mesh.surface.triangle_count(), "triangle"));
  if (floor.height > 0) {
    Json holes = Json::array();
    for (const auto& [low, high] : floor.rectangles)
      holes.push_back({low.real(), low.imag(), high.real(), high.imag()});
    report.json["rectangle"] = {{"height", floor.height}, {"holes", std::move(holes)}};
    report.rows.emplace_back("rectangle", "1 x " + fixed(floor.height, 6));
  }
  if (!floor.found)
    report.warnings.emplace_back("no map of the floor was found within the budget; the mesh of the floor may "
                                 "be too coarse, or its corners badly placed (--corners)");
  return report;
}

Report field_report(const product::HarmonicField& field, double height, int splits, bool clamped) {
  Report report;
  report.json = {{"height", height},
                 {"splits", splits},
                 {"flow", field.flow},
                 {"residual", field.residual},
                 {"iterations", field.iterations},
                 {"negative_weights", field.negative_weights},
                 {"weights", clamped ? "clamped" : "cotangent"}};
  report.rows = {{"height", fixed(height, 6)},
                 {"edges split", std::to_string(splits)},
                 {"field", "residual " + scientific(field.residual, 1) + ", " +
                               (field.iterations > 0 ? counted(field.iterations, "iteration") : "direct") +
                               ", " + counted(field.negative_weights, "negative weight") +
                               (clamped ? ", clamped" : "")}};
  return report;
}

Report critical_report(const product::Solid& solid, const product::CriticalPlaces& places) {
  Report report;
  Json vertices = Json::array();
  std::vector<std::string> texts;
  for (const product::CriticalVertex& v : places.vertices) {
    vertices.push_back({{"vertex", v.vertex},
                        {"at", solid.point(v.vertex)},
                        {"lower", v.lower},
                        {"upper", v.upper},
                        {"on_wall", v.on_wall}});
    if (texts.size() < most_told)
      texts.push_back("v" + std::to_string(v.vertex) + " " + at(solid.point(v.vertex)));
  }
  report.json["critical"] = {{"flat_tetrahedra", places.flat}, {"vertices", std::move(vertices)}};
  report.rows.emplace_back(
      "critical places",
      places.none() ? "none"
                    : counted(static_cast<long long>(places.flat.size()), "flat tetrahedron") + ", " +
                          counted(static_cast<long long>(places.vertices.size()), "critical vertex"));
  if (!texts.empty()) report.rows.emplace_back("", joined(texts, ", ") + more(places.vertices.size()));
  return report;
}

Report coordinates_report(const product::Coordinates& coordinates) {
  Report report;
  Json list = Json::array();
  std::vector<std::string> texts;
  for (const product::StuckFiber& s : coordinates.stuck) {
    list.push_back({{"vertex", s.vertex}, {"at", s.at}, {"why", end_word(s.end)}});
    if (texts.size() < most_told) texts.push_back("v" + std::to_string(s.vertex) + " at " + at(s.at));
  }
  report.json = {{"stuck_fibers", coordinates.stuck.size()},
                 {"stuck", std::move(list)},
                 {"fibers_by_gradient", coordinates.by_gradient}};
  report.rows.emplace_back("stuck fibres",
                           std::to_string(coordinates.stuck.size()) +
                               (coordinates.by_gradient > 0
                                    ? ", by the gradient " + std::to_string(coordinates.by_gradient)
                                    : ""));
  if (!texts.empty()) {
    report.rows.emplace_back("", joined(texts, ", ") + more(coordinates.stuck.size()));
    report.warnings.push_back(
        counted(static_cast<long long>(texts.size()), "fiber") +
        " failed to reach the floor; the places are listed, and --weights clamped may help");
  }
  return report;
}

Report quality_report(const product::Solid& solid, const product::Quality& quality) {
  Report report;
  Json places = Json::array();
  std::vector<std::string> texts;
  for (const int t : quality.flipped) {
    product::Point center{};
    for (const int v : solid.corners(t))
      for (std::size_t c = 0; c < 3; ++c) center[c] += solid.point(v)[c] / 4;
    places.push_back({{"tetrahedron", t}, {"at", center}});
    if (texts.size() < most_told) texts.push_back("t" + std::to_string(t) + " " + at(center));
  }
  report.json = {{"flipped", quality.flipped.size()},
                 {"flipped_tetrahedra", std::move(places)},
                 {"orthogonality_error", quality.mean_orthogonality_error},
                 {"max_orthogonality_error", quality.max_orthogonality_error},
                 {"uv_error", quality.mean_uv},
                 {"max_uv_error", quality.max_uv}};
  report.rows.emplace_back("flipped", counted(static_cast<long long>(quality.flipped.size()), "tetrahedron"));
  if (!texts.empty()) report.rows.emplace_back("", joined(texts, ", ") + more(quality.flipped.size()));
  report.rows.emplace_back("w to u and v", "cosine " + scientific(quality.mean_orthogonality_error, 1) +
                                               " on average, " +
                                               scientific(quality.max_orthogonality_error, 1) + " at most");
  report.rows.emplace_back("u to v", "cosine " + scientific(quality.mean_uv, 1) + " on average, " +
                                         scientific(quality.max_uv, 1) + " at most");
  return report;
}

Report confirmation_report(const product::Confirmation& confirmation) {
  Report report;
  report.json["opposite_way"] = {{"mean_distance", confirmation.mean_distance},
                                 {"max_distance", confirmation.max_distance},
                                 {"worst_vertex", confirmation.worst},
                                 {"farther_than_an_edge", confirmation.off},
                                 {"not_arrived", confirmation.not_arrived}};
  report.rows.emplace_back("the opposite way",
                           scientific(confirmation.mean_distance, 1) + " mean edges off on average, " +
                               scientific(confirmation.max_distance, 1) + " at most (v" +
                               std::to_string(confirmation.worst) + "), " +
                               counted(confirmation.off, "vertex") + " off by more than an edge, " +
                               std::to_string(confirmation.not_arrived) + " lost on the way");
  return report;
}

Report grid_report(const product::FloorGrid& grid) {
  Report report;
  report.json["grid"] = {{"columns", grid.columns},
                         {"rows", grid.rows},
                         {"cells", grid.cells.size()},
                         {"mean_stretch", grid.mean_stretch},
                         {"max_stretch", grid.max_stretch}};
  report.rows.emplace_back("grid", std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + ", " +
                                       counted(static_cast<long long>(grid.cells.size()), "cell") +
                                       ", stretch " + fixed(grid.mean_stretch, 3) + " on average, " +
                                       fixed(grid.max_stretch, 3) + " at most");
  return report;
}

double MeasuredHexahedra::volume_error() const {
  return std::abs(volume - solid_volume) / solid_volume;
}

Report hexahedra_report(const MeasuredHexahedra& hexahedra) {
  const product::HexQuality& quality = hexahedra.quality;
  const int left_out = hexahedra.of.left_out;
  const std::size_t count = hexahedra.of.mesh.hexahedra.size();
  Report report;
  std::vector<std::string> texts;
  for (const product::BadHexahedron& b : quality.worst)
    texts.push_back("h" + std::to_string(b.hexahedron) + " " + fixed(b.scaled_jacobian, 4) + " at " +
                    at(b.center));
  report.json = {{"hexahedra", count},
                 {"left_out", left_out},
                 {"volume",
                  {{"hexahedra", hexahedra.volume},
                   {"solid", hexahedra.solid_volume},
                   {"relative_error", hexahedra.volume_error()}}},
                 {"min_scaled_jacobian", quality.minimum},
                 {"mean_scaled_jacobian", quality.mean},
                 {"inverted", quality.bad.size()},
                 {"below_0.2", std::count_if(quality.scaled_jacobian.begin(), quality.scaled_jacobian.end(),
                                             [](double j) { return j < 0.2; })},
                 {"volume_ratio", hexahedra.volume / hexahedra.solid_volume},
                 {"hausdorff", hexahedra.deviation.relative()},
                 {"hausdorff_at", hexahedra.deviation.at()},
                 {"histogram", histogram_json(quality)},
                 {"bad", cells_json(quality.bad)},
                 {"worst", cells_json(quality.worst)}};
  report.rows = {
      {"hexahedra", std::to_string(count) + (left_out > 0 ? ", left out " + std::to_string(left_out) : "")},
      {"volume", rounded(hexahedra.volume) + ", of the solid " + rounded(hexahedra.solid_volume) +
                     ", relative error " + scientific(hexahedra.volume_error(), 1)},
      {"distance", scientific(hexahedra.deviation.relative(), 1) +
                       " of the diagonal between the surfaces, at " + at(hexahedra.deviation.at())},
      {"scaled Jacobian", fixed(quality.minimum, 4) + " at least, " + fixed(quality.mean, 4) +
                              " on average, 0 or less in " + std::to_string(quality.bad.size())},
      {"", histogram_text(quality)},
      {"worst", joined(texts, ", ")}};
  if (left_out > 0)
    report.warnings.push_back(counted(left_out, "hexahedron") +
                              " left out beside fibers that failed to arrive");
  return report;
}

std::vector<std::string> doubts_about(const MeasuredHexahedra& hexahedra, double volume_tolerance) {
  std::vector<std::string> doubts;
  if (hexahedra.of.mesh.hexahedra.empty()) return {"there are no hexahedra"};
  if (!hexahedra.quality.bad.empty())
    doubts.push_back(counted(static_cast<long long>(hexahedra.quality.bad.size()), "hexahedron") +
                     " of scaled Jacobian 0 or less");
  if (hexahedra.of.left_out > 0) doubts.push_back(counted(hexahedra.of.left_out, "hexahedron") + " left out");
  if (!(hexahedra.volume_error() <= volume_tolerance))
    doubts.push_back("the volume is " + rounded(hexahedra.volume) + " and that of the solid " +
                     rounded(hexahedra.solid_volume) + ", off by more than the tolerance of " +
                     rounded(volume_tolerance));
  return doubts;
}

std::vector<std::string> doubts_about(const product::Coordinates& coordinates,
                                      const product::Quality& quality,
                                      const product::Confirmation& confirmation) {
  std::vector<std::string> doubts;
  const auto doubt = [&](std::size_t count, const char* noun, const char* what) {
    if (count > 0) doubts.push_back(counted(static_cast<long long>(count), noun) + what);
  };
  doubt(quality.flipped.size(), "tetrahedron", " flipped");
  doubt(coordinates.stuck.size(), "fiber", " stuck");
  doubt(static_cast<std::size_t>(confirmation.off), "vertex", " off by more than an edge, the opposite way");
  doubt(static_cast<std::size_t>(confirmation.not_arrived), "fiber", " lost, the opposite way");
  return doubts;
}

Report verdict_report(const Verdict& verdict) {
  const std::vector<std::string>& doubts = verdict.doubts;
  Report report;
  report.json[verdict.key] = {{"verdict", doubts.empty() ? "yes" : "undecided"}, {"doubts", doubts}};
  report.rows.emplace_back(verdict.question,
                           doubts.empty() ? "yes: " + verdict.because : "undecided: " + joined(doubts, "; "));
  return report;
}

Report untangled_report(const product::Untangled& untangled) {
  Report report;
  report.json["untangling"] = {{"bad_before", untangled.bad_before},
                               {"bad_after", untangled.bad_after},
                               {"min_scaled_jacobian_before", untangled.minimum_before},
                               {"min_scaled_jacobian_after", untangled.minimum_after},
                               {"sliding", untangled.sliding},
                               {"iterations", untangled.iterations}};
  report.rows = {{"untangling",
                  counted(untangled.iterations, "iteration") + ", " + counted(untangled.sliding, "point") +
                      " sliding; 0 or less in " + std::to_string(untangled.bad_before) + " before, in " +
                      std::to_string(untangled.bad_after) + " after; " + fixed(untangled.minimum_before, 4) +
                      " at least before, " + fixed(untangled.minimum_after, 4) + " after"}};
  return report;
}

Report smoothed_report(const product::Smoothed& smoothed, const product::HexQuality& before) {
  Report report;
  report.json["smoothing"] = {{"sweeps", smoothed.sweeps},
                              {"moved", smoothed.moved},
                              {"min_scaled_jacobian_before", smoothed.minimum_before},
                              {"bad_before", smoothed.bad_before},
                              {"histogram_before", histogram_json(before)}};
  report.rows = {{"smoothing", counted(smoothed.sweeps, "sweep") + ", " + counted(smoothed.moved, "point") +
                                   " moved; before: " + fixed(smoothed.minimum_before, 4) +
                                   " at least, 0 or less in " + std::to_string(smoothed.bad_before)},
                 {"", histogram_text(before)}};
  return report;
}

} // namespace tetrarch::program
