// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/map.hpp"

#include "tetrarch/numeric/sparse_cholesky.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/polycube_pullback.hpp"
#include "tetrarch/solid/edge_weights.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;

/// The equations of one coordinate: a number for each plane of the axis, and for each vertex in none.
class Coordinate {
public:
  Coordinate(const product::Solid& solid, const Planes& planes, std::size_t axis,
             const std::vector<double>& wanted)
      : solid_(solid), axis_(axis), wanted_(wanted) {
    std::vector<int> of_plane(static_cast<std::size_t>(planes.count()), -1);
    plane_.resize(planes.holds.size());
    number_.resize(planes.holds.size(), -1);
    std::vector<char> used(planes.holds.size());
    for (const auto& tet : solid.mesh.tetrahedra)
      for (const int v : tet) used[v] = 1;
    for (std::size_t v = 0; v < planes.holds.size(); ++v) {
      const int plane = plane_[v] = planes.holds[v][axis];
      if (used[v] == 0 || (plane >= 0 && !wanted.empty())) continue;
      if (plane < 0) {
        number_[v] = size_++;
        continue;
      }
      if (of_plane[plane] < 0) of_plane[plane] = size_++;
      number_[v] = of_plane[plane];
    }
  }

  /// Of each vertex; nothing if there is no solution.
  std::optional<std::vector<double>> solved(const std::vector<solid::WeightedEdge>& edges, double scale) {
    std::vector<double> diagonal(static_cast<std::size_t>(size_));
    std::vector<double> right(static_cast<std::size_t>(size_));
    std::vector<std::vector<std::pair<int, double>>> below(static_cast<std::size_t>(size_));
    const auto add = [&](int here, int there, double weight) {
      const int row = number_[here];
      if (row < 0 || row == number_[there]) return;
      diagonal[row] += weight;
      right[row] += weight * scale * (solid_.point(here)[axis_] - solid_.point(there)[axis_]);
      if (number_[there] < 0)
        right[row] += weight * given(there);
      else if (number_[there] > row)
        below[row].emplace_back(number_[there], -weight);
    };
    for (const solid::WeightedEdge& e : edges) {
      add(e.from, e.to, e.weight);
      add(e.to, e.from, e.weight);
    }
    // A function is found up to a constant where no plane is given: its first number is 0.
    if (wanted_.empty() && size_ > 0) {
      diagonal[0] = 2 * std::max(diagonal[0], 1e-300);
    }
    SymmetricMatrix matrix = assembled(diagonal, below);
    std::vector<double> x(right.size());
    if (size_ > 0) {
      SparseCholesky solver(matrix);
      if (!solver.factor(matrix)) return std::nullopt;
      solver.solve(right, x);
    }
    std::vector<double> result;
    for (std::size_t v = 0; v < number_.size(); ++v) {
      result.push_back(number_[v] >= 0 ? x[number_[v]] : given(static_cast<int>(v)));
      if (!std::isfinite(result.back())) return std::nullopt;
    }
    return result;
  }

private:
  double given(int v) const { return plane_[v] >= 0 && !wanted_.empty() ? wanted_[plane_[v]] : 0; }

  static SymmetricMatrix assembled(const std::vector<double>& diagonal,
                                   std::vector<std::vector<std::pair<int, double>>>& below) {
    SymmetricMatrix matrix;
    matrix.first.push_back(0);
    for (std::size_t column = 0; column < diagonal.size(); ++column) {
      matrix.row.push_back(static_cast<int>(column));
      matrix.value.push_back(diagonal[column]);
      auto& entries = below[column];
      std::sort(entries.begin(), entries.end());
      for (std::size_t k = 0; k < entries.size(); ++k) {
        // A plane has many edges to a vertex.
        if (k > 0 && entries[k].first == entries[k - 1].first)
          matrix.value.back() += entries[k].second;
        else {
          matrix.row.push_back(entries[k].first);
          matrix.value.push_back(entries[k].second);
        }
      }
      matrix.first.push_back(static_cast<int>(matrix.row.size()));
    }
    return matrix;
  }

