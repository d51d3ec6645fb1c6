// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing.hpp"

#include "folded_part.hpp"
#include "full_turn.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;
using Complex = std::complex<double>;

constexpr int most_sweeps = 100;
/// Triangles that are unfolded together.
constexpr std::size_t most_unfolded = 2000;
/// A triangle this much narrower than in space counts as flipped.
constexpr double flat = 1e-3;

/// The altitude on the longest side, in units of that side.
double width(const numeric::FlatTriangle& p) {
  return numeric::twice_area(p) / numeric::longest_squared(p);
}

/// Where two walls meet.
Complex best_meeting_along(const std::vector<Wall>& walls, Complex direction) {
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

/// Where three walls are equally far.
Complex best_meeting(const std::vector<Wall>& walls) {
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

/// By a few walls: those that look most into each of eight directions, lest a way be open to infinity, and
/// those that turn out nearest.
template <class Solve>
Complex by_few(const std::vector<Wall>& walls, const Solve& solve) {
  constexpr std::size_t few = 20;
  if (walls.size() <= few) return solve(walls);
  constexpr int directions = 8;
  constexpr int most_added = 24;
  const auto nearest_after = [&](Complex step) {
    return *std::min_element(walls.begin(), walls.end(), [&](const Wall& a, const Wall& b) {
      return least({a}, step) < least({b}, step);
    });
  };
  std::vector<Wall> chosen{nearest_after(0)};
  for (int k = 0; k < directions; ++k) {
    const Complex way = std::polar(1.0, full_turn * k / directions);
    chosen.push_back(*std::max_element(walls.begin(), walls.end(), [&](const Wall& a, const Wall& b) {
      return (std::conj(a.normal) * way).real() < (std::conj(b.normal) * way).real();
    }));
  }
  Complex best = 0;
  double value = least(walls, 0);
  for (int added = 0; added < most_added; ++added) {
    const Complex step = solve(chosen);
    if (const double there = least(walls, step); there > value) {
      value = there;
      best = step;
    }
    const Wall nearest = nearest_after(step);
    if (!(least({nearest}, step) < least(chosen, step))) break;
    chosen.push_back(nearest);
  }
  return best;
}

} // namespace

double least(const std::vector<Wall>& walls, Complex step) {
  double result = INFINITY;
  for (const Wall& w : walls) result = std::min(result, w.now + (std::conj(w.normal) * step).real());
  return result;
}

Complex best_along(const std::vector<Wall>& walls, Complex direction) {
  return by_few(walls, [&](const std::vector<Wall>& some) { return best_meeting_along(some, direction); });
}

Complex best_anywhere(const std::vector<Wall>& walls) {
  return by_few(walls, best_meeting);
}

Drawing::Drawing(const surface::TriangleMesh& mesh, std::vector<Complex> along, std::vector<char> skipped,
                 std::vector<int> judged)
    : surface_(mesh.surface), points_(mesh.points), along_(std::move(along)), skipped_(std::move(skipped)),
      judged_(std::move(judged)), width_(skipped_.size(), 0.0),
      some_end_(static_cast<std::size_t>(surface_.vertex_count())) {
  for (const int t : judged_) width_[t] = width(numeric::laid_flat(mesh.points, surface_.corners(t)));
  for (int k = 0; k < surface_.side_count(); ++k) some_end_[surface_.from(Side(k))] = {Side(k), true};
}

Unflipped Drawing::set_right(const Freedom& freedom, const std::function<void(int, Complex)>& moved,
                             const std::map<int, Complex>& first_moves, const Progress& progress) {
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
    for (const int v : around(wrong, sweep / 20)) {
      progress.step("triangles turned over", sweep / static_cast<double>(most_sweeps));
      if (const Complex step = improved(v, freedom); step != 0.0) take(v, step);
    }
    // Triangles only turn over beside vertices that moved, and those only raise the least distance.
    wrong.erase(std::remove_if(wrong.begin(), wrong.end(), [&](int t) { return !is_flipped(t, flat); }),
                wrong.end());
    if (wrong.empty()) wrong = flipped_among_all();
    if (wrong.empty() || sweep % sweeps_between_counts == 0 || sweep + 1 == most_sweeps) keep_if_better(best);
  }
  take_back(moved);
  for (const int rings : {2, 4, 8}) {
    if (best.flipped == 0) break;
    unfold_around(flipped_among_all(), rings, freedom, take, progress);
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

bool Drawing::is_flipped(int t, double factor) const {
  if (skipped_[t]) return false;
  double longest = 0;
  for (const Side s : surface::sides_of(t)) longest = std::max(longest, std::abs(along_[s.value]));
  const double width =
      numeric::cross(along_[Side(t, 2).value] / longest, -along_[Side(t, 1).value] / longest);
  return !(width > factor * width_[t]);
}

std::vector<int> Drawing::flipped_among_all() const {
  std::vector<int> result;
  for (const int t : judged_)
    if (is_flipped(t, flat)) result.push_back(t);
  return result;
}

Drawing::Count Drawing::count() const {
  constexpr double rounding = 1e-12;
  Count result;
  for (const int t : judged_)
    if (is_flipped(t, rounding))
      ++result.flipped;
    else if (is_flipped(t, flat))
      ++result.narrow;
  return result;
}

void Drawing::keep_if_better(Count& best) {
  const Count now = count();
  if (std::pair(now.flipped, now.narrow) >= std::pair(best.flipped, best.narrow)) return;
  best = now;
  for (const auto& [v, step] : since_best_) total_[v] += step;
  since_best_.clear();
}

void Drawing::take_back(const std::function<void(int, Complex)>& moved) {
  for (auto step = since_best_.rbegin(); step != since_best_.rend(); ++step) {
    move(step->first, -step->second);
    moved(step->first, -step->second);
  }
  since_best_.clear();
}

void Drawing::unfold_around(const std::vector<int>& triangles, int rings, const Freedom& freedom,
                            const std::function<void(int, Complex)>& take, const Progress& progress) const {
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
  const std::vector<Complex> now = unfolded(part, progress.silent());
  for (const auto& [v, k] : point)
    if (part.freedom[k] && now[k] != part.points[k]) take(v, freedom.kept(v, now[k] - part.points[k]));
}

std::map<int, Complex> Drawing::laid_out(const std::vector<int>& part,
                                         std::map<int, std::vector<int>>& at) const {
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

std::vector<int> Drawing::around(const std::vector<int>& triangles, int rings) const {
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
      for (const surface::SideEnd e : surface::fan(surface_, some_end_[result[done]])) add(e.side.triangle());
  }
  return result;
}

std::vector<Wall> Drawing::walls(int v) const {
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

Complex Drawing::to_the_middle(int v) const {
  const surface::SideEnd e = some_end_[v];
  const Side opposite(e.side.triangle(), e.corner());
  return (along_[opposite.previous().value] - along_[opposite.next().value]) / 2.0;
}

Complex Drawing::improved(int v, const Freedom& freedom) const {
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

void Drawing::move(int v, Complex step) {
  for (const surface::SideEnd e : surface::fan(surface_, some_end_[v])) {
    const Side opposite(e.side.triangle(), e.corner());
    along_[opposite.next().value] += step;     // ends at v
    along_[opposite.previous().value] -= step; // starts there
  }
}

} // namespace tetrarch::slit
