// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/polycube.hpp"

#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/polycube/map.hpp"
#include "tetrarch/product/polycube_pullback.hpp"
#include "walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;

/// Gaps between two planes, all of them together.
class GapSet {
public:
  explicit GapSet(const Image& image) : image_(image) {}
  /// `low` and `high` are planes.
  void add(int low, int high, double weight) {
    const double width = image_.of_planes[high] - image_.of_planes[low];
    if (low != high && width > 0) weight_[{low, high}] += weight;
  }
  std::vector<Gap> all() const {
    double total = 0;
    for (const auto& [ends, weight] : weight_) total += weight;
    std::vector<Gap> result;
    for (const auto& [ends, weight] : weight_)
      result.push_back({ends[0], ends[1], image_.of_planes[ends[1]] - image_.of_planes[ends[0]],
                        weight / total * static_cast<double>(weight_.size())});
    return result;
  }

private:
  const Image& image_;
  std::map<std::array<int, 2>, double> weight_;
};

/// From the end of a line to the other.
void add_lines(const Frame& frame, GapSet& gaps) {
  const product::Solid& solid = frame.labeled.solid;
  for (const Line& line : frame.charts.lines) {
    if (line.is_closed || are_opposite(frame.charts.label[line.left], frame.charts.label[line.right]))
      continue;
    const std::size_t axis = frame.charts.axis(line);
    int low = frame.planes.holds[solid.vertex[line.vertices.front()]][axis];
    int high = frame.planes.holds[solid.vertex[line.vertices.back()]][axis];
    if (low < 0 || high < 0) continue; // a faulty corner
    double length = 0;
    for (std::size_t k = 1; k < line.vertices.size(); ++k)
      length += distance(solid.point(solid.vertex[line.vertices[k]]),
                         solid.point(solid.vertex[line.vertices[k - 1]]));
    constexpr double of_square = 0.1;
    gaps.add(low, high, of_square * length * length);
    gaps.add(high, low, of_square * length * length);
  }
}

/// From each triangle straight through the solid.
void add_walls(const Frame& frame, const Facets& facets, const Image& image, GapSet& gaps,
               const Progress& progress) {
  const product::Solid& solid = frame.labeled.solid;
  const ImageWalk walk(solid, image.points);
  const double far = 2 * extent(image.points);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (t % 256 == 0) progress.step("walls");
    const int tet = solid.face[t].tet;
    Point middle{};
    for (const int v : solid.corners(tet)) middle = middle + 0.25 * image.points[v];
    const Label label = frame.labeled.label[t];
    const WalkEnd end = walk.walk(tet, middle, middle - far * direction_of(label));
    if (end.is_lost || end.triangle < 0 || !are_opposite(label, frame.labeled.label[end.triangle])) continue;
    const int here = frame.planes.of_chart[frame.charts.of[t]];
    const int there = frame.planes.of_chart[frame.charts.of[end.triangle]];
    sign_of(label) > 0 ? gaps.add(there, here, facets.area[t]) : gaps.add(here, there, facets.area[t]);
  }
}

} // namespace

std::optional<Frame> frame(const product::Solid& solid, const std::vector<Label>& label,
                           const Progress& progress) {
  Frame result;
  result.labeled = with_room({solid, label}, progress);
  const Facets facets(result.labeled.solid);
  result.charts = charts(result.labeled.solid, facets, result.labeled.label);
  result.planes = planes(result.labeled.solid, result.charts);
  progress.step("least squares");
  const auto image = least_squares_image(result.labeled.solid, result.planes, 1);
  if (!image) return std::nullopt;
  result.places = image->of_planes;
  GapSet gaps(*image);
  add_lines(result, gaps);
  add_walls(result, facets, *image, gaps, progress);
  result.gaps = gaps.all();
  return result;
}

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
  Polycube result{
      unfolded_image(solid, frame.planes, 1 / edge, std::move(image->points), progress), *rounded, {}};
  result.flipped = product::folded(solid, result.image);
  return result;
}

Polycubes::Polycubes(const product::Solid& solid, const Progress& progress)
    : solid_(solid), labelings_(polycube::labelings(solid, progress)), frames_(labelings_.size()),
      is_framed_(labelings_.size()) {}

std::optional<Polycubes::Found> Polycubes::at(double edge, const Progress& progress) {
  std::optional<Found> best;
  for (std::size_t k = 0; k < labelings_.size(); ++k) {
    if (is_framed_[k] == 0) {
      is_framed_[k] = 1;
      frames_[k] = frame(solid_, labelings_[k].label, progress);
    }
    if (!frames_[k]) continue;
    auto made = polycube(*frames_[k], edge, progress);
    if (!made || (best && made->flipped.size() >= best->polycube.flipped.size())) continue;
    best = Found{&labelings_[k], &*frames_[k], *std::move(made)};
    if (best->polycube.flipped.empty()) break;
  }
  return best;
}

} // namespace tetrarch::polycube
