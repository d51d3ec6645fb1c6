// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/unflip.hpp"

#include "banks.hpp"
#include "folded_part.hpp"
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

constexpr int most_sweeps = 100;
/// Triangles that are unfolded together: nobody can stop that.
constexpr std::size_t most_unfolded = 2000;
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

  /// Only the `judged` triangles are to be set right.
  Drawing(const surface::TriangleMesh& mesh, std::vector<Complex> along, std::vector<char> skipped,
          std::vector<int> judged)
      : surface_(mesh.surface), points_(mesh.points), along_(std::move(along)), skipped_(std::move(skipped)),
        judged_(std::move(judged)), width_(skipped_.size(), 0.0),
        some_end_(static_cast<std::size_t>(surface_.vertex_count())) {
    for (const int t : judged_) width_[t] = width(numeric::laid_flat(mesh.points, surface_.corners(t)));
    for (int k = 0; k < surface_.side_count(); ++k) some_end_[surface_.from(Side(k))] = {Side(k), true};
  }

  /// `moved` is told of each step of a vertex; the first moves are those given. Ends with the best drawing
  /// that was met: the fewest flipped triangles, then the fewest narrow ones.
  Unflipped set_right(const Freedom& freedom, const std::function<void(int, Complex)>& moved,
                      const std::map<int, Complex>& first_moves = {}) {
    Count best = count();
    const auto take = [&](int v, Complex step) {
      move(v, step);
      moved(v, step);
      since_best_.emplace_back(v, step);
    };
    for (const auto& [v, step] : first_moves) take(v, step);
    std::vector<int> wrong = flipped_among_all();
    keep_if_better(best);
    constexpr int sweeps_between_counts = 5;
    for (int sweep = 0; sweep < most_sweeps && !wrong.empty(); ++sweep) {
      for (const int v : around(wrong, sweep / 20))
        if (const Complex step = improved(v, freedom); step != 0.0) take(v, step);
      // Triangles only turn over beside vertices that moved, and those only raise the least distance.
      wrong.erase(std::remove_if(wrong.begin(), wrong.end(), [&](int t) { return !is_flipped(t, flat); }),
                  wrong.end());
      if (wrong.empty()) wrong = flipped_among_all();
      if (wrong.empty() || sweep % sweeps_between_counts == 0 || sweep + 1 == most_sweeps)
        keep_if_better(best);
    }
    take_back(moved);
    for (const int rings : {2, 4, 8}) {
      if (best.flipped == 0) break;
      unfold_around(flipped_among_all(), rings, freedom, take);
      keep_if_better(best);
      take_back(moved);
    }
    Unflipped result;
    result.left = best.flipped + best.narrow;
    for (const auto& [v, step] : total_)
      if (step != 0.0) {
        ++result.moved;
        result.farthest = std::max(result.farthest, std::abs(step));
      }
    return result;
  }

  const std::vector<Complex>& along() const { return along_; }

