// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One hyperbolic tetrahedron whose vertices are finite, ideal or hyperideal in any mixture.
///
/// Put its vertices v_i into R^{3,1} with <v,v> = -1 (finite: a point of H^3), 0 (ideal: the point at
/// infinity with the horosphere -<x,v> = 1) or +1 (hyperideal: the vertex lies beyond infinity, and the plane
/// that is perpendicular to everything that passes through it truncates the tetrahedron). The length of an
/// edge is the signed distance of the two objects at its ends (point, horosphere, plane):
///
///   hyperideal-hyperideal  <v,w> = -cosh l     hyperideal-ideal   -exp l    ideal-ideal  -2 exp l
///   finite-finite                  -cosh l     finite-hyperideal  -sinh l   finite-ideal   -exp l
///
/// so that with g = sqrt(<v,w>^2 - <v,v><w,w>) the derivative is always d<v,w>/dl = -g. All geometry is read
/// from the Gram matrix W = (<v_i,v_j>) and its adjugate A. The tetrahedron exists iff det W < 0 and every
/// A_kk < 0, and then, with {i,j,k,l} = {0,1,2,3},
///
///   cos theta_ij = A_kl / sqrt(A_kk A_ll),   sin theta_ij = g_ij sqrt(-det W) / sqrt(A_kk A_ll)
///
/// (the sine by Jacobi's identity on complementary minors; both together lose no digits at angles near 0 and
/// pi). Edges are in the order 01, 02, 03, 12, 13, 23 of core/tet.hpp; lengths are pure numbers (curvature
/// -1), angles are in radians. Sources: Yin, section 4.3.1; Frigerio-Petronio 2004; Luo-Yang 2018 (the
/// extension).

#include "tetrarch/numeric/matrix4.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace tetrarch::hyperbolic {

enum class VertexType : std::uint8_t { finite, ideal, hyperideal };
/// "finite", "ideal", "hyperideal".
const char* to_string(VertexType type);

/// The self inner product <v,v> of a vertex vector: -1, 0, +1.
constexpr int norm(VertexType type) {
  return static_cast<int>(type) - 1;
}

/// One number an edge (a length or a dihedral angle).
template <class Scalar>
using SixNumbers = std::array<Scalar, 6>;
using VertexTypes = std::array<VertexType, 4>;
inline constexpr VertexTypes all_hyperideal{VertexType::hyperideal, VertexType::hyperideal,
                                            VertexType::hyperideal, VertexType::hyperideal};
inline constexpr VertexTypes all_ideal{VertexType::ideal, VertexType::ideal, VertexType::ideal,
                                       VertexType::ideal};

/// <v,w> of two vertices whose edge has this signed length.
template <class Scalar>
Scalar inner_product(VertexType a, VertexType b, const Scalar& length);
/// The inverse. An argument that no length gives (rounding may leave -cosh l just above -1; or two vectors on
/// different sides) is taken to the nearest that one does where there is one: length 0. Throws
/// PreconditionError for w >= 0 at an ideal vertex.
template <class Scalar>
Scalar signed_length(VertexType a, VertexType b, const Scalar& w);

/// W; symmetric.
template <class Scalar>
numeric::Matrix4<Scalar> gram_matrix(const SixNumbers<Scalar>& lengths, const VertexTypes& types);

/// det W < 0, all A_kk < 0, and no two truncating planes meet: lengths between hyperideal vertices are
/// positive.
template <class Scalar>
bool exists(const SixNumbers<Scalar>& lengths, const VertexTypes& types);

/// The dihedral angles, or nothing where there is no such tetrahedron.
template <class Scalar>
std::optional<SixNumbers<Scalar>> dihedral_angles(const SixNumbers<Scalar>& lengths,
                                                  const VertexTypes& types);

/// The angles continued to all of R^6: the cosine clamped to [-1, 1], hence angles 0 and pi, where no
/// tetrahedron exists, and a negative length between two hyperideal vertices read as 0 (the angle there is
/// 0). Law: without finite vertices they are the gradient of a convex C^1 function of the lengths.
template <class Scalar>
SixNumbers<Scalar> extended_dihedral_angles(const SixNumbers<Scalar>& lengths, const VertexTypes& types);

/// Entry [e][f] is d theta_e / d l_f; zero where no tetrahedron exists. Laws: symmetric; without finite
/// vertices positive semi-definite, and its kernel is spanned by the changes of horosphere (1 on the three
/// edges at an ideal vertex, 0 on the others).
template <class Scalar>
std::array<SixNumbers<Scalar>, 6> angle_jacobian(const SixNumbers<Scalar>& lengths, const VertexTypes& types);

/// The types that a set of dihedral angles gives its vertices: the angle sum at a vertex is less than pi
/// (hyperideal), pi within `tolerance` (ideal) or more (finite).
template <class Scalar>
VertexTypes vertex_types_of_angles(const SixNumbers<Scalar>& angles, const Scalar& tolerance);

/// The lengths of the tetrahedron with these dihedral angles, through the Gram matrix of its face normals,
/// which has the entries -cos theta. The horosphere at an ideal vertex is the one of its vector in the dual
/// basis of the normals, over sqrt(-det). Nothing where no tetrahedron has these angles and these types; the
/// type of an ideal vertex is the caller's word and is not tested, as rounding would blur the test.
template <class Scalar>
std::optional<SixNumbers<Scalar>> lengths_from_angles(const SixNumbers<Scalar>& angles,
                                                      const VertexTypes& types);

} // namespace tetrarch::hyperbolic
