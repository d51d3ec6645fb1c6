// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/log.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/ball.hpp"
#include "tetrarch/moves/boundary_moves.hpp"
#include "tetrarch/moves/merge.hpp"
#include "tetrarch/moves/pachner.hpp"

#include <algorithm>
#include <charconv>

namespace tetrarch::moves {
namespace {

/// What the numbers after the tetrahedron are.
enum class Place : std::uint8_t { none, tet, vertex, face, edge, edge_and_number };

struct Spelling {
  MoveKind kind;
  std::string_view name;
  std::string_view digits; ///< the same in short; empty: there is no such name
  Place place;
};
constexpr std::array<Spelling, move_kind_count> spellings{
    {{MoveKind::merge, "merge", "", Place::edge},
     {MoveKind::one_four, "one_four", "1-4", Place::tet},
     {MoveKind::four_one, "four_one", "4-1", Place::vertex},
     {MoveKind::two_three, "two_three", "2-3", Place::face},
     {MoveKind::three_two, "three_two", "3-2", Place::edge},
     {MoveKind::four_four, "four_four", "4-4", Place::edge_and_number},
     {MoveKind::two_zero_edge, "two_zero_edge", "2-0", Place::edge},
     {MoveKind::two_zero_vertex, "two_zero_vertex", "2-0", Place::vertex},
     {MoveKind::two_one, "two_one", "2-1", Place::edge},
     {MoveKind::zero_two_edge, "zero_two_edge", "0-2", Place::edge_and_number},
     {MoveKind::zero_two_face, "zero_two_face", "0-2", Place::face},
     {MoveKind::open_book, "open_book", "", Place::face},
     {MoveKind::close_book, "close_book", "", Place::edge},
     {MoveKind::shell, "shell", "", Place::tet},
     {MoveKind::pinch, "pinch", "", Place::edge},
     {MoveKind::cone, "cone", "", Place::face},
     {MoveKind::pack, "pack", "", Place::none}}};

const Spelling& spelling(MoveKind kind) {
  return spellings[static_cast<std::size_t>(kind)];
}

/// Of the move's tet, a, b, n.
int numbers_needed(Place place) {
  switch (place) {
  case Place::none:
    return 0;
  case Place::tet:
    return 1;
  case Place::vertex:
  case Place::face:
    return 2;
  case Place::edge:
    return 3;
  case Place::edge_and_number:
    return 4;
  }
  return 0;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r\n";
  while (true) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t length = std::min(line.find_first_of(blanks), line.size());
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

/// The move that a word names, by its long name or in digits; null if there is none. Where digits name moves
/// at simplices of two kinds, the number of numbers tells which; if it fits neither, it is the one at an
/// edge.
const Spelling* spelled(std::string_view word, int numbers) {
  const Spelling* found = nullptr;
  for (const Spelling& how : spellings) {
    if (word == how.name) return &how;
    if (!how.digits.empty() && word == how.digits &&
        (found == nullptr || numbers_needed(how.place) == numbers))
      found = &how;
  }
  return found;
}

/// Whether the local numbers name something in a tetrahedron.
bool names_something(const Move& move) {
  const auto local = [](int i) { return i >= 0 && i < 4; };
  switch (spelling(move.kind).place) {
  case Place::none:
  case Place::tet:
    return true;
  case Place::vertex:
  case Place::face:
    return local(move.a);
  case Place::edge:
    return local(move.a) && local(move.b) && move.a != move.b;
  case Place::edge_and_number:
    return local(move.a) && local(move.b) && move.a != move.b &&
           (move.kind != MoveKind::four_four || move.n == 0 || move.n == 1);
  }
  return false;
}

void require_there(const Complex& complex, const Move& move) {
  if (move.kind == MoveKind::pack) return;
  if (move.tet < 0 || move.tet >= complex.slot_count() || !complex.is_alive(move.tet))
    throw PreconditionError("the move " + in_quotes(move.str()) + " names no living tetrahedron");
  if (!names_something(move))
    throw PreconditionError("the move " + in_quotes(move.str()) + " has a local number out of range");
}

MaybeObstacle obstacle_of(const BallOrObstacle& ball) {
  if (const auto* obstacle = std::get_if<Obstacle>(&ball)) return *obstacle;
  return std::nullopt;
}

/// What `act` says of the boundary component with the face.
template <class Act>
MaybeObstacle at_component(const Complex& complex, TetFace f, Act act) {
  if (!complex.is_boundary(f)) return Obstacle::no_boundary_face;
  for (const auto& component : boundary_faces(complex))
    if (std::binary_search(component.begin(), component.end(), f)) return act(component);
  return Obstacle::no_boundary_face;
}

} // namespace

std::string Move::str() const {
  const Spelling& how = spelling(kind);
  std::string text(how.name);
  const std::array<int, 4> numbers{tet, a, b, n};
  for (int k = 0; k < numbers_needed(how.place); ++k) text += " " + std::to_string(numbers[k]);
  return text;
}

std::vector<std::string> move_names() {
  std::vector<std::string> names;
  names.reserve(2 * spellings.size());
  for (const Spelling& how : spellings) names.emplace_back(how.name);
  for (const Spelling& how : spellings)
    if (!how.digits.empty() && names.back() != how.digits) names.emplace_back(how.digits);
  return names;
}

bool is_called(const Move& move, std::string_view word) {
  const Spelling& how = spelling(move.kind);
  return spelled(word, numbers_needed(how.place)) == &how;
}

Move parse_move(std::string_view line) {
  const auto words = words_of(line);
  if (words.empty()) throw InputError("found an empty line, expected a move");
  const Spelling* how = spelled(words[0], static_cast<int>(words.size()) - 1);
  if (how == nullptr) throw InputError("found " + in_quotes(words[0]) + ", expected the name of a move");
  const int numbers = numbers_needed(how->place);
  if (static_cast<int>(words.size()) != 1 + numbers)
    throw InputError("found " + std::to_string(words.size() - 1) + " after " + in_quotes(words[0]) +
                     ", expected " + std::to_string(numbers) + (numbers == 1 ? " number" : " numbers"));
  Move move;
  move.kind = how->kind;
  const std::array<int*, 4> places{&move.tet, &move.a, &move.b, &move.n};
  for (int k = 0; k < numbers; ++k) {
    const std::string_view word = words[static_cast<std::size_t>(k) + 1];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), *places[k]);
    if (error != std::errc() || end != word.data() + word.size() || *places[k] < 0)
      throw InputError("found " + in_quotes(word) + ", expected a number");
  }
  if (!names_something(move))
    throw InputError("the move " + in_quotes(line) + " has a local number out of range");
  return move;
}

