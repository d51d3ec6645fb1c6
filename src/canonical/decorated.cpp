// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/decorated.hpp"

#include "tetrarch/hyperbolic/real50.hpp"

#include <cmath>
#include <map>
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
Matrix3<Scalar> inverse(const Matrix3<Scalar>& s) {
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

} // namespace

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
  const Matrix3<Scalar> s_inverse = inverse<Scalar>(s);
  const Scalar off_there = there[far][far] - dot<Scalar>(b, apply<Scalar>(s_inverse, b));
  const Scalar off_here = here[f.face][f.face] - dot<Scalar>(c, apply<Scalar>(s_inverse, c));
  Across<Scalar> out;
  const Scalar af = -sqrt(Scalar(off_there / off_here));
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
Decorated<Scalar> move(const Decorated<Scalar>& m, const moves::Ball& ball, int p, int q,
                       const Scalar& product) {
  std::map<std::pair<int, int>, Scalar> known;
  for (const moves::Placed& placed : ball.before)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) known[{placed.corners[i], placed.corners[j]}] = m.gram[placed.tet][i][j];
  if (p != q) known[{p, q}] = known[{q, p}] = product;
  moves::Replaced replaced = moves::replace(m.tri, ball);
  Decorated<Scalar> out{std::move(replaced.tri), {}};
  out.gram.resize(static_cast<std::size_t>(out.tri.size()));
  for (std::size_t t = 0; t < m.gram.size(); ++t)
    if (replaced.image[t] >= 0) out.gram[replaced.image[t]] = m.gram[t];
  for (std::size_t k = 0; k < ball.after.size(); ++k)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        out.gram[replaced.first_new + k][i][j] = known.at({ball.after[k][i], ball.after[k][j]});
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
    if (total[v] > 0) scale[v] = sqrt(Scalar(total[v] / area));
  for (int t = 0; t < m.tri.size(); ++t)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) m.gram[t][i][j] *= scale[vertex[4 * t + i]] * scale[vertex[4 * t + j]];
}

#define TETRARCH_DECORATED(Scalar)                                                                           \
  template Across<Scalar> look_across(const Decorated<Scalar>&, TetFace);                                    \
  template Scalar product_across(const Decorated<Scalar>&, TetFace, const Across<Scalar>&);                  \
  template Decorated<Scalar> move(const Decorated<Scalar>&, const moves::Ball&, int, int, const Scalar&);    \
  template void set_cusp_areas(Decorated<Scalar>&, const std::vector<int>&, int, const Scalar&);
TETRARCH_DECORATED(double)
TETRARCH_DECORATED(hyperbolic::Real50)
#undef TETRARCH_DECORATED

} // namespace tetrarch::canonical