private:
  struct Count {
    int flipped = 0;
    int narrow = 0;
  };

  /// Whether a triangle is narrower than its shape in space by this factor, or turned over. In units of its
  /// longest side, as squares of small ones underflow.
  bool is_flipped(int t, double factor) const {
    if (skipped_[t]) return false;
    double longest = 0;
    for (const Side s : surface::sides_of(t)) longest = std::max(longest, std::abs(along_[s.value]));
    const double width =
        numeric::cross(along_[Side(t, 2).value] / longest, -along_[Side(t, 1).value] / longest);
    return !(width > factor * width_[t]);
  }

  std::vector<int> flipped_among_all() const {
    std::vector<int> result;
    for (const int t : judged_)
      if (is_flipped(t, flat)) result.push_back(t);
    return result;
  }

  Count count() const {
    constexpr double rounding = 1e-12;
    Count result;
    for (const int t : judged_)
      if (is_flipped(t, rounding))
        ++result.flipped;
      else if (is_flipped(t, flat))
        ++result.narrow;
    return result;
  }

  void keep_if_better(Count& best) {
    const Count now = count();
    if (std::pair(now.flipped, now.narrow) >= std::pair(best.flipped, best.narrow)) return;
    best = now;
    for (const auto& [v, step] : since_best_) total_[v] += step;
    since_best_.clear();
  }

  void take_back(const std::function<void(int, Complex)>& moved) {
    for (auto step = since_best_.rbegin(); step != since_best_.rend(); ++step) {
      move(step->first, -step->second);
      moved(step->first, -step->second);
    }
    since_best_.clear();
  }

  /// Moves the vertices near some triangles all at once, by the foldover-free energy. Nothing where the part
  /// goes around the cylinder, as it is no part of the plane then, or is too large to be done in a second.
  void unfold_around(const std::vector<int>& triangles, int rings, const Freedom& freedom,
                     const std::function<void(int, Complex)>& take) const {
    const std::vector<int> moving = around(triangles, rings);
    std::vector<int> near;
    std::map<int, std::vector<int>> at; // the triangles of the part at each of its vertices
    for (const int v : moving)
      for (const surface::SideEnd e : surface::fan(surface_, some_end_[v]))
        if (!skipped_[e.side.triangle()]) near.push_back(e.side.triangle());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    if (near.size() > most_unfolded) return;
    for (const int t : near)
      for (const int v : surface_.corners(t)) at[v].push_back(t);
    const std::map<int, Complex> place = laid_out(near, at);
    if (place.empty()) return;
    FoldedPart part;
    std::map<int, int> point;
    for (const auto& [v, z] : place) {
      point[v] = static_cast<int>(part.points.size());
      part.points.push_back(z);
      part.freedom.emplace_back();
    }
    for (const int v : moving)
      if (const auto found = point.find(v); found != point.end())
        part.freedom[found->second] = freedom.slides(v);
    for (const int t : near) {
      const auto& c = surface_.corners(t);
      part.elements.push_back({{point[c[0]], point[c[1]], point[c[2]]}, numeric::laid_flat(points_, c)});
    }
    const std::vector<Complex> now = unfolded(part);
    for (const auto& [v, k] : point)
      if (part.freedom[k] && now[k] != part.points[k]) take(v, freedom.kept(v, now[k] - part.points[k]));
  }

  /// Places of the vertices of some triangles, each piece somewhere; nothing if they do not lie in a plane.
  std::map<int, Complex> laid_out(const std::vector<int>& part, std::map<int, std::vector<int>>& at) const {
    std::map<int, Complex> place;
    for (const int first : part) {
      std::vector<int> waiting;
      if (place.try_emplace(surface_.corners(first)[0], 0.0).second) waiting = at[surface_.corners(first)[0]];
      while (!waiting.empty()) {
        const int t = waiting.back();
        waiting.pop_back();
        const auto& c = surface_.corners(t);
        const auto known = static_cast<std::size_t>(
            std::find_if(c.begin(), c.end(), [&](int v) { return place.count(v) > 0; }) - c.begin());
        Complex z = place[c[known]];
        for (std::size_t k = 1; k <= 2; ++k) {
          const std::size_t corner = (known + k) % 3;
          // Side s runs from corner s + 1 to corner s + 2.
          const Complex edge = along_[Side(t, static_cast<int>((known + k + 1) % 3)).value];
          z += edge;
          const auto [there, is_new] = place.try_emplace(c[corner], z);
          if (is_new)
            waiting.insert(waiting.end(), at[c[corner]].begin(), at[c[corner]].end());
          else if (std::abs(there->second - z) > 1e-6 * std::abs(edge))
            return {};
        }
      }
    }
    return place;
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
        for (const surface::SideEnd e : surface::fan(surface_, some_end_[result[done]]))
          add(e.side.triangle());
    }
    return result;
  }

  std::vector<Wall> walls(int v) const {
    std::vector<Wall> result;
    for (const surface::SideEnd e : surface::fan(surface_, some_end_[v])) {
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

  /// Of a vertex of one triangle: the step that takes it to the middle between the two others. On a circle
  /// that is where the triangle is widest; along the tangent it would grow for ever.
  Complex to_the_middle(int v) const {
    const surface::SideEnd e = some_end_[v];
    const Side opposite(e.side.triangle(), e.corner());
    return (along_[opposite.previous().value] - along_[opposite.next().value]) / 2.0;
  }

  /// The step that takes v farther from its walls; 0 if there is none.
  Complex improved(int v, const Freedom& freedom) const {
    const std::vector<Wall> limits = walls(v);
    const Complex direction = freedom.slides(v);
    Complex step = direction == 0.0 ? best_anywhere(limits) : best_along(limits, direction);
    if (direction != 0.0 && limits.size() == 1) step = to_the_middle(v);
    const double before = least(limits, 0);
    // On a circle the straight step is too long at worst.
    constexpr int most_halvings = 20;
    for (int k = 0; k < most_halvings && step != 0.0; ++k, step /= 2) {
      const Complex kept = freedom.kept(v, step);
      if (!(least(limits, kept) > before)) continue;
      return kept;
    }
    return 0;
  }

  void move(int v, Complex step) {
    for (const surface::SideEnd e : surface::fan(surface_, some_end_[v])) {
      const Side opposite(e.side.triangle(), e.corner());
      along_[opposite.next().value] += step;     // ends at v
      along_[opposite.previous().value] -= step; // starts there
    }
  }

  const Surface& surface_;
  const std::vector<numeric::Point>& points_;
  std::vector<Complex> along_;
  std::vector<char> skipped_;
  std::vector<int> judged_;
  std::vector<double> width_; ///< of each judged triangle in space
  std::vector<surface::SideEnd> some_end_;
  std::vector<std::pair<int, Complex>> since_best_; ///< steps
  std::map<int, Complex> total_;                    ///< of each vertex that moved, up to the best drawing
};

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
                                 const std::map<int, Complex>& first_moves = {}) {
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
      freedom, [&](int v, Complex step) { position[v] += step; }, first_moves);
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

Unflipped unflip_on_cylinder(const OneForms& forms, SlitMap& map, Unflip which) {
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
      ordered);
  for (std::size_t s = 0; s < drawing.along().size(); ++s) {
    map.form.real[s] = drawing.along()[s].real();
    map.form.imaginary[s] = drawing.along()[s].imag();
  }
  return result;
}

Unflipped unflip_on_ring(const OneForms& forms, SlitMap& map, Unflip which) {
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
                                                  std::move(skipped), std::move(judged), ordered);
  move_on_ring(forms, map, before, position);
  return result;
}

Unflipped unflip_in_disk(const surface::TriangleMesh& mesh, CircularMap& map, Unflip which) {
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
  return unflip_between_circles(mesh, loop, map.position, circle, std::move(skipped), std::move(judged));
}

} // namespace tetrarch::slit
