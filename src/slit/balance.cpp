// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/balance.hpp"
#include "tetrarch/core/error.hpp"

#include "placing.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/unfold/relax.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using surface::Surface;
using Complex = std::complex<double>;
using numeric::FlatTriangle;
using unfold::FlatFreedom;
using Kind = FlatFreedom::Kind;

/// Triangles to be relaxed, with what is held because of those that are not.
struct Task {
  std::vector<unfold::FlatElement> elements;
  std::vector<FlatFreedom> freedom;
  int left_out = 0;
};

/// `image(t)` places the corners of a triangle.
template <class Image>
Task task(const surface::TriangleMesh& mesh, const std::vector<char>& ears, std::vector<FlatFreedom> freedom,
          const Image& image) {
  Task result{{}, std::move(freedom), 0};
  double area = 0;
  double area_of_image = 0;
  for (int t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto& corner = mesh.surface.corners(t);
    const FlatTriangle p = numeric::laid_flat(mesh.points, corner);
    const FlatTriangle q = image(t);
    // By rounding some are neither turned over nor good for anything.
    if (ears[t] || !(numeric::ratio_of_axes(p, q) > 0)) {
      ++result.left_out;
      for (const int v : corner) result.freedom[v].kind = Kind::fixed;
      continue;
    }
    const double weight = numeric::twice_area(p);
    result.elements.push_back(
        {{corner[0], corner[1], corner[2]}, {p[1] - p[0], p[2] - p[0]}, {q[1] - q[0], q[2] - q[0]}, weight});
    area += weight;
    area_of_image += numeric::twice_area(q);
  }
  const double scale = std::sqrt(area_of_image / area);
  for (unfold::FlatElement& e : result.elements)
    for (Complex& edge : e.wanted) edge *= scale;
  const auto kept = std::remove_if(result.elements.begin(), result.elements.end(), [&](const auto& e) {
    if (unfold::is_counterclockwise(e)) return false;
    ++result.left_out; // by rounding again
    for (const int v : e.corner) result.freedom[v].kind = Kind::fixed;
    return true;
  });
  result.elements.erase(kept, result.elements.end());
  return result;
}

/// Runs it. `shift` is that of each vertex.
Balanced run(Task task, std::vector<Complex>& shift, const Progress& progress) {
  unfold::Relaxed done = unfold::relaxed(std::move(task.elements), std::move(task.freedom), {}, progress);
  shift = std::move(done.shift);
  return {done.before, done.after, done.steps, done.settled, task.left_out};
}

/// Holds the vertices at the ends of slits, where the domain would change; without slits, one vertex, as the
/// domain may be turned.
void hold_ends(const OneForms& forms, const SlitMap& map, std::vector<FlatFreedom>& freedom) {
  const Surface& surface = forms.mesh().surface;
  for (const Slit& slit : map.slits) {
    const auto& sides = forms.loops()[slit.loop].sides;
    std::vector<double> at{0.0};
    for (const surface::SideEnd e : sides) at.push_back(at.back() + map.form.imaginary[e.side.value]);
    at.pop_back();
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    for (const auto end : {low, high}) freedom[surface.vertex(sides[end - at.begin()])].kind = Kind::fixed;
  }
  if (map.slits.empty()) freedom[surface.vertex(forms.loops()[map.outer].sides.front())].kind = Kind::fixed;
}

/// Pairs of edges of the boundary that cross, by a sweep over the real axis.
int crossings(const surface::TriangleMesh& mesh, const std::vector<Complex>& position) {
  struct Edge {
    int from;
    int to;
    double left;
    double right;
  };
  std::vector<Edge> edges;
  for (int k = 0; k < mesh.surface.side_count(); ++k) {
    if (!mesh.surface.is_boundary(Side(k))) continue;
    const int v = mesh.surface.from(Side(k));
    const int u = mesh.surface.to(Side(k));
    const double a = position[v].real();
    const double b = position[u].real();
    edges.push_back({v, u, std::min(a, b), std::max(a, b)});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
  const auto side = [&](const Edge& e, int v) {
    return numeric::cross(position[e.to] - position[e.from], position[v] - position[e.from]);
  };
  int result = 0;
  std::vector<Edge> active;
  for (const Edge& e : edges) {
    active.erase(
        std::remove_if(active.begin(), active.end(), [&](const Edge& a) { return a.right < e.left; }),
        active.end());
    for (const Edge& a : active) {
      if (a.from == e.from || a.from == e.to || a.to == e.from || a.to == e.to) continue;
      if (side(a, e.from) * side(a, e.to) < 0 && side(e, a.from) * side(e, a.to) < 0) ++result;
    }
    active.push_back(e);
  }
  return result;
}

/// A corner that is in one triangle alone goes to where that triangle is similar to what it is in space:
/// round holes turn such triangles over.
void set_tips_right(const surface::TriangleMesh& mesh, std::vector<Complex>& position) {
  const Surface& surface = mesh.surface;
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const Side before = Side(t, static_cast<int>((c + 1) % 3));
      const Side after = Side(t, static_cast<int>((c + 2) % 3));
      if (!surface.is_boundary(before) || !surface.is_boundary(after)) continue;
      const FlatTriangle p = numeric::laid_flat(mesh.points, surface.corners(t));
      const Complex from = position[surface.corners(t)[(c + 1) % 3]];
      const Complex to = position[surface.corners(t)[(c + 2) % 3]];
      position[surface.corners(t)[c]] =
          from + (to - from) * (p[c] - p[(c + 1) % 3]) / (p[(c + 2) % 3] - p[(c + 1) % 3]);
    }
}

} // namespace

