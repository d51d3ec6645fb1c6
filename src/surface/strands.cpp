// SPDX-License-Identifier: GPL-2.0-or-later
#include "strands.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace tetrarch::surface {
namespace {

/// A passage through a triangle between two places of its boundary, counted counterclockwise from corner 1;
/// the mark is that of the side from `from` to `to`.
struct Passage {
  int from = 0;
  int to = 0;
  int mark = 0;
};

using Order = Table<Side, std::vector<Crossing>>;

class Cutter;

class Weaver {
public:
  Weaver(MarkedSurface& surface, const Order& order)
      : surface_(surface), order_(order), points_on_(order.size()),
        passages_(static_cast<std::size_t>(order.size() / 3)), pieces_(order.size()),
        vertices_(surface.surface.vertex_count()) {}

  int run(const std::vector<Strand>& strands) && {
    const int before = vertices_;
    for (int k = 0; k < order_.size(); ++k) halve(Side(k));
    pass(strands);
    corners_ = surface_.surface.triangles();
    mate_ = std::vector<Side>(surface_.mark.size());
    for (int t = 0; t < surface_.surface.triangle_count(); ++t) {
      if (passages_[t].empty())
        for (const Side s : sides_of(t)) pieces_[s] = {s};
      else
        cut(t);
    }
    for (int k = 0; k < order_.size(); ++k) join(Side(k));
    surface_.edits.clear(); // of other triangles
    surface_.surface = Surface(vertices_, std::move(corners_), Table<Side, Side>(std::move(mate_)));
    return vertices_ - before;
  }

private:
  friend class Cutter;
  /// The side of lesser number at the same edge.
  Side first(Side s) const {
    const Side m = surface_.surface.mate(s);
    return m.exists() && m.value < s.value ? m : s;
  }
  int count_on(Side s) const { return static_cast<int>(order_[first(s)].size()); }
  /// Of the start of a side, in its triangle.
  int place(Side s) const {
    int before = 0;
    for (int c = 0; c < s.corner(); ++c) before += 1 + count_on(Side(s.triangle(), c));
    return before;
  }
  int place(Side s, int rank) const { return place(s) + 1 + (first(s) == s ? rank : count_on(s) - 1 - rank); }
  static Side from_corner(SideEnd e) { return Side(e.side.triangle(), (e.corner() + 2) % 3); }

  void halve(Side s);
  int put_middle(int from, int to);
  void pass(const std::vector<Strand>& strands);
  void cut(int triangle);
  Side add_triangle(int like, const Surface::Triangle& corners);
  void glue(Side s, Side m) {
    mate_[s.value] = m;
    mate_[m.value] = s;
  }
  void join(Side s);

  MarkedSurface& surface_;
  const Order& order_;
  Table<Side, std::vector<int>> points_on_;    ///< of each first side, the new vertices from its start on
  std::vector<std::vector<Passage>> passages_; ///< of each triangle
  Table<Side, std::vector<Side>> pieces_;      ///< of each old side, the new ones from its start on
  int vertices_;
  std::vector<Surface::Triangle> corners_;
  std::vector<Side> mate_;
};

int Weaver::put_middle(int from, int to) {
  surface_.splits.push_back({vertices_, {from, to, -1}});
  if (!surface_.points.empty()) {
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = surface_.points[from][k] / 2 + surface_.points[to][k] / 2;
    surface_.points.push_back(p);
  }
  return vertices_++;
}

/// Puts vertices on an edge, each in the middle between two others.
void Weaver::halve(Side s) {
  const int count = static_cast<int>(order_[s].size());
  if (count == 0) return;
  if (surface_.is_cut(s)) throw PreconditionError("a strand crosses a marked edge");
  std::vector<int>& points = points_on_[s];
  points.resize(static_cast<std::size_t>(count));
  const auto point = [&](int k) {
    if (k < 0) return surface_.surface.from(s);
    return k < count ? points[k] : surface_.surface.to(s);
  };
  std::vector<std::pair<int, int>> gaps{{-1, count}};
  while (!gaps.empty()) {
    const auto [from, to] = gaps.back();
    gaps.pop_back();
    if (to - from < 2) continue;
    const int middle = from + (to - from) / 2;
    points[middle] = put_middle(point(from), point(to));
    gaps.emplace_back(middle, to);
    gaps.emplace_back(from, middle);
  }
}

void Weaver::pass(const std::vector<Strand>& strands) {
  std::vector<std::vector<int>> rank(strands.size());
  for (std::size_t k = 0; k < strands.size(); ++k) rank[k].assign(strands[k].crossed.size(), -1);
  for (const std::vector<Crossing>& along : order_)
    for (std::size_t k = 0; k < along.size(); ++k)
      rank[along[k].strand][static_cast<std::size_t>(along[k].step)] = static_cast<int>(k);
  for (std::size_t k = 0; k < strands.size(); ++k) {
    const Strand& strand = strands[k];
    int from = place(from_corner(strand.from));
    for (std::size_t step = 0; step < strand.crossed.size(); ++step) {
      const Side s = strand.crossed[step];
      passages_[s.triangle()].push_back({from, place(s, rank[k][step]), strand.mark});
      from = place(surface_.surface.mate(s), rank[k][step]);
    }
    passages_[strand.to.side.triangle()].push_back({from, place(from_corner(strand.to)), strand.mark});
  }
}

/// The first takes the number of the old triangle.
Side Weaver::add_triangle(int like, const Surface::Triangle& corners) {
  int t = like;
  if (corners_[like][0] >= 0) {
    t = static_cast<int>(corners_.size());
    corners_.emplace_back();
    mate_.resize(mate_.size() + 3);
    surface_.mark.resize(surface_.mark.size() + 3, 0);
    surface_.origin.push_back(surface_.origin[like]);
  }
  corners_[t] = corners;
  return {t, 0};
}

/// Glues the pieces of an old edge.
void Weaver::join(Side s) {
  if (surface_.surface.is_boundary(s)) return;
  const std::vector<Side>& here = pieces_[s];
  const std::vector<Side>& there = pieces_[surface_.surface.mate(s)];
  for (std::size_t k = 0; k < here.size(); ++k) glue(here[k], there[here.size() - 1 - k]);
}

/// Cuts off what lies beyond the passages, the shortest stretches of the boundary first, then what is left.
class Cutter {
public:
  Cutter(Weaver& all, int triangle);
  void cut_off(const Passage& passage);
  /// What is left.
  void fill_rest();

private:
  /// From one place of the boundary, as it is by now, to the next.
  struct Piece {
    Side old;     ///< the side of the old triangle that it lies on, or none
    int rank = 0; ///< of the piece on that side
    Side beyond;  ///< else the new side there
    int mark = 0;
  };
  Side fill(const std::vector<int>& places, bool is_rest);
  void take(const Piece& piece, Side s);
  double diagonal(int a, int b) const {
    const auto& points = all_.surface_.points;
    return points.empty() ? 0 : numeric::distance(points[vertex_[a]], points[vertex_[b]]);
  }

