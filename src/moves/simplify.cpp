// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/simplify.hpp"

#include <algorithm>
#include <deque>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace tetrarch::moves {
namespace {

/// Tetrahedra that wait to be looked at, each once.
class Worklist {
public:
  void push(int tet) {
    if (static_cast<std::size_t>(tet) >= waiting_.size())
      waiting_.resize(2 * static_cast<std::size_t>(tet) + 64);
    if (waiting_[static_cast<std::size_t>(tet)] != 0) return;
    waiting_[static_cast<std::size_t>(tet)] = 1;
    queue_.push_back(tet);
  }
  bool empty() const { return queue_.empty(); }
  int pop() {
    const int tet = queue_.front();
    queue_.pop_front();
    waiting_[static_cast<std::size_t>(tet)] = 0;
    return tet;
  }

private:
  std::deque<int> queue_;
  std::vector<char> waiting_;
};

/// Makes moves, counts them, writes them down, and has them audited.
class Mover {
public:
  Mover(Complex& complex, const SimplifyOptions& options) : complex_(complex), options_(options) {}

  /// True if the move was legal and is made.
  bool made(const Move& move) {
    if (apply(complex_, move)) return false;
    ++counts_.of[static_cast<std::size_t>(move.kind)];
    if (options_.log != nullptr) options_.log->push_back(move);
    if (options_.audit && ++since_audit_ >= options_.audit_every) {
      since_audit_ = 0;
      options_.audit(complex_);
    }
    return true;
  }
  const MoveCounts& counts() const { return counts_; }
  MoveCounts take_counts() { return std::exchange(counts_, {}); }

private:
  Complex& complex_;
  const SimplifyOptions& options_;
  MoveCounts counts_;
  int since_audit_ = 0;
};

/// Edges of large valence that cannot be merged along, each with a tetrahedron around it that shows why: the
/// two sides of its right face that would meet are one edge already, or both on the boundary. Around a hub
/// every tetrahedron would ask for the same merge, and each time all of them would be walked round. Where the
/// merge failed for a reason that is nowhere in particular, the next quarter of the valence asks in vain, and
/// once more is asked at the end.
class Hubs {
public:
  explicit Hubs(const Complex& complex) : complex_(complex) {}

  /// Whether a merge along the edge is illegal for this reason. O(1) where the reason of last time holds,
  /// else O(tetrahedra up to the first one that shows it).
  bool forbid(DirectedTetEdge e, int valence) {
    if (valence <= small) return false;
    const EdgeId edge = complex_.edge(e);
    if (complex_.is_reversed(edge)) return false; // no ring to walk round; the move itself says no
    if (const auto tired = failed_.find(edge.value); tired != failed_.end() && tired->second.asks_left > 0) {
      tired->second = {e.tet, tired->second.asks_left - 1};
      return true;
    }
    const auto known = shown_by_.find(edge.value);
    if (known != shown_by_.end() && shows(known->second, edge)) return true;
    const Walk start{e.tet, edge_frame(e.from, e.to)};
    Walk w = start;
    do {
      if (!shows(w, edge)) continue;
      shown_by_[edge.value] = w;
      return true;
    } while (w.step_left(complex_) && !(w == start));
    return false;
  }

  /// A merge that was not forbidden was illegal.
  void failed(DirectedTetEdge e, int valence) {
    if (valence > small) failed_[complex_.edge(e).value] = {e.tet, valence / 4};
  }

  /// The tetrahedra at which merges failed, or were last asked for; all that failed is forgotten.
  std::vector<int> take_failed() {
    std::vector<int> tets;
    for (const auto& [edge, last] : failed_) tets.push_back(last.tet);
    failed_.clear();
    std::sort(tets.begin(), tets.end());
    return tets;
  }

private:
  static constexpr int small = 32; ///< up to here the merge is planned without the heap

  struct Failed {
    int tet = 0;
    int asks_left = 0;
  };

  bool shows(const Walk& w, EdgeId edge) const {
    if (!complex_.is_alive(w.tet) || complex_.edge(w.edge()) != edge) return false;
    if (complex_.is_boundary(w.right_face())) return false; // which takes part in a merge on the boundary
    const EdgeId a = complex_.edge(DirectedTetEdge{w.tet, w.hold[0], w.hold[3]});
    const EdgeId b = complex_.edge(DirectedTetEdge{w.tet, w.hold[1], w.hold[3]});
    const auto is_fixed = [this](EdgeId x) { return complex_.is_boundary(x) || complex_.is_reversed(x); };
    return a == b || (is_fixed(a) && is_fixed(b));
  }

