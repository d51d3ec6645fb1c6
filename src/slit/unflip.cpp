// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/unflip.hpp"

#include "banks.hpp"
#include "full_turn.hpp"
#include "tetrarch/slit/quality.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace tetrarch::slit {
namespace {

using mesh::Side;
using mesh::Surface;
using Complex = std::complex<double>;

constexpr int most_sweeps = 100;
/// A triangle this much narrower than in space counts as flipped.
constexpr double flat = 1e-3;

/// What a vertex must stay to the left of: its distance from a side, `now`, grows by Re(conj(normal) step).
struct Wall {
  double now = 0;
  Complex normal;
};

double least(const std::vector<Wall>& walls, Complex step) {
  double result = INFINITY;
  for (const Wall& w : walls) result = std::min(result, w.now + (std::conj(w.normal) * step).real());
  return result;
}

/// The step along `direction` to the highest value of `least`: where two walls, or one and none, meet.
Complex best_along(const std::vector<Wall>& walls, Complex direction) {
  Complex best = 0;
  double value = least(walls, 0);
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double slope = (std::conj(walls[i].normal - walls[j].normal) * direction).real();
      const Complex step = direction * ((walls[j].now - walls[i].now) / slope);
      if (const double there = least(walls, step); std::isfinite(std::abs(step)) && there > value) {
        value = there;
        best = step;
      }
    }
  return best;
}

/// The step to the highest value of `least`: where three walls are equally far. O(k^4) for k walls.
Complex best_anywhere(const std::vector<Wall>& walls) {
  Complex best = 0;
  double value = least(walls, 0);
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Complex a = walls[j].normal - walls[i].normal;
        const Complex b = walls[k].normal - walls[i].normal;
        const double right_a = walls[i].now - walls[j].now;
        const double right_b = walls[i].now - walls[k].now;
        const Complex step = Complex(0, 1) * (right_b * a - right_a * b) / numeric::cross(a, b);
        if (!std::isfinite(std::abs(step))) continue;
        if (const double there = least(walls, step); there > value) {
          value = there;
          best = step;
        }
      }
  return best;
}

/// The altitude on the longest side, in units of that side.
double width(const numeric::FlatTriangle& p) {
  return numeric::twice_area(p) / numeric::longest_squared(p);
}

/// A drawing by the differences along its sides, so that it may lie on a cylinder.
class Drawing {
public:
  /// `slides(v)`: the direction in which a vertex may move, 0 for any; `kept(v, step)`: the step that keeps
  /// it on its curve.
  struct Freedom {
    std::function<Complex(int)> slides;
    std::function<Complex(int, Complex)> kept;
  };

  Drawing(const mesh::TriangleMesh& mesh, std::vector<Complex> along, std::vector<char> skipped)
      : surface_(mesh.surface), along_(std::move(along)), skipped_(std::move(skipped)),
        some_end_(static_cast<std::size_t>(surface_.vertex_count())) {
    for (int t = 0; t < surface_.triangle_count(); ++t)
      width_.push_back(width(numeric::laid_flat(mesh.points, surface_.corners(t))));
    for (int k = 0; k < surface_.side_count(); ++k) some_end_[surface_.from(Side(k))] = {Side(k), true};
  }

  /// `moved` is told of each step of a vertex; `total` has what was moved before.
  Unflipped set_right(const Freedom& freedom, const std::function<void(int, Complex)>& moved,
                      std::map<int, Complex> total = {}) {
    std::vector<int> wrong = flipped_among_all();
    for (int sweep = 0; sweep < most_sweeps && !wrong.empty(); ++sweep) {
      for (const int v : around(wrong, sweep / 20)) {
        const Complex step = improve(v, freedom);
        if (step == 0.0) continue;
        total[v] += step;
        moved(v, step);
      }
      // Triangles only turn over beside vertices that moved, and those only raise the least distance.
      wrong.erase(std::remove_if(wrong.begin(), wrong.end(), [&](int t) { return !is_flipped(t); }),
                  wrong.end());
      if (wrong.empty()) wrong = flipped_among_all();
    }
    Unflipped result;
    result.left = static_cast<int>(wrong.size());
    for (const auto& [v, step] : total) {
      ++result.moved;
      result.farthest = std::max(result.farthest, std::abs(step));
    }
    return result;
  }

