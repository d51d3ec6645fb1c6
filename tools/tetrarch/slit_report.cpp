// SPDX-License-Identifier: GPL-2.0-or-later
#include "slit_report.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tetrarch::program {
namespace {

std::string triangles(long long n) {
  return counted(n, "triangle");
}

std::string loop_name(const char* what, int loop) {
  return std::string(what) + " of loop " + std::to_string(loop);
}

/// "0.293527 +- 2e-04"; without a bound the number alone.
std::string with_error(double value, double error) {
  return fixed(value, 6) + (std::isfinite(error) ? " +- " + scientific(error, 0) : "");
}

Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

} // namespace

Report loops_report(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops) {
  Report report;
  Json list = Json::array();
  for (const mesh::BoundaryLoop& loop : loops) {
    const long long vertex = surface.number[surface.mesh.surface.vertex(loop.sides.front())];
    report.rows.emplace_back("boundary loop " + std::to_string(list.size()),
                             counted(static_cast<long long>(loop.sides.size()), "edge") + ", length " +
                                 rounded(loop.length) + ", area " + rounded(loop.area) + ", through v" +
                                 std::to_string(vertex));
    list.push_back({{"index", list.size()},
                    {"edges", loop.sides.size()},
                    {"length", loop.length},
                    {"area", loop.area},
                    {"vertex", vertex}});
  }
  report.json["boundaries"] = std::move(list);
  return report;
}

Report map_report(const slit::SlitMap& map, bool on_ring) {
  Report report;
  report.json = {{"outer", map.outer},
                 {"inner", map.inner},
                 {"modulus", map.modulus},
                 {"modulus_bounds", {map.modulus, map.modulus_bound}}};
  report.rows = {{"outer, inner loop", std::to_string(map.outer) + ", " + std::to_string(map.inner)},
                 {"modulus", fixed(map.modulus, 6) + ", at most " + fixed(map.modulus_bound, 6)}};
  if (on_ring) {
    report.json["radii"] = {{"outer", 1.0}, {"inner", std::exp(-map.modulus)}};
    report.rows.emplace_back("inner radius", fixed(std::exp(-map.modulus), 6));
  }
  Json slits = Json::array();
  for (const slit::Slit& s : map.slits) {
    const char* const name = on_ring ? "radius" : "height";
    const double place = on_ring ? s.radius : -std::log(s.radius);
    slits.push_back({{"loop", s.loop}, {name, place}, {"start", s.start}, {"end", s.end}});
    report.rows.emplace_back(loop_name("slit", s.loop), std::string(name) + " " + fixed(place, 6) +
                                                            ", angle " + fixed(s.start, 6) + " to " +
                                                            fixed(s.end, 6));
    if (s.turns != 2)
      report.warnings.push_back("loop " + std::to_string(s.loop) + " turns back " + std::to_string(s.turns) +
                                " times on its slit instead of twice");
  }
  report.json["slits"] = std::move(slits);
  return report;
}

Report circles_report(const slit::CircularMap& map) {
  Report report;
  Json circles = Json::array();
  for (std::size_t k = 0; k < map.loop.size(); ++k) {
    const slit::Circle& c = map.domain.circles[k];
    circles.push_back({{"loop", map.loop[k]},
                       {"center", {c.center.real(), c.center.imag()}},
                       {"radius", c.radius},
                       {"circularity", c.circularity}});
    report.rows.emplace_back(loop_name("circle", map.loop[k]), "centre " + fixed(c.center.real(), 6) + ", " +
                                                                   fixed(c.center.imag(), 6) + ", radius " +
                                                                   fixed(c.radius, 6));
  }
  report.json = {{"circles", std::move(circles)},
                 {"circularity", map.domain.circularity},
                 {"iterations", map.domain.rounds},
                 {"converged", map.domain.found}};
  report.rows.emplace_back("circularity", scientific(map.domain.circularity, 1) + " after " +
                                              counted(map.domain.rounds, "round"));
  return report;
}

Report unflipped_report(const slit::Unflipped& unflipped) {
  Report report;
  report.json["unflipped"] = {{"moved", unflipped.moved}, {"farthest", unflipped.farthest}};
  report.rows.emplace_back("unflipped", counted(unflipped.moved, "vertex") + " moved, by " +
                                            scientific(unflipped.farthest, 1) + " at most");
  return report;
}