  const Complex& complex_;
  std::unordered_map<int, Walk> shown_by_;
  std::unordered_map<int, Failed> failed_; ///< by edge
};

/// The greedy part.
class Reducer {
public:
  Reducer(Complex& complex, const SimplifyOptions& options)
      : complex_(complex), options_(options), mover_(complex, options), hubs_(complex) {}

  void look_at_all() {
    for (int t = 0; t < complex_.slot_count(); ++t)
      if (complex_.is_alive(t)) waiting_.push(t);
  }
  void look_at_last_change() {
    for (const auto* tets : {&complex_.last_change().touched_tets, &complex_.last_change().new_tets})
      for (const int t : *tets)
        if (complex_.is_alive(t)) waiting_.push(t);
  }
  void run(const Progress& progress) {
    bool has_changed = true;
    while (has_changed) {
      has_changed = drain(progress);
      for (const int t : hubs_.take_failed())
        if (has_changed && complex_.is_alive(t)) waiting_.push(t);
    }
  }
  const MoveCounts& counts() const { return mover_.counts(); }

private:
  /// Looks until nobody waits. Whether anything was changed.
  bool drain(const Progress& progress) {
    constexpr int tets_between_reports = 4096;
    const double start = std::max(1, complex_.size());
    bool has_changed = false;
    for (int looked = 1; !waiting_.empty(); ++looked) {
      if (looked % tets_between_reports == 0) progress.step("simplifying", 1 - complex_.size() / start);
      const int t = waiting_.pop();
      if (!complex_.is_alive(t) || !improve_at(t)) continue;
      has_changed = true;
      look_at_last_change();
      if (complex_.is_alive(t)) waiting_.push(t);
    }
    return has_changed;
  }

  bool improve_at(int t) { return remove_small_edge(t) || merge_at(t) || improve_boundary(t); }

  bool remove_small_edge(int t) {
    for (int e = 0; e < 6; ++e) {
      const EdgeId edge = complex_.edge(TetEdge{t, e});
      if (complex_.valence(edge) > 3 || complex_.is_boundary(edge) || complex_.is_reversed(edge)) continue;
      const auto [a, b] = edge_vertex[e];
      switch (complex_.valence(edge)) {
      case 3:
        if (mover_.made({MoveKind::three_two, t, a, b})) return true;
        break;
      case 2:
        if (mover_.made({MoveKind::two_zero_edge, t, a, b})) return true;
        break;
      default:
        if (mover_.made({MoveKind::two_one, t, a, b}) || mover_.made({MoveKind::two_one, t, b, a}))
          return true;
      }
    }
    for (int v = 0; v < 4; ++v)
      if (complex_.degree(complex_.vertex({t, v})) == 2 && mover_.made({MoveKind::two_zero_vertex, t, v}))
        return true;
    return false;
  }

  bool merge_at(int t) {
    std::array<std::pair<int, int>, 6> edges;
    for (int e = 0; e < 6; ++e) edges[e] = {-complex_.valence(complex_.edge(TetEdge{t, e})), e};
    std::sort(edges.begin(), edges.end());
    for (const auto& [valence, e] : edges) {
      const auto [a, b] = edge_vertex[e];
      const VertexId from = complex_.vertex({t, a});
      const VertexId to = complex_.vertex({t, b});
      if (from == to) continue;
      const bool inside = complex_.link(from) == LinkKind::sphere || complex_.link(to) == LinkKind::sphere;
      if (!inside && !options_.change_boundary) continue;
      if (hubs_.forbid({t, a, b}, -valence)) continue;
      if (mover_.made({MoveKind::merge, t, a, b})) return true;
      hubs_.failed({t, a, b}, -valence);
    }
    return false;
  }

  bool improve_boundary(int t) {
    if (!options_.change_boundary) return false;
    bool free = false;
    for (int f = 0; f < 4; ++f) free = free || complex_.is_boundary(TetFace{t, f});
    if (!free) return false;
    if (mover_.made({MoveKind::shell, t})) return true;
    for (int f = 0; f < 4; ++f) {
      if (!complex_.is_boundary(TetFace{t, f})) continue;
      const auto [i, j, k] = face_vertex[f];
      for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, k}, std::pair{i, k}})
        if (mover_.made({MoveKind::close_book, t, a, b})) return true;
    }
    return false;
  }

  Complex& complex_;
  const SimplifyOptions& options_;
  Mover mover_;
  Hubs hubs_;
  Worklist waiting_;
};

/// What counts as smaller: finite vertices first, because they keep a manifold from being hyperbolized.
std::tuple<int, int, int> weight(const Complex& complex) {
  return {complex.vertex_count(), complex.size(), complex.boundary_face_count()};
}