  const std::vector<Complex>& along() const { return along_; }

private:
  /// Or nearly flat, against its shape in space.
  bool is_flipped(int t) const {
    if (skipped_[t]) return false;
    double longest = 0;
    for (const Side s : mesh::sides_of(t)) longest = std::max(longest, std::norm(along_[s.value]));
    const double twice_area = numeric::cross(along_[Side(t, 2).value], -along_[Side(t, 1).value]);
    return !(twice_area > flat * width_[t] * longest);
  }

  std::vector<int> flipped_among_all() const {
    std::vector<int> result;
    for (int t = 0; t < surface_.triangle_count(); ++t)
      if (is_flipped(t)) result.push_back(t);
    return result;
  }

  /// The vertices of triangles and so many rings around, each once, in the order in which they are met.
  std::vector<int> around(const std::vector<int>& triangles, int rings) const {
    std::vector<int> result;
    std::map<int, bool> seen;
    const auto add = [&](int t) {
      for (const int v : surface_.corners(t))
        if (seen.emplace(v, true).second) result.push_back(v);
    };
    for (const int t : triangles) add(t);
    for (std::size_t done = 0; rings > 0; --rings) {
      const std::size_t until = result.size();
      for (; done < until; ++done)
        for (const mesh::SideEnd e : mesh::fan(surface_, some_end_[result[done]])) add(e.side.triangle());
    }
    return result;
  }

  std::vector<Wall> walls(int v) const {
    std::vector<Wall> result;
    for (const mesh::SideEnd e : mesh::fan(surface_, some_end_[v])) {
      const int t = e.side.triangle();
      if (skipped_[t]) continue;
      const Side opposite(t, e.corner());
      const Complex edge = along_[opposite.value];
      if (edge == 0.0) continue;
      const Complex direction = edge / std::abs(edge);
      result.push_back(
          {numeric::cross(direction, -along_[opposite.previous().value]), Complex(0, 1) * direction});
    }
    return result;
  }

  Complex improve(int v, const Freedom& freedom) {
    const std::vector<Wall> limits = walls(v);
    const Complex direction = freedom.slides(v);
    Complex step = direction == 0.0 ? best_anywhere(limits) : best_along(limits, direction);
    const double before = least(limits, 0);
    // On a circle the straight step is too long at worst.
    constexpr int most_halvings = 20;
    for (int k = 0; k < most_halvings && step != 0.0; ++k, step /= 2) {
      const Complex kept = freedom.kept(v, step);
      if (!(least(limits, kept) > before)) continue;
      move(v, kept);
      return kept;
    }
    return 0;
  }

  void move(int v, Complex step) {
    for (const mesh::SideEnd e : mesh::fan(surface_, some_end_[v])) {
      const Side opposite(e.side.triangle(), e.corner());
      along_[opposite.next().value] += step;     // ends at v
      along_[opposite.previous().value] -= step; // starts there
    }
  }

  const Surface& surface_;
  std::vector<Complex> along_;
  std::vector<char> skipped_;
  std::vector<double> width_; ///< of each triangle in space
  std::vector<mesh::SideEnd> some_end_;
};

std::vector<Complex> differences(const Surface& surface, const std::vector<Complex>& position) {
  std::vector<Complex> along(static_cast<std::size_t>(surface.side_count()));
  for (int k = 0; k < surface.side_count(); ++k)
    along[k] = position[surface.to(Side(k))] - position[surface.from(Side(k))];
  return along;
}

/// Each vertex of a loop stays on the circle of its loop.
Unflipped unflip_between_circles(const mesh::TriangleMesh& mesh, const std::vector<int>& loop,
                                 std::vector<Complex>& position, const std::vector<Circle>& circle_of_loop,
                                 std::vector<char> skipped, std::map<int, Complex> before = {}) {
  Drawing drawing(mesh, differences(mesh.surface, position), std::move(skipped));
  const auto from_center = [&](int v) { return position[v] - circle_of_loop[loop[v]].center; };
  Drawing::Freedom freedom;
  freedom.slides = [&](int v) {
    return loop[v] < 0 ? Complex(0) : Complex(0, 1) * from_center(v) / std::abs(from_center(v));
  };
  freedom.kept = [&](int v, Complex step) {
    if (loop[v] < 0) return step;
    const Complex arm = from_center(v);
    return arm * std::polar(1.0, numeric::cross(arm, step) / std::norm(arm)) - arm;
  };
  return drawing.set_right(
      freedom, [&](int v, Complex step) { position[v] += step; }, std::move(before));
}

