// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Why a manifold is not hyperbolic: a reason that a reader can check.
///
/// M is compact, its ideal vertices truncated; tori and Klein bottles of the boundary would be cusps, the
/// rest of the boundary geodesic. Had M such a structure, its group G would be discrete, without torsion and
/// not abelian, and M would hold no essential sphere, disk, annulus or torus. So each of the following is a
/// proof:
///
///   of the group   G is cyclic or abelian; G is a free product; G splits over a cyclic group (an essential
///   disk,
///                  sphere, annulus or Moebius band follows: Stallings, Waldhausen, Scott); G has torsion;
///                  two elements have a common power, or commute with a third one, and do not commute with
///                  each other (fixed points at infinity are shared or not); u v^p U = v^q where that cannot
///                  be; G holds Z^2 and M has no cusp.
///   of a surface   A normal surface that is a projective plane, a Klein bottle, a sphere or torus that does
///   not
///                  separate, a sphere with no ball on either side, a torus that is incompressible on both
///                  sides and parallel to no cusp.
///
/// What is seen of G is seen in a presentation, where a pattern of letters is the whole proof; that two
/// elements do not commute, or one is not 1, is seen in a finite quotient, which is given. Statements that
/// hold for orientable manifolds only are applied to the orientable double cover, which would be hyperbolic,
/// too. Sources: Hempel, "3-Manifolds" (1976); Jaco and Shalen (1979); Culler and Shalen (1983), 2.3.1; Jaco
/// and Tollefson, "Algorithms for the complete decomposition of a closed 3-manifold" (1995).

#include "tetrarch/algebra/cover.hpp"
#include "tetrarch/algebra/presentation.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::reasons {

/// What was found.
enum class Kind {
  cyclic_group,     ///< G has one generator or none
  abelian_group,    ///< the relators make all generators commute
  free_product,     ///< no relator joins two sets of generators
  root,             ///< a generator occurs in p-th powers only, p > 1, or nowhere
  twice,            ///< a generator occurs twice, in one relator
  stable_letter,    ///< a generator t occurs in subwords t v^k T only, with one word v
  amalgam,          ///< powers of one word u are all that joins a set of generators to the others
  torsion,          ///< a relator u^p with u not 1
  common_power,     ///< u^p = v^q, and u and v do not commute
  conjugate_powers, ///< u v^p U = v^q in a way that isometries forbid
  commuting,        ///< y and z commute with x, which is not 1, and not with each other
  plane,            ///< x and y commute and generate no cyclic group, and there is no cusp
  projective_plane, ///< such a normal surface, or vertex link
  klein_bottle,     ///< such a normal surface
  nonseparating,    ///< a sphere or torus that does not separate
  essential_sphere, ///< a sphere that separates, with no ball on either side
  essential_torus,  ///< a torus that separates
};
/// The name as spelt above; stable, for JSON.
const char* to_string(Kind kind);

/// How it is known that an element is not 1, or that elements do not commute: their images in a finite group.
struct Quotient {
  int modulus = 0;                     ///< not 0: already in the first homology modulo this prime
  std::optional<algebra::Cover> cover; ///< else as permutations of the sheets of a cover
};

/// What is seen in a presentation of the group.
struct GroupEvidence {
  std::string triangulation; ///< signature of the triangulation whose simplified group is `from`
  algebra::Presentation from;
  std::vector<algebra::Word> image; ///< each generator of `from` in the letters of `shown`: an automorphism
  algebra::Presentation shown;      ///< relators cyclically reduced
  std::vector<int> generators;      ///< those meant, counted from 0: of the root, stable letter, factor
  std::vector<algebra::Word> elements; ///< u, v or x, y, z
  int p = 0, q = 0;                    ///< exponents: of u^p = v^q, of u v^p U = v^q, of a root, of torsion
  std::optional<Quotient> quotient;    ///< where one is needed
};

/// A normal surface, by how often it has each piece in each tetrahedron.
struct SurfaceEvidence {
  std::string triangulation;    ///< signature of the triangulation in which it lies
  std::vector<int> coordinates; ///< of each tetrahedron four triangles, by vertex, and three quadrilaterals:
                                ///< those that part 01 from 23, 02 from 13, 03 from 12
  int euler = 0;
  bool orientable = true;
  bool separating = false;
  std::vector<std::string> sides; ///< what is said of each side, where it separates
};

/// A proof that there is no hyperbolic structure.
struct Reason {
  Kind kind = Kind::cyclic_group;
  std::string text;             ///< a sentence: what was found
  std::string theorem;          ///< a sentence: why no hyperbolic manifold has that
  bool in_double_cover = false; ///< it was found in the orientable double cover
  std::optional<GroupEvidence> group;
  std::optional<SurfaceEvidence> surface;
};

struct ReasonOptions {
  std::uint64_t seed = 1;
  bool groups = true;                  ///< read presentations; else look at normal surfaces alone
  int changes = 10;                    ///< further triangulations of the manifold whose groups are read
  int presentations = 60;              ///< of shortest ones that are looked at, for each triangulation
  int degree = 7;                      ///< greatest degree of the covers that finite quotients come from
  long long cover_steps = 40'000;      ///< for each presentation
  int most_tetrahedra = 10;            ///< normal surfaces are sought in triangulations up to this size
  long long surface_steps = 3'000'000; ///< pairs of normal surfaces that may be combined
};

/// A reason why the manifold of this triangulation, truncated at its ideal vertices, balls filled into its
/// boundary spheres, has no hyperbolic structure; nothing if none was found, which proves nothing. Throws
/// PreconditionError unless `tri` is a connected manifold of at least one tetrahedron. Deterministic for a
/// seed. A fraction of a millisecond to some milliseconds for five tetrahedra where there is a reason; tens
/// of milliseconds where there is none.
[[nodiscard]] std::optional<Reason> why_not_hyperbolic(const Triangulation& tri,
                                                       const ReasonOptions& options = {},
                                                       const Progress& progress = {});

/// By groups alone, without other triangulations: first of a simplified triangulation, then of the `given` one,
/// if that is larger and of no more than 10,000 tetrahedra. A large triangulation of few edges has long
/// relators, which simplify the better, the more of them there are. Throws as above. For searches, on their way.
[[nodiscard]] std::optional<Reason> quick_reason(const Triangulation& simplified, const Triangulation& given,
                                                 std::uint64_t seed, const Progress& progress = {});

/// Checks a reason from what it holds: the presentation is read anew from its triangulation, the automorphism
/// is applied and shown to be one (Stallings' folding), the pattern sought again, the finite group tested
/// relator by relator. Empty if all is right, else a sentence. That the triangulation is one of the manifold
/// in question is for the caller to know. Throws InputError if a signature is none.
[[nodiscard]] std::string what_is_wrong(const Reason& reason);

} // namespace tetrarch::reasons
