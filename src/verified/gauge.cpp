// SPDX-License-Identifier: GPL-2.0-or-later
#include "gauge.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace tetrarch::verified {
namespace {

using hyperbolic::VertexType;
using numeric::Ball;

template <class Scalar>
using Vector3 = std::array<Scalar, 3>;

/// Motions whose columns are dependent up to this part are taken for dependent.
constexpr double dependent = 1e-9;

template <class Scalar>
Vector3<Scalar> cross(const Vector3<Scalar>& x, const Vector3<Scalar>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

/// The cosines of the angles at vertex v of a tetrahedron between its edges to a and b: inner products of
/// v_a + <v_a, v> v, of length 1. Entries with a or b = v mean nothing.
template <class Scalar>
numeric::Matrix4<Scalar> cosines(const numeric::Matrix4<Scalar>& w, int v) {
  using std::sqrt;
  numeric::Matrix4<Scalar> c;
  std::array<Scalar, 4> size;
  for (int a = 0; a < 4; ++a)
    if (a != v) size[a] = sqrt(Scalar(w[a][a] + w[v][a] * w[v][a]));
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      if (a != v && b != v) c[a][b] = (w[a][b] + w[v][a] * w[v][b]) / (size[a] * size[b]);
  return c;
}

/// The unit vector z with x.z = xz and y.z = yz, on the side of x cross y that `sign` tells; x.y = xy.
template <class Scalar>
Vector3<Scalar> third(const Vector3<Scalar>& x, const Vector3<Scalar>& y, const Scalar& xy, const Scalar& xz,
                      const Scalar& yz, int sign) {
  using std::sqrt;
  const Scalar square = 1 - xy * xy;
  const Scalar volume = sqrt(Scalar(square - xz * xz - yz * yz + 2 * xy * xz * yz));
  const Vector3<Scalar> normal = cross<Scalar>(x, y);
  Vector3<Scalar> z;
  for (int k = 0; k < 3; ++k)
    z[k] = ((xz - xy * yz) * x[k] + (yz - xy * xz) * y[k] + sign * volume * normal[k]) / square;
  return z;
}

/// Whether (a, b, c), three of 0..3, is an even permutation of its increasing order.
int sign_of(int a, int b, int c) {
  return ((a > b) != (a > c)) != (b > c) ? -1 : 1;
}

} // namespace

Gauge::Gauge(const Triangulation& tri, const Skeleton& skeleton)
    : tri_(tri), skeleton_(skeleton), types_(hyperbolic::vertex_types(skeleton)) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    if (types_[v] == VertexType::ideal) cusps_.push_back(v);
    if (types_[v] == VertexType::finite) layouts_.push_back(lay_out(v));
  }
  points_ = static_cast<int>(layouts_.size());
}

Gauge::Point Gauge::lay_out(VertexId v) const {
  Point point;
  std::set<std::pair<int, int>> seen;     // triangles
  std::set<std::pair<EdgeId, bool>> ends; // and which end of the edge it is
  const TetVertex first = skeleton_.preimages(v).front();
  point.steps.push_back({first.tet, first.vertex, -1, 0});
  seen.insert({first.tet, first.vertex});
  for (std::size_t k = 0; k < point.steps.size(); ++k) {
    const Step here = point.steps[k];
    for (int w = 0; w < 4; ++w) {
      if (w == here.vertex) continue;
      const EdgeId e = skeleton_.edge({here.tet, edge_number[here.vertex][w]});
      if (ends.insert({e, skeleton_.runs_along({here.tet, here.vertex, w})}).second)
        point.corners.push_back({static_cast<int>(k), w, e});
      const Gluing g = tri_.gluing({here.tet, w});
      if (seen.insert({g.tet, g.perm[here.vertex]}).second)
        point.steps.push_back({g.tet, g.perm[here.vertex], static_cast<int>(k), w});
    }
  }
  return point;
}

template <class Scalar>
std::vector<std::array<Vector3<Scalar>, 4>>
Gauge::directions(const Point& point, const hyperbolic::Metric<Scalar>& lengths) const {
  using std::sqrt;
  std::vector<std::array<Vector3<Scalar>, 4>> at(point.steps.size());
  std::vector<int> handed(point.steps.size(), 1); // the sign of the determinant, corners in increasing order
  for (std::size_t k = 0; k < point.steps.size(); ++k) {
    const Step& step = point.steps[k];
    const auto c = cosines(hyperbolic::gram_matrix(hyperbolic::lengths_at(skeleton_, lengths, step.tet),
                                                   hyperbolic::types_at(skeleton_, types_, step.tet)),
                           step.vertex);
    if (step.from < 0) {
      const auto [a, b, d] = face_vertex[step.vertex];
      at[k][a] = {Scalar(1), Scalar(0), Scalar(0)};
      at[k][b] = {c[a][b], Scalar(sqrt(Scalar(1 - c[a][b] * c[a][b]))), Scalar(0)};
      at[k][d] = third<Scalar>(at[k][a], at[k][b], c[a][b], c[a][d], c[b][d], 1);
      continue;
    }
    const Step& before = point.steps[step.from];
    const Perm4 p = tri_.gluing({before.tet, step.side}).perm;
    std::array<int, 2> shared{}; // vertices of the tetrahedron before
    std::size_t count = 0;
    for (int w = 0; w < 4; ++w)
      if (w != before.vertex && w != step.side) shared[count++] = w;
    const auto [a, b] = shared;
    // The new corner is on the other side of the shared one.
    const int side = -handed[step.from] * sign_of(a, b, step.side);
    const int far = p[step.side];
    at[k][p[a]] = at[step.from][a];
    at[k][p[b]] = at[step.from][b];
    at[k][far] = third<Scalar>(at[k][p[a]], at[k][p[b]], c[p[a]][p[b]], c[p[a]][far], c[p[b]][far], side);
    handed[k] = side * sign_of(p[a], p[b], far);
  }
  return at;
}