/// Puts the loops on their slits in order; what was moved.
std::map<int, Complex> order_slits(const OneForms& forms, SlitMap& map) {
  const std::map<int, double> shifts = shifts_into_order(forms, map);
  std::map<int, Complex> moved;
  for (const auto& [v, shift] : shifts) {
    map.angle[v] = wrapped(map.angle[v] + shift);
    moved[v] = {0, shift};
  }
  const Surface& surface = forms.mesh().surface;
  const auto shift_at = [&](int v) {
    const auto found = shifts.find(v);
    return found == shifts.end() ? 0.0 : found->second;
  };
  if (!shifts.empty())
    for (int k = 0; k < surface.side_count(); ++k)
      map.form.imaginary[k] += shift_at(surface.to(Side(k))) - shift_at(surface.from(Side(k)));
  return moved;
}

} // namespace

Unflipped unflip_on_cylinder(const OneForms& forms, SlitMap& map) {
  const std::vector<int> loop = mesh::loops_of_vertices(forms.loops(), forms.mesh().surface);
  std::map<int, Complex> ordered = order_slits(forms, map);
  std::vector<Complex> along(map.form.real.size());
  for (std::size_t s = 0; s < along.size(); ++s) along[s] = {map.form.real[s], map.form.imaginary[s]};
  Drawing drawing(forms.mesh(), std::move(along), ears(forms));
  Drawing::Freedom freedom;
  freedom.slides = [&](int v) { return loop[v] < 0 ? Complex(0) : Complex(0, 1); };
  freedom.kept = [](int, Complex step) { return step; };
  const Unflipped result = drawing.set_right(
      freedom,
      [&](int v, Complex step) {
        map.log_radius[v] += step.real();
        map.angle[v] = wrapped(map.angle[v] + step.imag());
      },
      std::move(ordered));
  for (std::size_t s = 0; s < drawing.along().size(); ++s) {
    map.form.real[s] = drawing.along()[s].real();
    map.form.imaginary[s] = drawing.along()[s].imag();
  }
  return result;
}

Unflipped unflip_on_ring(const OneForms& forms, SlitMap& map) {
  std::map<int, Complex> ordered = order_slits(forms, map);
  std::vector<Complex> position;
  position.reserve(forms.mesh().points.size());
  for (int v = 0; v < forms.mesh().surface.vertex_count(); ++v) position.push_back(map.concentric(v));
  for (auto& [v, step] : ordered) step = position[v] * (1.0 - std::polar(1.0, -step.imag()));
  const std::vector<Circle> about_origin(forms.loops().size(), Circle{0, 1, 0});
  const std::vector<Complex> before = position;
  const Unflipped result =
      unflip_between_circles(forms.mesh(), mesh::loops_of_vertices(forms.loops(), forms.mesh().surface),
                             position, about_origin, ears(forms), std::move(ordered));
  for (std::size_t v = 0; v < position.size(); ++v) {
    if (position[v] == before[v]) continue;
    map.log_radius[v] = std::log(std::abs(position[v]));
    map.angle[v] = wrapped(std::arg(position[v]));
  }
  return result;
}

Unflipped unflip_in_disk(const mesh::TriangleMesh& mesh, CircularMap& map) {
  const auto loops = mesh::boundary_loops(mesh);
  std::vector<Circle> circle(loops.size());
  for (std::size_t k = 0; k < map.loop.size(); ++k) circle[map.loop[k]] = map.domain.circles[k];
  const std::vector<char> none(static_cast<std::size_t>(mesh.surface.triangle_count()), 0);
  return unflip_between_circles(mesh, mesh::loops_of_vertices(loops, mesh.surface), map.position, circle,
                                none);
}

} // namespace tetrarch::slit
