// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/surface.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::surface {
namespace {

using Triangles = std::vector<Surface::Triangle>;

void check_corners(int vertices, const Triangles& triangles) {
  if (triangles.size() > std::numeric_limits<int>::max() / 3) throw InputError("too many triangles");
  std::vector<char> used(static_cast<std::size_t>(std::max(vertices, 0)), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const int v : triangles[t]) {
      if (v < 0 || v >= vertices)
        throw InputError("triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                         ", but there are " + std::to_string(vertices));
      used[v] = 1;
    }
    const auto& [a, b, c] = triangles[t];
    if (a == b || b == c || c == a) throw InputError("triangle " + std::to_string(t) + " has a vertex twice");
  }
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused != used.end())
    throw InputError("vertex " + std::to_string(unused - used.begin()) + " is in no triangle");
}

/// Sides sorted by the lesser of their two ends: those of vertex v are sides[first[v]] ..
/// sides[first[v+1]-1].
struct SidesByVertex {
  std::vector<int> first;
  std::vector<Side> sides;
};

SidesByVertex sort_sides(int vertices, const Triangles& triangles) {
  SidesByVertex out{std::vector<int>(static_cast<std::size_t>(vertices) + 1, 0),
                    std::vector<Side>(3 * triangles.size())};
  const auto visit = [&](auto job) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
      for (int c = 0; c < 3; ++c)
        job(std::min(triangles[t][(c + 1) % 3], triangles[t][(c + 2) % 3]), Side(t, c));
  };
  visit([&](int v, Side) { ++out.first[v]; });
  int before = 0;
  for (int& first : out.first) before = first += before;
  // Filled from the back, which leaves first[v] at the start of v's range.
  visit([&](int v, Side s) { out.sides[--out.first[v]] = s; });
  return out;
}

[[noreturn]] void reject_edge(const Surface& surface, Side s, Side t) {
  if (t.value < s.value) std::swap(s, t);
  throw InputError("triangles " + std::to_string(s.triangle()) + " and " + std::to_string(t.triangle()) +
                   ", edge " + std::to_string(surface.from(s)) + "-" + std::to_string(surface.to(s)) +
                   ": more than two triangles share it");
}

/// Finds the mates. A table by the greater end, refilled for each lesser end, keeps this linear even for a
/// vertex on all triangles.
std::vector<Side> find_mates(const Surface& surface) {
  const SidesByVertex by_vertex = sort_sides(surface.vertex_count(), surface.triangles());
  std::vector<Side> mate(static_cast<std::size_t>(surface.side_count()));
  std::vector<Side> seen(static_cast<std::size_t>(surface.vertex_count()));
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const auto range = [&](auto job) {
      for (int k = by_vertex.first[v]; k < by_vertex.first[v + 1]; ++k) {
        const Side s = by_vertex.sides[k];
        job(s, seen[surface.from(s) == v ? surface.to(s) : surface.from(s)]);
      }
    };
    range([&](Side s, Side& other) {
      if (!other.exists()) {
        other = s;
        return;
      }
      if (mate[other.value].exists()) reject_edge(surface, other, s);
      mate[other.value] = s;
      mate[s.value] = other;
    });
    range([](Side, Side& other) { other = Side(); });
  }
  return mate;
}

} // namespace

Surface::Surface(int vertices, std::vector<Triangle> triangles)
    : vertices_(vertices), triangles_(std::move(triangles)) {
  check_corners(vertices_, triangles_);
  mate_ = find_mates(*this);
  for (int k = 0; k < side_count(); ++k) {
    const Side s(k);
    if (is_boundary(s) || from(s) != from(mate(s))) continue;
    turned_.resize(static_cast<std::size_t>(side_count()), 0);
    turned_[k] = 1;
  }
}

