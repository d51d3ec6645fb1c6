// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/fibers.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetrarch::product {
namespace {

/// Weights below it become 0: a fibre that comes so near to a face, edge or vertex goes through it.
constexpr double near_zero = 1e-12;

using Weights = std::array<double, 4>;
using namespace numeric;

Point between(const Point& p, const Point& q) {
  return q - p;
}

/// Of the weights of corners 1, 2 and 3 of a tetrahedron; that of corner 0 is minus their sum.
std::array<Point, 3> weight_gradients(const Solid& solid, int tet) {
  const auto& v = solid.corners(tet);
  const std::array<Point, 3> e{between(solid.point(v[0]), solid.point(v[1])),
                               between(solid.point(v[0]), solid.point(v[2])),
                               between(solid.point(v[0]), solid.point(v[3]))};
  std::array<Point, 3> gradient{cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
  const double six_volumes = dot(e[0], gradient[0]);
  for (Point& g : gradient)
    for (double& x : g) x /= six_volumes;
  return gradient;
}

double tetrahedron_volume(const Solid& solid, int tet) {
  const auto& v = solid.corners(tet);
  return dot(between(solid.point(v[0]), solid.point(v[1])),
             cross(between(solid.point(v[0]), solid.point(v[2])),
                   between(solid.point(v[0]), solid.point(v[3])))) /
         6;
}

/// The walls around a vertex, as sums over their triangles, weighted by area.
struct Walls {
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(); ///< n n^T
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d away = Eigen::Vector3d::Zero(); ///< from the vertex to the centroid
};

/// Above this part of the normals' spread in a second direction, two walls meet at a ridge: they do so at 37
/// degrees.
constexpr double ridge_spread = 0.1;

/// Where less of a vector runs along a ridge, the field crosses it and vanishes there.
constexpr double least_along_ridge = 0.5;

/// What of a vector is tangent to the walls. Around a ridge that points into the solid the field may turn
/// from one wall to the other, even with infinite speed; there a mean vector stays as it is, as it does where
/// the field crosses a ridge.
Eigen::Vector3d tangent(const Eigen::Vector3d& vector, const Walls& walls) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(walls.normals); // eigenvalues increase
  if (axes.eigenvalues()[1] < ridge_spread * walls.normals.trace()) {
    const Eigen::Vector3d normal = axes.eigenvectors().col(2);
    return vector - normal * normal.dot(vector);
  }
  if (walls.normal.dot(walls.away) > 0) return vector;
  const Eigen::Vector3d along = axes.eigenvectors().col(0) * axes.eigenvectors().col(0).dot(vector);
  return along.norm() < least_along_ridge * vector.norm() ? vector : along;
}

std::vector<Point> smoothed(const Solid& solid, const Partition& partition,
                            const std::vector<Point>& gradient) {
  std::vector<Point> sum(solid.mesh.points.size(), Point{});
  std::vector<double> volumes(solid.mesh.points.size(), 0.0);
  for (int t = 0; t < solid.size(); ++t) {
    const double weight = tetrahedron_volume(solid, t);
    for (const int v : solid.corners(t)) {
      volumes[v] += weight;
      for (int c = 0; c < 3; ++c) sum[v][c] += weight * gradient[t][c];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    for (double& x : sum[v]) x /= volumes[v];

  std::vector<Walls> walls(solid.vertex.size());
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (partition.patch[t] < first_wall) continue;
    std::array<Eigen::Vector3d, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = Eigen::Vector3d::Map(solid.point(solid.corner(t, c)).data());
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const Eigen::Vector3d centroid = (p[0] + p[1] + p[2]) / 3;
    for (int c = 0; c < 3; ++c) {
      Walls& at = walls[solid.boundary.corners(t)[c]];
      at.normals += normal * normal.transpose() / normal.norm();
      at.normal += normal;
      at.away += normal.norm() * (centroid - p[c]);
    }
  }
  for (std::size_t b = 0; b < walls.size(); ++b) {
    auto vector = Eigen::Vector3d::Map(sum[solid.vertex[b]].data());
    if (walls[b].normals.trace() > 0) vector = tangent(vector, walls[b]);
  }
  return sum;
}

/// A level that is never reached.
double beyond(Way way) {
  return way == Way::up ? std::numeric_limits<double>::max() : -std::numeric_limits<double>::max();
}

} // namespace

Point gradient_in(const Solid& solid, int tet, const std::vector<double>& f) {
  const auto& v = solid.corners(tet);
  const std::array<Point, 3> weight = weight_gradients(solid, tet);
  Point gradient{};
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) gradient[c] += (f[v[k + 1]] - f[v[0]]) * weight[k][c];
  return gradient;
}