Balanced balance_on_cylinder(const OneForms& forms, SlitMap& map, const Progress& progress) {
  const Surface& surface = forms.mesh().surface;
  std::vector<FlatFreedom> freedom(static_cast<std::size_t>(surface.vertex_count()));
  for (const surface::BoundaryLoop& loop : forms.loops())
    for (const surface::SideEnd e : loop.sides) freedom[surface.vertex(e)] = {Kind::line, Complex(0, 1)};
  hold_ends(forms, map, freedom);
  const auto image = [&](int t) {
    const auto value = [&](Side s) { return Complex(map.form.real[s.value], map.form.imaginary[s.value]); };
    return FlatTriangle{0.0, value(Side(t, 2)), -value(Side(t, 1))};
  };
  std::vector<Complex> shift;
  const Balanced result = run(task(forms.mesh(), ears(forms), std::move(freedom), image), shift, progress);
  shift_on_cylinder(surface, map, shift);
  return result;
}

Balanced balance_on_ring(const OneForms& forms, SlitMap& map, const Progress& progress) {
  const Surface& surface = forms.mesh().surface;
  std::vector<Complex> before;
  before.reserve(forms.mesh().points.size());
  for (int v = 0; v < surface.vertex_count(); ++v) before.push_back(map.concentric(v));
  std::vector<FlatFreedom> freedom(before.size());
  for (const surface::BoundaryLoop& loop : forms.loops())
    for (const surface::SideEnd e : loop.sides) {
      const int v = surface.vertex(e);
      freedom[v] = {Kind::circle, before[v]};
    }
  hold_ends(forms, map, freedom);
  const auto image = [&](int t) {
    const auto& v = surface.corners(t);
    return FlatTriangle{before[v[0]], before[v[1]], before[v[2]]};
  };
  std::vector<Complex> now;
  const Balanced result = run(task(forms.mesh(), ears(forms), std::move(freedom), image), now, progress);
  for (std::size_t v = 0; v < now.size(); ++v) now[v] += before[v];
  move_on_ring(forms, map, before, now);
  return result;
}

Balanced balance_in_disk(const surface::TriangleMesh& mesh, CircularMap& map, const Progress& progress) {
  const auto loops = surface::boundary_loops(mesh);
  std::vector<FlatFreedom> freedom(map.position.size());
  for (std::size_t k = 0; k < map.loop.size(); ++k)
    for (const surface::SideEnd e : loops[map.loop[k]].sides) {
      const int v = mesh.surface.vertex(e);
      freedom[v] = {Kind::circle, map.position[v] - map.domain.circles[k].center};
    }
  // Circles about 0 leave the whole free to turn.
  if (map.loop.size() <= 2) freedom[mesh.surface.vertex(loops[map.loop[0]].sides.front())].kind = Kind::fixed;
  const auto image = [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return FlatTriangle{map.position[v[0]], map.position[v[1]], map.position[v[2]]};
  };
  std::vector<Complex> shift;
  const Balanced result =
      run(task(mesh, ears_in_disk(mesh, map), std::move(freedom), image), shift, progress);
  for (std::size_t v = 0; v < shift.size(); ++v) map.position[v] += shift[v];
  return result;
}

FreeMap free_map(const surface::TriangleMesh& mesh, const std::vector<Complex>& start,
                 const Progress& progress) {
  FreeMap result;
  result.position = start;
  set_tips_right(mesh, result.position);
  std::vector<FlatFreedom> freedom(start.size());
  freedom.front().kind = Kind::fixed; // the whole may be moved
  double area = 0;
  double area_of_image = 0;
  for (const auto& v : mesh.surface.triangles()) {
    area += numeric::twice_area(numeric::laid_flat(mesh.points, v));
    area_of_image +=
        std::abs(numeric::twice_area({result.position[v[0]], result.position[v[1]], result.position[v[2]]}));
  }
  const double growth = std::sqrt(area / area_of_image);
  if (!(std::isfinite(growth) && growth > 0))
    throw InputError(
        "areas of the surface are beyond doubles, which a map in its unit needs: choose another unit");
  for (Complex& z : result.position) z *= growth;
  const auto image = [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return FlatTriangle{result.position[v[0]], result.position[v[1]], result.position[v[2]]};
  };
  std::vector<Complex> shift;
  const std::vector<char> none(static_cast<std::size_t>(mesh.surface.triangle_count()), 0);
  result.balanced = run(task(mesh, none, std::move(freedom), image), shift, progress);
  for (std::size_t v = 0; v < shift.size(); ++v) result.position[v] += shift[v];
  result.crossings = crossings(mesh, result.position);
  return result;
}

} // namespace tetrarch::slit
