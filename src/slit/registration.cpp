// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/registration.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "flat_location.hpp"
#include "full_turn.hpp"
#include "periodic.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/slit/unflip.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetrarch::slit {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using SpacePoint = std::array<double, 3>;

Vector3d vector(const SpacePoint& p) {
  return {p[0], p[1], p[2]};
}

SpacePoint space_point(const Vector3d& p) {
  return {p[0], p[1], p[2]};
}

SpacePoint point_at(const surface::TriangleMesh& mesh, const MeshPoint& at) {
  Vector3d result = Vector3d::Zero();
  for (std::size_t c = 0; c < 3; ++c)
    result += at.weight[c] * vector(mesh.points[mesh.surface.corners(at.triangle)[c]]);
  return space_point(result);
}

/// A loop of a mesh, laid round a circle, where its edges are chords.
class RoundLoop {
public:
  RoundLoop(const surface::TriangleMesh& mesh, const surface::BoundaryLoop& loop, const CircularMap& map,
            std::size_t curve)
      : mesh_(mesh), sides_(loop.sides), center_(map.domain.circles[curve].center),
        // The surface lies to the left.
        sense_(curve == 0 ? 1 : -1) {
    const auto angle_at = [&](std::size_t k) {
      return angle_of(map.position[mesh.surface.vertex(sides_[k])]);
    };
    angle_.push_back(sense_ * angle_at(0));
    double angle = angle_[0];
    for (std::size_t k = 0; k + 1 < sides_.size(); ++k) {
      angle += std::remainder(sense_ * (angle_at(k + 1) - angle_at(k)), full_turn);
      // Where vertices are out of order, the first to come that far counts.
      angle_.push_back(std::clamp(angle, angle_.back(), angle_[0] + full_turn));
    }
    angle_.push_back(angle_[0] + full_turn);
  }

  Complex center() const { return center_; }
  double angle_of(Complex z) const { return std::arg(z - center_); }

  /// Where the ray from the centre meets the loop. O(log of its length).
  MeshPoint at(double angle) const {
    const double reached = angle_[0] + wrapped(sense_ * angle - angle_[0]);
    const auto next = std::upper_bound(angle_.begin() + 1, angle_.end() - 1, reached);
    const double before = reached - *(next - 1);
    const double after = *next - reached;
    const bool has_chord = before + after < full_turn / 2;
    const double part = before <= 0  ? 0
                        : after <= 0 ? 1
                        : has_chord  ? std::sin(before) / (std::sin(before) + std::sin(after))
                                     : before / (before + after);
    const surface::SideEnd e = sides_[static_cast<std::size_t>(next - angle_.begin()) - 1];
    MeshPoint result{e.side.triangle(), {}};
    result.weight[e.corner()] = 1 - part;
    result.weight[3 - e.corner() - e.side.corner()] = part;
    return result;
  }
  Vector3d point(double angle) const { return vector(point_at(mesh_, at(angle))); }

private:
  const surface::TriangleMesh& mesh_;
  const std::vector<surface::SideEnd>& sides_;
  Complex center_;
  int sense_;
  /// At the starts of the sides and once round, times the sense: never falling.
  std::vector<double> angle_;
};

/// By number of the loop.
std::vector<RoundLoop> round_loops(const surface::TriangleMesh& mesh,
                                   const std::vector<surface::BoundaryLoop>& loops, const CircularMap& map) {
  std::vector<RoundLoop> result;
  for (int k = 0; k < static_cast<int>(loops.size()); ++k) {
    const auto curve = std::find(map.loop.begin(), map.loop.end(), k);
    if (curve == map.loop.end()) throw PreconditionError("the circular map belongs to another surface");
    result.emplace_back(mesh, loops[k], map, static_cast<std::size_t>(curve - map.loop.begin()));
  }
  return result;
}

/// The motion x -> rotation x + shift that brings points closest to others in the mean square.
struct BestMotion {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();
  double distance = 0; ///< the sum of squares that is left, weighted

