// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/monodromy.hpp"

#include "regauge.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <numeric>

namespace tetrarch::moves {

namespace {

/// `is_there` says of a number below `count` whether there is such a tetrahedron.
template <class Gluings, class IsThere>
void shorten_at(const Gluings& tri, Monodromy& monodromy, int count, IsThere is_there) {
  std::vector<std::array<bool, 4>> done(static_cast<std::size_t>(count), {false, false, false, false});
  std::vector<TetVertex> front;
  for (int t = 0; t < count; ++t)
    for (int v = 0; is_there(t) && v < 4; ++v) {
      if (done[t][v]) continue;
      done[t][v] = true;
      front.assign(1, {t, v});
      for (std::size_t head = 0; head < front.size(); ++head) {
        const TetVertex at = front[head];
        for (int f = 0; f < 4; ++f) {
          if (f == at.vertex) continue;
          const Gluing g = tri.gluing(TetFace{at.tet, f});
          if (g.tet < 0 || done[g.tet][g.perm[at.vertex]]) continue;
          const TetVertex next{g.tet, g.perm[at.vertex]};
          regauge(tri, monodromy, next, inverse(monodromy.at(at.tet, at.vertex, f)));
          done[next.tet][next.vertex] = true;
          front.push_back(next);
        }
      }
    }
}

} // namespace

FreeWord product(const FreeWord& a, const FreeWord& b) {
  std::size_t cancelled = 0;
  while (cancelled < a.size() && cancelled < b.size() && a[a.size() - 1 - cancelled] == -b[cancelled])
    ++cancelled;
  FreeWord ab(a.begin(), a.end() - static_cast<std::ptrdiff_t>(cancelled));
  ab.insert(ab.end(), b.begin() + static_cast<std::ptrdiff_t>(cancelled), b.end());
  return ab;
}

FreeWord inverse(const FreeWord& a) {
  FreeWord back(a.rbegin(), a.rend());
  for (int& letter : back) letter = -letter;
  return back;
}

long long Monodromy::letter_count() const {
  long long count = 0;
  for (const auto& tet : words_)
    for (const auto& vertex : tet)
      for (const FreeWord& word : vertex) count += static_cast<long long>(word.size());
  return count;
}

bool is_monodromy(const Triangulation& tri, const Skeleton& skeleton, const Monodromy& monodromy) {
  if (monodromy.size() != tri.size()) return false;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet < 0) continue;
      for (const int v : face_vertex[f])
        if (monodromy.at(g.tet, g.perm[v], g.perm[f]) != inverse(monodromy.at(t, v, f))) return false;
    }
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_boundary(e) || skeleton.is_reversed(e)) continue;
    FreeWord near_start;
    FreeWord near_end;
    for (const Walk& w : skeleton.around(e)) {
      near_start = product(near_start, monodromy.at(w.tet, w.from(), w.left_face().face));
      near_end = product(near_end, monodromy.at(w.tet, w.to(), w.left_face().face));
    }
    if (!near_start.empty() || !near_end.empty()) return false;
  }
  return true;
}

GraphLetters graph_letters(const Skeleton& skeleton, const Table<EdgeId, bool>& edges) {
  GraphLetters out{Table<EdgeId, int>(skeleton.edge_count(), 0), 0};
  std::vector<int> parent(static_cast<std::size_t>(skeleton.vertex_count()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (!edges[e]) continue;
    const auto [a, b] = skeleton.ends(e);
    const int root_a = numeric::find_root(parent, a.value);
    const int root_b = numeric::find_root(parent, b.value);
    if (root_a == root_b) out.letter[e] = ++out.count;
    parent[static_cast<std::size_t>(root_a)] = root_b;
  }
  return out;
}

void shorten(const Complex& complex, Monodromy& monodromy) {
  shorten_at(complex, monodromy, complex.slot_count(), [&complex](int t) { return complex.is_alive(t); });
}

void shorten(const Triangulation& tri, Monodromy& monodromy) {
  shorten_at(tri, monodromy, tri.size(), [](int) { return true; });
}

Monodromy compacted(const Monodromy& monodromy, const Complex::Compact& compact) {
  Monodromy out(compact.tri.size());
  for (std::size_t slot = 0; slot < compact.image.size(); ++slot)
    if (compact.image[slot] >= 0) out.take(compact.image[slot], monodromy, static_cast<int>(slot));
  return out;
}

void flatten_words(const Triangulation& tri, Monodromy& monodromy,
                   const std::vector<std::array<bool, 4>>& inside) {
  std::vector<std::array<bool, 4>> done(static_cast<std::size_t>(tri.size()), {false, false, false, false});
  std::vector<TetVertex> pending;
  for (int t = 0; t < tri.size(); ++t)
    for (int v = 0; v < 4; ++v) {
      if (done[t][v]) continue;
      done[t][v] = true;
      pending.push_back({t, v});
      while (!pending.empty()) {
        const TetVertex at = pending.back();
        pending.pop_back();
        for (int f = 0; f < 4; ++f) {
          if (f == at.vertex || !inside[at.tet][f]) continue;
          const Gluing g = tri.gluing({at.tet, f});
          const TetVertex next{g.tet, g.perm[at.vertex]};
          if (done[next.tet][next.vertex]) {
            if (!monodromy.at(at.tet, at.vertex, f).empty())
              throw PreconditionError("flatten_words: a loop inside a cell has a word");
            continue;
          }
          regauge(tri, monodromy, next, inverse(monodromy.at(at.tet, at.vertex, f)));
          done[next.tet][next.vertex] = true;
          pending.push_back(next);
        }
      }
    }
}

} // namespace tetrarch::moves
