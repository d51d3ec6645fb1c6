// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A homomorphism from the groups of the vertex links to a free group, and how moves carry it along.
///
///      c ------ d        Near each vertex a tetrahedron cuts off a triangle, and these make the links. From
///       \  t   / \       one triangle to the next one crosses a face near the vertex. Every crossing has a
///        \    /   \      word; crossing back has its inverse, and going once round an edge, near one of its
///         \  /  t' \     ends, has the empty word. So a loop in a link has a word that its homotopy class
///          ab -------    determines.
///
/// Drill a graph out of a manifold: the boundary of the graph's neighborhood maps to the graph, whose group
/// is free, and the kernel is what bounds disks in the neighborhood: the meridians. Crushing an edge of the
/// graph identifies the two faces of a flat tetrahedron that do not contain it, and who crosses it there
/// travels along the edge: its letter. Words of one triangle may be changed by an element of the group
/// (`regauge`), which changes no loop.
///
/// A move replaces disks in links by disks, so that it changes no loop either. Carried are all moves that
/// simplify a triangulation without boundary. Source: flat bundles over surfaces, textbook
/// matter; the construction is ours.

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/ball.hpp"
#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace tetrarch::moves {

/// A reduced word in a free group: letter g is the number g + 1, its inverse -(g + 1).
using FreeWord = std::vector<int>;
FreeWord product(const FreeWord& a, const FreeWord& b);
FreeWord inverse(const FreeWord& a);

/// The words of all crossings, by tetrahedron (or slot), vertex and face; the entries of a vertex and the
/// face opposite it mean nothing.
class Monodromy {
public:
  explicit Monodromy(int tets = 0) { resize(tets); }

  int size() const { return static_cast<int>(words_.size()); }
  void resize(int tets) {
    words_.resize(static_cast<std::size_t>(tets));
    hands_.resize(static_cast<std::size_t>(tets), 1);
  }
  const FreeWord& at(int tet, int vertex, int face) const {
    return words_[static_cast<std::size_t>(tet)][vertex][face];
  }
  FreeWord& at(int tet, int vertex, int face) { return words_[static_cast<std::size_t>(tet)][vertex][face]; }
  void clear(int tet) { words_[static_cast<std::size_t>(tet)] = {}; }
  /// Everything that `from` has of one of its tetrahedra.
  void take(int tet, const Monodromy& from, int other) {
    words_[static_cast<std::size_t>(tet)] = from.words_[static_cast<std::size_t>(other)];
    hands_[static_cast<std::size_t>(tet)] = from.hands_[static_cast<std::size_t>(other)];
  }

  long long letter_count() const;

  /// +1 or -1: whether a tetrahedron is right-handed. Carried too, so that what is oriented stays so.
  int hand(int tet) const { return hands_[static_cast<std::size_t>(tet)]; }
  void set_hand(int tet, int hand) { hands_[static_cast<std::size_t>(tet)] = hand; }

private:
  std::vector<std::array<std::array<FreeWord, 4>, 4>> words_;
  std::vector<int> hands_;
};

/// Whether the laws above hold. O(n) words.
bool is_monodromy(const Triangulation& tri, const Skeleton& skeleton, const Monodromy& monodromy);

/// Letters for the edges of a graph: 0 for those of a spanning forest, 1, 2, ... for the others.
struct GraphLetters {
  Table<EdgeId, int> letter;
  int count = 0;
};
GraphLetters graph_letters(const Skeleton& skeleton, const Table<EdgeId, bool>& edges);

/// Crushing (drill.hpp) with the homomorphism to the group of the drilled graph. `letter` is read in the
/// direction of the skeleton's edge; `hands` says of each tetrahedron whether it is right-handed.
struct Crushed {
  Triangulation tri;
  Monodromy monodromy;
};
[[nodiscard]] std::variant<Crushed, Obstacle>
crushed_with_monodromy(const Triangulation& tri, const Skeleton& skeleton, const Table<EdgeId, bool>& edges,
                       const GraphLetters& letters, const std::vector<int>& hands);

/// Makes a move of a complex without boundary and carries the words along. False, and nothing is changed: the
/// move is illegal, or of a kind that is not carried (cone, books, shelling, 1-4, 4-1, 0-2). Words grow by
/// what is multiplied; `shorten` them now and then. O(valence) words; a pinch, O(n).
bool carry(Complex& complex, Monodromy& monodromy, const Move& move);

/// Makes the words on a spanning tree of each link empty, from its first triangle breadth first, so that the
/// others are words of loops. O(n) words.
void shorten(const Complex& complex, Monodromy& monodromy);
void shorten(const Triangulation& tri, Monodromy& monodromy);

/// `carry` for a ball that is replaced in a triangulation.
Monodromy carried(Monodromy monodromy, const Triangulation& before, const Ball& ball, const Replaced& after);

/// The words of a triangulation that `Complex::compact` made.
Monodromy compacted(const Monodromy& monodromy, const Complex::Compact& compact);

/// Makes all words inside disks of triangles empty where those meet in `inside` faces: inside[t][f] says that
/// the triangles on either side of the face belong together, near each of its vertices. Throws
/// PreconditionError if such triangles do not form disks on which this is possible. O(n) words.
void flatten_words(const Triangulation& tri, Monodromy& monodromy,
                   const std::vector<std::array<bool, 4>>& inside);

} // namespace tetrarch::moves
