// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/scene/slit.hpp"

#include "palette.hpp"
#include "tetrarch/format/text.hpp"
#include "vector.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace tetrarch::scene {
namespace {

using mesh::Side;
using mesh::SideEnd;
using Place = std::array<double, 2>;

constexpr double full_turn = 2 * std::numbers::pi;

/// The domain in the plane. The first places are those of the vertices, by their numbers; then come the
/// second places of those on the seam.
struct Chart {
  std::vector<Place> places;
  std::vector<int> vertex;                 ///< of each place
  std::vector<std::array<int, 3>> corners; ///< of each triangle: places

  int place_at(SideEnd e) const { return corners[e.side.triangle()][e.corner()]; }
  int place_from(Side s) const { return corners[s.triangle()][s.next().corner()]; }
  int place_to(Side s) const { return corners[s.triangle()][s.previous().corner()]; }
};

Chart ring(const slit::OneForms& forms, const slit::SlitMap& map) {
  Chart chart;
  const mesh::Surface& surface = forms.mesh().surface;
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const auto z = map.concentric(v);
    chart.places.push_back({z.real(), z.imag()});
    chart.vertex.push_back(v);
  }
  chart.corners = surface.triangles();
  return chart;
}

Chart rectangle(const slit::OneForms& forms, const slit::SlitMap& map) {
  const mesh::Surface& surface = forms.mesh().surface;
  const slit::ParallelDomain domain = slit::parallel_domain(surface, map);
  constexpr int unmet = -100; // whole turns: corners are less than one away from their angle
  std::vector<int> turn_of_first(static_cast<std::size_t>(surface.vertex_count()), unmet);
  std::map<std::pair<int, int>, int> seconds; // by vertex and turn
  Chart chart;
  chart.places.resize(turn_of_first.size());
  for (int v = 0; v < surface.vertex_count(); ++v) chart.vertex.push_back(v);
  for (int t = 0; t < surface.triangle_count(); ++t) {
    chart.corners.push_back(surface.corners(t));
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      // The turn and not the place itself, whose last digits depend on the triangle.
      const auto turn = static_cast<int>(std::lround((domain.corners[t][c][0] - map.angle[v]) / full_turn));
      const Place place{map.angle[v] + turn * full_turn, -map.log_radius[v]};
      if (turn_of_first[v] == unmet) {
        turn_of_first[v] = turn;
        chart.places[v] = place;
      }
      if (turn_of_first[v] == turn) continue;
      const auto [found, is_new] = seconds.try_emplace({v, turn}, static_cast<int>(chart.places.size()));
      chart.corners[t][c] = found->second;
      if (!is_new) continue;
      chart.places.push_back(place);
      chart.vertex.push_back(v);
    }
  }
  return chart;
}

Chart chart_of(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  return domain == SlitDomain::concentric ? ring(forms, map) : rectangle(forms, map);
}

Place texture(const Place& place, const slit::SlitMap& map, SlitDomain domain) {
  if (domain == SlitDomain::concentric) return {(place[0] + 1) / 2, (place[1] + 1) / 2};
  return {place[0] / full_turn, place[1] / map.modulus};
}

/// Each loop as the places one comes by, closed, and cut at the seam.
std::vector<std::vector<int>> paths(const Chart& chart, const mesh::BoundaryLoop& loop) {
  std::vector<std::vector<int>> result;
  for (const SideEnd e : loop.sides) {
    const int here = chart.place_at(e);
    const int there = chart.place_at({e.side, !e.at_start});
    if (result.empty() || result.back().back() != here) result.push_back({here});
    result.back().push_back(there);
  }
  return result;
}

Tubes loop_tubes(const slit::OneForms& forms, const Chart& chart, const std::vector<Point>& points) {
  Tubes tubes;
  tubes.name = "loops";
  Data number{"loop", {}};
  for (int k = 0; k < forms.loop_count(); ++k)
    for (const auto& path : paths(chart, forms.loops()[k])) {
      for (const int place : path) tubes.points.push_back(points[place]);
      tubes.starts.push_back(static_cast<int>(tubes.points.size()));
      tubes.colors.push_back(qualitative(k));
      number.values.push_back(k);
    }
  tubes.radii.assign(tubes.points.size(), size_of(points) / 300);
  tubes.data.push_back(std::move(number));
  return tubes;
}