  /// Each row: a point. Source: Kabsch, "A discussion of the solution for the best rotation to relate two
  /// sets of vectors" (1978).
  static BestMotion of(const Eigen::MatrixX3d& from, const Eigen::MatrixX3d& to,
                       const Eigen::VectorXd& weight) {
    const double total = weight.sum();
    const Vector3d center = from.transpose() * weight / total;
    const Vector3d to_center = to.transpose() * weight / total;
    const Eigen::MatrixX3d before = from.rowwise() - center.transpose();
    const Eigen::MatrixX3d after = to.rowwise() - to_center.transpose();
    const Matrix3d covariance = after.transpose() * weight.asDiagonal() * before;
    const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
    const Vector3d signs(1, 1, sign);
    BestMotion result;
    result.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    result.shift = to_center - result.rotation * center;
    const Eigen::VectorXd left = (before * result.rotation.transpose() - after).rowwise().squaredNorm();
    result.distance = left.dot(weight);
    return result;
  }
};

/// A loop in space by angle, through equally spaced samples. A smooth curve for this reason: chords shrink
/// the polygon itself between vertices, by which the least distance would catch on steps of the mesh.
class SpaceCurve {
public:
  static constexpr int samples = 256;
  static constexpr double step = full_turn / samples;
  explicit SpaceCurve(const RoundLoop& loop)
      : xy_(sampled([&](double t) { return Complex(loop.point(t)[0], loop.point(t)[1]); })),
        z_(sampled([&](double t) { return Complex(loop.point(t)[2]); })) {}
  Vector3d operator()(double t) const {
    const Complex xy = xy_(t);
    return {xy.real(), xy.imag(), z_(t).real()};
  }

private:
  template <class Curve>
  static Periodic sampled(const Curve& curve) {
    std::vector<Complex> result;
    result.reserve(samples);
    for (int j = 0; j < samples; ++j) result.push_back(curve(step * j));
    return Periodic(result);
  }
  Periodic xy_;
  Periodic z_;
};

/// The turn by which two loops, outer and inner, come closest to the other two in space.
double turn_in_space(const std::vector<RoundLoop>& a, const std::vector<const RoundLoop*>& b) {
  constexpr int steps = SpaceCurve::samples;
  constexpr double step = SpaceCurve::step;
  const auto points = [](const std::array<SpaceCurve, 2>& curves, double turn) {
    Eigen::MatrixX3d result(2 * steps, 3);
    for (int j = 0; j < steps; ++j) {
      result.row(j) = curves[0](step * j + turn);
      result.row(steps + j) = curves[1](step * j + turn);
    }
    return result;
  };
  const Eigen::MatrixX3d fixed = points({SpaceCurve(a[0]), SpaceCurve(a[1])}, 0);
  const std::array<SpaceCurve, 2> other{SpaceCurve(*b[0]), SpaceCurve(*b[1])};
  const Eigen::VectorXd weight = Eigen::VectorXd::Ones(fixed.rows());
  const auto distance = [&](double turn) {
    return BestMotion::of(points(other, turn), fixed, weight).distance;
  };
  int best = 0;
  double least = distance(0);
  for (int k = 1; k < steps; ++k)
    if (const double here = distance(step * k); here < least) {
      least = here;
      best = k;
    }
  constexpr int bits = 26; // half of them: it is a least value
  return boost::math::tools::brent_find_minima(distance, step * (best - 1), step * (best + 1), bits).first;
}

/// The loops of B in the order of A's.
std::vector<const RoundLoop*> matched(const std::vector<RoundLoop>& loops, const std::vector<int>& matching) {
  std::vector<const RoundLoop*> result;
  result.reserve(matching.size());
  for (const int k : matching) result.push_back(&loops[k]);
  return result;
}

double best_turn(const std::vector<RoundLoop>& a, const std::vector<const RoundLoop*>& b) {
  if (a.size() == 2) return turn_in_space(a, b);
  Complex turn = 0;
  for (std::size_t k = 0; k < a.size(); ++k) turn += b[k]->center() * std::conj(a[k].center());
  return std::arg(turn);
}

