// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A move as a value: a program can test it, make it, write it down, and make it again.
///
/// A log replays on a Complex of the triangulation it was recorded from, because slots are taken and freed in
/// a fixed order. As text a move is a line: its name, the slot of its tetrahedron, and what else it needs:
///
///     merge 17 0 2          vertex 0 of tetrahedron 17 into its vertex 2
///     two_three 4 1         across face 1;  three_two 4 0 1: around the edge from 0 to 1
///     four_four 4 0 1 1     around that edge, axis 1;  zero_two_edge 4 0 1 2: two left steps apart
///
/// 1-4, 4-1, 2-3, 3-2, 4-4, 2-0, 0-2 and 2-1 are understood as well.

#include "tetrarch/moves/complex.hpp"
#include "tetrarch/moves/obstacle.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::moves {

enum class MoveKind : std::uint8_t {
  merge,           ///< tet, a: from, b: to
  one_four,        ///< tet
  four_one,        ///< tet, a: vertex
  two_three,       ///< tet, a: face
  three_two,       ///< tet, a: from, b: to
  four_four,       ///< tet, a: from, b: to, n: axis
  two_zero_edge,   ///< tet, a: from, b: to
  two_zero_vertex, ///< tet, a: vertex
  two_one,         ///< tet, a: from, b: to
  zero_two_edge,   ///< tet, a: from, b: to, n: turn
  zero_two_face,   ///< tet, a: face
  open_book,       ///< tet, a: face
  close_book,      ///< tet, a: from, b: to
  shell,           ///< tet
  pinch,           ///< tet, a: from, b: to
  cone,            ///< tet, a: face: the boundary component with this triangle
  pack             ///< no move, but a renumbering: Complex::pack
};

inline constexpr int move_kind_count = 17;

/// A move as a value.
struct Move {
  MoveKind kind = MoveKind::merge;
  int tet = -1;
  int a = 0;
  int b = 0;
  int n = 0;

  DirectedTetEdge edge() const { return {tet, a, b}; }
  TetFace face() const { return {tet, a}; }
  TetVertex vertex() const { return {tet, a}; }
  std::string str() const;
  friend bool operator==(const Move&, const Move&) = default;
};
using MoveLog = std::vector<Move>;

/// The move that a line spells. Throws InputError that says what was found and what was expected.
Move parse_move(std::string_view line);

/// All names that `parse_move` takes, each once: the long ones, then those in digits.
std::vector<std::string> move_names();

/// Whether a word is the name of the move, long or in digits: "2-0" is either of two kinds.
bool is_called(const Move& move, std::string_view word);

/// Asking and doing. Throws PreconditionError if there is no such tetrahedron, or a local number is out of
/// range. Costs as documented with the moves; that of a cone looks for the component among all, O(n).
[[nodiscard]] MaybeObstacle why_not_apply(const Complex& complex, const Move& move);
[[nodiscard]] MaybeObstacle apply(Complex& complex, const Move& move);

/// Makes all moves up to the first illegal one, which is returned; nothing after it is made.
struct Refused {
  std::size_t index;
  Obstacle obstacle;
};
[[nodiscard]] std::optional<Refused> replay(Complex& complex, const MoveLog& log);

} // namespace tetrarch::moves
