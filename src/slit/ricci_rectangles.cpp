// SPDX-License-Identifier: GPL-2.0-or-later
#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "vertex_scaling.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;
using surface::Side;

constexpr double quarter_turn = full_turn / 4;

/// Between corners, in sides: no vertex should have a part of two.
constexpr double least_gap = 1;

/// A loop of vertices with four corners: corner c is at place[c], in sides from loop[0] on, increasing.
struct CornerLoop {
  std::vector<int> vertex;
  std::array<double, 4> place{};

  int at(double where) const {
    const auto n = static_cast<double>(vertex.size());
    return vertex[static_cast<std::size_t>(where - n * std::floor(where / n)) % vertex.size()];
  }
  double gap(std::size_t c) const {
    return c < 3 ? place[c + 1] - place[c] : place[0] + static_cast<double>(vertex.size()) - place[3];
  }
};

CornerLoop corner_loop(const surface::Surface& surface, const std::vector<Side>& out,
                       const std::array<int, 4>& hints) {
  CornerLoop loop;
  const int first = hints[0];
  if (first < 0 || first >= surface.vertex_count() || !out[first].exists())
    throw InputError("vertex " + std::to_string(first) + " (counted from 0) is not on the boundary");
  int v = first;
  do {
    loop.vertex.push_back(v);
    v = surface.to(out[v]);
  } while (v != first);
  for (std::size_t c = 1; c < 4; ++c) {
    const auto found = std::find(loop.vertex.begin(), loop.vertex.end(), hints[c]);
    if (found == loop.vertex.end())
      throw InputError("vertex " + std::to_string(hints[c]) +
                       " (counted from 0) is not on the loop of vertex " + std::to_string(first));
    loop.place[c] = static_cast<double>(found - loop.vertex.begin());
  }
  std::sort(loop.place.begin(), loop.place.end());
  for (std::size_t c = 0; c < 4; ++c)
    if (loop.gap(c) < 2)
      throw InputError("two corners of the loop of vertex " + std::to_string(first) + " are neighbors on it");
  return loop;
}

class RectangleSearch {
public:
  RectangleSearch(const surface::IntrinsicTriangulation& start, std::vector<CornerLoop> loops,
                  const RectangleOptions& options, const Progress& progress)
      : scaling_(start, first_held(start.surface.vertex_count())), loops_(std::move(loops)),
        options_(options), progress_(progress) {}

  RicciRectangles run() {
    bool is_metric = solve();
    Eigen::VectorXd defect = defects(scaling_.metric());
    while (is_metric && error(defect) > options_.tolerance && result_.rounds < options_.most_rounds &&
           improve(defect))
      ++result_.rounds;
    result_.holonomy = error(defect);
    result_.found = is_metric && result_.holonomy <= options_.tolerance;
    report();
    return std::move(result_);
  }

private:
  static std::vector<char> first_held(int vertices) {
    std::vector<char> held(static_cast<std::size_t>(vertices), 0);
    held[0] = 1;
    return held;
  }
  Eigen::Index holes() const { return static_cast<Eigen::Index>(loops_.size()) - 1; }
  CornerLoop& hole(Eigen::Index h) { return loops_[static_cast<std::size_t>(h) + 1]; }
  const CornerLoop& hole(Eigen::Index h) const { return loops_[static_cast<std::size_t>(h) + 1]; }

  bool solve() {
    std::vector<double> curvature(scaling_.log_scale().size(), 0.0);
    for (const CornerLoop& loop : loops_)
      for (const double where : loop.place) {
        const double bend = &loop == &loops_[0] ? quarter_turn : -quarter_turn;
        const double part = where - std::floor(where);
        curvature[loop.at(where)] += (1 - part) * bend;
        curvature[loop.at(std::floor(where) + 1)] += part * bend;
      }
    const VertexScaling::Outcome outcome = scaling_.solve(curvature, options_.metric, progress_);
    result_.residual = outcome.residual;
    return outcome.found;
  }

  /// Of each hole: how far it is from closing, x and y, in circumferences; and how its first full side after
  /// corner 0 lies to the outer rectangle, up to right angles.
  Eigen::VectorXd defects(const surface::IntrinsicTriangulation& metric) const {
    const std::vector<Side> out = boundary_sides(metric.surface);
    const std::vector<double> curvature = curvatures_of(metric);
    const std::vector<Complex> corner = laid_out(metric).corner;
    const auto heading = [&](int v) {
      return std::arg(corner[out[v].previous().value] - corner[out[v].next().value]);
    };
    const double outer = heading(loops_[0].at(0));
    Eigen::VectorXd defect(3 * holes());
    for (Eigen::Index h = 0; h < holes(); ++h) {
      Complex place = 0;
      double direction = 0;
      double circumference = 0;
      for (const int v : hole(h).vertex) {
        const double length = metric.length[out[v].value];
        place += std::polar(length, direction);
        circumference += length;
        direction += curvature[metric.surface.to(out[v])];
      }
      defect[3 * h] = place.real() / circumference;
      defect[3 * h + 1] = place.imag() / circumference;
      const int after = hole(h).at(std::ceil(hole(h).place[0]));
      defect[3 * h + 2] = std::remainder(heading(after) - outer, quarter_turn);
    }
    return defect;
  }

  /// Greatest of the distances and angles.
  static double error(const Eigen::VectorXd& defect) {
    double most = 0;
    for (Eigen::Index h = 0; h < defect.size() / 3; ++h)
      most = numeric::maximum(
          most, numeric::maximum(std::hypot(defect[3 * h], defect[3 * h + 1]), std::abs(defect[3 * h + 2])));
    return most;
  }