  const product::Solid& solid_;
  std::size_t axis_;
  const std::vector<double>& wanted_;
  std::vector<int> plane_;
  std::vector<int> number_; ///< of each vertex, -1 where its coordinate is given or of no matter
  int size_ = 0;
};

unfold::Freedom freedom_in(const std::array<int, 3>& holds) {
  using Kind = unfold::Freedom::Kind;
  const auto held = std::count_if(holds.begin(), holds.end(), [](int plane) { return plane >= 0; });
  unfold::Freedom result{held == 0   ? Kind::free
                         : held == 1 ? Kind::plane
                         : held == 2 ? Kind::line
                                     : Kind::fixed,
                         {}};
  // The normal of the only plane, or the axis of none.
  for (std::size_t a = 0; a < 3; ++a)
    if ((held == 1 && holds[a] >= 0) || (held == 2 && holds[a] < 0)) result.direction[a] = 1;
  return result;
}

/// Unfolds, while vertices that are not to move stay.
std::vector<Point> unfolded_where(const product::Solid& solid, const Planes& planes, double scale,
                                  std::vector<Point> start, const std::vector<char>& moves,
                                  const Progress& progress) {
  unfold::Problem problem;
  double total = 0;
  for (const auto& v : solid.mesh.tetrahedra) {
    if (std::none_of(v.begin(), v.end(), [&](int w) { return moves[w] != 0; })) continue;
    std::array<Vector, 3> edges{};
    for (std::size_t k = 0; k < 3; ++k) edges[k] = scale * (solid.point(v[k + 1]) - solid.point(v[0]));
    const double volume = dot(edges[0], cross(edges[1], edges[2]));
    if (!(volume > 0)) continue; // positive, but not after rounding
    total += volume;
    problem.elements.push_back(unfold::element(v, edges, volume));
  }
  for (unfold::Element& e : problem.elements)
    e.weight *= static_cast<double>(problem.elements.size()) / total;
  for (std::size_t v = 0; v < moves.size(); ++v)
    problem.freedom.push_back(moves[v] != 0 ? freedom_in(planes.holds[v])
                                            : unfold::Freedom{unfold::Freedom::Kind::fixed, {}});
  return unfold::unfold(problem, std::move(start), {}, progress).points;
}

} // namespace

std::optional<Image> least_squares_image(const product::Solid& solid, const Planes& planes, double scale,
                                         const std::vector<double>& wanted) {
  const std::vector<solid::WeightedEdge> edges = solid::edge_weights(solid.mesh);
  Image image{std::vector<Point>(solid.mesh.points.size()), wanted};
  image.of_planes.resize(static_cast<std::size_t>(planes.count()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto x = Coordinate(solid, planes, axis, wanted).solved(edges, scale);
    if (!x) return std::nullopt;
    for (std::size_t v = 0; v < x->size(); ++v) {
      image.points[v][axis] = (*x)[v];
      if (const int plane = planes.holds[v][axis]; plane >= 0) image.of_planes[plane] = (*x)[v];
    }
  }
  return image;
}

std::vector<Point> unfolded_image(const product::Solid& solid, const Planes& planes, double scale,
                                  std::vector<Point> start, const Progress& progress) {
  const std::vector<char> all(start.size(), 1);
  return unfolded_where(solid, planes, scale, std::move(start), all, progress);
}

std::vector<Point> locally_unfolded_image(const product::Solid& solid, const Planes& planes, double scale,
                                          std::vector<Point> start, int rings, const Progress& progress) {
  std::vector<char> moves(start.size());
  for (const int t : product::folded(solid, start))
    for (const int v : solid.corners(t)) moves[v] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = moves;
    for (const auto& tet : solid.mesh.tetrahedra)
      if (std::any_of(tet.begin(), tet.end(), [&](int v) { return before[v] != 0; }))
        for (const int v : tet) moves[v] = 1;
  }
  return unfolded_where(solid, planes, scale, std::move(start), moves, progress);
}

} // namespace tetrarch::polycube
