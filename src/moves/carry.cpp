// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/monodromy.hpp"

#include "carry_pinch.hpp"
#include "corners.hpp"
#include "regauge.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/merge.hpp"
#include "tetrarch/moves/pachner.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tetrarch::moves {
namespace {

// Balls.

template <class Tets>
std::map<unsigned, int> face_counts(const Tets& tets) {
  std::map<unsigned, int> count;
  for (const Corners& corners : tets)
    for (int f = 0; f < 4; ++f) ++count[face_key(corners, f)];
  return count;
}

/// A face of a ball's boundary, seen from inside: the corners of its tetrahedron, the face, the hand.
struct Side {
  Corners corners{};
  int face = 0;
  int hand = 1;
};

/// The words by which one leaves a ball, by face and corner, once all inside it are empty; and its sides.
struct WaysOut {
  std::map<std::pair<unsigned, int>, FreeWord> word;
  std::map<unsigned, Side> side;
};

/// Makes the words inside the ball empty, near each of its corners, and reads off those that lead out.
template <class Gluings>
WaysOut ways_out(const Gluings& tri, Monodromy& monodromy, const Ball& ball) {
  std::vector<Corners> before;
  for (const Placed& p : ball.before) before.push_back(p.corners);
  const auto count = face_counts(before);
  std::vector<std::array<bool, 4>> done(before.size(), {false, false, false, false});
  std::vector<std::pair<std::size_t, int>> pending;
  for (std::size_t first = 0; first < before.size(); ++first)
    for (int start = 0; start < 4; ++start) {
      // One triangle of each corner's disk: the first that has it.
      const int corner = before[first][start];
      const auto has = [corner](const Corners& c) {
        return std::find(c.begin(), c.end(), corner) != c.end();
      };
      if (std::any_of(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(first), has)) continue;
      done[first][start] = true;
      pending.emplace_back(first, start);
      while (!pending.empty()) {
        const auto [k, v] = pending.back();
        pending.pop_back();
        for (int f = 0; f < 4; ++f) {
          if (f == v || count.at(face_key(before[k], f)) != 2) continue;
          for (std::size_t l = 0; l < before.size(); ++l) {
            if (l == k) continue;
            const auto at = std::find(before[l].begin(), before[l].end(), corner);
            bool shares = false;
            for (int g = 0; g < 4; ++g) shares |= face_key(before[l], g) == face_key(before[k], f);
            if (!shares || at == before[l].end()) continue;
            const int w = static_cast<int>(at - before[l].begin());
            const FreeWord& across = monodromy.at(ball.before[k].tet, v, f);
            if (done[l][w]) {
              if (!across.empty()) throw PreconditionError("carry: a loop inside a ball has a word");
              continue;
            }
            regauge(tri, monodromy, TetVertex{ball.before[l].tet, w}, inverse(across));
            done[l][w] = true;
            pending.emplace_back(l, w);
          }
        }
      }
    }
  WaysOut ways;
  for (std::size_t k = 0; k < before.size(); ++k)
    for (int f = 0; f < 4; ++f) {
      const unsigned key = face_key(before[k], f);
      if (count.at(key) == 2) continue;
      ways.side[key] = {before[k], f, monodromy.hand(ball.before[k].tet)};
      for (const int v : face_vertex[f])
        ways.word[{key, before[k][v]}] = monodromy.at(ball.before[k].tet, v, f);
    }
  return ways;
}

/// The hand of a tetrahedron with a face on the boundary of the ball.
int hand_of(const Corners& corners, int face, const Side& side) {
  std::array<int, 4> to{};
  to[face] = side.face;
  for (const int v : face_vertex[face])
    to[v] = static_cast<int>(std::find(side.corners.begin(), side.corners.end(), corners[v]) -
                             side.corners.begin());
  return side.hand * Perm4(to[0], to[1], to[2], to[3]).sign();
}

/// The words of the filling, of which `tets` lists the tetrahedra.
template <class Tets>
void fill_in(Monodromy& monodromy, const WaysOut& ways, const Ball& ball, const Tets& tets) {
  const auto count = face_counts(ball.after);
  for (std::size_t k = 0; k < ball.after.size(); ++k) {
    monodromy.clear(tets[k]);
    for (int f = 0; f < 4; ++f) {
      const unsigned key = face_key(ball.after[k], f);
      if (count.at(key) == 2) continue;
      monodromy.set_hand(tets[k], hand_of(ball.after[k], f, ways.side.at(key)));
      for (const int v : face_vertex[f]) monodromy.at(tets[k], v, f) = ways.word.at({key, ball.after[k][v]});
    }
  }
}

bool carry_ball(Complex& complex, Monodromy& monodromy, const BallOrObstacle& found) {
  const auto* ball = std::get_if<Ball>(&found);
  if (ball == nullptr) return false;
  const WaysOut ways = ways_out(complex, monodromy, *ball);
  replace(complex, *ball);
  monodromy.resize(std::max(monodromy.size(), complex.slot_count()));
  fill_in(monodromy, ways, *ball, complex.last_change().new_tets);
  return true;
}

// Tetrahedra that are pressed flat: two faces of such become one, and one passes from the one to the other.

/// Vertex v of a's tetrahedron is pressed onto vertex map[v] of b's, with the word of the way there.
struct Pressed {
  TetFace a;
  TetFace b;
  Perm4 map;
  std::array<FreeWord, 4> word;
};

std::vector<Pressed> pressed_by_merge(const Complex& complex, const Monodromy& monodromy, DirectedTetEdge e) {
  std::vector<Pressed> pairs;
  FreeWord along; // from the edge's end to its start
  for (const Walk& w : complex.around(e)) {
    Pressed pair{{w.tet, w.from()}, {w.tet, w.to()}, Perm4::swap(w.from(), w.to()), {}};
    pair.word[w.to()] = along;
    pairs.push_back(std::move(pair));
    const int left = w.left_face().face;
    along = product(inverse(monodromy.at(w.tet, w.to(), left)),
                    product(along, monodromy.at(w.tet, w.from(), left)));
  }
  return pairs;
}

/// Two tetrahedra at an edge of valence 2.
std::vector<Pressed> pressed_at_edge(const Complex& complex, const Monodromy& monodromy, DirectedTetEdge e) {
  const Walk one{e.tet, edge_frame(e.from, e.to)};
  const Gluing g = complex.gluing(one.left_face());
  std::vector<Pressed> pairs;
  for (const int end : {e.from, e.to}) {
    Pressed pair{{one.tet, end}, {g.tet, g.perm[end]}, g.perm, {}};
    for (const int v : face_vertex[end]) {
      const int through = v == one.left_face().face ? one.right_face().face : one.left_face().face;
      pair.word[v] = monodromy.at(one.tet, v, through);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

/// Two tetrahedra at a vertex of degree 2.
std::vector<Pressed> pressed_at_vertex(const Complex& complex, const Monodromy& monodromy, TetVertex v) {
  const Gluing g = complex.gluing(TetFace{v.tet, face_vertex[v.vertex][0]});
  Pressed pair{{v.tet, v.vertex}, {g.tet, g.perm[v.vertex]}, g.perm, {}};
  for (const int c : face_vertex[v.vertex]) {
    const int through = face_vertex[v.vertex][face_vertex[v.vertex][0] == c ? 1 : 0];
    pair.word[c] = monodromy.at(v.tet, c, through);
  }
  return {pair};
}

/// A crossing as it will be: the face of a tetrahedron that stays, near a vertex.
struct Crossing {
  int tet;
  int vertex;
  int face;
  FreeWord word;
};

std::vector<Crossing> crossings_through(const Complex& complex, const Monodromy& monodromy,
                                        const std::vector<Pressed>& pairs) {
  std::map<TetFace, std::pair<const Pressed*, bool>> at; // of each pressed face, whether it is b
  std::map<int, bool> flat;
  for (const Pressed& pair : pairs) {
    at[pair.a] = {&pair, false};
    at[pair.b] = {&pair, true};
    flat[pair.a.tet] = flat[pair.b.tet] = true;
  }
  std::vector<Crossing> out;
  for (const auto& [face, unused] : at) {
    const Gluing first = complex.gluing(face);
    if (first.tet < 0 || flat.count(first.tet) > 0) continue;
    const TetFace start{first.tet, first.perm[face.face]};
    for (const int v : face_vertex[start.face]) {
      FreeWord word;
      TetFace leaving = start;
      int vertex = v;
      while (true) {
        const Gluing g = complex.gluing(leaving);
        word = product(word, monodromy.at(leaving.tet, vertex, leaving.face));
        if (g.tet < 0 || flat.count(g.tet) == 0) break;
        vertex = g.perm[vertex];
        const auto& [pair, is_b] = at.at(TetFace{g.tet, g.perm[leaving.face]});
        const Perm4 map = is_b ? pair->map.inverse() : pair->map;
        word = product(word, is_b ? inverse(pair->word[map[vertex]]) : pair->word[vertex]);
        vertex = map[vertex];
        leaving = is_b ? pair->a : pair->b;
        if (complex.gluing(leaving).tet < 0) break;
      }
      out.push_back({start.tet, v, start.face, std::move(word)});
    }
  }
  return out;
}

bool carry_pressed(Complex& complex, Monodromy& monodromy, const Move& move,
                   const std::vector<Pressed>& pairs) {
  const std::vector<Crossing> crossings = crossings_through(complex, monodromy, pairs);
  if (apply(complex, move)) return false;
  for (const Pressed& pair : pairs) {
    monodromy.clear(pair.a.tet);
    monodromy.clear(pair.b.tet);
  }
  for (const Crossing& c : crossings) monodromy.at(c.tet, c.vertex, c.face) = c.word;
  return true;
}

/// A 2-3 move, then the 2-0 move at an edge of valence 2 that it leaves.
bool carry_two_one(Complex& complex, Monodromy& monodromy, DirectedTetEdge e) {
  if (why_not_two_one(complex, e)) return false;
  const bool first = carry(complex, monodromy, {MoveKind::two_three, e.tet, e.from});
  const int to = face_corner(e.from, e.to);
  const int holder = complex.last_change().new_tets[to == 2 ? 1 : 0];
  if (!first || !carry(complex, monodromy, {MoveKind::two_zero_edge, holder, 2, to == 0 ? 0 : 1}))
    throw PreconditionError("carry: the second half of a 2-1 move is impossible");
  return true;
}

void carry_pack(Complex& complex, Monodromy& monodromy) {
  const std::vector<int> image = complex.pack().tet;
  Monodromy packed(complex.slot_count());
  for (std::size_t slot = 0; slot < image.size(); ++slot)
    if (image[slot] >= 0) packed.take(image[slot], monodromy, static_cast<int>(slot));
  monodromy = std::move(packed);
  shorten(complex, monodromy);
}

} // namespace

bool carry(Complex& complex, Monodromy& monodromy, const Move& move) {
  switch (move.kind) {
  case MoveKind::two_three:
    return carry_ball(complex, monodromy, two_three_ball(complex, move.face()));
  case MoveKind::three_two:
    return carry_ball(complex, monodromy, three_two_ball(complex, move.edge()));
  case MoveKind::four_four:
    return carry_ball(complex, monodromy, four_four_ball(complex, move.edge(), move.n));
  case MoveKind::merge:
    if (why_not_merge(complex, move.edge()) || complex.is_boundary(complex.edge(move.edge()))) return false;
    return carry_pressed(complex, monodromy, move, pressed_by_merge(complex, monodromy, move.edge()));
  case MoveKind::two_zero_edge:
    if (why_not_two_zero_edge(complex, move.edge())) return false;
    return carry_pressed(complex, monodromy, move, pressed_at_edge(complex, monodromy, move.edge()));
  case MoveKind::two_zero_vertex:
    if (why_not_two_zero_vertex(complex, move.vertex())) return false;
    return carry_pressed(complex, monodromy, move, pressed_at_vertex(complex, monodromy, move.vertex()));
  case MoveKind::two_one:
    return carry_two_one(complex, monodromy, move.edge());
  case MoveKind::pinch:
    return carry_pinch(complex, monodromy, move.edge());
  case MoveKind::pack:
    carry_pack(complex, monodromy);
    return true;
  default:
    return false;
  }
}

Monodromy carried(Monodromy monodromy, const Triangulation& before, const Ball& ball, const Replaced& after) {
  const WaysOut ways = ways_out(before, monodromy, ball);
  Monodromy out(after.tri.size());
  for (int t = 0; t < before.size(); ++t)
    if (after.image[t] >= 0) out.take(after.image[t], monodromy, t);
  std::vector<int> tets(ball.after.size());
  std::iota(tets.begin(), tets.end(), after.first_new);
  fill_in(out, ways, ball, tets);
  return out;
}

} // namespace tetrarch::moves
