// SPDX-License-Identifier: GPL-2.0-or-later
#include "handles.hpp"

#include "handle.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/cuts.hpp"
#include "tree_cotree.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace tetrarch::surface {
namespace {

/// Triangles of the first ball around a place. A few times what a small handle has.
constexpr int first_ball = 32;
/// Of a triangle, in edges, for each place beyond it. On plates with holes more makes longer loops, and less
/// makes longer ways.
constexpr double toll_of_place = 1;

/// Where a handle may be, by the size of the ball to be tried next, then by rank.
struct Place {
  int ball = first_ball;
  int rank = 0;
  Side side;
  auto operator<=>(const Place& other) const {
    return std::pair(ball, rank) <=> std::pair(other.ball, other.rank);
  }
};

class Opener {
public:
  Opener(MarkedSurface& surface, const Progress& progress) : surface_(surface), progress_(progress) {
    on_loop_.assign(static_cast<std::size_t>(surface.surface.vertex_count()), 0);
  }

  Handles run(int base) && {
    const int genus = type_of(surface_.surface).genus();
    const std::vector<Side> places = closing_edges(base);
    const Side at_base = side_from(base);
    tolls_ = tolls_from(at_base.triangle(), places);
    for (int ball = first_ball; !try_ball(base, at_base.triangle(), ball);) ball *= 2;
    std::priority_queue<Place, std::vector<Place>, std::greater<>> queue;
    for (std::size_t k = 0; k < places.size(); ++k) queue.push({first_ball, static_cast<int>(k), places[k]});
    while (static_cast<int>(result_.point.size()) < genus) {
      progress_.step("opening handles", static_cast<double>(result_.point.size()) / genus);
      Place place = queue.top();
      queue.pop();
      const auto [root, triangle] = free_vertex_near(place.side.triangle(), place.ball);
      if (!try_ball(root, triangle, place.ball)) place.ball *= 2;
      queue.push(place);
    }
    return std::move(result_);
  }

private:
  struct Root {
    int vertex;
    int triangle;
  };

  std::vector<Side> closing_edges(int base) const {
    const std::vector<double> length = side_lengths(surface_);
    return close_loops(surface_.surface, length, shortest_paths(surface_.surface, length, {base}), false)
        .edges;
  }
  Tolls tolls_from(int triangle, const std::vector<Side>& places) const;
  Side side_from(int vertex) const {
    int k = 0;
    while (surface_.surface.from(Side(k)) != vertex) ++k;
    return Side(k);
  }
  bool is_free(int vertex) const {
    return vertex >= static_cast<int>(on_loop_.size()) || on_loop_[vertex] == 0;
  }

  std::vector<int> triangles_around(int triangle, int root, int size);
  Surface part_of(const std::vector<int>& ball);
  Root free_vertex_near(int triangle, int size);
  bool try_ball(int root, int triangle, int size);
  void open(int root, int triangle, const std::vector<int>& ball);

  MarkedSurface& surface_;
  const Progress& progress_;
  Handles result_;
  std::vector<char> on_loop_; ///< of each vertex; those beyond the end are new and free
  Tolls tolls_;
  std::vector<int> seen_;  ///< of each triangle, the search that met it last
  std::vector<int> local_; ///< and its number in that ball
  int searches_ = 0;
};

/// Of the tree of shortest ways from a triangle, by how many handles' places lie beyond: a loop across the
/// ways to many of them makes all their strands longer. This leaves the loops near where the ways meet.
Tolls Opener::tolls_from(int triangle, const std::vector<Side>& places) const {
  const Surface& whole = surface_.surface;
  const auto steps = [&](int t, const auto& visit) {
    for (const Side s : sides_of(t)) visit(whole.mate(s).triangle(), dual_length(surface_, s), s);
  };
  const std::size_t n = static_cast<std::size_t>(whole.triangle_count());
  const auto ways = numeric::shortest_paths(n, {triangle}, Side(), steps);
  Tolls tolls{std::vector<int>(n, -1), std::vector<double>(n, 0)};
  for (const Side s : places) tolls.of[s.triangle()] += toll_of_place;
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return ways.distance[a] > ways.distance[b]; });
  for (const int t : order)
    if (ways.last[t].exists()) {
      tolls.parent[t] = ways.last[t].triangle();
      tolls.of[tolls.parent[t]] += tolls.of[t];
    }
  return tolls;
}

