// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/slit.hpp"
#include "tetrarch/workshop/text.hpp"

#include <cmath>

namespace tetrarch::workshop {
namespace {

std::string name_of_loop(const char* what, int loop) {
  return std::string(what) + " of loop " + std::to_string(loop);
}

void add_slits(Rows& rows, const ConformalMap::Slits& s) {
  rows.emplace_back("outer, inner loop",
                    std::to_string(s.circles.outer) + ", " + std::to_string(s.circles.inner));
  rows.emplace_back("modulus", fixed(s.modulus, 6) + ", at most " + fixed(s.modulus_bound, 6));
  if (s.on_ring) rows.emplace_back("inner radius", fixed(std::exp(-s.modulus), 6));
  for (const slit::Slit& one : s.slits)
    rows.emplace_back(
        name_of_loop("slit", one.loop),
        (s.on_ring ? "radius " + fixed(one.radius, 6) : "height " + fixed(-std::log(one.radius), 6)) +
            ", angle " + fixed(one.start, 6) + " to " + fixed(one.end, 6));
}

void add_rectangle(Rows& rows, const ConformalMap::Rectangle& r) {
  std::vector<std::string> corners;
  for (const long long number : r.corners) corners.push_back("v" + std::to_string(number));
  rows.emplace_back("outer loop", std::to_string(r.outer) + ", corners " + joined(corners, ", "));
  rows.emplace_back("rectangle", "width 1, height " + fixed(r.height, 6));
  for (const auto& hole : r.holes)
    rows.emplace_back(name_of_loop("hole", hole.loop),
                      "x " + fixed(hole.left, 6) + " to " + fixed(hole.right, 6) + ", y " +
                          fixed(hole.bottom, 6) + " to " + fixed(hole.top, 6));
  rows.emplace_back("residuals",
                    "holonomy " + scientific(r.holonomy, 1) + ", curvatures " + scientific(r.residual, 1));
}

void add_circles(Rows& rows, const ConformalMap::Circles& c) {
  for (std::size_t k = 0; k < c.loops.size(); ++k) {
    const slit::Circle& circle = c.circles[k];
    rows.emplace_back(name_of_loop("circle", c.loops[k]), "centre " + fixed(circle.center.real(), 6) + ", " +
                                                              fixed(circle.center.imag(), 6) + ", radius " +
                                                              fixed(circle.radius, 6));
  }
  rows.emplace_back("circularity", scientific(c.circularity, 1) + " after " + counted(c.rounds, "round"));
}

void add_moves(Rows& rows, const ConformalMap& found) {
  if (found.unflipped)
    rows.emplace_back("unflipped", counted(found.unflipped->moved, "vertex") + " moved, by " +
                                       scientific(found.unflipped->farthest, 1) + " at most");
  if (found.softened)
    rows.emplace_back("slit ends",
                      counted(found.softened->moved, "vertex") + " moved, greatest distortion there " +
                          rounded(found.softened->before) + " to " + rounded(found.softened->after));
}

void add_balance(Rows& rows, const ConformalMap::Balance& b) {
  rows.emplace_back("balanced", "energy " + rounded(b.balanced.before) + " to " + rounded(b.balanced.after) +
                                    " in " + counted(b.balanced.steps, "step"));
  rows.emplace_back("before", "area errors mean " + fixed(b.before.mean_area_error, 4) + ", greatest " +
                                  fixed(b.before.max_area_error, 4) + "; angle errors mean " +
                                  scientific(b.before.mean_angle_error, 1));
}

void add_distortion(Rows& rows, const slit::Distortion& d) {
  rows.emplace_back("angle errors", "mean " + scientific(d.mean_angle_error, 1) + ", greatest " +
                                        scientific(d.max_angle_error, 1));
  rows.emplace_back("quasi-conformal", "mean " + fixed(d.mean_quasi_conformal, 4) + ", greatest " +
                                           fixed(d.max_quasi_conformal, 4));
  rows.emplace_back("area errors",
                    "mean " + fixed(d.mean_area_error, 4) + ", greatest " + fixed(d.max_area_error, 4));
  rows.emplace_back(
      "flipped", d.flipped.empty() ? "none" : counted(static_cast<long long>(d.flipped.size()), "triangle"));
}

void add_residuals(Rows& rows, const slit::Residuals& r) {
  rows.emplace_back("residuals", "periods " + scientific(r.period, 1) + ", fluxes " + scientific(r.flux, 1) +
                                     ", harmonic " + scientific(r.harmonic, 1) + ", radii " +
                                     scientific(r.radius, 1));
}

void add_quad_quality(Rows& rows, const ConformalMap::Quads& q) {
  rows.emplace_back("quads", std::to_string(q.mesh.quads.size()) + ", angle errors mean " +
                                 scientific(q.quality.mean_angle_error, 1) + ", greatest " +
                                 scientific(q.quality.max_angle_error, 1));
}

void add_mended(Rows& rows, const ConformalMap::Mended& m) {
  rows.emplace_back("mended",
                    counted(static_cast<long long>(m.flipped_before), "triangle") + " would be inverted; " +
                        (m.intrinsic ? "solved on the intrinsic Delaunay triangulation, then vertices moved"
                                     : "vertices moved"));
}

/// Of slits that are run through in another way than to and fro.
void remark_turns(std::vector<std::string>& remarks, const ConformalMap::Slits& s) {
  for (const slit::Slit& one : s.slits)
    if (one.turns != 2)
      remarks.push_back("loop " + std::to_string(one.loop) + " turns back " + std::to_string(one.turns) +
                        " times on its slit instead of twice");
}

void remark_search(std::vector<std::string>& remarks, const ConformalMap& found) {
  if (found.circles && !found.circles->found)
    remarks.emplace_back(found.circles->circularity < slit::CircularOptions{}.tolerance
                             ? "the circles are round, but more samples than are allowed would be needed to "
                               "know them as well as that"
                             : "the budget of rounds ended before the circles became round");
  if (found.rectangle && !found.rectangle->found)
    remarks.emplace_back("the rectangle was not found: holes do not close, or triangles beside short loops "
                         "break down (a finer mesh or other --corners may help)");
  if (found.balance && !found.balance->balanced.settled)
    remarks.emplace_back("the energy of the map still fell when its budget of steps ended, or areas are too "
                         "unequal for doubles; it may not be the least");
}

void remark_distortion(std::vector<std::string>& remarks, const slit::Distortion& d) {
  const auto flipped = static_cast<long long>(d.flipped.size());
  if (flipped > 0)
    remarks.push_back(counted(flipped, "triangle") + (flipped == 1 ? " is" : " are") +
                      " inverted or flat, the first is " + std::to_string(d.flipped.front()) +
                      " (counted from 0)");
  if (d.ears > 0)
    remarks.push_back(counted(d.ears, "triangle") + (d.ears == 1 ? " has" : " have") +
                      " all corners on one loop, so the domain has no room for them");
}

} // namespace

std::vector<std::string> ConformalMap::remarks() const {
  std::vector<std::string> remarks;
  if (slits) remark_turns(remarks, *slits);
  remark_search(remarks, *this);
  remark_distortion(remarks, distortion);
  if (crossings.value_or(0) > 0)
    remarks.push_back("the domain overlaps itself: " + counted(*crossings, "pair") +
                      " of its boundary edges cross");
  return remarks;
}

Rows map_rows(const ConformalMap& found) {
  Rows rows;
  if (found.slits) add_slits(rows, *found.slits);
  if (found.rectangle) add_rectangle(rows, *found.rectangle);
  if (found.circles && found.domain == MapDomain::circular) add_circles(rows, *found.circles);
  add_moves(rows, found);
  if (found.balance) add_balance(rows, *found.balance);
  add_distortion(rows, found.distortion);
  if (found.residuals) add_residuals(rows, *found.residuals);
  if (found.quads) add_quad_quality(rows, *found.quads);
  if (found.mended) add_mended(rows, *found.mended);
  return rows;
}

Rows rows_of(const ConformalMap& found) {
  const surface::Surface& surface = found.surface.mesh().surface;
  Rows rows{
      {"surface", surface::type_of(surface).str() + ", " + counted(surface.triangle_count(), "triangle")},
      {"domain", name_of(found.domain)}};
  const Rows more = map_rows(found);
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

} // namespace tetrarch::workshop
