// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/cosine_laws.hpp"

#include "tetrarch/core/tet.hpp"
#include "tetrarch/numeric/instantiate.hpp"

#include <cmath>

namespace tetrarch::hyperbolic {
namespace {

/// The sides of all truncation triangles: that of vertex i in face l is side(i, j, k, l), where j and k are
/// the other two vertices of the face. It joins the corners on the edges ij and ik; opposite lies the corner
/// on il.
template <class Scalar, class Side>
TriangleSides<Scalar> all_sides(const Side& side) {
  TriangleSides<Scalar> sides;
  for (int i = 0; i < 4; ++i) {
    sides[i][i] = 0;
    for (int l = 0; l < 4; ++l) {
      if (l == i) continue;
      const int j = face_vertex[l][face_corner(l, i) == 0 ? 1 : 0];
      sides[i][l] = side(i, j, 6 - i - j - l, l);
    }
  }
  return sides;
}

} // namespace

template <class Scalar>
Scalar triangle_side(const Scalar& angle, const Scalar& a, const Scalar& b) {
  using std::acosh;
  using std::cos;
  using std::sin;
  return acosh(Scalar((cos(angle) + cos(a) * cos(b)) / (sin(a) * sin(b))));
}

template <class Scalar>
Scalar triangle_angle(const Scalar& side, const Scalar& a, const Scalar& b) {
  using std::acos;
  using std::cosh;
  using std::sinh;
  return acos(Scalar((cosh(a) * cosh(b) - cosh(side)) / (sinh(a) * sinh(b))));
}

template <class Scalar>
Scalar hexagon_side(const Scalar& opposite, const Scalar& a, const Scalar& b) {
  using std::acosh;
  using std::cosh;
  using std::sinh;
  return acosh(Scalar((cosh(opposite) + cosh(a) * cosh(b)) / (sinh(a) * sinh(b))));
}

template <class Scalar>
TriangleSides<Scalar> triangle_sides_from_lengths(const SixNumbers<Scalar>& lengths) {
  return all_sides<Scalar>([&](int i, int j, int k, int) {
    return hexagon_side(lengths[edge_number[j][k]], lengths[edge_number[i][j]], lengths[edge_number[i][k]]);
  });
}

template <class Scalar>
TriangleSides<Scalar> triangle_sides_from_angles(const SixNumbers<Scalar>& angles) {
  return all_sides<Scalar>([&](int i, int j, int k, int l) {
    return triangle_side(angles[edge_number[i][l]], angles[edge_number[i][j]], angles[edge_number[i][k]]);
  });
}

template <class Scalar>
SixNumbers<Scalar> angles_by_cosine_laws(const SixNumbers<Scalar>& lengths) {
  const TriangleSides<Scalar> side = triangle_sides_from_lengths(lengths);
  SixNumbers<Scalar> angles;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const auto [k, l] = edge_vertex[opposite_edge(e)];
    angles[e] = triangle_angle(side[i][j], side[i][k], side[i][l]);
  }
  return angles;
}

template <class Scalar>
SixNumbers<Scalar> lengths_by_cosine_laws(const SixNumbers<Scalar>& angles) {
  const TriangleSides<Scalar> side = triangle_sides_from_angles(angles);
  SixNumbers<Scalar> lengths;
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const auto [k, l] = edge_vertex[opposite_edge(e)];
    lengths[e] = hexagon_side(side[k][l], side[i][l], side[j][l]);
  }
  return lengths;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Scalar triangle_side(const Scalar&, const Scalar&, const Scalar&);                                \
  template Scalar triangle_angle(const Scalar&, const Scalar&, const Scalar&);                               \
  template Scalar hexagon_side(const Scalar&, const Scalar&, const Scalar&);                                 \
  template TriangleSides<Scalar> triangle_sides_from_lengths(const SixNumbers<Scalar>&);                     \
  template TriangleSides<Scalar> triangle_sides_from_angles(const SixNumbers<Scalar>&);                      \
  template SixNumbers<Scalar> angles_by_cosine_laws(const SixNumbers<Scalar>&);                              \
  template SixNumbers<Scalar> lengths_by_cosine_laws(const SixNumbers<Scalar>&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