/// The nearest triangles, going across no loop, by the number of edges between; of a root the whole fan
/// first. At least `size` of them, if there are so many.
std::vector<int> Opener::triangles_around(int triangle, int root, int size) {
  const Surface& whole = surface_.surface;
  seen_.resize(static_cast<std::size_t>(whole.triangle_count()), 0);
  ++searches_;
  std::vector<int> found{triangle};
  seen_[triangle] = searches_;
  const auto grow = [&](std::size_t next, auto crosses) {
    for (; next < found.size(); ++next)
      for (const Side s : sides_of(found[next])) {
        if (surface_.is_cut(s) || !crosses(s, found.size())) continue;
        const int other = whole.mate(s).triangle();
        if (std::exchange(seen_[other], searches_) != searches_) found.push_back(other);
      }
  };
  grow(0, [&](Side s, std::size_t) { return whole.from(s) == root || whole.to(s) == root; });
  grow(0, [&](Side, std::size_t count) { return static_cast<int>(count) < size; });
  return found;
}

/// The ball found last, cut along the loops.
Surface Opener::part_of(const std::vector<int>& ball) {
  local_.resize(seen_.size());
  for (std::size_t k = 0; k < ball.size(); ++k) local_[ball[k]] = static_cast<int>(k);
  Table<Side, Side> mate(3 * static_cast<int>(ball.size()));
  for (std::size_t k = 0; k < ball.size(); ++k)
    for (const Side s : sides_of(ball[k])) {
      const Side m = surface_.surface.mate(s);
      if (!surface_.is_cut(s) && seen_[m.triangle()] == searches_)
        mate[Side(static_cast<int>(k), s.corner())] = Side(local_[m.triangle()], m.corner());
    }
  return Surface(mate);
}

/// A vertex on no loop among those of the triangles around, or a new one.
Opener::Root Opener::free_vertex_near(int triangle, int size) {
  for (const int t : triangles_around(triangle, -1, size))
    for (const int v : surface_.surface.corners(t))
      if (is_free(v)) return {v, t};
  ++result_.splits.faces;
  return {split_face(surface_, triangle), triangle};
}

/// Opens a handle at the root, if there is one in the ball.
bool Opener::try_ball(int root, int triangle, int size) {
  const std::vector<int> ball = triangles_around(triangle, root, size);
  if (type_of(part_of(ball)).genus() == 0) return false;
  open(root, triangle, ball);
  return true;
}

/// In a copy of the ball, and then in the surface.
void Opener::open(int root, int triangle, const std::vector<int>& ball) {
  MarkedSurface copy(part_of(ball));
  int base = -1;
  if (!surface_.points.empty()) copy.points.resize(static_cast<std::size_t>(copy.surface.vertex_count()));
  for (std::size_t k = 0; k < ball.size(); ++k) {
    copy.origin[k] = surface_.origin[ball[k]];
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = surface_.surface.corners(ball[k])[c];
      const int here = copy.surface.corners(static_cast<int>(k))[c];
      if (v == root && ball[k] == triangle) base = here;
      if (!surface_.points.empty()) copy.points[here] = surface_.points[v];
    }
  }
  const SplitCount count = lay_handle(copy, base, tolls_, progress_.silent());
  result_.splits.edges += count.edges;
  result_.splits.faces += count.faces;
  std::vector<int> name = ball;
  for (const Edit& edit : copy.edits) repeat(surface_, edit, name);
  on_loop_.resize(static_cast<std::size_t>(surface_.surface.vertex_count()), 0);
  const int first = 2 * static_cast<int>(result_.point.size());
  for (int k = 0; k < copy.surface.side_count(); ++k) {
    const int m = copy[Side(k)];
    if (m <= 0) continue;
    const Side s(name[Side(k).triangle()], Side(k).corner());
    set_mark(surface_, s, first + m);
    on_loop_[surface_.surface.from(s)] = on_loop_[surface_.surface.to(s)] = 1;
  }
  result_.point.push_back(root);
}

} // namespace

Handles lay_handles(MarkedSurface& surface, int base, const Progress& progress) {
  return Opener(surface, progress).run(base);
}

} // namespace tetrarch::surface