constexpr Color pale{225, 225, 220};

/// `points` has one for each place of the chart.
Scene scene_of(const slit::OneForms& forms, const Chart& chart, std::vector<Point> points,
               const std::string& title) {
  Scene scene;
  scene.title = title;
  scene.tubes.push_back(loop_tubes(forms, chart, points));
  Surface surface;
  surface.name = title;
  surface.points = std::move(points);
  surface.triangles = chart.corners;
  surface.colors = {pale};
  scene.surfaces.push_back(std::move(surface));
  return scene;
}

} // namespace

Scene slit_domain(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  Chart chart = chart_of(forms, map, domain);
  std::vector<Point> points;
  if (domain == SlitDomain::cylindric) {
    chart.corners = forms.mesh().surface.triangles(); // round again: there is no seam
    for (int v = 0; v < forms.mesh().surface.vertex_count(); ++v) points.push_back(map.cylindric(v));
  } else {
    for (const Place& place : chart.places) points.push_back({place[0], place[1], 0});
  }
  return scene_of(forms, chart, std::move(points), "slit domain");
}

Scene textured_surface(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  const Chart chart = chart_of(forms, map, domain);
  std::vector<Point> points;
  for (const int v : chart.vertex) points.push_back(forms.mesh().points[v]);
  Scene scene = scene_of(forms, chart, std::move(points), "surface");
  for (const Place& place : chart.places)
    scene.surfaces.front().textures.push_back(texture(place, map, domain));
  return scene;
}

std::string textured_obj(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  const Chart chart = chart_of(forms, map, domain);
  std::string out;
  const auto append_line = [&out](const char* keyword, const auto& vector) {
    out += keyword;
    for (const double x : vector) {
      out += ' ';
      format::append_number(out, x);
    }
    out += '\n';
  };
  for (const Point& point : forms.mesh().points) append_line("v", point);
  for (const Place& place : chart.places) append_line("vt", texture(place, map, domain));
  for (const auto& corners : chart.corners) {
    out += 'f';
    for (const int place : corners) {
      out += ' ';
      format::append_number(out, chart.vertex[place] + 1);
      out += '/';
      format::append_number(out, place + 1);
    }
    out += '\n';
  }
  return out;
}

Drawing slit_drawing(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  const Chart chart = chart_of(forms, map, domain);
  const mesh::Surface& surface = forms.mesh().surface;
  const bool is_ring = domain == SlitDomain::concentric;
  Drawing drawing;
  drawing.title = is_ring ? "concentric slit domain" : "parallel slit domain";
  drawing.lower = {0, 0};
  drawing.upper = {0, 0};
  for (const Place& place : chart.places)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      drawing.lower[axis] = std::min(drawing.lower[axis], place[axis]);
      drawing.upper[axis] = std::max(drawing.upper[axis], place[axis]);
    }
  const double margin = 0.02 * (drawing.upper[0] - drawing.lower[0]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    drawing.lower[axis] -= margin;
    drawing.upper[axis] += margin;
  }
  const auto add = [&](const std::vector<int>& path, Color color, double width) {
    Outline outline;
    for (const int place : path) outline.points.push_back(chart.places[place]);
    outline.ink = {{}, color, width};
    drawing.outlines.push_back(std::move(outline));
  };
  // On the seam, an edge is drawn on both banks.
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    const Side m = surface.mate(s);
    const bool drawn = m.exists() && m.value < k && chart.place_from(s) == chart.place_to(m) &&
                       chart.place_to(s) == chart.place_from(m);
    if (!drawn) add({chart.place_from(s), chart.place_to(s)}, {150, 150, 150}, 0.3);
  }
  for (int k = 0; k < forms.loop_count(); ++k)
    for (const auto& path : paths(chart, forms.loops()[k])) add(path, qualitative(k), 3);
  return drawing;
}

} // namespace tetrarch::scene
