// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/unflip.hpp"

#include "banks.hpp"
#include "drawing.hpp"
#include "full_turn.hpp"
#include "placing.hpp"
#include "tetrarch/slit/quality.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using surface::Surface;
using Complex = std::complex<double>;

std::vector<Complex> differences(const Surface& surface, const std::vector<Complex>& position) {
  std::vector<Complex> along(static_cast<std::size_t>(surface.side_count()));
  for (int k = 0; k < surface.side_count(); ++k)
    along[k] = position[surface.to(Side(k))] - position[surface.from(Side(k))];
  return along;
}

/// Each vertex of a loop stays on the circle of its loop.
Unflipped unflip_between_circles(const surface::TriangleMesh& mesh, const std::vector<int>& loop,
                                 std::vector<Complex>& position, const std::vector<Circle>& circle_of_loop,
                                 std::vector<char> skipped, std::vector<int> judged,
                                 const std::map<int, Complex>& first_moves, const Progress& progress) {
  Drawing drawing(mesh, differences(mesh.surface, position), std::move(skipped), std::move(judged));
  const auto from_center = [&](int v) { return position[v] - circle_of_loop[loop[v]].center; };
  Drawing::Freedom freedom;
  freedom.slides = [&](int v) {
    return loop[v] < 0 ? Complex(0) : Complex(0, 1) * from_center(v) / std::abs(from_center(v));
  };
  freedom.kept = [&](int v, Complex step) {
    if (loop[v] < 0) return step;
    const Complex arm = from_center(v);
    return arm * (std::polar(1.0, (step / arm).imag()) - 1.0);
  };
  return drawing.set_right(
      freedom, [&](int v, Complex step) { position[v] += step; }, first_moves, progress);
}

/// The triangles that are to be set right: all but those skipped, or those that touch a slit.
std::vector<int> judged_triangles(const Surface& surface, const std::vector<char>& skipped,
                                  const std::vector<int>& loop, int outer, int inner, Unflip which) {
  std::vector<int> result;
  const auto is_on_slit = [&](int v) { return loop[v] >= 0 && loop[v] != outer && loop[v] != inner; };
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const auto& v = surface.corners(t);
    if (!skipped[t] &&
        (which == Unflip::everywhere || is_on_slit(v[0]) || is_on_slit(v[1]) || is_on_slit(v[2])))
      result.push_back(t);
  }
  return result;
}

/// Whether any of them is turned over, which decides before anything is set up for its repair.
template <class Image>
bool any_flipped(const std::vector<int>& triangles, const Image& image) {
  return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
    const numeric::FlatTriangle p = image(t);
    const double size = std::max(std::abs(p[1] - p[0]), std::abs(p[2] - p[0]));
    return !(numeric::cross((p[1] - p[0]) / size, (p[2] - p[0]) / size) > 0);
  });
}

} // namespace

Unflipped unflip_on_cylinder(const OneForms& forms, SlitMap& map, Unflip which, const Progress& progress) {
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), forms.mesh().surface);
  std::vector<char> skipped = ears(forms);
  std::vector<int> judged =
      judged_triangles(forms.mesh().surface, skipped, loop, map.outer, map.inner, which);
  const auto image = [&](int t) {
    const auto value = [&](Side s) { return Complex(map.form.real[s.value], map.form.imaginary[s.value]); };
    return numeric::FlatTriangle{0.0, value(Side(t, 2)), -value(Side(t, 1))};
  };
  if (which == Unflip::at_slits && !any_flipped(judged, image)) return {};
  std::map<int, Complex> ordered;
  for (const auto& [v, shift] : shifts_into_order(forms, map)) ordered[v] = {0, shift};
  std::vector<Complex> along(map.form.real.size());
  for (std::size_t s = 0; s < along.size(); ++s) along[s] = {map.form.real[s], map.form.imaginary[s]};
  Drawing drawing(forms.mesh(), std::move(along), std::move(skipped), std::move(judged));
  Drawing::Freedom freedom;
  freedom.slides = [&](int v) { return loop[v] < 0 ? Complex(0) : Complex(0, 1); };
  freedom.kept = [](int, Complex step) { return step; };
  const Unflipped result = drawing.set_right(
      freedom,
      [&](int v, Complex step) {
        map.log_radius[v] += step.real();
        map.angle[v] = wrapped(map.angle[v] + step.imag());
      },
      ordered, progress);
  for (std::size_t s = 0; s < drawing.along().size(); ++s) {
    map.form.real[s] = drawing.along()[s].real();
    map.form.imaginary[s] = drawing.along()[s].imag();
  }
  return result;
}

Unflipped unflip_on_ring(const OneForms& forms, SlitMap& map, Unflip which, const Progress& progress) {
  const Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  std::vector<char> skipped = ears(forms);
  std::vector<int> judged = judged_triangles(surface, skipped, loop, map.outer, map.inner, which);
  const auto image = [&](int t) {
    const auto& v = surface.corners(t);
    return numeric::FlatTriangle{map.concentric(v[0]), map.concentric(v[1]), map.concentric(v[2])};
  };
  if (which == Unflip::at_slits && !any_flipped(judged, image)) return {};
  std::vector<Complex> position;
  position.reserve(forms.mesh().points.size());
  for (int v = 0; v < surface.vertex_count(); ++v) position.push_back(map.concentric(v));
  std::map<int, Complex> ordered;
  for (const auto& [v, shift] : shifts_into_order(forms, map))
    ordered[v] = position[v] * (std::polar(1.0, shift) - 1.0);
  const std::vector<Circle> about_origin(forms.loops().size(), Circle{0, 1, 0});
  const std::vector<Complex> before = position;
  const Unflipped result = unflip_between_circles(forms.mesh(), loop, position, about_origin,
                                                  std::move(skipped), std::move(judged), ordered, progress);
  move_on_ring(forms, map, before, position);
  return result;
}

Unflipped unflip_in_disk(const surface::TriangleMesh& mesh, CircularMap& map, Unflip which,
                         const Progress& progress) {
  const auto loops = surface::boundary_loops(mesh);
  std::vector<Circle> circle(loops.size());
  for (std::size_t k = 0; k < map.loop.size(); ++k) circle[map.loop[k]] = map.domain.circles[k];
  const std::vector<int> loop = surface::loops_of_vertices(loops, mesh.surface);
  const int inner = map.loop.size() > 1 ? map.loop[1] : map.loop[0];
  std::vector<char> skipped = ears_in_disk(mesh, map);
  std::vector<int> judged = judged_triangles(mesh.surface, skipped, loop, map.loop[0], inner, which);
  const auto image = [&](int t) {
    const auto& v = mesh.surface.corners(t);
    return numeric::FlatTriangle{map.position[v[0]], map.position[v[1]], map.position[v[2]]};
  };
  if (which == Unflip::at_slits && !any_flipped(judged, image)) return {};
  return unflip_between_circles(mesh, loop, map.position, circle, std::move(skipped), std::move(judged), {},
                                progress);
}

} // namespace tetrarch::slit