Surface::Surface(const Table<Side, Side>& mate, std::vector<char> turned)
    : triangles_(static_cast<std::size_t>(mate.size() / 3), Triangle{-1, -1, -1}), mate_(mate.values()),
      turned_(std::move(turned)) {
  if (mate.size() % 3 != 0) throw PreconditionError("three sides for each triangle are needed");
  if (!turned_.empty() && static_cast<int>(turned_.size()) != mate.size())
    throw PreconditionError("whether mates are turned is needed for all sides or none");
  for (int k = 0; k < mate.size(); ++k) {
    const Side m = mate[Side(k)];
    if (!m.exists()) continue;
    if (m.value == k || m.value >= mate.size() || mate[m] != Side(k) || is_turned(m) != is_turned(Side(k)))
      throw PreconditionError("the mates of side " + std::to_string(k) + " are not mutual");
  }
  if (std::find(turned_.begin(), turned_.end(), 1) == turned_.end()) turned_.clear();
  name_vertices();
}

Surface::Surface(int vertices, std::vector<Triangle> triangles, const Table<Side, Side>& mate)
    : vertices_(vertices), triangles_(std::move(triangles)), mate_(mate.values()) {
  if (mate.size() != side_count()) throw PreconditionError("three sides for each triangle are needed");
  for (const Triangle& t : triangles_)
    if (*std::min_element(t.begin(), t.end()) < 0 || *std::max_element(t.begin(), t.end()) >= vertices)
      throw PreconditionError("a triangle names a vertex that there is not");
  for (int k = 0; k < side_count(); ++k) {
    const Side s(k);
    const Side m = mate[s];
    if (!m.exists()) continue;
    if (m == s || m.value >= side_count() || mate[m] != s || from(m) != to(s) || to(m) != from(s))
      throw PreconditionError("the mates of side " + std::to_string(k) + " do not fit each other");
  }
}

/// Gives each corner the number of its vertex, fan by fan.
void Surface::name_vertices() {
  for (int t = 0; t < triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      if (triangles_[t][c] >= 0) continue;
      const SideEnd start{Side(t, (c + 2) % 3), true};
      triangles_[t][c] = vertices_;
      // One way round until home or the boundary, then the other way.
      for (SideEnd e : {start, start.pivot()})
        while (!is_boundary(e.side)) {
          e = across(e);
          int& name = triangles_[e.side.triangle()][e.corner()];
          if (name >= 0) break;
          name = vertices_;
          e = e.pivot();
        }
      ++vertices_;
    }
}

int Surface::edge_count() const {
  const auto boundary = std::count_if(mate_.begin(), mate_.end(), [](Side m) { return !m.exists(); });
  return (side_count() + static_cast<int>(boundary)) / 2;
}

void Surface::glue(Side s, Side m, bool turned) {
  mate_[s.value] = m;
  mate_[m.value] = s;
  if (turned && turned_.empty()) turned_.resize(static_cast<std::size_t>(side_count()), 0);
  if (turned_.empty()) return;
  turned_[s.value] = turned_[m.value] = static_cast<char>(turned);
}

void Surface::unglue(Side s) {
  const Side m = mate(s);
  if (!m.exists()) return;
  mate_[s.value] = mate_[m.value] = Side();
  if (!turned_.empty()) turned_[s.value] = turned_[m.value] = 0;
}

void Surface::turn(const std::vector<char>& over) {
  const auto renamed = [&](Side s) {
    return s.exists() && over[s.triangle()] && s.corner() != 0 ? Side(s.triangle(), 3 - s.corner()) : s;
  };
  std::vector<Side> mate(mate_.size());
  std::vector<char> turned(mate_.size(), 0);
  for (int k = 0; k < side_count(); ++k) {
    const Side s(k);
    const Side m = mate_[k];
    mate[renamed(s).value] = renamed(m);
    if (m.exists())
      turned[renamed(s).value] =
          static_cast<char>(is_turned(s) != (over[s.triangle()] != over[m.triangle()]));
  }
  for (int t = 0; t < triangle_count(); ++t)
    if (over[t]) std::swap(triangles_[t][1], triangles_[t][2]);
  mate_ = std::move(mate);
  if (std::find(turned.begin(), turned.end(), 1) == turned.end()) turned.clear();
  turned_ = std::move(turned);
}