/// Random moves; `told` hears of each one that was legal, while its change is the last one.
template <class Told>
void shake_and_tell(Complex& complex, int count, SplitMix64& random, Told told) {
  for (int k = 0; k < count && complex.size() > 0; ++k) {
    int t = random.below(complex.slot_count());
    while (!complex.is_alive(t)) t = (t + 1) % complex.slot_count();
    Move move{MoveKind::two_three, t, random.below(4)};
    if (random.below(2) == 0) {
      const auto [a, b] = edge_vertex[random.below(6)];
      move = {MoveKind::four_four, t, a, b, random.below(2)};
    }
    if (!apply(complex, move)) told(move);
  }
}

/// Pinches an edge from some finite vertex to another one, if there is such an edge; false if not.
bool pinch_somewhere(Complex& complex, Mover& mover) {
  for (int t = 0; t < complex.slot_count(); ++t) {
    if (!complex.is_alive(t)) continue;
    for (int e = 0; e < 6; ++e) {
      const auto [a, b] = edge_vertex[e];
      if (mover.made({MoveKind::pinch, t, a, b}) || mover.made({MoveKind::pinch, t, b, a})) return true;
    }
  }
  return false;
}

Table<VertexId, VertexId> pack(Complex& complex, MoveLog* log) {
  if (log != nullptr) log->push_back({MoveKind::pack});
  return complex.pack().vertex;
}

/// First one renaming, then the other.
void rename(Table<VertexId, VertexId>& names, const Table<VertexId, VertexId>& then) {
  for (VertexId& v : names)
    if (v.value >= 0) v = then[v];
}

} // namespace

void MoveCounts::add(const MoveCounts& more) {
  for (std::size_t k = 0; k < of.size(); ++k) of[k] += more.of[k];
}

long long MoveCounts::total() const {
  return std::accumulate(of.begin(), of.end(), 0LL);
}

MoveCounts reduce(Complex& complex, const SimplifyOptions& options, const Progress& progress) {
  Reducer reducer(complex, options);
  reducer.look_at_all();
  reducer.run(progress);
  return reducer.counts();
}

void shake(Complex& complex, int count, SplitMix64& random, MoveLog* log) {
  shake_and_tell(complex, count, random, [log](const Move& move) {
    if (log != nullptr) log->push_back(move);
  });
}

Simplification simplify(Complex& complex, const SimplifyOptions& options, const Progress& progress) {
  Simplification out{{}, complex.all_vertices()};
  out.counts = reduce(complex, options, progress);
  // Rarely a finite vertex is left with no legal merge: each round removes one.
  for (Mover mover(complex, options); pinch_somewhere(complex, mover);) {
    out.counts.add(mover.take_counts());
    out.counts.add(reduce(complex, options, progress));
  }
  rename(out.vertices, pack(complex, options.log));
  // Few are left now: their names are carried along apart from those of the many of before.
  Table<VertexId, VertexId> few = complex.all_vertices();
  SplitMix64 random(options.seed);
  MoveLog excursion;
  SimplifyOptions greed = options;
  greed.log = &excursion;
  constexpr int setting_out = 500; // what an excursion costs besides copying, in tetrahedra copied
  long long work = 0;
  for (int fruitless = 0; complex.size() > 0 && work < options.most_work; ++fruitless) {
    work += complex.size() + setting_out;
    const int budget = std::clamp(options.excursions_per_tet * complex.size(), options.least_excursions,
                                  options.most_excursions);
    if (fruitless >= budget) break;
    progress.step("shaking", static_cast<double>(fruitless) / budget);
    Complex trial = complex;
    excursion.clear();
    // All else is at a local minimum: only the neighbourhoods of the random moves are looked at.
    Reducer reducer(trial, greed);
    shake_and_tell(trial, 1 + random.below(std::min(2 * trial.size(), 20)), random, [&](const Move& move) {
      excursion.push_back(move);
      reducer.look_at_last_change();
    });
    reducer.run(progress.silent());
    if (weight(trial) > weight(complex)) continue;
    if (weight(trial) < weight(complex)) fruitless = -1;
    complex = std::move(trial);
    for (const Move& move : excursion) ++out.counts.of[static_cast<std::size_t>(move.kind)];
    if (options.log != nullptr) options.log->insert(options.log->end(), excursion.begin(), excursion.end());
    rename(few, pack(complex, options.log));
  }
  rename(out.vertices, few);
  return out;
}

Triangulation simplified(const Triangulation& tri, const SimplifyOptions& options, const Progress& progress) {
  Complex complex(tri);
  simplify(complex, options, progress);
  return complex.triangulation();
}

} // namespace tetrarch::moves
