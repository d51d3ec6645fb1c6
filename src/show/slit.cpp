// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/slit.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/palette.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

namespace tetrarch::show {

using namespace scene;

namespace {

using surface::Side;
using surface::SideEnd;
using Place = std::array<double, 2>;

constexpr double full_turn = 2 * std::numbers::pi;

int place_at(const Layout& layout, SideEnd e) {
  return layout.corners[e.side.triangle()][e.corner()];
}
int place_from(const Layout& layout, Side s) {
  return place_at(layout, {s, true});
}
int place_to(const Layout& layout, Side s) {
  return place_at(layout, {s, false});
}

/// Gives the corners of triangles places: the first one that a vertex gets is its own, others follow after
/// all vertices, one for each shift.
class Placer {
public:
  explicit Placer(const surface::Surface& surface) : surface_(surface) {
    const auto vertices = static_cast<std::size_t>(surface.vertex_count());
    layout_.places.resize(vertices);
    layout_.corners = surface.triangles();
    for (int v = 0; v < surface.vertex_count(); ++v) layout_.vertex.push_back(v);
    shift_of_first_.resize(vertices);
    is_met_.resize(vertices, 0);
  }

  /// Places with equal shifts are equal but for rounding.
  void put(int triangle, int corner, const Place& place, long long shift) {
    const int v = surface_.corners(triangle)[corner];
    if (!std::exchange(is_met_[v], 1)) {
      shift_of_first_[v] = shift;
      layout_.places[v] = place;
    }
    if (shift_of_first_[v] == shift) return;
    const auto [found, is_new] = seconds_.try_emplace({v, shift}, static_cast<int>(layout_.places.size()));
    layout_.corners[triangle][corner] = found->second;
    if (!is_new) return;
    layout_.places.push_back(place);
    layout_.vertex.push_back(v);
  }

  Layout take() { return std::move(layout_); }

private:
  const surface::Surface& surface_;
  Layout layout_;
  std::vector<long long> shift_of_first_;
  std::vector<char> is_met_;
  std::map<std::pair<int, long long>, int> seconds_; // by vertex and shift
};

Layout rectangle(const slit::OneForms& forms, const slit::SlitMap& map) {
  const surface::Surface& surface = forms.mesh().surface;
  const slit::ParallelDomain domain = slit::parallel_domain(surface, map);
  Placer placer(surface);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      // The turn and not the place itself, whose last digits depend on the triangle.
      const long long turn = std::llround((domain.corners[t][c][0] - map.angle[v]) / full_turn);
      const double angle = map.angle[v] + static_cast<double>(turn) * full_turn;
      placer.put(t, c, {angle, -map.log_radius[v]}, turn);
    }
  Layout result = placer.take();
  result.name = "parallel slit domain";
  for (const Place& place : result.places)
    result.textures.push_back({place[0] / full_turn, place[1] / full_turn});
  result.texture_scale = 1 / full_turn;
  return result;
}

/// Each loop as the places one comes by, closed, and cut at the seam.
std::vector<std::vector<int>> paths(const Layout& layout, const surface::BoundaryLoop& loop) {
  std::vector<std::vector<int>> result;
  for (const SideEnd e : loop.sides) {
    const int here = place_at(layout, e);
    const int there = place_at(layout, {e.side, !e.at_start});
    if (result.empty() || result.back().back() != here) result.push_back({here});
    result.back().push_back(there);
  }
  return result;
}

Tubes loop_tubes(const surface::TriangleMesh& mesh, const Layout& layout, const std::vector<Point>& points) {
  Tubes tubes;
  tubes.name = "loops";
  Data number{"loop", {}};
  for (const surface::BoundaryLoop& loop : surface::boundary_loops(mesh)) {
    const int index = number.values.empty() ? 0 : number.values.back() + 1;
    for (const auto& path : paths(layout, loop)) {
      for (const int place : path) tubes.points.push_back(points[place]);
      tubes.starts.push_back(static_cast<int>(tubes.points.size()));
      tubes.colors.push_back(qualitative(index));
      number.values.push_back(index);
    }
  }
  tubes.radii.assign(tubes.points.size(), numeric::extent(points) / 300);
  tubes.data.push_back(std::move(number));
  return tubes;
}

/// `points` has one for each place.
Scene scene_of(const surface::TriangleMesh& mesh, const Layout& layout, std::vector<Point> points,
               const std::string& title) {
  constexpr Color pale{225, 225, 220};
  Scene scene;
  scene.title = title;
  scene.tubes.push_back(loop_tubes(mesh, layout, points));
  Surface surface;
  surface.name = title;
  surface.points = std::move(points);
  surface.textures = layout.textures;
  surface.triangles = layout.corners;
  surface.colors = {pale};
  scene.surfaces.push_back(std::move(surface));
  return scene;
}

} // namespace

Layout layout(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain) {
  if (domain != SlitDomain::concentric) {
    Layout result = rectangle(forms, map);
    if (domain == SlitDomain::parallel) return result;
    result.name = "cylindric slit domain";
    for (const auto& [angle, height] : result.places)
      result.rolled.push_back({std::cos(angle), std::sin(angle), height});
    return result;
  }
  std::vector<std::complex<double>> position;
  position.reserve(forms.mesh().points.size());
  for (int v = 0; v < forms.mesh().surface.vertex_count(); ++v) position.push_back(map.concentric(v));
  Layout result = disk_layout(forms.mesh(), position);
  result.name = "concentric slit domain";
  return result;
}

