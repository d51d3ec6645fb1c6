// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A fundamental domain of a hyperbolic manifold in hyperbolic space (a "single period"), and the holonomy.
///
/// Put tetrahedron 0 down, then walk over the gluing, breadth first, and put every other tetrahedron against
/// the face through which the walk reached it. The union is a ball. A face inside it has a tetrahedron on
/// either side; an *open* face looks at another copy of the whole domain, which the *pairing* of the face
/// carries the domain onto. Open faces that meet in an edge of the domain and look at the same copy make up
/// one *gluable face* (all their pairings are the same isometry):
///
///     _____________
///    /\  a  /\     \        a and b look at the copy P(domain) and are one gluable face; the partner of
///   /  \   /  \  c  \       that face, somewhere else on the domain, looks at the copy P^-1(domain).
///  /____\_/_b__\_____\      Around the edge between a and b there are just two copies.
///
/// The walk is the spanning tree of the dual presentation (algebra/group.hpp), whose generator g goes to the
/// pairing of its face: the holonomy, a representation of the fundamental group; the word ab goes to the
/// product of the two. A generator that an edge shows to be trivial (all other faces around that edge lie
/// inside) is no open face: the domain closes up there. Source: Yin, sections 4.4.3 and 4.4.4.

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/embed/placed.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

namespace tetrarch::embed {

using hyperbolic::Metric;

/// Open faces that look at the same copy of the domain.
template <class Scalar>
struct GluableFace {
  std::vector<TetFace> hexagons;
  int partner = -1;        ///< its own index only if the pairing were an involution, which no structure has
  Matrix4<Scalar> pairing; ///< takes the domain to the copy that lies beyond this face
};

/// A fundamental domain: where each tetrahedron lies, and how its open faces are paired.
template <class Scalar>
struct Domain {
  std::vector<VertexTypes> types;              ///< per tetrahedron
  std::vector<VertexVectors<Scalar>> vertices; ///< per tetrahedron, where it lies
  std::vector<TetFace>
      entrance;           ///< the face of its parent through which it was reached; tet -1 for the first
  std::vector<int> order; ///< the tetrahedra in the order in which they were reached
  std::vector<std::array<int, 4>> gluable; ///< per face: its gluable face, or -1 inside
  std::vector<GluableFace<Scalar>> faces;
  algebra::DualPresentation group;
  std::vector<Matrix4<Scalar>> holonomy; ///< per generator
  /// From here to where tetrahedron 0 lies as in placed.hpp. Here the middle of the domain is the base point:
  /// pairings move it only a little, and so lose few digits when they are multiplied.
  Matrix4<Scalar> half_space;

  /// The copy of the domain that face f of the copy "identity" looks at: the identity itself inside.
  Matrix4<Scalar> across(TetFace f) const {
    const int face = gluable[static_cast<std::size_t>(f.tet)][f.face];
    return face < 0 ? identity<Scalar>() : faces[static_cast<std::size_t>(face)].pairing;
  }
};

struct DomainOptions {
  /// The area of the cross-section that cuts a cusp off. It is smaller where horospheres would come close to
  /// each other or to the geodesic boundary. It changes no pairing.
  double cusp_area = 0.5;
};

/// `lengths` are those of a geometric structure. Throws PreconditionError if the skeleton is stale, the
/// gluing has boundary faces, is invalid, empty or not connected, or a tetrahedron does not exist. O(n).
template <class Scalar>
Domain<Scalar> fundamental_domain(const Triangulation& tri, const Skeleton& skeleton,
                                  const Metric<Scalar>& lengths, const DomainOptions& options = {});

/// The domain of a structure, to the full precision of doubles: the lengths are refined and the tetrahedra
/// placed in 50 digits, and the result is rounded. With more than `most_precise_edges` edge classes
/// everything is done in doubles, which costs about four of the sixteen digits. Throws PreconditionError also
/// unless `found` is geometric. 20 milliseconds for three tetrahedra, 5 seconds for 100 edge classes.
inline constexpr int most_precise_edges = 100;
Domain<double> fundamental_domain(const Triangulation& tri, const Skeleton& skeleton,
                                  const hyperbolic::Hyperbolization<double>& found,
                                  const DomainOptions& options = {}, const Progress& progress = {});

/// The isometry of a word in the generators of `domain.group`.
template <class Scalar>
Matrix4<Scalar> holonomy_of(const Domain<Scalar>& domain, const algebra::Word& word);

/// Residuals of a domain; without rounding every number would be 0.
struct Residuals {
  double seam = 0;           ///< largest distance of two corners that the gluing of a face identifies
  double relator = 0;        ///< largest entry of (holonomy of a relator) - 1, in SO(3,1)
  double relator_sl2c = 0;   ///< the same up to sign in SL(2,C)
  double edge_rotation = 0;  ///< largest |2 pi - sum of dihedral angles around an edge|, measured in place
  double boundary_plane = 0; ///< largest distance of a corner from the plane of its boundary component's lift
  double gauss_bonnet = 0;   ///< largest |area + 2 pi chi| of a boundary component, measured in place
};
/// Measured from the placed vertices alone, by formulas other than those that placed them. O(n + length of
/// the relators).
template <class Scalar>
Residuals residuals(const Triangulation& tri, const Skeleton& skeleton, const Domain<Scalar>& domain);

} // namespace tetrarch::embed
