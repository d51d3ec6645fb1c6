// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The arithmetic of one tetrahedron that the solvers run in their inner loop: inner products in, angles and
/// their derivatives out, nothing allocated.

#include "tetrarch/core/tet.hpp"
#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include <cmath>
#include <type_traits>

namespace tetrarch::hyperbolic::kernel {

/// max |x| over a range of scalars; not a number if one of them is not.
template <class Range>
auto largest_magnitude(const Range& range) {
  using std::abs;
  using std::isnan;
  std::decay_t<decltype(*range.begin())> worst = 0;
  for (const auto& x : range) {
    if (isnan(x)) return x;
    if (abs(x) > worst) worst = abs(x);
  }
  return worst;
}

/// What a tetrahedron needs to know of an edge: w = <v,v'> and g = -dw/dl = sqrt(w^2 - <v,v><v',v'>).
template <class Scalar>
struct EdgeForm {
  Scalar w;
  Scalar g;
};

/// A negative length between hyperideal (or between finite) vertices is read as 0: -cosh l alone would fold
/// it back.
template <class Scalar>
EdgeForm<Scalar> edge_form(VertexType a, VertexType b, const Scalar& length) {
  using std::cosh;
  using std::exp;
  using std::sinh;
  if (a == VertexType::ideal || b == VertexType::ideal) {
    const Scalar e = a == b ? Scalar(2 * exp(length)) : Scalar(exp(length));
    return {-e, e};
  }
  if (a != b) return {-sinh(length), cosh(length)};
  if (length <= 0) return {Scalar(-1), Scalar(0)};
  return {-cosh(length), sinh(length)};
}

/// Of an edge whose two truncating planes touch, or of one with an ideal end on the other's plane. No angle
/// depends on it: they are 0 there.
template <class Scalar>
EdgeForm<Scalar> null_form(VertexType a, VertexType b) {
  return {Scalar(a == VertexType::ideal || b == VertexType::ideal ? 0 : -1), Scalar(0)};
}

/// Which of a tetrahedron's edges are null.
using NullEdges = std::array<bool, 6>;

/// Of the six edges of a tetrahedron.
template <class Scalar>
std::array<EdgeForm<Scalar>, 6> edge_forms(const SixNumbers<Scalar>& lengths, const VertexTypes& types) {
  std::array<EdgeForm<Scalar>, 6> form;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    form[e] = edge_form(types[i], types[j], lengths[e]);
  }
  return form;
}

template <class Scalar>
numeric::Matrix4<Scalar> gram(const std::array<EdgeForm<Scalar>, 6>& form, const VertexTypes& types) {
  numeric::Matrix4<Scalar> m;
  for (int i = 0; i < 4; ++i) m[i][i] = norm(types[i]);
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    m[i][j] = form[e].w;
    m[j][i] = form[e].w;
  }
  return m;
}

/// The adjugate A of W, and s = sqrt(-det W) where the tetrahedron exists.
template <class Scalar>
struct Shape {
  numeric::Matrix4<Scalar> a;
  Scalar s;
  bool exists;

  explicit Shape(const numeric::Matrix4<Scalar>& w) {
    using std::sqrt;
    const numeric::Minors<Scalar> minors(w);
    a = numeric::adjugate(w, minors);
    const Scalar det = minors.determinant();
    exists = det < 0 && a[0][0] < 0 && a[1][1] < 0 && a[2][2] < 0 && a[3][3] < 0;
    s = exists ? Scalar(sqrt(-det)) : Scalar(0);
  }
};

/// The extended angles: s = 0 where no tetrahedron exists gives 0 or pi by the sign of A_kl.
template <class Scalar>
SixNumbers<Scalar> angles(const Shape<Scalar>& shape, const std::array<EdgeForm<Scalar>, 6>& form) {
  using std::atan2;
  SixNumbers<Scalar> theta;
  for (int e = 0; e < 6; ++e) {
    const auto [k, l] = edge_vertex[opposite_edge(e)];
    theta[e] = atan2(Scalar(form[e].g * shape.s), shape.a[k][l]);
  }
  return theta;
}

/// d theta_ij / d l_ij. The bracket is what remains of d(W^-1) = -W^-1 dW W^-1.
template <class Scalar>
Scalar own_derivative(const numeric::Matrix4<Scalar>& a, const Scalar& s, int e) {
  const auto [i, j] = edge_vertex[e];
  const auto [k, l] = edge_vertex[opposite_edge(e)];
  const Scalar bracket = a[i][k] * a[j][l] + a[j][k] * a[i][l] -
                         a[k][l] * (a[i][k] * a[j][k] / a[k][k] + a[i][l] * a[j][l] / a[l][l]);
  return bracket / (s * s * s);
}

/// d theta / d l of a tetrahedron that exists. With {i,j,k,l} = {0,1,2,3} the general formula shrinks to
///   d theta_ij / d l_kl = g_ij g_kl / s,   d theta_ij / d l_ik = g_ij g_ik A_il / (A_ll s).
template <class Scalar>
std::array<SixNumbers<Scalar>, 6> jacobian(const Shape<Scalar>& shape,
                                           const std::array<EdgeForm<Scalar>, 6>& form) {
  std::array<SixNumbers<Scalar>, 6> d;
  const auto& a = shape.a;
  const Scalar inverse = 1 / shape.s;
  for (int e = 0; e < 6; ++e) d[e][e] = form[e].g == 0 ? Scalar(0) : own_derivative(a, shape.s, e);
  for (int e = 0; e < 3; ++e) {
    const Scalar value = form[e].g * form[5 - e].g * inverse;
    d[e][5 - e] = value;
    d[5 - e][e] = value;
  }
  for (int l = 0; l < 4; ++l) {
    const auto& [p, q, r] = face_vertex[l];
    const Scalar scale = inverse / a[l][l];
    for (const auto& [i, j, k] : {std::array{p, q, r}, std::array{q, p, r}, std::array{r, p, q}}) {
      const int e = edge_number[i][j];
      const int f = edge_number[i][k];
      const Scalar value = form[e].g * form[f].g * a[i][l] * scale;
      d[e][f] = value;
      d[f][e] = value;
    }
  }
  return d;
}

} // namespace tetrarch::hyperbolic::kernel