Layout basis_layout(const slit::OneForms& forms, int loop) {
  const surface::Surface& surface = forms.mesh().surface;
  const slit::HolomorphicOneForm form = slit::holomorphic_one_form(forms, loop);
  std::vector<double> lag(static_cast<std::size_t>(surface.vertex_count()), 0.0);
  for (int i = 1; i < forms.loop_count(); ++i)
    for (std::size_t v = 0; v < lag.size(); ++v) lag[v] += forms.flux(i, loop) * forms.lag(i)[v];
  Placer placer(surface);
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const auto& v = surface.corners(t);
    const double first = lag[v[0]];
    const std::array along{first, first + form.imaginary[Side(t, 2).value],
                           first - form.imaginary[Side(t, 1).value]};
    constexpr double resolution = 1e-6;
    for (int c = 0; c < 3; ++c)
      placer.put(t, c, {forms.potential(loop)[v[c]], along[c]},
                 std::llround((along[c] - lag[v[c]]) / resolution));
  }
  Layout result = placer.take();
  result.name = "holomorphic one-form of loop " + std::to_string(loop);
  result.textures = result.places;
  return result;
}

namespace {

/// Of a disk, one vertex goes to 0 itself.
bool is_ring(const surface::TriangleMesh& mesh) {
  return surface::boundary_loops(mesh).size() > 1;
}

} // namespace

Layout disk_layout(const surface::TriangleMesh& mesh, const std::vector<std::complex<double>>& position) {
  Layout result;
  result.name = "circular domain";
  double nearest = 1;
  for (const std::complex<double>& z : position) nearest = std::min(nearest, std::abs(z));
  // 1/2 + z/2 has no digits for what is nearer to 0.
  constexpr double too_near = 1e-6;
  result.texture_scale = 0.5;
  result.texture_shift = nearest < too_near && position.size() > 1 && is_ring(mesh) ? 0 : 0.5;
  for (const std::complex<double>& z : position) {
    result.vertex.push_back(static_cast<int>(result.vertex.size()));
    result.places.push_back({z.real(), z.imag()});
    result.textures.push_back({z.real() / 2 + result.texture_shift, z.imag() / 2 + result.texture_shift});
  }
  result.corners = mesh.surface.triangles();
  return result;
}

Layout plane_layout(const surface::TriangleMesh& mesh, const std::vector<std::complex<double>>& position,
                    const std::string& name) {
  Layout result;
  result.name = name;
  double left = INFINITY;
  double low = INFINITY;
  double size = 0;
  for (const std::complex<double>& z : position) {
    left = std::min(left, z.real());
    low = std::min(low, z.imag());
  }
  for (const std::complex<double>& z : position) size = std::max({size, z.real() - left, z.imag() - low});
  result.texture_scale = 1 / size;
  for (const std::complex<double>& z : position) {
    result.vertex.push_back(static_cast<int>(result.vertex.size()));
    result.places.push_back({z.real() - left, z.imag() - low});
    result.textures.push_back({result.places.back()[0] / size, result.places.back()[1] / size});
  }
  result.corners = mesh.surface.triangles();
  return result;
}

Scene slit_domain(const surface::TriangleMesh& mesh, const Layout& layout) {
  std::vector<Point> points = layout.rolled;
  if (points.empty())
    for (const Place& place : layout.places) points.push_back({place[0], place[1], 0});
  return scene_of(mesh, layout, std::move(points), layout.name);
}

Scene textured_surface(const surface::TriangleMesh& mesh, const Layout& layout, const Fields& fields) {
  std::vector<Point> points;
  for (const int v : layout.vertex) points.push_back(mesh.points[v]);
  Scene scene = scene_of(mesh, layout, std::move(points), "surface");
  scene.surfaces.front().cell_fields = fields.triangles;
  for (const Field& field : fields.vertices) {
    Field& here = scene.surfaces.front().point_fields.emplace_back(Field{field.name, {}});
    for (const int v : layout.vertex) here.values.push_back(field.values[v]);
  }
  return scene;
}

std::string textured_obj(const surface::TriangleMesh& mesh, const Layout& layout) {
  std::string out;
  const auto append_line = [&out](const char* keyword, const auto& vector) {
    out += keyword;
    for (const double x : vector) {
      out += ' ';
      format::append_number(out, x);
    }
    out += '\n';
  };
  for (const Point& point : mesh.points) append_line("v", point);
  for (const Place& texture : layout.textures) append_line("vt", texture);
  for (const auto& corners : layout.corners) {
    out += 'f';
    for (const int place : corners) {
      out += ' ';
      format::append_number(out, layout.vertex[place] + 1);
      out += '/';
      format::append_number(out, place + 1);
    }
    out += '\n';
  }
  return out;
}

Drawing slit_drawing(const surface::TriangleMesh& mesh, const Layout& layout) {
  const surface::Surface& surface = mesh.surface;
  Drawing drawing;
  drawing.title = layout.name;
  drawing.lower = {0, 0};
  drawing.upper = {0, 0};
  for (const Place& place : layout.places)
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
    for (const int place : path) outline.points.push_back(layout.places[place]);
    outline.ink = {{}, color, width};
    drawing.outlines.push_back(std::move(outline));
  };
  // On the seam, an edge is drawn on both banks.
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    const Side m = surface.mate(s);
    const bool drawn = m.exists() && m.value < k && place_from(layout, s) == place_to(layout, m) &&
                       place_to(layout, s) == place_from(layout, m);
    if (!drawn) add({place_from(layout, s), place_to(layout, s)}, {150, 150, 150}, 0.3);
  }
  int number = 0;
  for (const surface::BoundaryLoop& loop : surface::boundary_loops(mesh)) {
    for (const auto& path : paths(layout, loop)) add(path, qualitative(number), 3);
    ++number;
  }
  return drawing;
}

} // namespace tetrarch::show
