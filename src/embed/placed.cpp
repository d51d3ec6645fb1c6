// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/placed.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/instantiate.hpp"

namespace tetrarch::embed {
namespace {

/// The vector over the z axis (x = y = 0) whose object crosses the axis at height e^s, looking up: its back
/// half-space or horoball lies above. For `below`, s = 0 and it looks down.
template <class Scalar>
Vector4<Scalar> on_axis(VertexType type, const Scalar& s, bool below) {
  using std::cosh;
  using std::exp;
  using std::sinh;
  const Scalar up = below ? -1 : 1;
  switch (type) {
  case VertexType::hyperideal:
    return {Scalar(0), Scalar(0), Scalar(up * cosh(s)), Scalar(sinh(s))};
  case VertexType::ideal:
    return {Scalar(0), Scalar(0), Scalar(up * exp(s)), Scalar(exp(s))};
  case VertexType::finite:
    break;
  }
  return {Scalar(0), Scalar(0), Scalar(sinh(s)), Scalar(cosh(s))};
}

/// The vector in the z,t plane with the inner products p with v and q with w, which lie in that plane.
template <class Scalar>
Vector4<Scalar> in_axis_plane(const Vector4<Scalar>& v, const Vector4<Scalar>& w, const Scalar& p,
                              const Scalar& q) {
  const Scalar d = v[3] * w[2] - v[2] * w[3];
  return {Scalar(0), Scalar(0), Scalar((v[3] * q - w[3] * p) / d), Scalar((v[2] * q - w[2] * p) / d)};
}

} // namespace

template <class Scalar>
VertexVectors<Scalar> place(const SixNumbers<Scalar>& lengths, const VertexTypes& types, Perm4 hold) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const auto angles = hyperbolic::dihedral_angles(lengths, types);
  if (!angles) throw PreconditionError("place: there is no tetrahedron with these lengths");
  const Matrix4<Scalar> w = hyperbolic::gram_matrix(lengths, types);
  const auto [a, b, c, d] = std::array<int, 4>{hold[0], hold[1], hold[2], hold[3]};
  const int axis = edge_number[a][b];

  VertexVectors<Scalar> v;
  v[a] = on_axis(types[a], Scalar(0), true);
  v[b] = on_axis(types[b], lengths[axis], false);
  v[c] = in_axis_plane(v[a], v[b], w[a][c], w[b][c]);
  v[d] = in_axis_plane(v[a], v[b], w[a][d], w[b][d]);
  const Scalar from_axis_c = sqrt(Scalar(w[c][c] - inner(v[c], v[c])));
  const Scalar from_axis_d = sqrt(Scalar(w[d][d] - inner(v[d], v[d])));
  v[c][0] = from_axis_c;
  v[d][0] = from_axis_d * cos((*angles)[axis]);
  v[d][1] = from_axis_d * sin((*angles)[axis]);
  return v;
}

template <class Scalar>
Matrix4<Scalar> frame(const VertexVectors<Scalar>& v, const VertexTypes& types) {
  // Gram and Schmidt from the middle of the tetrahedron, where the vectors look least alike.
  std::array<Vector4<Scalar>, 4> axis;
  axis[3] = center(v, types);
  for (int k = 0; k < 3; ++k) {
    axis[k] = combination(Scalar(1), v[k], inner(v[k], axis[3]), axis[3]);
    for (int j = 0; j < k; ++j)
      axis[k] = combination(Scalar(1), axis[k], Scalar(-inner(axis[k], axis[j])), axis[j]);
    axis[k] = normalized(axis[k]);
  }
  return reorthonormalized(matrix_with_columns(axis));
}

template <class Scalar>
Matrix4<Scalar> motion(const VertexVectors<Scalar>& from, const VertexVectors<Scalar>& to,
                       const VertexTypes& types) {
  return frame(to, types) * inverse(frame(from, types));
}

template <class Scalar>
Vector4<Scalar> face_normal(const VertexVectors<Scalar>& v, int f) {
  const auto& corners = face_vertex[f];
  const Vector4<Scalar> n = normalized(cross(v[corners[0]], v[corners[1]], v[corners[2]]));
  return inner(n, v[f]) > 0 ? scaled(Scalar(-1), n) : n;
}

template <class Scalar>
Vector4<Scalar> corner(const VertexVectors<Scalar>& v, const VertexTypes& types, int i, int j) {
  switch (types[i]) {
  case VertexType::hyperideal:
    return normalized(combination(Scalar(1), v[j], Scalar(-inner(v[i], v[j])), v[i]));
  case VertexType::ideal:
    return onto_horosphere(v[j], v[i], norm(types[j]));
  case VertexType::finite:
    break;
  }
  return v[i];
}

template <class Scalar>
Vector4<Scalar> center(const VertexVectors<Scalar>& v, const VertexTypes& types) {
  std::array<Vector4<Scalar>, 12> corners;
  std::size_t count = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j) corners[count++] = corner(v, types, i, j);
  return centroid(corners);
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template VertexVectors<Scalar> place(const SixNumbers<Scalar>&, const VertexTypes&, Perm4);                \
  template Matrix4<Scalar> frame(const VertexVectors<Scalar>&, const VertexTypes&);                          \
  template Matrix4<Scalar> motion(const VertexVectors<Scalar>&, const VertexVectors<Scalar>&,                \
                                  const VertexTypes&);                                                       \
  template Vector4<Scalar> face_normal(const VertexVectors<Scalar>&, int);                                   \
  template Vector4<Scalar> corner(const VertexVectors<Scalar>&, const VertexTypes&, int, int);               \
  template Vector4<Scalar> center(const VertexVectors<Scalar>&, const VertexTypes&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