int Surface::add_triangle(Triangle corners, std::vector<int>* carried, std::vector<int>* origin, int like) {
  triangles_.push_back(corners);
  mate_.resize(static_cast<std::size_t>(side_count()));
  if (!turned_.empty()) turned_.resize(static_cast<std::size_t>(side_count()), 0);
  if (carried != nullptr) carried->resize(static_cast<std::size_t>(side_count()), 0);
  if (origin != nullptr) origin->push_back((*origin)[static_cast<std::size_t>(like)]);
  return triangle_count() - 1;
}

/// Side `to`, new and free, takes the place of side `from`, which becomes free.
void Surface::move_side(Side from, Side to, std::vector<int>* carried) {
  if (!is_boundary(from)) {
    const Side m = mate(from);
    const bool turned = is_turned(from);
    unglue(from);
    glue(to, m, turned);
  }
  if (carried == nullptr) return;
  (*carried)[to.value] = (*carried)[from.value];
  (*carried)[from.value] = 0;
}

/// Cuts the triangle of s in two, from the apex to `middle`, which becomes the end of s. Returns the other
/// half of s, in a new triangle, which the next side of the old triangle has moved to. Neither half is glued.
Side Surface::halve(Side s, int middle, std::vector<int>* carried, std::vector<int>* origin) {
  unglue(s);
  Triangle corners = triangles_[s.triangle()];
  triangles_[s.triangle()][s.previous().corner()] = middle;
  corners[s.next().corner()] = middle;
  const int added = add_triangle(corners, carried, origin, s.triangle());
  if (carried != nullptr) (*carried)[Side(added, s.corner()).value] = (*carried)[s.value];
  move_side(s.next(), Side(added, s.next().corner()), carried);
  glue(s.next(), Side(added, s.previous().corner()), false);
  return {added, s.corner()};
}

int Surface::split_edge(Side s, std::vector<int>* carried, std::vector<int>* origin) {
  Side m = mate(s);
  const bool turned = is_turned(s);
  const int middle = vertices_++;
  const Side s_rest = halve(s, middle, carried, origin);
  if (!m.exists()) return middle;
  if (m == s.next()) m = Side(s_rest.triangle(), m.corner()); // it has just moved
  const Side m_rest = halve(m, middle, carried, origin);
  if (s == m.next()) s = Side(m_rest.triangle(), s.corner());
  glue(s, turned ? m : m_rest, turned);
  glue(s_rest, turned ? m_rest : m, turned);
  return middle;
}

int Surface::split_face(int triangle, std::vector<int>* carried, std::vector<int>* origin) {
  const int centre = vertices_++;
  const Triangle old = triangles_[triangle];
  // Triangle `t[c]` keeps side c and has the centre in place of corner c.
  std::array<int, 3> t{triangle, 0, 0};
  for (int c = 1; c < 3; ++c) {
    Triangle corners = old;
    corners[c] = centre;
    t[c] = add_triangle(corners, carried, origin, triangle);
    move_side(Side(triangle, c), Side(t[c], c), carried);
  }
  triangles_[triangle][0] = centre;
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3;
    glue(Side(t[c], d), Side(t[d], c), false);
  }
  return centre;
}

void Surface::flip_edge(Side s, std::vector<int>* carried) {
  const Side m = mate(s);
  unglue(s);
  // Each triangle gives up the end of its side and takes the other one's apex.
  const int apex = triangles_[s.triangle()][s.corner()];
  triangles_[s.triangle()][s.previous().corner()] = triangles_[m.triangle()][m.corner()];
  triangles_[m.triangle()][m.previous().corner()] = apex;
  const Side of_s = s.next();
  move_side(m.next(), s, carried);
  move_side(of_s, m, carried);
  glue(s.next(), m.next(), false);
}

std::vector<SideEnd> fan(const Surface& surface, SideEnd e) {
  // Back to the boundary, or once around.
  const SideEnd start = e;
  while (!surface.is_boundary(e.side)) {
    e = surface.across(e).pivot();
    if (e == start) break;
  }
  // Now all the way in the other direction, leaving each triangle by the side that we did not come by.
  std::vector<SideEnd> ends;
  const SideEnd first = e;
  while (true) {
    ends.push_back(e);
    const SideEnd out = e.pivot();
    if (surface.is_boundary(out.side)) break;
    e = surface.across(out);
    if (e == first) break;
  }
  return ends;
}