MaybeObstacle why_not_apply(const Complex& complex, const Move& move) {
  require_there(complex, move);
  switch (move.kind) {
  case MoveKind::merge:
    return why_not_merge(complex, move.edge());
  case MoveKind::one_four:
    return std::nullopt;
  case MoveKind::four_one:
    return obstacle_of(four_one_ball(complex, move.vertex()));
  case MoveKind::two_three:
    return obstacle_of(two_three_ball(complex, move.face()));
  case MoveKind::three_two:
    return obstacle_of(three_two_ball(complex, move.edge()));
  case MoveKind::four_four:
    return obstacle_of(four_four_ball(complex, move.edge(), move.n));
  case MoveKind::two_zero_edge:
    return why_not_two_zero_edge(complex, move.edge());
  case MoveKind::two_zero_vertex:
    return why_not_two_zero_vertex(complex, move.vertex());
  case MoveKind::two_one:
    return why_not_two_one(complex, move.edge());
  case MoveKind::zero_two_edge:
    return why_not_zero_two_edge(complex, move.edge(), move.n);
  case MoveKind::zero_two_face:
    return why_not_zero_two_face(complex, move.face());
  case MoveKind::open_book:
    return why_not_open_book(complex, move.face());
  case MoveKind::close_book:
    return why_not_close_book(complex, move.edge());
  case MoveKind::shell:
    return why_not_shell(complex, move.tet);
  case MoveKind::pinch:
    return why_not_pinch(complex, move.edge());
  case MoveKind::cone:
    return at_component(complex, move.face(),
                        [&](const auto& component) { return why_not_cone(complex, component); });
  case MoveKind::pack:
    return std::nullopt;
  }
  return std::nullopt;
}

MaybeObstacle apply(Complex& complex, const Move& move) {
  require_there(complex, move);
  switch (move.kind) {
  case MoveKind::merge:
    return merge(complex, move.edge());
  case MoveKind::one_four:
    return one_four(complex, move.tet);
  case MoveKind::four_one:
    return four_one(complex, move.vertex());
  case MoveKind::two_three:
    return two_three(complex, move.face());
  case MoveKind::three_two:
    return three_two(complex, move.edge());
  case MoveKind::four_four:
    return four_four(complex, move.edge(), move.n);
  case MoveKind::two_zero_edge:
    return two_zero_edge(complex, move.edge());
  case MoveKind::two_zero_vertex:
    return two_zero_vertex(complex, move.vertex());
  case MoveKind::two_one:
    return two_one(complex, move.edge());
  case MoveKind::zero_two_edge:
    return zero_two_edge(complex, move.edge(), move.n);
  case MoveKind::zero_two_face:
    return zero_two_face(complex, move.face());
  case MoveKind::open_book:
    return open_book(complex, move.face());
  case MoveKind::close_book:
    return close_book(complex, move.edge());
  case MoveKind::shell:
    return shell(complex, move.tet);
  case MoveKind::pinch:
    return pinch(complex, move.edge());
  case MoveKind::cone:
    return at_component(complex, move.face(),
                        [&](const auto& component) { return cone(complex, component); });
  case MoveKind::pack:
    complex.pack();
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Refused> replay(Complex& complex, const MoveLog& log) {
  for (std::size_t k = 0; k < log.size(); ++k)
    if (const auto obstacle = apply(complex, log[k])) return Refused{k, *obstacle};
  return std::nullopt;
}

} // namespace tetrarch::moves
