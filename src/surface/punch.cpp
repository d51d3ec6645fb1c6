// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/punch.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace tetrarch::surface {
namespace {

/// Takes one hole after the other out of a mesh.
class Puncher {
public:
  explicit Puncher(const OpenedMesh& opened);
  /// The triangles of a round hole.
  std::vector<int> around(const RoundHole& hole) const;
  /// Takes these triangles, and what it needs to make a disk of them. `name` is for messages.
  void take(std::vector<int> triangles, const std::string& name);
  OpenedMesh result() const;

private:
  enum Owner : int { nobody, the_boundary, a_hole };

  std::vector<SideEnd> star(int vertex) const { return fan(surface(), end_of_[vertex]); }
  const Surface& surface() const { return opened_.mesh.surface; }
  bool is_taken(SideEnd e) const { return taken_[e.side.triangle()] != 0; }
  /// Whether a triangle on the other side of that side of a taken one stays.
  bool is_rim(Side s) const { return !surface().is_boundary(s) && !taken_[surface().mate(s).triangle()]; }
  void close_pinches(std::vector<int>& triangles);
  void fill_islands(std::vector<int>& triangles, const std::string& name);
  void require_disk(const std::vector<int>& triangles, const std::string& name) const;

  const OpenedMesh& opened_;
  std::vector<SideEnd> end_of_; ///< of each vertex, some end there
  std::vector<int> owner_;      ///< of each vertex
  std::vector<char> taken_;     ///< of each triangle
  Surface apart_;               ///< the surface, cut along the rims of all holes
};

Puncher::Puncher(const OpenedMesh& opened)
    : opened_(opened), end_of_(opened.mesh.points.size()), owner_(end_of_.size(), nobody),
      taken_(opened.triangle_of.size(), 0), apart_(opened.mesh.surface) {
  for (int k = 0; k < surface().side_count(); ++k) {
    const Side s(k);
    end_of_[surface().from(s)] = {s, true};
    if (surface().is_boundary(s)) owner_[surface().from(s)] = owner_[surface().to(s)] = the_boundary;
  }
}

std::vector<int> Puncher::around(const RoundHole& hole) const {
  const auto& points = opened_.mesh.points;
  const int centre = vertex_numbered(opened_, hole.vertex);
  const auto from_centre = [&](int v) { return numeric::distance(points[v], points[centre]); };
  double least = 0;
  std::vector<int> triangles;
  std::vector<char> seen(taken_.size(), 0);
  for (const SideEnd e : star(centre)) {
    triangles.push_back(e.side.triangle());
    seen[e.side.triangle()] = 1;
    for (const int v : surface().corners(e.side.triangle())) least = std::max(least, from_centre(v));
  }
  if (!(hole.radius >= least))
    throw InputError("the radius " + format::to_text(hole.radius) + " of the hole at vertex " +
                     std::to_string(hole.vertex) +
                     " is too small: the neighbors of the vertex reach out to " + format::to_text(least));
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (const Side s : sides_of(triangles[k])) {
      if (surface().is_boundary(s)) continue;
      const int next = surface().mate(s).triangle();
      if (seen[next] || from_centre(surface().apex(surface().mate(s))) > hole.radius) continue;
      seen[next] = 1;
      triangles.push_back(next);
    }
  return triangles;
}

void Puncher::take(std::vector<int> triangles, const std::string& name) {
  const auto refuse_if_met = [&] {
    for (const int t : triangles)
      for (const int v : surface().corners(t))
        if (owner_[v] != nobody)
          throw InputError(name + (owner_[v] == a_hole ? " reaches another hole" : " reaches the boundary"));
  };
  refuse_if_met();
  for (const int t : triangles) taken_[t] = 1;
  close_pinches(triangles);
  fill_islands(triangles, name);
  refuse_if_met();
  require_disk(triangles, name);
  for (const int t : triangles)
    for (const int v : surface().corners(t)) owner_[v] = a_hole;
}

/// Takes whole stars until the triangles make one fan at each vertex. Where that meets the boundary is told
/// later.
void Puncher::close_pinches(std::vector<int>& triangles) {
  std::vector<int> to_do;
  std::vector<char> waits(owner_.size(), 0);
  const auto look_at = [&](int t) {
    for (const int v : surface().corners(t))
      if (std::exchange(waits[v], 1) == 0) to_do.push_back(v);
  };
  for (const int t : triangles) look_at(t);
  while (!to_do.empty()) {
    const int v = to_do.back();
    to_do.pop_back();
    waits[v] = 0;
    const std::vector<SideEnd> ring = star(v);
    int changes = 0;
    for (std::size_t k = 0; k < ring.size(); ++k)
      changes += static_cast<int>(is_taken(ring[k]) != is_taken(ring[(k + 1) % ring.size()]));
    if (changes <= 2) continue;
    for (const SideEnd e : ring) {
      if (is_taken(e)) continue;
      taken_[e.side.triangle()] = 1;
      triangles.push_back(e.side.triangle());
      look_at(e.side.triangle());
    }
  }
}

/// Takes the parts that the triangles separate from the greatest one.
void Puncher::fill_islands(std::vector<int>& triangles, const std::string& name) {
  for (const int t : triangles)
    for (const Side s : sides_of(t))
      if (is_rim(s)) apart_.unglue(s);
  const Parts all = parts(apart_);
  for (const int t : triangles)
    if (all.of[t] != all.of[triangles.front()]) throw InputError(name + " is not connected");
  std::vector<int> size(static_cast<std::size_t>(all.count), 0);
  for (int t = 0; t < surface().triangle_count(); ++t)
    if (!taken_[t]) ++size[all.of[t]];
  const auto greatest = std::max_element(size.begin(), size.end());
  if (*greatest == 0) throw InputError(name + " leaves nothing of the surface");
  for (int t = 0; t < surface().triangle_count(); ++t)
    if (!taken_[t] && all.of[t] != greatest - size.begin()) {
      taken_[t] = 1;
      triangles.push_back(t);
    }
}

/// By the Euler characteristic of triangles that are connected and have no pinches.
void Puncher::require_disk(const std::vector<int>& triangles, const std::string& name) const {
  std::set<int> vertices;
  int sides = 0; // an edge inside counts as two, one on the rim too
  for (const int t : triangles) {
    vertices.insert(surface().corners(t).begin(), surface().corners(t).end());
    for (const Side s : sides_of(t)) sides += is_rim(s) ? 2 : 1;
  }
  if (static_cast<int>(vertices.size()) - sides / 2 + static_cast<int>(triangles.size()) != 1)
    throw InputError(name + " is no disk: it closes around a handle");
}

OpenedMesh Puncher::result() const {
  OpenedMesh out;
  std::vector<int> name(owner_.size(), -1);
  std::vector<Surface::Triangle> triangles;
  for (int t = 0; t < surface().triangle_count(); ++t) {
    if (taken_[t]) continue;
    triangles.push_back(surface().corners(t));
    out.triangle_of.push_back(opened_.triangle_of[t]);
    for (const int v : triangles.back()) name[v] = 0;
  }
  for (std::size_t v = 0; v < name.size(); ++v) {
    if (name[v] < 0) continue;
    name[v] = static_cast<int>(out.number.size());
    out.number.push_back(opened_.number[v]);
    out.mesh.points.push_back(opened_.mesh.points[v]);
  }
  for (auto& triangle : triangles)
    for (int& v : triangle) v = name[v];
  out.mesh.surface = Surface(static_cast<int>(out.number.size()), std::move(triangles));
  return out;
}

} // namespace

OpenedMesh punch(const OpenedMesh& opened, const std::vector<RoundHole>& holes) {
  Puncher puncher(opened);
  for (const RoundHole& hole : holes)
    puncher.take(puncher.around(hole), "the hole at vertex " + std::to_string(hole.vertex));
  return puncher.result();
}

OpenedMesh punch_triangles(const OpenedMesh& opened, const std::vector<std::vector<int>>& holes) {
  Puncher puncher(opened);
  for (const std::vector<int>& hole : holes) {
    if (hole.empty()) throw InputError("a hole has no triangles");
    const std::set<int> wanted(hole.begin(), hole.end());
    std::set<int> found;
    std::vector<int> triangles;
    for (int t = 0; t < opened.mesh.surface.triangle_count(); ++t) {
      if (wanted.count(opened.triangle_of[t]) == 0) continue;
      found.insert(opened.triangle_of[t]);
      triangles.push_back(t);
    }
    for (const int t : wanted)
      if (found.count(t) == 0) throw InputError("there is no triangle " + std::to_string(t));
    puncher.take(std::move(triangles), "the hole with triangle " + std::to_string(hole.front()));
  }
  return puncher.result();
}

} // namespace tetrarch::surface