std::vector<int> checked_matching(const OneForms& a, const CircularMap& map_a, std::size_t loops,
                                  const CircularMap& map_b, std::vector<int> matching) {
  const auto count = static_cast<std::size_t>(a.loop_count());
  if (loops != count)
    throw InputError("surfaces with " + std::to_string(count) + " and " + std::to_string(loops) +
                     " boundary loops cannot be registered");
  std::vector<int> by_number(count);
  std::iota(by_number.begin(), by_number.end(), 0);
  if (matching.empty()) matching = by_number;
  if (!std::is_permutation(matching.begin(), matching.end(), by_number.begin(), by_number.end()))
    throw InputError("a matching must name each of the " + std::to_string(count) +
                     " boundary loops of the other surface once");
  for (const std::size_t curve : {0, 1})
    if (map_a.loop.at(curve) < 0 || matching.at(map_a.loop[curve]) != map_b.loop.at(curve))
      throw PreconditionError("the outer loops of both maps must match, and so must the inner loops");
  return matching;
}

/// Loops go round their circles, the rest follows harmonically: the log of new places over old ones, which is
/// 0 if both surfaces are the same, and whose errors are relative to |z| on long surfaces.
std::vector<Complex> carried_over(const OneForms& forms, const CircularMap& map,
                                  const std::vector<RoundLoop>& a, const std::vector<const RoundLoop*>& b,
                                  const surface::Surface& surface, const std::vector<Complex>& target,
                                  double turn) {
  std::vector<Complex> places(forms.mesh().points.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    for (const surface::SideEnd e : forms.loops()[k].sides) {
      const int v = forms.mesh().surface.vertex(e);
      const MeshPoint at = b[k]->at(a[k].angle_of(map.position[v]) + turn);
      Complex place = 0;
      for (std::size_t c = 0; c < 3; ++c) place += at.weight[c] * target[surface.corners(at.triangle)[c]];
      places[v] = std::log(place / std::polar(1.0, turn) / map.position[v]) + Complex(0, turn);
    }
  places = forms.extended(places);
  for (std::size_t v = 0; v < places.size(); ++v) places[v] = map.position[v] * std::exp(places[v]);
  return places;
}

/// Vertices slide along B's circles.
void unflip(const OneForms& forms, const CircularMap& map_a, const CircularMap& map_b,
            const std::vector<int>& matching, Unflip which, Registration& result, const Progress& progress) {
  CircularMap image{map_a.loop, {}, result.position};
  for (const int k : map_a.loop) {
    const auto curve = std::find(map_b.loop.begin(), map_b.loop.end(), matching[k]) - map_b.loop.begin();
    image.domain.circles.push_back(map_b.domain.circles[static_cast<std::size_t>(curve)]);
  }
  result.moved = unflip_in_disk(forms.mesh(), image, which, progress).moved;
  result.position = image.position;
}

void locate(const OneForms& forms, const std::vector<const RoundLoop*>& loops, const surface::TriangleMesh& b,
            const std::vector<Complex>& target, Registration& result) {
  // Above rounding errors, far below the size of triangles.
  constexpr double margin = 1e-12;
  for (const FlatPoint& found : flat_points(b.surface, target, result.position)) {
    result.outside += static_cast<int>(found.outside > margin);
    result.farthest = numeric::maximum(result.farthest, found.outside);
    result.at.push_back(found.at);
  }
  // Loops stay on loops, even where triangles are turned over there.
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const surface::SideEnd e : forms.loops()[k].sides) {
      const int v = forms.mesh().surface.vertex(e);
      result.at[v] = loops[k]->at(loops[k]->angle_of(result.position[v]));
    }
  for (const MeshPoint& at : result.at) result.resampled.push_back(point_at(b, at));
}

/// Where the image is flat, its axes are rounding errors.
bool is_flat(const numeric::FlatTriangle& p) {
  constexpr double flat = 1e-12;
  return !(numeric::twice_area(p) > flat * numeric::longest_squared(p));
}

/// Round holes have no room for ears: these are not called flipped.
std::vector<int> flipped_in_disk(const surface::TriangleMesh& a, const CircularMap& map_a,
                                 const std::vector<Complex>& position) {
  return distortion_in_disk(a, {map_a.loop, {}, position}).flipped;
}