Point point_at(const Solid& solid, const Location& location) {
  Point p{};
  for (int k = 0; k < 4; ++k)
    for (int c = 0; c < 3; ++c) p[c] += location.weight[k] * solid.point(solid.corners(location.tet)[k])[c];
  return p;
}

double value_at(const Solid& solid, const std::vector<double>& f, const Location& location) {
  double value = 0;
  for (int k = 0; k < 4; ++k)
    if (location.weight[k] > 0) value += location.weight[k] * f[solid.corners(location.tet)[k]];
  return value;
}

FiberField::FiberField(const Solid& solid, const Partition& partition, std::vector<double> w,
                       Direction direction)
    : solid_(&solid), partition_(&partition), w_(std::move(w)), base_(bases_of_vertices(solid, partition)),
      on_wall_(solid.mesh.points.size(), 0), corner_(solid.mesh.points.size()) {
  height_ = *std::max_element(w_.begin(), w_.end());
  gradient_.reserve(static_cast<std::size_t>(solid.size()));
  for (int t = 0; t < solid.size(); ++t) {
    gradient_.push_back(gradient_in(solid, t, w_));
    for (int k = 0; k < 4; ++k) corner_[solid.corners(t)[k]] = {t, k};
  }
  if (direction == Direction::smoothed) smoothed_ = smoothed(solid, partition, gradient_);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c)
      if (partition.patch[t] >= first_wall) on_wall_[solid.corner(t, c)] = 1;
}

Location FiberField::at_vertex(int v) const {
  Location at{corner_[v].tet, {}};
  at.weight[corner_[v].vertex] = 1;
  return at;
}

Location FiberField::on_triangle(int triangle, const std::array<double, 3>& weight) const {
  const TetFace face = solid_->face[triangle];
  const OrientedTetFace seen = outward(face);
  Location at{face.tet, {}};
  at.weight[seen.a] = weight[0];
  at.weight[seen.b] = weight[1];
  at.weight[seen.c] = weight[2];
  return at;
}

/// One fibre being followed.
class FiberField::Walker {
public:
  Walker(const FiberField& field, const Location& from, Way way, double level, Direction direction)
      : field_(field), solid_(*field.solid_), sign_(way == Way::up ? 1 : -1), level_(level),
        target_(way == Way::up ? ceiling_patch : floor_patch), is_smoothed_(direction == Direction::smoothed),
        at_(from) {
    tidy(at_.weight);
    on_wall_ = starts_on_wall();
  }

  Fiber run(std::vector<Point>* path) {
    // Fibres of good meshes meet a few times the cube root of the number of tetrahedra.
    const int most_steps = 1000 + 100 * static_cast<int>(std::cbrt(solid_.size()));
    Fiber fiber;
    if (path) path->push_back(point_at(solid_, at_));
    for (fiber.end = FiberEnd::budget; fiber.steps < most_steps; ++fiber.steps) {
      if (is_on_target()) {
        fiber.end = FiberEnd::base;
        break;
      }
      if (reached_ || sign_ * (value_at(solid_, field_.w_, at_) - level_) >= 0) {
        fiber.end = FiberEnd::level;
        break;
      }
      const Motion motion = in_the_middle(steepest());
      if (!(motion.squared_speed > 0)) {
        fiber.end = FiberEnd::stuck;
        break;
      }
      const Location before = at_;
      fiber.length += std::sqrt(motion.squared_speed) * go(motion);
      // Speeds in slivers may be more than doubles hold.
      if (!std::isfinite(at_.weight[0] + at_.weight[1] + at_.weight[2] + at_.weight[3])) {
        at_ = before;
        fiber.end = FiberEnd::stuck;
        break;
      }
      if (path) path->push_back(point_at(solid_, at_));
    }
    fiber.at = at_;
    return fiber;
  }

private:
  /// A way on, inside a tetrahedron or one of its faces or edges: how its weights change.
  struct Motion {
    int tet = -1;
    Weights rate{};
    double squared_speed = 0;
  };

  static void tidy(Weights& weight) {
    double sum = 0;
    for (double& x : weight) {
      if (x < near_zero) x = 0;
      sum += x;
    }
    for (double& x : weight) x /= sum;
  }

  bool is_on_target() const {
    for (int k = 0; k < 4; ++k)
      if (at_.weight[k] > 0 && field_.base_[solid_.corners(at_.tet)[k]] != target_) return false;
    return true;
  }