  /// By the places of all corners: how numbers respond is linear algebra, what that does to the holes is seen
  /// by going a little that way.
  Eigen::MatrixXd derivatives(const Eigen::VectorXd& defect) {
    std::vector<std::vector<double>> changes;
    for (Eigen::Index h = 0; h < holes(); ++h)
      for (const double where : hole(h).place) {
        auto& change = changes.emplace_back(scaling_.log_scale().size(), 0.0);
        // At a vertex itself the mean of both sides, as a step may go either way.
        const bool at_vertex = where == std::floor(where);
        const double bend = at_vertex ? quarter_turn / 2 : quarter_turn;
        change[hole(h).at(at_vertex ? where - 1 : where)] = bend;
        change[hole(h).at(std::floor(where) + 1)] = -bend;
      }
    changes = scaling_.responses(std::move(changes));
    Eigen::MatrixXd derivative(defect.size(), 4 * holes());
    constexpr double little = 1e-6;
    for (Eigen::Index k = 0; k < derivative.cols(); ++k) {
      std::vector<double> moved = scaling_.log_scale();
      for (std::size_t v = 0; v < moved.size(); ++v)
        moved[v] += little * changes[static_cast<std::size_t>(k)][v];
      surface::IntrinsicTriangulation metric = scaling_.metric();
      metric.length = scaling_.lengths(moved);
      Eigen::VectorXd change = defects(metric) - defect;
      for (Eigen::Index h = 0; h < holes(); ++h)
        change[3 * h + 2] = std::remainder(change[3 * h + 2], quarter_turn);
      derivative.col(k) = change / little;
    }
    return derivative;
  }

  /// Moves the corners by the least step that would do away with the defect, or where that makes it no less,
  /// by damped ones, which turn to the steepest descent as they get shorter. False if no step helps.
  bool improve(Eigen::VectorXd& defect) {
    const Eigen::MatrixXd derivative = derivatives(defect);
    const Eigen::MatrixXd normal = derivative * derivative.transpose();
    const std::vector<CornerLoop> start = loops_;
    const std::vector<double> log_scale = scaling_.log_scale();
    constexpr double least_damping = 1e-5;
    constexpr double most_damping = 1e5;
    for (double damping = 0; damping<most_damping; damping = damping> 0 ? 10 * damping : least_damping) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal().array() += damping * normal.trace() / static_cast<double>(normal.rows());
      const Eigen::VectorXd step =
          -derivative.transpose() * damped.completeOrthogonalDecomposition().solve(defect);
      loops_ = start;
      if (!move_corners(step)) continue;
      if (solve()) {
        const Eigen::VectorXd next = defects(scaling_.metric());
        if (next.norm() < defect.norm()) {
          defect = next;
          return true;
        }
      }
      scaling_.move_to(log_scale);
    }
    loops_ = start;
    solve();
    return false;
  }

  /// False where two corners would come nearer than half the way to what is allowed.
  bool move_corners(const Eigen::VectorXd& step) {
    const std::vector<CornerLoop> start = loops_;
    for (Eigen::Index k = 0; k < step.size(); ++k)
      hole(k / 4).place[static_cast<std::size_t>(k % 4)] += step[k];
    for (std::size_t h = 0; h < loops_.size(); ++h)
      for (std::size_t c = 0; c < 4; ++c)
        if (loops_[h].gap(c) - least_gap < (start[h].gap(c) - least_gap) / 2) return false;
    return true;
  }

  void report() {
    for (const CornerLoop& loop : loops_) {
      auto& corners = result_.corners.emplace_back();
      for (std::size_t c = 0; c < 4; ++c)
        corners[c] = {loop.at(loop.place[c]), loop.place[c] - std::floor(loop.place[c])};
    }
    result_.position = laid_out(scaling_.metric()).position;
    const auto& outer = result_.corners[0];
    const Complex origin = result_.position[outer[0].vertex];
    const Complex along = result_.position[outer[1].vertex] - origin;
    for (Complex& z : result_.position) z = (z - origin) / along;
    result_.height = result_.position[outer[3].vertex].imag();
  }

  VertexScaling scaling_;
  std::vector<CornerLoop> loops_;
  RectangleOptions options_;
  const Progress& progress_;
  RicciRectangles result_;
};

} // namespace

RicciRectangles ricci_rectangles(const surface::TriangleMesh& mesh,
                                 const std::vector<std::array<int, 4>>& hints,
                                 const RectangleOptions& options, const Progress& progress) {
  const SurfaceType type = surface::type_of(mesh.surface);
  const auto loops = surface::boundary_loops(mesh);
  if (!type.orientable || loops.empty() || type.euler != 2 - static_cast<int>(loops.size()))
    throw InputError("a rectangle with holes needs a sphere with holes, but this surface has type " +
                     type.str());
  if (hints.size() != loops.size())
    throw InputError("each of the " + std::to_string(loops.size()) + " loops needs its four corners, not " +
                     std::to_string(hints.size()) + " of them");
  const surface::IntrinsicTriangulation start = surface::intrinsic_delaunay(mesh);
  const std::vector<Side> out = boundary_sides(mesh.surface);
  const std::vector<int> loop_of = surface::loops_of_vertices(loops, mesh.surface);
  std::vector<char> met(loops.size(), 0);
  std::vector<CornerLoop> corners;
  for (const auto& hint : hints) {
    corners.push_back(corner_loop(mesh.surface, out, hint));
    if (std::exchange(met[loop_of[hint[0]]], 1))
      throw InputError("the loop of vertex " + std::to_string(hint[0]) + " has two sets of corners");
  }
  return RectangleSearch(start, std::move(corners), options, progress).run();
}

} // namespace tetrarch::slit
