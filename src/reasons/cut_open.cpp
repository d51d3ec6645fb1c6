// SPDX-License-Identifier: GPL-2.0-or-later
#include "cut_open.hpp"

#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::reasons {
namespace {

using algebra::Word;

/// Sets of numbers that have been joined.
class Joined {
public:
  explicit Joined(int count) : root_(static_cast<std::size_t>(count)) {
    std::iota(root_.begin(), root_.end(), 0);
  }
  int find(int x) {
    auto at = static_cast<std::size_t>(x);
    while (root_[at] != static_cast<int>(at))
      at = static_cast<std::size_t>(root_[at] = root_[static_cast<std::size_t>(root_[at])]);
    return static_cast<int>(at);
  }
  /// False if they were one set already.
  bool join(int a, int b) {
    const int ra = find(a);
    const int rb = find(b);
    root_[static_cast<std::size_t>(std::max(ra, rb))] = std::min(ra, rb);
    return ra != rb;
  }

private:
  std::vector<int> root_;
};

using Step = std::pair<int, bool>;
using Loop = std::vector<Step>;

Loop backwards(Loop path) {
  std::reverse(path.begin(), path.end());
  for (Step& step : path) step.second = !step.second;
  return path;
}

} // namespace

CutOpen::CutOpen(const Triangulation& tri, const Skeleton& skeleton, const Coordinates& coordinates)
    : tri_(tri), skeleton_(skeleton) {
  for (int t = 0; t < tri.size(); ++t) pieces_.emplace_back(coordinates, t);
  number_pieces();
  make_doors();
  make_arcs();
  find_shape();
}

void CutOpen::number_pieces() {
  int rooms = 0;
  int discs = 0;
  for (const Pieces& p : pieces_) {
    first_room_.push_back(rooms);
    first_disc_.push_back(discs);
    rooms += p.room_count();
    discs += p.disc_count();
  }
  first_room_.push_back(rooms);
  first_disc_.push_back(discs);
  int points = 0;
  for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
    first_point_.push_back(points);
    const Walk at = skeleton_.around(e).front();
    points += pieces_[static_cast<std::size_t>(at.tet)].points(at.from(), at.to());
  }
  first_point_.push_back(points);
}

int CutOpen::strips(int tet, int face) const {
  int sum = 1;
  for (const int v : face_vertex[face]) sum += pieces_[static_cast<std::size_t>(tet)].arcs(face, v);
  return sum;
}

int CutOpen::strip_of(int tet, int face, int corner, int k) const {
  const Pieces& p = pieces_[static_cast<std::size_t>(tet)];
  if (k == p.arcs(face, corner)) return strips(tet, face) - 1;
  int sum = k;
  for (const int v : face_vertex[face])
    if (v < corner) sum += p.arcs(face, v);
  return sum;
}

int CutOpen::room_of_strip(int tet, int face, int strip) const {
  const Pieces& p = pieces_[static_cast<std::size_t>(tet)];
  const int first = first_room_[static_cast<std::size_t>(tet)];
  for (const int v : face_vertex[face]) {
    if (strip < p.arcs(face, v)) return first + p.room_of_strip(v, strip);
    strip -= p.arcs(face, v);
  }
  return first + p.room_of_middle(face);
}

/// The door of a strip, and whether it is passed from its first side when one leaves this tetrahedron.
CutOpen::Passage CutOpen::passage(int tet, int face, int strip) const {
  const int first = first_door_[static_cast<std::size_t>(tet)][static_cast<std::size_t>(face)];
  const TetFace seen = skeleton_.preimages(skeleton_.face({tet, face})).front();
  if (seen == TetFace{tet, face}) return {first + strip, true};
  const Gluing g = tri_.gluing({tet, face});
  const Pieces& p = pieces_[static_cast<std::size_t>(tet)];
  int rest = strip;
  for (const int v : face_vertex[face]) {
    if (rest < p.arcs(face, v)) return {first + strip_of(g.tet, seen.face, g.perm[v], rest), false};
    rest -= p.arcs(face, v);
  }
  return {first + strip, false};
}

void CutOpen::make_doors() {
  first_door_.assign(pieces_.size(), std::vector<int>(4, -1));
  for (const FaceId f : all<FaceId>(skeleton_.face_count())) {
    const auto sides = skeleton_.preimages(f);
    for (const TetFace side : sides)
      first_door_[static_cast<std::size_t>(side.tet)][static_cast<std::size_t>(side.face)] =
          static_cast<int>(doors_.size());
    const int count = strips(sides[0].tet, sides[0].face);
    const auto first = doors_.size();
    doors_.resize(first + static_cast<std::size_t>(count));
    for (int s = 0; s < count; ++s) {
      doors_[first + static_cast<std::size_t>(s)].from = room_of_strip(sides[0].tet, sides[0].face, s);
      const Passage other = passage(sides[1].tet, sides[1].face, s);
      doors_[static_cast<std::size_t>(other.door)].to = room_of_strip(sides[1].tet, sides[1].face, s);
    }
  }
}

