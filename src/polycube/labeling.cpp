// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/labeling.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;

/// How bad faults are, all together: turning points may go away in the map, the others hardly.
int badness(const std::vector<Fault>& faults) {
  constexpr int topological = 3;
  int sum = 0;
  for (const Fault& f : faults) sum += f.kind == Fault::Kind::turning_point ? 1 : topological;
  return sum;
}

/// The labeling that is mended, and its faults.
class Mending {
public:
  Mending(const product::Solid& solid, const Facets& facets, std::vector<Label> label,
          const Progress& progress)
      : solid_(solid), facets_(facets), label_(std::move(label)), progress_(progress) {
    const surface::Surface& surface = solid.boundary;
    at_.resize(static_cast<std::size_t>(surface.vertex_count()));
    for (int t = 0; t < surface.triangle_count(); ++t)
      for (const int v : surface.corners(t)) at_[v].push_back(t);
    measure();
  }
  bool is_done() const { return faults_.empty() || trials_ >= most_trials; }
  /// Tries all faults once; whether one was mended.
  bool improve() {
    for (const Fault& fault : std::vector<Fault>(faults_)) {
      const bool is_mended =
          fault.kind == Fault::Kind::few_corners ? mend_chart(fault.vertex) : mend_vertex(fault.vertex);
      if (is_mended) return true;
      if (is_done()) break;
    }
    return false;
  }
  std::vector<Label> take() { return std::move(label_); }

private:
  static constexpr int most_trials = 600;

  void measure() {
    charts_ = charts(solid_, facets_, label_);
    faults_ = faults(solid_, charts_);
  }
  /// Gives some triangles a label if that makes the whole better.
  bool tries(const std::vector<int>& triangles, Label label) {
    progress_.step("mending labels");
    if (++trials_ > most_trials) return false;
    std::vector<Label> before = label_;
    for (const int t : triangles) label_[t] = label;
    if (label_ == before) return false;
    const int worst = badness(faults_);
    Charts charts = polycube::charts(solid_, facets_, label_);
    std::vector<Fault> now = faults(solid_, charts);
    if (badness(now) < worst) {
      charts_ = std::move(charts);
      faults_ = std::move(now);
      return true;
    }
    label_ = std::move(before);
    return false;
  }
  /// What it costs more to give the triangles this label.
  double cost(const std::vector<int>& triangles, Label label) const {
    double sum = 0;
    for (const int t : triangles) sum -= facets_.area[t] * dot(facets_.normal[t], direction_of(label));
    return sum;
  }
  bool tries_all(const std::vector<int>& triangles, std::vector<Label> candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Label a, Label b) { return cost(triangles, a) < cost(triangles, b); });
    return std::any_of(candidates.begin(), candidates.end(), [&](Label l) { return tries(triangles, l); });
  }
  bool mend_chart(int vertex) {
    // The chart at the vertex that has the fault.
    for (const int chart : std::vector<int>(charts_.around[vertex])) {
      const std::vector<int>& curves = charts_.corners_of_curve[chart];
      if (std::all_of(curves.begin(), curves.end(), [](int c) { return c >= 4; })) continue;
      std::vector<int> triangles;
      for (int t = 0; t < static_cast<int>(charts_.of.size()); ++t)
        if (charts_.of[t] == chart) triangles.push_back(t);
      std::set<Label> beside;
      for (const Line& line : charts_.lines) {
        if (line.left == chart) beside.insert(charts_.label[line.right]);
        if (line.right == chart) beside.insert(charts_.label[line.left]);
      }
      if (tries_all(triangles, {beside.begin(), beside.end()})) return true;
    }
    return false;
  }
  bool mend_vertex(int vertex) {
    std::vector<int> triangles;
    std::vector<int> rim{vertex};
    constexpr int rings = 3;
    for (int ring = 0; ring < rings; ++ring) {
      for (const int v : rim) triangles.insert(triangles.end(), at_[v].begin(), at_[v].end());
      std::sort(triangles.begin(), triangles.end());
      triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
      if (tries_all(triangles, {0, 1, 2, 3, 4, 5})) return true;
      for (const int t : triangles)
        for (const int v : solid_.boundary.corners(t)) rim.push_back(v);
      std::sort(rim.begin(), rim.end());
      rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    }
    return false;
  }

  const product::Solid& solid_;
  const Facets& facets_;
  std::vector<Label> label_;
  const Progress& progress_;
  std::vector<std::vector<int>> at_; ///< triangles at each vertex
  Charts charts_;
  std::vector<Fault> faults_;
  int trials_ = 0;
};

} // namespace

std::vector<Label> mended(const product::Solid& solid, const Facets& facets, std::vector<Label> label,
                          const Progress& progress) {
  progress.step("mending labels");
  Mending mending(solid, facets, std::move(label), progress);
  while (!mending.is_done() && mending.improve()) {
  }
  return mending.take();
}

std::vector<Labeling> labelings(const product::Solid& solid, const Progress& progress) {
  const Facets facets(solid);
  std::vector<Labeling> result;
  std::set<std::vector<Label>> known;
  for (const double smoothness : {0.003, 0.01, 0.03, 0.06, 0.1, 0.2}) {
    Labeling found;
    found.smoothness = smoothness;
    found.label = labeled(solid, facets, smoothness, progress);
    if (!known.insert(found.label).second) continue;
    found.label = mended(solid, facets, std::move(found.label), progress);
    known.insert(found.label);
    const Charts all = charts(solid, facets, found.label);
    found.faults = faults(solid, all);
    found.charts = all.count();
    found.corners = static_cast<int>(all.corners.size());
    for (std::size_t t = 0; t < found.label.size(); ++t)
      found.misfit +=
          facets.area[t] / facets.total * (1 - dot(facets.normal[t], direction_of(found.label[t])));
    result.push_back(std::move(found));
  }
  std::stable_sort(result.begin(), result.end(), [](const Labeling& a, const Labeling& b) {
    const int bad_a = badness(a.faults);
    const int bad_b = badness(b.faults);
    return bad_a != bad_b ? bad_a < bad_b : a.misfit < b.misfit;
  });
  // Straight lines are easier to map: the smoothest comes first that hardly fits less than the best.
  constexpr double hardly_less = 1.1;
  std::size_t first = 0;
  for (std::size_t k = 1; k < result.size(); ++k)
    if (badness(result[k].faults) == badness(result[0].faults) &&
        result[k].misfit <= hardly_less * result[0].misfit && result[k].smoothness > result[first].smoothness)
      first = k;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(first),
              result.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  return result;
}

} // namespace tetrarch::polycube
