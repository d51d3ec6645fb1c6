// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/automatic.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/parallel.hpp"
#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/product.hpp"

#include "homology.hpp"
#include "levels.hpp"
#include "patches.hpp"
#include "tunnels.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tetrarch::product {
namespace {

using surface::Side;
using namespace numeric;

/// More sides than this are not tried in pairs.
constexpr std::size_t most_sides = 60;

/// What does not change during the search.
struct Search {
  const Solid& solid;
  const AutomaticOptions& options;
  std::vector<Point> areas;
  double whole = 0;
  std::optional<FirstHomology> homology; ///< of solids with handles

  Search(const Solid& s, const AutomaticOptions& o) : solid(s), options(o), areas(vector_areas(s)) {
    for (const Point& a : areas) whole += norm(a);
    if (genus(s) > 0) homology.emplace(s);
  }
};

double score(const Solid& solid, const Partition& partition) {
  const std::vector<Point> areas = vector_areas(solid);
  Vector difference{};
  double whole = 0;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    whole += norm(areas[t]);
    if (partition.patch[t] == floor_patch) difference = difference - areas[t];
    if (partition.patch[t] == ceiling_patch) difference = difference + areas[t];
  }
  return norm(difference) / whole;
}

/// A partition with these bases, if they make one.
std::optional<Partition> accepted(const Solid& solid, const std::vector<int>& base,
                                  const std::optional<FirstHomology>& homology) {
  return try_partition(solid, base, -1, homology ? &*homology : nullptr).partition;
}

std::string in_words(const Vector& axis) {
  std::string text;
  for (const double x : axis) {
    const auto hundredths = std::lround(100 * x);
    text += (text.empty() ? "(" : ", ") + std::string(hundredths < 0 ? "-" : "") +
            std::to_string(std::abs(hundredths) / 100) + "." +
            std::to_string(std::abs(hundredths) / 10 % 10) + std::to_string(std::abs(hundredths) % 10);
  }
  return text + ")";
}

//
// Ridges.
//

surface::Surface torn_along_ridges(const Search& search) {
  surface::Surface surface = search.solid.boundary;
  const double sharp = std::cos(search.options.ridge_degrees * std::numbers::pi / 180);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t)) {
      if (surface.is_boundary(s)) continue;
      const Point& a = search.areas[t];
      const Point& b = search.areas[surface.mate(s).triangle()];
      if (dot(a, b) < sharp * norm(a) * norm(b)) surface.unglue(s);
    }
  return surface;
}

/// The sides whose type is that of a base, the largest first, as lists of triangles.
std::vector<std::vector<int>> sides(const Search& search) {
  const surface::Surface torn = torn_along_ridges(search);
  const int n = genus(search.solid);
  struct Found {
    double area;
    std::vector<int> triangles;
  };
  std::vector<Found> found;
  for (surface::Part& piece : surface::split(torn, surface::parts(torn))) {
    if (surface::type_of(piece.surface) != SurfaceType{1 - n, n + 1}) continue;
    double area = 0;
    for (const int t : piece.triangles) area += norm(search.areas[t]);
    found.push_back({area, std::move(piece.triangles)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.area > b.area; });
  if (found.size() > most_sides) found.resize(most_sides);
  std::vector<std::vector<int>> result;
  result.reserve(found.size());
  for (Found& f : found) result.push_back(std::move(f.triangles));
  return result;
}

std::optional<Automatic> by_ridges(const Search& search, const Progress& progress) {
  const std::vector<std::vector<int>> all = sides(search);
  std::optional<Partition> best;
  double best_score = -1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    progress.step("sides between ridges", static_cast<double>(i) / static_cast<double>(all.size()));
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      std::vector<int> base(search.areas.size(), -1);
      for (const int t : all[i]) base[t] = floor_patch;
      for (const int t : all[j]) base[t] = ceiling_patch;
      std::optional<Partition> found = accepted(search.solid, base, search.homology);
      if (!found) continue;
      const double value = score(search.solid, *found);
      if (value <= best_score) continue;
      best = std::move(found);
      best_score = value;
    }
  }
  if (!best) return {};
  return Automatic{search.solid,
                   *std::move(best),
                   best_score,
                   "floor and ceiling are two of the sides between ridges of more than " +
                       std::to_string(std::lround(search.options.ridge_degrees)) + " degrees",
                   {}};
}

//
// Axes.
//