  Weaver& all_;
  int triangle_;
  std::vector<int> vertex_;  ///< of each place
  std::vector<Piece> piece_; ///< that starts there
  std::vector<int> next_;    ///< place on the boundary of what is left
};

Cutter::Cutter(Weaver& all, int triangle) : all_(all), triangle_(triangle) {
  for (const Side s : sides_of(triangle)) {
    std::vector<int> points = all.points_on_[all.first(s)];
    if (all.first(s) != s) std::reverse(points.begin(), points.end());
    vertex_.push_back(all.surface_.surface.from(s));
    vertex_.insert(vertex_.end(), points.begin(), points.end());
    const int pieces = static_cast<int>(points.size()) + 1;
    for (int rank = 0; rank < pieces; ++rank) piece_.push_back({s, rank, Side(), all.surface_[s]});
    all.pieces_[s].assign(static_cast<std::size_t>(pieces), Side());
  }
  for (const Side s : sides_of(triangle)) all.surface_.mark[s.value] = 0;
  all.corners_[triangle] = {-1, -1, -1};
  const int places = static_cast<int>(vertex_.size());
  for (int k = 1; k <= places; ++k) next_.push_back(k % places);
}

/// New side s is this piece of the boundary.
void Cutter::take(const Piece& piece, Side s) {
  all_.surface_.mark[s.value] = piece.mark;
  if (piece.old.exists())
    all_.pieces_[piece.old][static_cast<std::size_t>(piece.rank)] = s;
  else
    all_.glue(s, piece.beyond);
}

/// Makes a polygon of places a fan; one of four is cut along its shorter diagonal. Returns the side from the
/// last place to the first, if the polygon is not the rest.
Side Cutter::fill(const std::vector<int>& places, bool is_rest) {
  const std::size_t n = places.size();
  const bool turn = n == 4 && diagonal(places[1], places[3]) < diagonal(places[0], places[2]);
  const auto place = [&](std::size_t k) { return (k + (turn ? 1 : 0)) % n; };
  Side last;
  // Side s leads from place k of the fan to the next.
  const auto put = [&](std::size_t k, Side s) {
    if (place(k) == n - 1 && !is_rest)
      last = s;
    else
      take(piece_[places[place(k)]], s);
  };
  const auto corner = [&](std::size_t k) { return vertex_[places[place(k)]]; };
  Side before;
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Side s = all_.add_triangle(triangle_, {corner(0), corner(k), corner(k + 1)});
    put(k, s);
    if (k == 1)
      put(0, s.previous());
    else
      all_.glue(s.previous(), before);
    before = s.next();
  }
  put(n - 1, before);
  return last;
}

void Cutter::cut_off(const Passage& passage) {
  const int from = std::min(passage.from, passage.to);
  const int to = std::max(passage.from, passage.to);
  std::vector<int> places;
  for (int k = from; k != to; k = next_[k]) places.push_back(k);
  places.push_back(to);
  if (places.size() < 3) throw PreconditionError("a strand leaves a corner along an edge");
  const Side s = fill(places, false);
  const int mark = passage.from == to ? passage.mark : -passage.mark; // of s, which runs from `to` to `from`
  all_.surface_.mark[s.value] = mark;
  piece_[from] = {Side(), 0, s, -mark};
  next_[from] = to;
}

void Cutter::fill_rest() {
  std::vector<int> places{0};
  for (int k = next_[0]; k != 0; k = next_[k]) places.push_back(k);
  fill(places, true);
}

void Weaver::cut(int triangle) {
  std::vector<Passage>& passages = passages_[triangle];
  std::sort(passages.begin(), passages.end(), [](const Passage& x, const Passage& y) {
    const auto key = [](const Passage& p) {
      return std::pair(std::abs(p.to - p.from), std::min(p.from, p.to));
    };
    return key(x) < key(y);
  });
  Cutter cutter(*this, triangle);
  for (const Passage& passage : passages) cutter.cut_off(passage);
  cutter.fill_rest();
}

} // namespace

int lay_strands(MarkedSurface& surface, const std::vector<Strand>& strands,
                const Table<Side, std::vector<Crossing>>& order) {
  return Weaver(surface, order).run(strands);
}

} // namespace tetrarch::surface