/// Returns for each vertex a third of the area of the triangles around it.
Eigen::VectorXd measure_distortion(const surface::TriangleMesh& a, Registration& result) {
  std::vector<char> is_flipped(static_cast<std::size_t>(a.surface.triangle_count()), 0);
  for (const int t : result.flipped) is_flipped[t] = 1;
  Eigen::VectorXd share = Eigen::VectorXd::Zero(a.surface.vertex_count());
  double measured = 0;
  for (int t = 0; t < a.surface.triangle_count(); ++t) {
    const auto& corners = a.surface.corners(t);
    const numeric::FlatTriangle own = numeric::laid_flat(a.points, corners);
    const double area = numeric::twice_area(own) / 2;
    for (const int v : corners) share[v] += area / 3;
    const numeric::FlatTriangle image = numeric::laid_flat(result.resampled, corners);
    const double ratio = is_flipped[t] || is_flat(image) ? 0 : numeric::ratio_of_axes(own, image);
    result.quasi_conformal.push_back(ratio);
    if (!is_flipped[t] && ratio == 0) ++result.flattened;
    if (ratio == 0) continue;
    result.mean_quasi_conformal += ratio * area;
    result.max_quasi_conformal = numeric::maximum(result.max_quasi_conformal, ratio);
    measured += area;
  }
  if (measured > 0) result.mean_quasi_conformal /= measured;
  return share;
}

Eigen::MatrixX3d rows(const std::vector<SpacePoint>& points) {
  Eigen::MatrixX3d result(points.size(), 3);
  for (std::size_t v = 0; v < points.size(); ++v) result.row(static_cast<int>(v)) = vector(points[v]);
  return result;
}

void compare(const surface::TriangleMesh& a, const Eigen::VectorXd& share, bool aligned,
             Registration& result) {
  BestMotion motion;
  if (aligned) motion = BestMotion::of(rows(result.resampled), rows(a.points), share);
  for (int i = 0; i < 3; ++i) {
    result.motion.shift[i] = motion.shift[i];
    for (int j = 0; j < 3; ++j) result.motion.rotation[i][j] = motion.rotation(i, j);
  }
  const double area = share.sum();
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    const Vector3d moved = motion.rotation * vector(result.resampled[v]) + motion.shift;
    const Vector3d own = vector(a.points[v]);
    result.average.push_back(space_point((own + moved) / 2));
    const double distance = (moved - own).norm();
    result.mean_distance += distance * share[static_cast<int>(v)] / area;
    result.max_distance = numeric::maximum(result.max_distance, distance);
  }
}

} // namespace

Registration registered(const OneForms& a, const CircularMap& map_a, const surface::TriangleMesh& b,
                        const CircularMap& map_b, const RegistrationOptions& options,
                        const Progress& progress) {
  const std::vector<surface::BoundaryLoop> loops_b = surface::boundary_loops(b);
  const std::vector<int> matching = checked_matching(a, map_a, loops_b.size(), map_b, options.matching);
  const std::vector<RoundLoop> from = round_loops(a.mesh(), a.loops(), map_a);
  const std::vector<RoundLoop> onto = round_loops(b, loops_b, map_b);
  const std::vector<const RoundLoop*> to = matched(onto, matching);
  Registration result;
  result.turn = best_turn(from, to);
  result.position = carried_over(a, map_a, from, to, b.surface, map_b.position, result.turn);
  if (options.unflip)
    unflip(a, map_a, map_b, matching, Unflip::everywhere, result, progress);
  else if (options.unflip_at_slits)
    unflip(a, map_a, map_b, matching, Unflip::at_slits, result, progress);
  locate(a, to, b, map_b.position, result);
  result.flipped = flipped_in_disk(a.mesh(), map_a, result.position);
  const Eigen::VectorXd share = measure_distortion(a.mesh(), result);
  compare(a.mesh(), share, options.aligned, result);
  return result;
}

} // namespace tetrarch::slit