SideEnd next_on_boundary(const Surface& surface, SideEnd e) {
  e = e.pivot();
  while (!surface.is_boundary(e.side)) e = surface.across(e).pivot();
  return e;
}

std::vector<std::vector<SideEnd>> boundary_curves(const Surface& surface) {
  std::vector<std::vector<SideEnd>> curves;
  std::vector<char> seen(static_cast<std::size_t>(surface.side_count()), 0);
  for (int k = 0; k < surface.side_count(); ++k) {
    if (!surface.is_boundary(Side(k)) || seen[k]) continue;
    std::vector<SideEnd> curve;
    for (SideEnd e{Side(k), true}; !seen[e.side.value];
         e = next_on_boundary(surface, {e.side, !e.at_start})) {
      seen[e.side.value] = 1;
      curve.push_back(e);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

namespace {

/// Visits the triangles part by part: `reach(from, side)` on every side crossed for the first time, with -1
/// and none for the first triangle of a part.
template <class Reach>
void visit_parts(const Surface& surface, Reach reach) {
  std::vector<char> seen(static_cast<std::size_t>(surface.triangle_count()), 0);
  std::vector<int> stack;
  for (int first = 0; first < surface.triangle_count(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    reach(first, Side());
    stack.push_back(first);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (const Side s : sides_of(t)) {
        if (surface.is_boundary(s)) continue;
        const int other = surface.mate(s).triangle();
        if (seen[other]) continue;
        seen[other] = 1;
        reach(other, s);
        stack.push_back(other);
      }
    }
  }
}

} // namespace

Parts parts(const Surface& surface) {
  Parts out{0, std::vector<int>(static_cast<std::size_t>(surface.triangle_count()))};
  visit_parts(surface, [&](int t, Side through) {
    if (!through.exists()) ++out.count;
    out.of[t] = out.count - 1;
  });
  return out;
}

std::vector<Part> split(const Surface& surface, const Parts& parts) {
  std::vector<Part> out(static_cast<std::size_t>(parts.count));
  std::vector<int> local(static_cast<std::size_t>(surface.triangle_count()));
  for (int t = 0; t < surface.triangle_count(); ++t) {
    std::vector<int>& triangles = out[parts.of[t]].triangles;
    local[t] = static_cast<int>(triangles.size());
    triangles.push_back(t);
  }
  for (Part& part : out) {
    Table<Side, Side> mate(3 * static_cast<int>(part.triangles.size()));
    std::vector<char> turned(static_cast<std::size_t>(mate.size()), 0);
    for (int k = 0; k < mate.size(); ++k) {
      const Side s = part.in_whole(Side(k));
      if (surface.is_boundary(s)) continue;
      const Side m = surface.mate(s);
      mate[Side(k)] = Side(local[m.triangle()], m.corner());
      turned[k] = static_cast<char>(surface.is_turned(s));
    }
    part.surface = Surface(mate, std::move(turned));
  }
  return out;
}

std::vector<int> orientation(const Surface& surface) {
  std::vector<int> sign(static_cast<std::size_t>(surface.triangle_count()), 1);
  visit_parts(surface, [&](int t, Side through) {
    if (through.exists())
      sign[t] = surface.is_turned(through) ? -sign[through.triangle()] : sign[through.triangle()];
  });
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    if (surface.is_boundary(s)) continue;
    if ((sign[s.triangle()] != sign[surface.mate(s).triangle()]) != surface.is_turned(s)) return {};
  }
  return sign;
}

SurfaceType type_of(const Surface& surface) {
  if (parts(surface).count != 1) throw PreconditionError("the surface is not connected");
  return {surface.vertex_count() - surface.edge_count() + surface.triangle_count(),
          static_cast<int>(boundary_curves(surface).size()), !orientation(surface).empty()};
}

} // namespace tetrarch::surface