  /// The motion that the field has halfway, where that is another one and a way on, too.
  Motion in_the_middle(const Motion& motion) const {
    if (!is_smoothed_ || !(motion.squared_speed > 0)) return motion;
    const Weights start = seen_from(motion.tet);
    const double half = time_to_exit(motion, start).second / 2;
    Weights middle{};
    for (int k = 0; k < 4; ++k) middle[k] = std::max(0.0, start[k] + half * motion.rate[k]);
    // A motion in a face or an edge stays there.
    int zeros = 0;
    for (int k = 0; k < 4; ++k) zeros += middle[k] > 0 ? 0 : 1;
    Motion better = zeros == 0 ? in_tetrahedron(motion.tet, middle) : motion;
    better = checked(better, start);
    return better.squared_speed > 0 ? better : motion;
  }

  /// Which weight becomes 0 first, -1 if none does, and when.
  static std::pair<int, double> time_to_exit(const Motion& motion, const Weights& weight) {
    std::pair<int, double> first{-1, std::numeric_limits<double>::max()};
    for (int k = 0; k < 4; ++k)
      if (motion.rate[k] < 0 && weight[k] < -motion.rate[k] * first.second)
        first = {k, weight[k] / -motion.rate[k]};
    return first;
  }

  /// Moves on to where the first weights become 0, or to the level. Returns the time it takes.
  double go(const Motion& motion) {
    if (motion.tet != at_.tet) at_ = {motion.tet, seen_from(motion.tet)};
    auto [first, time] = time_to_exit(motion, at_.weight);
    double climb = 0;
    for (int k = 0; k < 4; ++k) climb += motion.rate[k] * field_.w_[solid_.corners(at_.tet)[k]];
    const double to_level = level_ - value_at(solid_, field_.w_, at_);
    if (climb * sign_ > 0 && std::abs(to_level) < std::abs(climb) * time) {
      time = to_level / climb;
      first = -1;
      reached_ = true;
    }
    for (int k = 0; k < 4; ++k) at_.weight[k] += time * motion.rate[k];
    if (first >= 0) at_.weight[first] = 0;
    tidy(at_.weight);
    return time;
  }

