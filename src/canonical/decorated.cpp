// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/decorated.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tetrarch::canonical {
namespace {

template <class Scalar>
using Vector3 = std::array<Scalar, 3>;
template <class Scalar>
using Matrix3 = std::array<Vector3<Scalar>, 3>;

template <class Scalar>
Scalar dot(const Vector3<Scalar>& x, const Vector3<Scalar>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// The inverse of a symmetric 3x3 matrix by cofactors.
template <class Scalar>
Matrix3<Scalar> inverse_matrix(const Matrix3<Scalar>& s) {
  Matrix3<Scalar> c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3;
      const int i2 = (i + 2) % 3;
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      c[i][j] = s[i1][j1] * s[i2][j2] - s[i1][j2] * s[i2][j1];
    }
  }
  const Scalar det = dot<Scalar>(s[0], c[0]);
  for (auto& row : c)
    for (Scalar& x : row) x /= det;
  return c;
}

template <class Scalar>
Vector3<Scalar> apply(const Matrix3<Scalar>& m, const Vector3<Scalar>& x) {
  return {dot<Scalar>(m[0], x), dot<Scalar>(m[1], x), dot<Scalar>(m[2], x)};
}

/// Whether a sum of areas is one of a cusp rather than of nothing. A ball that may hold 0 is none the less.
template <class Scalar>
bool is_area(const Scalar& total) {
  return total > 0;
}
template <>
bool is_area(const numeric::Ball& total) {
  return total != numeric::Ball(0);
}

/// Vertex classes by t-vertex (4 t + v).
std::vector<int> vertex_numbers(const Skeleton& skeleton) {
  std::vector<int> vertex;
  vertex.reserve(4 * static_cast<std::size_t>(skeleton.tetrahedron_count()));
  for (int t = 0; t < skeleton.tetrahedron_count(); ++t)
    for (int v = 0; v < 4; ++v) vertex.push_back(skeleton.vertex({t, v}).value);
  return vertex;
}

} // namespace

template <class Scalar>
Decorated<Scalar> decorate(const Triangulation& tri, const Skeleton& skeleton,
                           const hyperbolic::Metric<Scalar>& lengths) {
  skeleton.require_current(tri);
  const auto types = hyperbolic::vertex_types(skeleton);
  Decorated<Scalar> m{tri, {}, std::vector<bool>(static_cast<std::size_t>(tri.size()), false)};
  m.gram.reserve(static_cast<std::size_t>(tri.size()));
  for (int t = 0; t < tri.size(); ++t)
    m.gram.push_back(hyperbolic::gram_matrix(hyperbolic::lengths_at(skeleton, lengths, t),
                                             hyperbolic::types_at(skeleton, types, t)));
  set_cusp_areas(m, vertex_numbers(skeleton), skeleton.vertex_count(), Scalar(cusp_area));
  return m;
}

hyperbolic::Metric<double> edge_lengths(Decorated<double> m, const Skeleton& skeleton) {
  skeleton.require_current(m.tri);
  // A regular ideal tetrahedron with lengths 0 has cross-sections of area sqrt(3) / 4, and four of them.
  const double area = std::sqrt(3.0) * m.tri.size() / skeleton.vertex_count();
  set_cusp_areas(m, vertex_numbers(skeleton), skeleton.vertex_count(), area);
  const auto types = hyperbolic::vertex_types(skeleton);
  hyperbolic::Metric<double> lengths(skeleton.edge_count());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const Walk& w = skeleton.around(e).front();
    const auto [p, q] = skeleton.ends(e);
    lengths[e] = hyperbolic::signed_length(types[p], types[q], m.gram[w.tet][w.from()][w.to()]);
  }
  return lengths;
}

template <class Scalar>
Across<Scalar> look_across(const Decorated<Scalar>& m, TetFace f) {
  using std::sqrt;
  const Gluing g = m.tri.gluing(f);
  const Gram<Scalar>& here = m.gram[f.tet];
  const Gram<Scalar>& there = m.gram[g.tet];
  const auto& shared = face_vertex[f.face];
  const int far = g.perm[f.face];
  Matrix3<Scalar> s;
  Vector3<Scalar> b;
  Vector3<Scalar> c;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) s[i][j] = here[shared[i]][shared[j]];
    c[i] = here[shared[i]][f.face];
    b[i] = there[g.perm[shared[i]]][far];
  }
  // Off the plane of the face both far vertices have a component; the squares of these fix a[f.face] up to
  // its sign.
  const Matrix3<Scalar> s_inverse = inverse_matrix<Scalar>(s);
  Across<Scalar> out;
  Scalar af(0);
  if (!m.is_flat(g.tet)) { // the root would make 1e-8 of a flat one's 1e-16
    const Scalar off_there = there[far][far] - dot<Scalar>(b, apply<Scalar>(s_inverse, b));
    const Scalar off_here = here[f.face][f.face] - dot<Scalar>(c, apply<Scalar>(s_inverse, c));
    af = -sqrt(Scalar(off_there / off_here));
  }
  const Vector3<Scalar> as = apply<Scalar>(s_inverse, {b[0] - c[0] * af, b[1] - c[1] * af, b[2] - c[2] * af});
  out.a[f.face] = af;
  out.tilt = af - 1;
  for (int i = 0; i < 3; ++i) {
    out.a[shared[i]] = as[i];
    out.tilt += as[i];
  }
  return out;
}