void CutOpen::make_arcs() {
  for (const FaceId f : all<FaceId>(skeleton_.face_count())) {
    const TetFace side = skeleton_.preimages(f).front();
    for (const int v : face_vertex[side.face])
      for (int k = 0; k < pieces_[static_cast<std::size_t>(side.tet)].arcs(side.face, v); ++k)
        arcs_.push_back({side.tet, side.face, v, k});
  }
}

int CutOpen::disc(int tet, int corner, int k) const {
  return first_disc_[static_cast<std::size_t>(tet)] +
         pieces_[static_cast<std::size_t>(tet)].disc_of_arc(corner, k);
}

int CutOpen::point(int tet, int corner, int towards, int k) const {
  const EdgeId e = skeleton_.edge({tet, edge_number[corner][towards]});
  const int count =
      first_point_[static_cast<std::size_t>(e.value) + 1] - first_point_[static_cast<std::size_t>(e.value)];
  return first_point_[static_cast<std::size_t>(e.value)] +
         (skeleton_.runs_along({tet, corner, towards}) ? k : count - 1 - k);
}

int CutOpen::next_disc(int arc, bool forward) const {
  const Arc& a = arcs_[static_cast<std::size_t>(arc)];
  if (!forward) return disc(a.tet, a.corner, a.number);
  const Gluing g = tri_.gluing({a.tet, a.face});
  return disc(g.tet, g.perm[a.corner], a.number);
}

void CutOpen::find_shape() {
  const int discs = first_disc_.back();
  shape_.euler = first_point_.back() - static_cast<int>(arcs_.size()) + discs;
  Joined parts(discs);
  Joined faces(2 * discs); // disc d as seen from its first side, and from its second
  for (int a = 0; a < static_cast<int>(arcs_.size()); ++a) {
    const Arc& arc = arcs_[static_cast<std::size_t>(a)];
    const Gluing g = tri_.gluing({arc.tet, arc.face});
    const int here = next_disc(a, false);
    const int there = next_disc(a, true);
    parts.join(here, there);
    const bool same =
        pieces_[static_cast<std::size_t>(arc.tet)].first_side_is_towards(arc.corner, arc.number) ==
        pieces_[static_cast<std::size_t>(g.tet)].first_side_is_towards(g.perm[arc.corner], arc.number);
    faces.join(2 * here, 2 * there + (same ? 0 : 1));
    faces.join(2 * here + 1, 2 * there + (same ? 1 : 0));
  }
  shape_.connected = discs > 0;
  for (int d = 0; d < discs; ++d) shape_.connected &= parts.find(d) == 0;
  shape_.two_sided = discs > 0 && faces.find(0) != faces.find(1);
  Joined rooms(first_room_.back());
  for (const Door& door : doors_) rooms.join(door.from, door.to);
  for (int r = 0; r < first_room_.back(); ++r) side_.push_back(rooms.find(r));
  shape_.separating =
      shape_.connected && shape_.two_sided &&
      side_[static_cast<std::size_t>(start_room(true))] != side_[static_cast<std::size_t>(start_room(false))];
}

/// The room beside the first disc.
int CutOpen::start_room(bool first_side) const {
  std::size_t tet = 0;
  while (first_disc_[tet + 1] == 0) ++tet;
  return first_room_[tet] + pieces_[tet].room_beside(0, first_side);
}

