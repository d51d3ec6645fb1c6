// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Handlebodies in manifolds, and links: isometries of the exterior that extend over what was drilled out.
///
/// An isometry f of exteriors maps boundary components to boundary components. Each component S of the first
/// bounds a handlebody (a solid torus), so that its group maps onto a free group; `moves::Monodromy` says
/// how. f extends to a homeomorphism of the pairs iff it takes the kernel of this to the kernel on f(S):
///
///     group of S    --->  F          f extends over the handlebody iff a homomorphism a closes the square:
///       |  f              .          then all disks of the one go to disks of the other. Loops that generate
///       v                 . a        the group of S have words u in F and words v in F' of their images;
///     group of f(S) --->  F'         u generate F, so a exists iff what is trivial in u is trivial in v.
///
/// To decide that, a graph of loops labeled by u is folded (Stallings) while v rides along: two edges with a
/// common end and equal letters become one, and their words in F' are made equal by a change of gauge; where
/// both ends are common already, the words must agree. F and F' have equal ranks and are Hopfian, so one
/// direction is enough. Sources: Stallings, "Topology of finite graphs" (1983); that a homeomorphism extends
/// over a handlebody iff the kernels correspond, is textbook matter (Hempel, "3-Manifolds").

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/moves/monodromy.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::canonical {

/// Words in two free groups, collected pair by pair: is there a homomorphism that takes each first word to
/// its second?
class Correspondence {
public:
  void add(moves::FreeWord first, moves::FreeWord second);
  struct Answer {
    bool exists = false;
    /// Whether the first words generate the group of all their letters.
    bool generates = false;
    /// Where the homomorphism takes each letter, if it exists and the words generate; sorted by letter.
    std::vector<std::pair<int, moves::FreeWord>> images;
  };
  /// Near-quadratic in the sum of the lengths.
  Answer answer() const;
  /// Second words of what is trivial in the first ones, such that all such second words are products of
  /// conjugates of these, by second words.
  std::vector<moves::FreeWord> kernel() const;
  const std::vector<std::pair<moves::FreeWord, moves::FreeWord>>& pairs() const { return pairs_; }

private:
  std::vector<std::pair<moves::FreeWord, moves::FreeWord>> pairs_;
};

/// An exterior with its canonical cells and the homomorphism of its boundary, on the canonical triangulation.
struct MarkedCells {
  Canonical canonical;
  moves::Monodromy monodromy;
  std::string why_not; ///< empty: all was found
};

struct MarkedOptions {
  std::uint64_t seed = 1;
  int attempts = 300; ///< triangulations from which the cells are sought by moves
};

/// Looks for a triangulation on which the structure is found and from which flips lead to the canonical
/// cells; the words are carried all the way. `tri` is closed with ideal vertices only.
MarkedCells marked_cells(const Triangulation& tri, const moves::Monodromy& monodromy,
                         const MarkedOptions& options = {}, const Progress& progress = {});

/// Whether an isomorphism of triangulations with homomorphisms takes kernels to kernels. Throws
/// PreconditionError if a homomorphism is not onto.
bool extends(const Triangulation& a, const moves::Monodromy& words_a, const Isomorphism& isomorphism,
             const moves::Monodromy& words_b);

/// For each vertex link the loops that generate its group: a word of each, and its second word, of the
/// corresponding loop by `words_b` (of the same triangulation: the identity is the isomorphism).
std::vector<Correspondence> link_loops(const Triangulation& tri, const moves::Monodromy& words_a,
                                       const moves::Monodromy& words_b);

/// The isometries between two exteriors that extend, among all of them.
struct PairIsometries {
  std::vector<Isomorphism> all;
  std::vector<Isomorphism> extending;
  std::vector<int>
      hands; ///< of each that extends: +1 if it keeps the orientation of space, -1 if it reverses
};
PairIsometries pair_isometries(const MarkedCells& a, const MarkedCells& b);

/// A triangulation that both exteriors were brought to, hyperbolic or not.
struct CommonTriangulation {
  std::string signature;        ///< empty: none was met
  std::size_t isomorphisms = 0; ///< between the two as they were brought there
  std::vector<int>
      hands; ///< of those that extend: +1 if it keeps the orientation of space, -1 if it reverses
};
struct CommonOptions {
  std::uint64_t seed = 1;
  int walks = 300; ///< from either
};
/// Wanders from both among triangulations of about their size and looks for one met from both sides: a proof
/// that the exteriors are homeomorphic, and that the pairs are if an isomorphism extends. Ends at the first
/// that extends. That none is met, or none extends, proves nothing. 0.1 s for five tetrahedra.
CommonTriangulation common_triangulation(const Triangulation& a, const moves::Monodromy& words_a,
                                         const Triangulation& b, const moves::Monodromy& words_b,
                                         const CommonOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::canonical