Report softened_report(const slit::Softened& softened) {
  Report report;
  report.json["slit_ends"] = {{"moved", softened.moved},
                              {"max_quasiconformal_before", softened.before},
                              {"max_quasiconformal", softened.after}};
  report.rows.emplace_back("slit ends", counted(softened.moved, "vertex") +
                                            " moved, greatest distortion there " + rounded(softened.before) +
                                            " to " + rounded(softened.after));
  return report;
}

Report balanced_report(const slit::Balanced& balanced, const slit::Distortion& before) {
  Report report;
  report.json["balanced"] = {{"energy_before", finite_or_null(balanced.before)},
                             {"energy", finite_or_null(balanced.after)},
                             {"steps", balanced.steps},
                             {"settled", balanced.settled},
                             {"left_out", balanced.left_out},
                             {"mean_area_error_before", before.mean_area_error},
                             {"max_area_error_before", before.max_area_error},
                             {"mean_angle_error_before", before.mean_angle_error},
                             {"mean_quasiconformal_before", before.mean_quasi_conformal}};
  report.rows = {{"balanced", "energy " + rounded(balanced.before) + " to " + rounded(balanced.after) +
                                  " in " + counted(balanced.steps, "step")},
                 {"before", "area errors mean " + fixed(before.mean_area_error, 4) + ", greatest " +
                                fixed(before.max_area_error, 4) + "; angle errors mean " +
                                scientific(before.mean_angle_error, 1)}};
  if (!balanced.settled)
    report.warnings.emplace_back("the energy of the map still fell when its budget of steps ended, or areas "
                                 "are too unequal for doubles; it may not be the least");
  return report;
}

Report distortion_report(const slit::Distortion& d) {
  Report report;
  report.json = {{"max_angle_error", d.max_angle_error},
                 {"mean_angle_error", d.mean_angle_error},
                 {"max_quasiconformal", d.max_quasi_conformal},
                 {"mean_quasiconformal", d.mean_quasi_conformal},
                 {"max_area_error", d.max_area_error},
                 {"mean_area_error", d.mean_area_error},
                 {"flipped", d.flipped.size()},
                 {"ears", d.ears}};
  const auto flipped = static_cast<long long>(d.flipped.size());
  report.rows = {
      {"angle errors",
       "mean " + scientific(d.mean_angle_error, 1) + ", greatest " + scientific(d.max_angle_error, 1)},
      {"quasi-conformal",
       "mean " + fixed(d.mean_quasi_conformal, 4) + ", greatest " + fixed(d.max_quasi_conformal, 4)},
      {"area errors", "mean " + fixed(d.mean_area_error, 4) + ", greatest " + fixed(d.max_area_error, 4)},
      {"flipped", flipped == 0 ? "none" : triangles(flipped)}};
  if (flipped > 0)
    report.warnings.push_back(triangles(flipped) + (flipped == 1 ? " is" : " are") +
                              " inverted or flat, the first is " + std::to_string(d.flipped.front()) +
                              " (counted from 0)");
  if (d.ears > 0)
    report.warnings.push_back(triangles(d.ears) + (d.ears == 1 ? " has" : " have") +
                              " all corners on one loop, so the domain has no room for them");
  return report;
}

Report residuals_report(const slit::Residuals& r) {
  Report report;
  report.json["residuals"] = {
      {"period", r.period}, {"flux", r.flux}, {"harmonic", r.harmonic}, {"radius", r.radius}};
  report.rows.emplace_back("residuals", "periods " + scientific(r.period, 1) + ", fluxes " +
                                            scientific(r.flux, 1) + ", harmonic " +
                                            scientific(r.harmonic, 1) + ", radii " + scientific(r.radius, 1));
  return report;
}

Report rectangle_report(const slit::RicciRectangles& found, const mesh::OpenedMesh& surface,
                        const std::vector<mesh::BoundaryLoop>& loops, const std::vector<int>& order) {
  Report report;
  Json corners = Json::array();
  std::vector<std::string> names;
  for (const slit::LoopCorner& c : found.corners.front()) {
    corners.push_back(surface.number[c.vertex]);
    names.push_back("v" + std::to_string(surface.number[c.vertex]));
  }
  report.rows = {{"outer loop", std::to_string(order.front()) + ", corners " + joined(names, ", ")},
                 {"rectangle", "width 1, height " + fixed(found.height, 6)}};
  Json holes = Json::array();
  for (std::size_t k = 1; k < order.size(); ++k) {
    double left = INFINITY;
    double right = -INFINITY;
    double bottom = INFINITY;
    double top = -INFINITY;
    for (const mesh::SideEnd e : loops[order[k]].sides) {
      const std::complex<double> z = found.position[surface.mesh.surface.vertex(e)];
      left = std::min(left, z.real());
      right = std::max(right, z.real());
      bottom = std::min(bottom, z.imag());
      top = std::max(top, z.imag());
    }
    holes.push_back({{"loop", order[k]}, {"left", left}, {"right", right}, {"bottom", bottom}, {"top", top}});
    report.rows.emplace_back(loop_name("hole", order[k]), "x " + fixed(left, 6) + " to " + fixed(right, 6) +
                                                              ", y " + fixed(bottom, 6) + " to " +
                                                              fixed(top, 6));
  }
  report.json = {{"outer", order.front()}, {"corners", corners},         {"height", found.height},
                 {"holes", holes},         {"holonomy", found.holonomy}, {"residual", found.residual},
                 {"rounds", found.rounds}, {"converged", found.found}};
  report.rows.emplace_back("residuals", "holonomy " + scientific(found.holonomy, 1) + ", curvatures " +
                                            scientific(found.residual, 1));
  return report;
}