/// Of a torus: a tree of arcs that discs are joined across, a tree of further arcs that join points; two arcs
/// are left, and each closes a loop in the first tree.
std::vector<Loop> CutOpen::generating_loops() const {
  const int discs = first_disc_.back();
  std::vector<Loop> path(static_cast<std::size_t>(discs));
  std::vector<bool> reached(static_cast<std::size_t>(discs), false);
  std::vector<bool> used(arcs_.size(), false);
  std::vector<std::vector<Step>> out(static_cast<std::size_t>(discs));
  for (int a = 0; a < static_cast<int>(arcs_.size()); ++a) {
    out[static_cast<std::size_t>(next_disc(a, false))].emplace_back(a, true);
    out[static_cast<std::size_t>(next_disc(a, true))].emplace_back(a, false);
  }
  std::vector<int> queue{0};
  reached[0] = true;
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (const Step& step : out[static_cast<std::size_t>(queue[head])]) {
      const auto to = static_cast<std::size_t>(next_disc(step.first, step.second));
      if (reached[to]) continue;
      reached[to] = true;
      used[static_cast<std::size_t>(step.first)] = true;
      path[to] = path[static_cast<std::size_t>(queue[head])];
      path[to].push_back(step);
      queue.push_back(static_cast<int>(to));
    }
  Joined points(first_point_.back());
  std::vector<Loop> loops;
  for (int a = 0; a < static_cast<int>(arcs_.size()); ++a) {
    if (used[static_cast<std::size_t>(a)]) continue;
    const Arc& arc = arcs_[static_cast<std::size_t>(a)];
    std::array<int, 2> ends{};
    int n = 0;
    for (const int x : face_vertex[arc.face])
      if (x != arc.corner) ends[static_cast<std::size_t>(n++)] = point(arc.tet, arc.corner, x, arc.number);
    if (points.join(ends[0], ends[1])) continue;
    Loop loop = path[static_cast<std::size_t>(next_disc(a, false))];
    loop.emplace_back(a, true);
    const Loop home = backwards(path[static_cast<std::size_t>(next_disc(a, true))]);
    loop.insert(loop.end(), home.begin(), home.end());
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// The doors that one walks through beside a loop of the surface, on one side of it.
Word CutOpen::push(const Loop& loop, bool first_side, const std::vector<int>& letter) const {
  Word word;
  bool first = first_side;
  for (const auto& [a, forward] : loop) {
    const Arc& arc = arcs_[static_cast<std::size_t>(a)];
    const Gluing g = tri_.gluing({arc.tet, arc.face});
    std::array<int, 2> tet{arc.tet, g.tet};
    std::array<int, 2> face{arc.face, g.perm[arc.face]};
    std::array<int, 2> corner{arc.corner, g.perm[arc.corner]};
    const std::size_t here = forward ? 0 : 1;
    const std::size_t there = 1 - here;
    const auto towards = [&](std::size_t end) {
      return pieces_[static_cast<std::size_t>(tet[end])].first_side_is_towards(corner[end], arc.number);
    };
    const bool near_corner = first == towards(here);
    const int strip =
        strip_of(tet[here], face[here], corner[here], near_corner ? arc.number : arc.number + 1);
    const Passage through = passage(tet[here], face[here], strip);
    const int x = letter[static_cast<std::size_t>(through.door)];
    if (x != 0) word.push_back(through.forward ? x : -x);
    first = near_corner == towards(there);
  }
  return algebra::freely_reduced(word);
}

int CutOpen::strip_at_edge(int tet, int face, int i, int j, int segment) const {
  const Pieces& p = pieces_[static_cast<std::size_t>(tet)];
  if (segment <= p.arcs(face, i)) return strip_of(tet, face, i, segment);
  return strip_of(tet, face, j, p.points(i, j) - segment);
}

std::vector<Side> CutOpen::sides() const {
  std::vector<Side> parts;
  for (const bool first_side : {true, false}) {
    const int start = start_room(first_side);
    const int number = side_[static_cast<std::size_t>(start)];
    if (!first_side && !shape_.separating) break;
    Side side;
    Joined tree(first_room_.back());
    std::vector<int> letter(doors_.size(), 0);
    for (std::size_t d = 0; d < doors_.size(); ++d) {
      if (side_[static_cast<std::size_t>(doors_[d].from)] != number) continue;
      if (!tree.join(doors_[d].from, doors_[d].to)) letter[d] = ++side.group.generators;
    }
    for (const EdgeId e : all<EdgeId>(skeleton_.edge_count())) {
      const auto around = skeleton_.around(e);
      const int segments = first_point_[static_cast<std::size_t>(e.value) + 1] -
                           first_point_[static_cast<std::size_t>(e.value)] + 1;
      for (int s = 0; s < segments; ++s) {
        Word relator;
        bool here = true;
        for (const Walk& w : around) {
          const int strip = strip_at_edge(w.tet, w.left_face().face, w.from(), w.to(), s);
          here &= side_[static_cast<std::size_t>(room_of_strip(w.tet, w.left_face().face, strip))] == number;
          const Passage through = passage(w.tet, w.left_face().face, strip);
          const int x = letter[static_cast<std::size_t>(through.door)];
          if (x != 0) relator.push_back(through.forward ? x : -x);
        }
        if (here) side.group.relators.push_back(std::move(relator));
      }
    }
    std::set<int> vertices;
    for (int t = 0; t < tri_.size(); ++t)
      for (int v = 0; v < 4; ++v)
        if (side_[static_cast<std::size_t>(first_room_[static_cast<std::size_t>(t)]) +
                  static_cast<std::size_t>(pieces_[static_cast<std::size_t>(t)].room_at_corner(v))] == number)
          vertices.insert(skeleton_.vertex({t, v}).value);
    for (const int v : vertices)
      if (!skeleton_.link(VertexId(v)).is_sphere()) side.boundary.emplace_back(v);
    if (shape_.euler == 0 && shape_.two_sided)
      for (const Loop& loop : generating_loops()) side.loops.push_back(push(loop, first_side, letter));
    parts.push_back(std::move(side));
  }
  return parts;
}

} // namespace tetrarch::reasons
