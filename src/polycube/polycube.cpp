// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/polycube.hpp"

#include "tetrarch/polycube/gaps.hpp"
#include "tetrarch/polycube/map.hpp"
#include "tetrarch/product/polycube_pullback.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace tetrarch::polycube {

std::optional<Frame> frame(const product::Solid& solid, const std::vector<Label>& label,
                           const Progress& progress) {
  Frame result;
  result.labeled = with_room({solid, label}, progress);
  result.charts = charts(result.labeled.solid, Facets(result.labeled.solid), result.labeled.label);
  result.planes = planes(result.labeled.solid, result.charts);
  progress.step("least squares");
  const auto image = least_squares_image(result.labeled.solid, result.planes, 1);
  if (!image) return std::nullopt;
  result.places = image->of_planes;
  result.gaps = gaps(result.labeled, result.charts, result.planes, *image, progress);
  return result;
}

template <class Number>
std::vector<int> twisted_corners(const Frame& frame, const std::vector<Number>& places) {
  // The far end of the line that leaves a corner by way of a vertex.
  std::map<std::array<int, 2>, int> far_end;
  for (const Line& line : frame.charts.lines) {
    const std::vector<int>& v = line.vertices;
    far_end[{v.front(), v[1]}] = v.back();
    far_end[{v.back(), v[v.size() - 2]}] = v.front();
  }
  const auto place = [&](int v, std::size_t axis) {
    const int plane = frame.planes.holds[frame.labeled.solid.vertex[v]][axis];
    return plane < 0 ? Number{} : places[plane];
  };
  std::vector<int> result;
  for (const int v : frame.charts.corners) {
    const std::vector<int>& around = frame.charts.around[v];
    std::vector<Sector> sectors;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Label here = frame.charts.label[around[k]];
      const Label before = frame.charts.label[around[(k + around.size() - 1) % around.size()]];
      if (axis_of(here) == axis_of(before)) break;
      const std::size_t axis = 3 - axis_of(here) - axis_of(before);
      const bool is_up = place(far_end.at({v, frame.charts.begins[v][k]}), axis) > place(v, axis);
      sectors.push_back({here, static_cast<Label>(2 * axis) + (is_up ? 0 : 1)});
    }
    if (sectors.size() < around.size() || !is_corner_of_cubes(sectors)) result.push_back(v);
  }
  return result;
}
template std::vector<int> twisted_corners(const Frame& frame, const std::vector<int>& places);
template std::vector<int> twisted_corners(const Frame& frame, const std::vector<double>& places);

namespace {

/// Unfolds around folds, if there are any; in larger surroundings, too, if they are few.
void unfold_folds(Polycube& polycube, const Planes& planes, double edge, const Progress& progress) {
  constexpr std::size_t few = 5;
  LabeledSolid& labeled = polycube.labeled;
  polycube.flipped = product::folded(labeled.solid, labeled.image);
  for (const int rings : {3, 8}) {
    if (polycube.flipped.empty() || (rings > 3 && polycube.flipped.size() > few)) return;
    labeled.image =
        locally_unfolded_image(labeled.solid, planes, 1 / edge, std::move(labeled.image), rings, progress);
    polycube.flipped = product::folded(labeled.solid, labeled.image);
  }
}

} // namespace

std::optional<Polycube> polycube(const Frame& frame, double edge, const Progress& progress) {
  std::vector<double> places = frame.places;
  std::vector<Gap> gaps = frame.gaps;
  for (double& x : places) x /= edge;
  for (Gap& gap : gaps) gap.width /= edge;
  const auto rounded = rounded_places(places, gaps, progress);
  if (!rounded) return std::nullopt;
  progress.step("least squares");
  const product::Solid& solid = frame.labeled.solid;
  auto image = least_squares_image(solid, frame.planes, 1 / edge,
                                   std::vector<double>(rounded->begin(), rounded->end()));
  if (!image) return std::nullopt;
  Polycube result{frame.labeled, *rounded, twisted_corners(frame, *rounded), {}};
  result.labeled.image = unfolded_image(solid, frame.planes, 1 / edge, std::move(image->points), progress);
  unfold_folds(result, frame.planes, edge, progress);
  // Folds that few tetrahedra have are stuck: they want more freedom.
  constexpr int most_rounds = 3;
  constexpr std::size_t few = 60;
  Polycube finer = result;
  for (int round = 0; round < most_rounds && !result.flipped.empty() && finer.flipped.size() < few; ++round) {
    finer.labeled = refined(finer.labeled, finer.flipped, progress);
    const product::Solid& pieces = finer.labeled.solid;
    unfold_folds(finer, planes(pieces, charts(pieces, Facets(pieces), finer.labeled.label)), edge, progress);
    if (finer.flipped.size() < result.flipped.size()) result = finer;
  }
  return result;
}

Polycubes::Polycubes(const product::Solid& solid, const Progress& progress)
    : solid_(solid), labelings_(polycube::labelings(solid, progress)), frames_(labelings_.size()),
      is_framed_(labelings_.size()) {
  for (std::size_t k = 0; k < labelings_.size(); ++k) order_.push_back(k);
}

std::optional<Polycubes::Found> Polycubes::at(double edge, const Progress& progress) {
  std::optional<Found> best;
  constexpr std::size_t most_tried = 3;
  std::size_t tried = 0;
  // What did well before is tried first.
  const std::vector<std::size_t> order = order_;
  for (const std::size_t k : order) {
    // What has more faults than the best has no better map, and costs as much.
    if (tried == most_tried || labelings_[k].faults.size() > labelings_.front().faults.size()) break;
    if (is_framed_[k] == 0) {
      is_framed_[k] = 1;
      frames_[k] = frame(solid_, labelings_[k].label, progress);
    }
    if (!frames_[k]) continue;
    ++tried;
    auto made = polycube(*frames_[k], edge, progress);
    if (!made || (best && made->flipped.size() >= best->polycube.flipped.size())) continue;
    best = Found{&labelings_[k], &*frames_[k], *std::move(made)};
    if (!best->polycube.flipped.empty()) continue;
    order_.erase(std::find(order_.begin(), order_.end(), k));
    order_.insert(order_.begin(), k);
    break;
  }
  return best;
}

} // namespace tetrarch::polycube