template <class Scalar>
Scalar product_across(const Decorated<Scalar>& m, TetFace f, const Across<Scalar>& across) {
  Scalar sum(0);
  for (int j = 0; j < 4; ++j) sum += across.a[j] * m.gram[f.tet][j][f.face];
  return sum;
}

template <class Scalar>
Scalar cone_volume(const Decorated<Scalar>& m, int tet) {
  using std::sqrt;
  if (m.is_flat(tet)) return Scalar(0);
  const Scalar square = -numeric::determinant(m.gram[tet]);
  return square > 0 ? Scalar(sqrt(square)) : Scalar(0);
}

template <class Scalar>
Decorated<Scalar> move(const Decorated<Scalar>& m, const moves::Ball& ball, int p, int q,
                       const Scalar& product) {
  constexpr int most_corners = 6;
  std::array<std::array<Scalar, most_corners>, most_corners> known{};
  for (const moves::Placed& placed : ball.before)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) known[placed.corners[i]][placed.corners[j]] = m.gram[placed.tet][i][j];
  if (p != q) known[p][q] = known[q][p] = product;
  moves::Replaced replaced = moves::replace(m.tri, ball);
  Decorated<Scalar> out{std::move(replaced.tri), {}, {}};
  out.gram.resize(static_cast<std::size_t>(out.tri.size()));
  out.flat.assign(static_cast<std::size_t>(out.tri.size()), false);
  for (std::size_t t = 0; t < m.gram.size(); ++t) {
    const int image = replaced.image[t];
    if (image < 0) continue;
    out.gram[image] = m.gram[t];
    out.flat[image] = m.is_flat(static_cast<int>(t));
  }
  for (std::size_t k = 0; k < ball.after.size(); ++k)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        out.gram[replaced.first_new + k][i][j] = known[ball.after[k][i]][ball.after[k][j]];
  return out;
}

template <class Scalar>
void set_cusp_areas(Decorated<Scalar>& m, const std::vector<int>& vertex, int vertex_count,
                    const Scalar& area) {
  using std::sqrt;
  std::vector<Scalar> total(static_cast<std::size_t>(vertex_count), Scalar(0));
  for (int t = 0; t < m.tri.size(); ++t) {
    const Gram<Scalar>& w = m.gram[t];
    for (int i = 0; i < 4; ++i) {
      if (w[i][i] != 0) continue;
      Vector3<Scalar> side; // squares of the sides of the cross-section
      for (int c = 0; c < 3; ++c) {
        const int j = face_vertex[i][c];
        const int k = face_vertex[i][(c + 1) % 3];
        side[c] =
            w[j][j] / (w[i][j] * w[i][j]) + w[k][k] / (w[i][k] * w[i][k]) - 2 * w[j][k] / (w[i][j] * w[i][k]);
      }
      const Scalar sum = side[0] + side[1] + side[2];
      total[vertex[4 * t + i]] += sqrt(Scalar(sum * sum - 2 * dot<Scalar>(side, side))) / 4; // Heron
    }
  }
  std::vector<Scalar> scale(total.size(), Scalar(1));
  for (std::size_t v = 0; v < total.size(); ++v)
    if (is_area<Scalar>(total[v])) scale[v] = sqrt(Scalar(total[v] / area));
  for (int t = 0; t < m.tri.size(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) m.gram[t][i][j] *= scale[vertex[4 * t + i]] * scale[vertex[4 * t + j]];
}

#define TETRARCH_DECORATED(Scalar)                                                                           \
  template Decorated<Scalar> decorate(const Triangulation&, const Skeleton&,                                 \
                                      const hyperbolic::Metric<Scalar>&);                                    \
  template Across<Scalar> look_across(const Decorated<Scalar>&, TetFace);                                    \
  template Scalar product_across(const Decorated<Scalar>&, TetFace, const Across<Scalar>&);                  \
  template void set_cusp_areas(Decorated<Scalar>&, const std::vector<int>&, int, const Scalar&);
TETRARCH_FOR_EACH_FORMULA(TETRARCH_DECORATED)
#undef TETRARCH_DECORATED

#define TETRARCH_DECORATED(Scalar)                                                                           \
  template Scalar cone_volume(const Decorated<Scalar>&, int);                                                \
  template Decorated<Scalar> move(const Decorated<Scalar>&, const moves::Ball&, int, int, const Scalar&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_DECORATED)
#undef TETRARCH_DECORATED

} // namespace tetrarch::canonical
