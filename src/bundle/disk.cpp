// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/disk.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::bundle {
namespace {

using Triangles = std::vector<Disk::Triangle>;

void check_corners(int vertices, const Triangles& triangles) {
  if (triangles.empty()) throw InputError("a disk needs a triangle");
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

[[noreturn]] void reject_edge(const Disk& disk, Side s, Side t) {
  if (t.value < s.value) std::swap(s, t);
  const std::string pair = "triangles " + std::to_string(s.triangle()) + " and " +
                           std::to_string(t.triangle()) + ", edge " + std::to_string(disk.from(s)) + "-" +
                           std::to_string(disk.to(s));
  if (disk.from(s) != disk.from(t)) throw InputError(pair + ": more than two triangles share it");
  throw InputError(pair + ": both run along it in the same direction, or more than two share it");
}

/// Finds the mates. A table by the greater end, refilled for each lesser end, keeps this linear even for a
/// vertex on all triangles.
Table<Side, Side> find_mates(const Disk& disk, const Triangles& triangles) {
  const SidesByVertex by_vertex = sort_sides(disk.vertex_count(), triangles);
  Table<Side, Side> mate(3 * disk.triangle_count());
  std::vector<Side> seen(static_cast<std::size_t>(disk.vertex_count()));
  for (int v = 0; v < disk.vertex_count(); ++v) {
    const auto range = [&](auto job) {
      for (int k = by_vertex.first[v]; k < by_vertex.first[v + 1]; ++k) {
        const Side s = by_vertex.sides[k];
        job(s, seen[disk.from(s) == v ? disk.to(s) : disk.from(s)]);
      }
    };
    range([&](Side s, Side& other) {
      if (!other.exists()) {
        other = s;
        return;
      }
      if (mate[other].exists() || disk.from(s) == disk.from(other)) reject_edge(disk, other, s);
      mate[other] = s;
      mate[s] = other;
    });
    range([](Side, Side& other) { other = Side(); });
  }
  return mate;
}

bool is_connected(const Disk& disk) {
  std::vector<char> seen(static_cast<std::size_t>(disk.triangle_count()), 0);
  std::vector<int> stack{0};
  seen[0] = 1;
  int count = 0;
  while (!stack.empty()) {
    const int t = stack.back();
    stack.pop_back();
    ++count;
    for (const Side s : sides_of(t)) {
      if (disk.is_boundary(s) || seen[disk.mate(s).triangle()]) continue;
      seen[disk.mate(s).triangle()] = 1;
      stack.push_back(disk.mate(s).triangle());
    }
  }
  return count == disk.triangle_count();
}

/// The boundary side that starts where boundary side s ends: turn about that vertex until home.
Side next_on_boundary(const Disk& disk, Side s) {
  s = s.next();
  while (!disk.is_boundary(s)) s = disk.mate(s).next();
  return s;
}

} // namespace

Disk::Disk(int vertices, std::vector<Triangle> triangles)
    : vertices_(vertices), triangles_(std::move(triangles)) {
  check_corners(vertices_, triangles_);
  mate_ = find_mates(*this, triangles_);
  find_boundary();
}

Disk::Disk(Table<Side, Side> mate)
    : triangles_(static_cast<std::size_t>(mate.size() / 3), Triangle{-1, -1, -1}), mate_(std::move(mate)) {
  if (mate_.size() == 0 || mate_.size() % 3 != 0)
    throw PreconditionError("three sides for each triangle are needed");
  for (int k = 0; k < mate_.size(); ++k) {
    const Side m = mate_[Side(k)];
    if (!m.exists()) continue;
    if (m.value == k || m.value >= mate_.size() || mate_[m] != Side(k))
      throw PreconditionError("the mates of side " + std::to_string(k) + " are not mutual");
  }
  name_vertices();
  find_boundary();
}

/// Gives each corner the number of its vertex: turns about a corner without one, to its right as far as
/// possible and then all the way to the left.
void Disk::name_vertices() {
  for (int k = 0; k < mate_.size(); ++k) {
    const Side start(k); // stands for the corner that it starts from
    if (from(start) >= 0) continue;
    Side s = start;
    while (!is_boundary(s) && mate_[s].next() != start) s = mate_[s].next();
    while (true) {
      triangles_[s.triangle()][s.next().corner()] = vertices_;
      const Side left = mate_[s.previous()];
      if (!left.exists() || from(left) >= 0) break;
      s = left;
    }
    ++vertices_;
  }
}

void Disk::find_boundary() {
  if (!is_connected(*this)) throw InputError("no disk: the triangles are not connected through edges");
  for (int k = 0; k < 3 * triangle_count(); ++k)
    if (is_boundary(Side(k))) boundary_.push_back(Side(k));
  if (boundary_.empty()) throw InputError("no disk: the surface has no boundary");
  // A connected surface with boundary has V - E + F <= 1 with equality for the disk alone, and vertices where
  // it touches itself only lower V: this one number says all that is left.
  const int euler = vertices_ - edge_count() + triangle_count();
  if (euler != 1)
    throw InputError("no disk: vertices - edges + triangles = " + std::to_string(euler) + ", not 1");
  for (std::size_t k = 1; k < boundary_.size(); ++k) boundary_[k] = next_on_boundary(*this, boundary_[k - 1]);
}

std::vector<char> Disk::boundary_vertices() const {
  std::vector<char> on_boundary(static_cast<std::size_t>(vertices_), 0);
  for (const Side s : boundary_) on_boundary[from(s)] = 1;
  return on_boundary;
}

} // namespace tetrarch::bundle