/// Principal axes of inertia and of the normals, then points spread over half a sphere.
std::vector<Vector> axes(const Search& search) {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const auto centre = [&](int t) {
    Eigen::Vector3d c = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      c += Eigen::Vector3d::Map(search.solid.point(search.solid.corner(t, k)).data()) / 3;
    return c;
  };
  const int triangles = search.solid.boundary.triangle_count();
  for (int t = 0; t < triangles; ++t) middle += norm(search.areas[t]) / search.whole * centre(t);
  for (int t = 0; t < triangles; ++t) {
    const Eigen::Vector3d a = Eigen::Vector3d::Map(search.areas[t].data());
    const Eigen::Vector3d r = centre(t) - middle;
    if (a.norm() > 0) normals += a * a.transpose() / a.norm();
    inertia += a.norm() * r * r.transpose();
  }
  std::vector<Vector> result;
  for (const Eigen::Matrix3d& tensor : {normals, inertia}) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    for (int k = 2; k >= 0; --k) {
      const Eigen::Vector3d v = solver.eigenvectors().col(k);
      result.push_back({v[0], v[1], v[2]});
    }
  }
  for (int k = 0; k < search.options.axes; ++k) {
    const double z = (k + 0.5) / search.options.axes;
    const double angle = 2 * std::numbers::pi * std::numbers::phi * k;
    const double r = std::sqrt(1 - z * z);
    result.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return result;
}

/// At each vertex of the boundary the unit normal, after so many rounds of averaging with those around.
std::vector<Vector> smoothed_normals(const Search& search, int rounds) {
  const surface::Surface& surface = search.solid.boundary;
  std::vector<Vector> normal(static_cast<std::size_t>(surface.vertex_count()));
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (const int v : surface.corners(t)) normal[v] = normal[v] + search.areas[t];
  const auto make_unit = [&] {
    for (Vector& n : normal)
      if (const double length = norm(n); length > 0) n = 1 / length * n;
  };
  make_unit();
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vector> next(normal.size());
    for (int t = 0; t < surface.triangle_count(); ++t) {
      const auto& [a, b, c] = surface.corners(t);
      const Vector sum = norm(search.areas[t]) * (normal[a] + (normal[b] + normal[c]));
      for (const int v : {a, b, c}) next[v] = next[v] + sum;
    }
    normal = std::move(next);
    make_unit();
  }
  return normal;
}

CornerValues cosines_along(const Search& search, const std::vector<Vector>& normal, const Vector& axis) {
  CornerValues values;
  values.reserve(search.areas.size());
  for (const auto& [a, b, c] : search.solid.boundary.triangles())
    values.push_back({dot(normal[a], axis), dot(normal[b], axis), dot(normal[c], axis)});
  return values;
}

/// Bases where the mean of the corners is beyond the threshold, cleaned up.
std::vector<int> bases_beyond(const Solid& solid, const CornerValues& values, double threshold) {
  std::vector<int> base;
  base.reserve(values.size());
  for (const auto& [a, b, c] : values) {
    const double mean = (a + b + c) / 3;
    base.push_back(mean < -threshold ? floor_patch : mean > threshold ? ceiling_patch : -1);
  }
  clean_up(solid, base);
  return base;
}

struct FloorCandidate {
  Vector axis{};
  double threshold = 0;
  int smoothing = 0;
  double score = -1;
};

/// The partition of a candidate: with smooth rims if wanted and if that succeeds.
Automatic built(const Search& search, const FloorCandidate& c) {
  const CornerValues values = cosines_along(search, smoothed_normals(search, c.smoothing), c.axis);
  const std::string how = "floor and ceiling face against and along the axis " + in_words(c.axis) +
                          ", normals averaged " + std::to_string(c.smoothing) + " times";
  if (search.options.smooth_rims) {
    Levelled below = split_at_level(search.solid, values, -c.threshold);
    Levelled both = split_at_level(below.solid, std::move(below.values), c.threshold);
    below.splits.insert(below.splits.end(), both.splits.begin(), both.splits.end());
    const std::vector<int> base = bases_beyond(both.solid, both.values, c.threshold);
    // Splits change no topology: the homology was checked before.
    if (std::optional<Partition> found = accepted(both.solid, base, {})) {
      const double value = score(both.solid, *found);
      return {std::move(both.solid), *std::move(found), value, how, std::move(below.splits)};
    }
  }
  const std::vector<int> base = bases_beyond(search.solid, values, c.threshold);
  Partition found = try_partition(search.solid, base, -1, nullptr).partition.value();
  const double value = score(search.solid, found);
  return {search.solid, std::move(found), value, how, {}};
}

/// The best partition with this axis; its score is negative if there is none.
FloorCandidate best_along(const Search& search, const std::vector<Vector>& normal, const Vector& axis,
                          int smoothing) {
  FloorCandidate best;
  const CornerValues values = cosines_along(search, normal, axis);
  for (const double threshold : search.options.thresholds) {
    const std::vector<int> base = bases_beyond(search.solid, values, threshold);
    const std::optional<Partition> found = accepted(search.solid, base, search.homology);
    if (!found) continue;
    const double value = score(search.solid, *found);
    if (value > best.score) best = {axis, threshold, smoothing, value};
  }
  return best;
}

