// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/domain.hpp"
#include "tetrarch/embed/mobius.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "unroll.hpp"

#include <cmath>

namespace tetrarch::embed {
namespace {

/// Raises `most` to |x|; what is not a number stays.
template <class Scalar>
void raise(double& most, const Scalar& x) {
  const double value = std::abs(static_cast<double>(x));
  if (!(value <= most)) most = value;
}

/// Both sides of every face: the corners on this side, and those on the other side taken across.
template <class Scalar>
double seam(const Triangulation& tri, const Domain<Scalar>& domain) {
  double most = 0;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const auto [other, perm] = tri.gluing({t, f});
      const Matrix4<Scalar> across = domain.across({t, f});
      for (const int i : face_vertex[f])
        for (const int j : face_vertex[f]) {
          if (i == j) continue;
          const auto there = corner(domain.vertices[other], domain.types[other], perm[i], perm[j]);
          raise(most, distance(corner(domain.vertices[t], domain.types[t], i, j), across * there));
        }
    }
  return most;
}

template <class Scalar>
double relator(const Domain<Scalar>& domain) {
  double most = 0;
  for (const algebra::Word& word : domain.group.presentation.relators)
    raise(most, relative_difference(holonomy_of(domain, word), identity<Scalar>()));
  return most;
}

template <class Scalar>
double relator_sl2c(const Domain<Scalar>& domain) {
  std::vector<Mobius<Scalar>> letters;
  std::vector<Mobius<Scalar>> inverses;
  for (const Matrix4<Scalar>& g : domain.holonomy) {
    letters.push_back(mobius_of(g));
    inverses.push_back(mobius_of(inverse(g)));
  }
  double most = 0;
  for (const algebra::Word& word : domain.group.presentation.relators) {
    Mobius<Scalar> m;
    for (const int letter : word) {
      const auto g = static_cast<std::size_t>(std::abs(letter)) - 1;
      m = composed(m, letter > 0 ? letters[g] : inverses[g]);
    }
    raise(most, relative_difference(m, Mobius<Scalar>()));
  }
  return most;
}

/// The angle between two faces, without the loss of digits that acos has near 0 and pi.
template <class Scalar>
Scalar angle_between(const Vector4<Scalar>& n, const Vector4<Scalar>& m) {
  using std::atan2;
  using std::sqrt;
  const auto length = [](const Vector4<Scalar>& v) {
    const Scalar square = inner(v, v);
    return square > 0 ? Scalar(sqrt(square)) : Scalar(0);
  };
  return 2 * atan2(length(combination(Scalar(1), n, Scalar(1), m)),
                   length(combination(Scalar(1), n, Scalar(-1), m)));
}

template <class Scalar>
double edge_rotation(const Skeleton& skeleton, const Domain<Scalar>& domain) {
  double most = 0;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    Scalar sum = -2 * numeric::pi<Scalar>();
    for (const Walk& w : skeleton.around(e)) {
      const auto& v = domain.vertices[w.tet];
      sum += angle_between(face_normal(v, w.left_face().face), face_normal(v, w.right_face().face));
    }
    raise(most, sum);
  }
  return most;
}

/// tan(area / 2) = |det(n, a, b, c)| / (1 + cosh + cosh + cosh), the sides being those between the corners.
template <class Scalar>
Scalar triangle_area(const Vector4<Scalar>& normal, const std::array<Vector4<Scalar>, 3>& corners) {
  using std::abs;
  using std::atan2;
  const auto& [a, b, c] = corners;
  const Scalar det = inner(cross(a, b, c), normal);
  return 2 * atan2(Scalar(abs(det)), Scalar(1 - inner(a, b) - inner(b, c) - inner(c, a)));
}

template <class Scalar>
double gauss_bonnet(const Skeleton& skeleton, const Domain<Scalar>& domain) {
  double most = 0;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    if (hyperbolic::vertex_type(skeleton.link(v)) != VertexType::hyperideal) continue;
    Scalar sum = 2 * numeric::pi<Scalar>() * skeleton.link(v).euler;
    for (const TetVertex at : skeleton.preimages(v))
      sum += triangle_area(domain.vertices[at.tet][at.vertex], corners_of(domain, at));
    raise(most, sum);
  }
  return most;
}

/// Unrolls the triangles of a boundary component over the whole of one lift of it, and measures how far their
/// corners are from the plane of the first one.
template <class Scalar>
double boundary_plane(const Triangulation& tri, const Skeleton& skeleton, const Domain<Scalar>& domain,
                      VertexId v) {
  using std::asinh;
  double most = 0;
  const auto triangles = unroll(tri, skeleton, domain, v);
  const TetVertex first = triangles.front().at;
  const Vector4<Scalar>& normal = domain.vertices[first.tet][first.vertex];
  for (const UnrolledTriangle<Scalar>& triangle : triangles)
    for (const Vector4<Scalar>& x : corners_of(domain, triangle.at))
      raise(most, asinh(inner(triangle.copy * x, normal)));
  return most;
}

} // namespace

template <class Scalar>
Residuals residuals(const Triangulation& tri, const Skeleton& skeleton, const Domain<Scalar>& domain) {
  skeleton.require_current(tri);
  Residuals found;
  found.seam = seam(tri, domain);
  found.relator = relator(domain);
  found.relator_sl2c = relator_sl2c(domain);
  found.edge_rotation = edge_rotation(skeleton, domain);
  found.gauss_bonnet = gauss_bonnet(skeleton, domain);
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (hyperbolic::vertex_type(skeleton.link(v)) == VertexType::hyperideal)
      raise(found.boundary_plane, boundary_plane(tri, skeleton, domain, v));
  return found;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Residuals residuals(const Triangulation&, const Skeleton&, const Domain<Scalar>&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