Report quads_report(const slit::QuadMesh& quads) {
  const slit::QuadQuality q = slit::quality(quads);
  Report report;
  report.json["quads"] = {{"count", quads.quads.size()},
                          {"vertices", quads.points.size()},
                          {"thinnest_line", quads.thinnest},
                          {"mean_edge", q.mean_edge},
                          {"mean_angle_error", q.mean_angle_error},
                          {"max_angle_error", q.max_angle_error},
                          {"mean_warp", q.mean_warp},
                          {"max_warp", q.max_warp},
                          {"min_edge", q.min_edge},
                          {"max_edge", q.max_edge}};
  report.rows.emplace_back("quads", std::to_string(quads.quads.size()) + ", angle errors mean " +
                                        scientific(q.mean_angle_error, 1) + ", greatest " +
                                        scientific(q.max_angle_error, 1));
  return report;
}

Report fingerprint_report(const slit::Fingerprint& f) {
  Report report;
  const auto invariant = [](double value, double error) {
    return Json{{"value", value}, {"error", finite_or_null(error)}};
  };
  const auto ring = [&](std::size_t k) { return with_error(f.ring[k], f.ring_error[k]); };
  const auto disk = [&](std::size_t k) { return with_error(f.disk[k], f.disk_error[k]); };
  const std::vector<int> slit_loops(f.loops.begin() + 2, f.loops.end());
  report.rows = {{"outer, inner loop", std::to_string(f.loops[0]) + ", " + std::to_string(f.loops[1])},
                 {"inner radius, ring", ring(0)}};
  Json slits = Json::array();
  Json circles = Json::array();
  for (std::size_t k = 0; k < slit_loops.size(); ++k) {
    const std::size_t at = 3 * k + 1;
    slits.push_back({{"loop", slit_loops[k]},
                     {"radius", invariant(f.ring[at], f.ring_error[at])},
                     {"start", invariant(f.ring[at + 1], f.ring_error[at + 1])},
                     {"end", invariant(f.ring[at + 2], f.ring_error[at + 2])}});
    report.rows.emplace_back(loop_name("slit", slit_loops[k]),
                             "radius " + ring(at) + ", angle " + ring(at + 1) + " to " + ring(at + 2));
  }
  report.rows.emplace_back("inner radius, disk", disk(0));
  for (std::size_t k = 0; k < slit_loops.size(); ++k) {
    const std::size_t at = 3 * k + 1;
    circles.push_back({{"loop", slit_loops[k]},
                       {"x", invariant(f.disk[at], f.disk_error[at])},
                       {"y", invariant(f.disk[at + 1], f.disk_error[at + 1])},
                       {"radius", invariant(f.disk[at + 2], f.disk_error[at + 2])}});
    report.rows.emplace_back(loop_name("circle", slit_loops[k]),
                             "centre " + disk(at) + ", " + disk(at + 1) + ", radius " + disk(at + 2));
  }
  std::vector<std::string> sizes;
  for (const int n : f.triangles) sizes.push_back(std::to_string(n));
  report.rows.emplace_back("triangles", joined(sizes, ", "));
  report.json["fingerprint"] = {
      {"outer", f.loops[0]},
      {"inner", f.loops[1]},
      {"ring", {{"inner_radius", invariant(f.ring[0], f.ring_error[0])}, {"slits", slits}}},
      {"disk", {{"inner_radius", invariant(f.disk[0], f.disk_error[0])}, {"circles", circles}}},
      {"triangles", f.triangles}};
  return report;
}

} // namespace tetrarch::program