std::optional<Automatic> by_axes(const Search& search, const Progress& progress) {
  const std::vector<Vector> all = axes(search);
  for (const int smoothing : search.options.smoothings) {
    const std::vector<Vector> normal = smoothed_normals(search, smoothing);
    std::vector<FloorCandidate> found(all.size());
    numeric::parallel_for(
        static_cast<int>(all.size()), {search.options.threads, 1},
        [&](int k) { found[k] = best_along(search, normal, all[k], smoothing); },
        [&](double part) { progress.step("axes", part); });
    const auto best =
        std::max_element(found.begin(), found.end(),
                         [](const FloorCandidate& a, const FloorCandidate& b) { return a.score < b.score; });
    if (best->score >= 0) return built(search, *best);
  }
  return {};
}

//
// Tunnels.
//

/// What a tunnel's function makes of the solid, if that is a partition.
std::optional<Automatic> between_levels(const Search& search, Tunnel found) {
  Levelled at{search.solid, std::move(found.values), {}};
  std::vector<solid::EdgePoint> splits;
  for (const double level : found.levels) {
    if (!search.options.smooth_rims) break;
    at = split_at_level(at.solid, std::move(at.values), level);
    splits.insert(splits.end(), at.splits.begin(), at.splits.end());
  }
  std::vector<int> base;
  base.reserve(at.values.size());
  for (const auto& [a, b, c] : at.values) {
    const double mean = (a + b + c) / 3;
    const auto& l = found.levels;
    base.push_back(mean > l[2] && mean < l[3]   ? floor_patch
                   : mean > l[0] && mean < l[1] ? ceiling_patch
                                                : -1);
  }
  clean_up(at.solid, base);
  std::optional<Partition> patches = accepted(at.solid, base, {});
  if (!patches) return {};
  const double value = score(at.solid, *patches);
  return Automatic{std::move(at.solid), *std::move(patches), value, found.how, std::move(splits)};
}

/// What tells good partitions from bad ones, by the field that has no extrema inside.
struct Judgement {
  std::size_t critical = 0; ///< places
  /// The difference of w within a tetrahedron, the geometric mean of all: small where parts of the solid are
  /// out of the field's reach.
  double rise = 0;

  bool is_better_than(const Judgement& other) const {
    constexpr double clearly = 1.5;
    return critical < other.critical || (critical == other.critical && rise > clearly * other.rise);
  }
};

Judgement judgement(const Automatic& found, const Progress& progress) {
  const SplitSolid p = split_shortcuts(found.solid, found.partition);
  FieldOptions options;
  options.clamped = true;
  const std::vector<double> w = harmonic_field(p.solid, p.partition, options, progress).w;
  const CriticalPlaces places = critical_places(p.solid, p.partition, w);
  double logarithms = 0;
  for (const auto& v : p.solid.mesh.tetrahedra) {
    const auto [low, high] = std::minmax({w[v[0]], w[v[1]], w[v[2]], w[v[3]]});
    logarithms += std::log(std::max(high - low, std::numeric_limits<double>::min()));
  }
  return {places.flat.size() + places.vertices.size(), std::exp(logarithms / p.solid.size())};
}

/// The best of those that were offered.
class Best {
public:
  /// Whether it is better than all before.
  bool offer(std::optional<Automatic> found, const Progress& progress) {
    if (!found) return false;
    const Judgement judged = judgement(*found, progress);
    if (found_ && !judged.is_better_than(judged_)) return false;
    found_ = std::move(found);
    judged_ = judged;
    return true;
  }
  /// Whether it makes a product.
  bool is_product() const { return found_ && judged_.critical == 0; }
  std::optional<Automatic> take() { return std::move(found_); }

private:
  std::optional<Automatic> found_;
  Judgement judged_;
};

/// Offers partitions around tunnels until one makes a product and more branches make it no better.
void offer_tunnels(const Search& search, Best& best, const Progress& progress) {
  progress.step("tunnels");
  if (!search.homology) return;
  const std::optional<TunnelLoops> around = tunnel_loops(search.solid, *search.homology);
  if (!around) return;
  for (const int branches : search.options.branches) {
    const bool is_enough = best.is_product();
    std::optional<Tunnel> found = tunnel(search.solid, *around, branches);
    if (!found) return;
    if (!best.offer(between_levels(search, *std::move(found)), progress) && is_enough) return;
  }
}

} // namespace

std::optional<Automatic> automatic_partition(const Solid& solid, const AutomaticOptions& options,
                                             const Progress& progress) {
  const Search search(solid, options);
  Best best;
  best.offer(by_ridges(search, progress), progress);
  if (!best.is_product()) best.offer(by_axes(search, progress), progress);
  if (!best.is_product()) offer_tunnels(search, best, progress);
  return best.take();
}

} // namespace tetrarch::product