  /// The weights of the point by the corners of another tetrahedron around it.
  Weights seen_from(int tet) const {
    Weights weight{};
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4 && at_.weight[k] > 0; ++j)
        if (solid_.corners(tet)[j] == solid_.corners(at_.tet)[k]) weight[j] = at_.weight[k];
    return weight;
  }

  Motion steepest() {
    if (!on_wall_) {
      const int zeros = static_cast<int>(std::count(at_.weight.begin(), at_.weight.end(), 0.0));
      if (zeros == 0) return in_tetrahedron(at_.tet, at_.weight);
      if (zeros == 1) {
        if (const Motion through = through_face(); through.squared_speed > 0) return through;
      }
    }
    Motion best;
    const auto offer = [&](const Motion& motion) {
      if (motion.squared_speed > best.squared_speed) best = motion;
    };
    gather_star();
    for (const int tet : star_) {
      const Weights weight = seen_from(tet);
      if (!on_wall_) offer(in_tetrahedron(tet, weight));
      for (int f = 0; f < 4; ++f) {
        if (weight[f] > 0 || (on_wall_ && !is_wall({tet, f}))) continue;
        offer(in_face(tet, f, weight));
        for (int k = 0; k < 3; ++k) offer(on_edge(tet, f, k, weight));
      }
    }
    return best;
  }

  /// Into one of the two tetrahedra at a face; where one of them is a way on, it is the steepest.
  Motion through_face() const {
    const int f = static_cast<int>(std::find(at_.weight.begin(), at_.weight.end(), 0.0) - at_.weight.begin());
    const Motion here = in_tetrahedron(at_.tet, at_.weight);
    const int other = solid_.gluings.gluing({at_.tet, f}).tet;
    if (other < 0) return here;
    const Motion there = in_tetrahedron(other, seen_from(other));
    return there.squared_speed > here.squared_speed ? there : here;
  }

  /// What is only noise in a rate is 0, so that fibres along a face stay there; and weights that are 0 must
  /// not fall, else this is no way on.
  static Motion checked(Motion motion, const Weights& weight) {
    double greatest = 0;
    for (const double rate : motion.rate) greatest = std::max(greatest, std::abs(rate));
    for (int k = 0; k < 4; ++k) {
      if (weight[k] > 0) continue;
      if (std::abs(motion.rate[k]) < near_zero * greatest) motion.rate[k] = 0;
      if (motion.rate[k] < 0) return {};
    }
    return motion;
  }

  /// The field at a point of a tetrahedron, up or down.
  Point velocity(int tet, const Weights& weight) const {
    Point v{};
    for (int c = 0; c < 3; ++c) {
      if (!is_smoothed_) v[c] = sign_ * field_.gradient_[tet][c];
      for (int k = 0; k < 4 && is_smoothed_; ++k)
        v[c] += sign_ * weight[k] * field_.smoothed_[solid_.corners(tet)[k]][c];
    }
    return v;
  }

  Motion in_tetrahedron(int tet, const Weights& weight) const {
    const Point v = velocity(tet, weight);
    const std::array<Point, 3> gradient = weight_gradients(solid_, tet);
    Motion motion{tet, {}, dot(v, v)};
    for (int k = 0; k < 3; ++k) {
      motion.rate[k + 1] = dot(gradient[k], v);
      motion.rate[0] -= motion.rate[k + 1];
    }
    return checked(motion, weight);
  }

  /// Along the field projected to the face.
  Motion in_face(int tet, int face, const Weights& weight) const {
    const auto& corners = solid_.corners(tet);
    const auto& [a, b, c] = face_vertex[face];
    const Point p = between(solid_.point(corners[a]), solid_.point(corners[b]));
    const Point q = between(solid_.point(corners[a]), solid_.point(corners[c]));
    const Point v = velocity(tet, weight);
    const double pp = dot(p, p);
    const double pq = dot(p, q);
    const double qq = dot(q, q);
    const double determinant = pp * qq - pq * pq;
    Motion motion{tet, {}, 0};
    motion.rate[b] = (qq * dot(p, v) - pq * dot(q, v)) / determinant;
    motion.rate[c] = (pp * dot(q, v) - pq * dot(p, v)) / determinant;
    motion.rate[a] = -motion.rate[b] - motion.rate[c];
    motion.squared_speed = motion.rate[b] * dot(p, v) + motion.rate[c] * dot(q, v);
    return checked(motion, weight);
  }

  /// Along the field projected to the edge opposite the k-th corner of the face, if the point is on it.
  Motion on_edge(int tet, int face, int k, const Weights& weight) const {
    if (weight[face_vertex[face][k]] > 0) return {};
    const int a = face_vertex[face][(k + 1) % 3];
    const int b = face_vertex[face][(k + 2) % 3];
    const auto& corners = solid_.corners(tet);
    const Point p = between(solid_.point(corners[a]), solid_.point(corners[b]));
    const double along = dot(p, velocity(tet, weight));
    Motion motion{tet, {}, along * along / dot(p, p)};
    motion.rate[b] = along / dot(p, p);
    motion.rate[a] = -motion.rate[b];
    return checked(motion, weight);
  }

  bool is_wall(TetFace face) const {
    const int triangle = solid_.outside[4 * face.tet + face.face];
    return triangle >= 0 && field_.partition_->patch[triangle] >= first_wall;
  }

  /// All tetrahedra around the cell in which the point lies.
  void gather_star() {
    star_.assign(1, at_.tet);
    for (std::size_t next = 0; next < star_.size(); ++next) {
      const int tet = star_[next];
      const Weights weight = seen_from(tet);
      for (int f = 0; f < 4; ++f) {
        const int other = solid_.gluings.gluing({tet, f}).tet;
        if (weight[f] == 0 && other >= 0 && std::find(star_.begin(), star_.end(), other) == star_.end())
          star_.push_back(other);
      }
    }
  }

  bool starts_on_wall() {
    for (int k = 0; k < 4; ++k)
      if (at_.weight[k] > 0 && !field_.on_wall_[solid_.corners(at_.tet)[k]]) return false;
    gather_star();
    for (const int tet : star_) {
      const Weights weight = seen_from(tet);
      for (int f = 0; f < 4; ++f)
        if (weight[f] == 0 && is_wall({tet, f})) return true;
    }
    return false;
  }

  const FiberField& field_;
  const Solid& solid_;
  double sign_;
  double level_;
  int target_;
  bool is_smoothed_;
  Location at_;
  bool on_wall_ = false;
  bool reached_ = false;  ///< the level
  std::vector<int> star_; ///< kept for its memory
};

Fiber FiberField::run(const Location& from, Way way, double level, std::vector<Point>* path) const {
  const std::size_t start = path ? path->size() : 0;
  if (!smoothed_.empty()) {
    const Fiber fiber = Walker(*this, from, way, level, Direction::smoothed).run(path);
    if (fiber.end == FiberEnd::base || fiber.end == FiberEnd::level) return fiber;
    if (path) path->resize(start);
  }
  Fiber fiber = Walker(*this, from, way, level, Direction::gradient).run(path);
  fiber.by_gradient = !smoothed_.empty();
  return fiber;
}

Fiber FiberField::trace(const Location& from, Way way) const {
  return run(from, way, beyond(way), nullptr);
}

Fiber FiberField::trace(const Location& from, Way way, std::vector<Point>& path) const {
  return run(from, way, beyond(way), &path);
}

Fiber FiberField::trace_to(const Location& from, Way way, double level) const {
  return run(from, way, level, nullptr);
}

} // namespace tetrarch::product