template <class Scalar>
std::vector<std::vector<Scalar>> Gauge::motions(const hyperbolic::Metric<Scalar>& lengths) const {
  std::vector<std::vector<Scalar>> m(static_cast<std::size_t>(skeleton_.edge_count()),
                                     std::vector<Scalar>(static_cast<std::size_t>(dimensions()), Scalar(0)));
  std::size_t column = 0;
  for (const VertexId v : cusps_) {
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      const auto [a, b] = skeleton_.ends(e);
      m[e.value][column] += (a == v ? 1 : 0) + (b == v ? 1 : 0);
    }
    ++column;
  }
  for (const Point& point : layouts_) {
    const auto at = directions<Scalar>(point, lengths);
    for (const Corner& corner : point.corners)
      for (std::size_t k = 0; k < 3; ++k)
        m[corner.edge.value][column + k] += at[corner.triangle][corner.towards][k];
    column += 3;
  }
  return m;
}

template std::vector<std::vector<double>> Gauge::motions(const hyperbolic::Metric<double>&) const;
template std::vector<std::vector<Ball>> Gauge::motions(const hyperbolic::Metric<Ball>&) const;

std::vector<EdgeId> Gauge::choose(const hyperbolic::Metric<double>& lengths) const {
  const auto m = motions(lengths);
  Eigen::MatrixXd transposed(dimensions(), skeleton_.edge_count());
  for (int d = 0; d < dimensions(); ++d)
    for (int e = 0; e < skeleton_.edge_count(); ++e) transposed(d, e) = m[e][d];
  if (!transposed.allFinite()) return {};
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivots(transposed);
  pivots.setThreshold(dependent);
  std::vector<EdgeId> chosen;
  for (Eigen::Index k = 0; k < pivots.rank(); ++k) chosen.emplace_back(pivots.colsPermutation().indices()[k]);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

int Gauge::most_ends(const std::vector<EdgeId>& dropped) const {
  int most = 0;
  for (const Point& point : layouts_) {
    int count = 0;
    for (const Corner& corner : point.corners)
      count += std::binary_search(dropped.begin(), dropped.end(), corner.edge) ? 1 : 0;
    most = std::max(most, count);
  }
  return most;
}

bool Gauge::dropped_vanish(const std::vector<EdgeId>& dropped, const hyperbolic::Metric<Ball>& box,
                           const hyperbolic::Metric<Ball>& curvature) const {
  const int size = dimensions();
  const auto m = motions(box);
  if (static_cast<int>(dropped.size()) != size) return false;
  Eigen::MatrixXd middle(size, size);
  Ball largest = 0; // of the dropped curvatures
  for (int j = 0; j < size; ++j) {
    for (int d = 0; d < size; ++d) middle(d, j) = numeric::to_double(m[dropped[j].value][d]);
    const Ball here = numeric::upper_end(abs(curvature[dropped[j]]));
    if (!(here <= largest)) largest = here; // what is no number stays
  }
  const Eigen::MatrixXd inverse = middle.inverse();
  if (!inverse.allFinite()) return false;
  const int ends = most_ends(dropped);
  if (!(ends * largest <= 2)) return false;
  for (int i = 0; i < size; ++i) {
    Ball norm = 0;
    Ball defect = 0;
    for (int d = 0; d < size; ++d) norm += Ball(std::abs(inverse(i, d)));
    for (int j = 0; j < size; ++j) {
      Ball entry = i == j ? 1 : 0;
      for (int d = 0; d < size; ++d) entry -= Ball(inverse(i, d)) * m[dropped[j].value][d];
      defect += abs(entry);
    }
    // |K_i| <= defect |K| + norm n^2 |K|^2 / 2 must be impossible for the greatest |K_i| that is not 0.
    if (!(defect + norm * (ends * ends) * largest / 2 < 1)) return false;
  }
  return true;
}

} // namespace tetrarch::verified
