// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/twist.hpp"

#include "tetrarch/bundle/cut.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace tetrarch::bundle {

using surface::MarkedSurface;
using surface::SideEnd;
using surface::Surface;

void orient_parts(MarkedSurface& cut) {
  const std::vector<int> sign = surface::orientation(surface::cut_open(cut));
  if (sign.empty() && cut.surface.triangle_count() > 0)
    throw PreconditionError("a part of the cut surface is not orientable");
  surface::turn_triangles(cut, sign);
}

int give_inner_vertices(MarkedSurface& cut) {
  const Surface open = surface::cut_open(cut);
  const surface::Parts parts = surface::parts(open);
  std::vector<char> inside(static_cast<std::size_t>(open.vertex_count()), 1);
  for (int k = 0; k < open.side_count(); ++k)
    if (const Side s(k); open.is_boundary(s)) inside[open.from(s)] = inside[open.to(s)] = 0;
  std::vector<int> first(static_cast<std::size_t>(parts.count),
                         -1); // the first triangle, none if all is well
  std::vector<char> good(static_cast<std::size_t>(parts.count), 0);
  for (int t = 0; t < open.triangle_count(); ++t) {
    const int part = parts.of[t];
    if (first[part] < 0) first[part] = t;
    for (const int v : open.corners(t)) good[part] = static_cast<char>(good[part] != 0 || inside[v] != 0);
  }
  int splits = 0;
  for (int part = 0; part < parts.count; ++part) {
    if (good[part]) continue;
    surface::split_face(cut, first[part]);
    ++splits;
  }
  return splits;
}

std::vector<Side> cut_edges(const MarkedSurface& cut) {
  std::vector<Side> sides;
  for (int k = 0; k < cut.surface.side_count(); ++k)
    if (cut.mark[k] > 0) sides.emplace_back(k);
  std::stable_sort(sides.begin(), sides.end(), [&](Side a, Side b) { return cut[a] < cut[b]; });
  return sides;
}

std::vector<int> spread_twist(const MarkedSurface& cut, int total) {
  std::vector<Side> edges = cut_edges(cut);
  if (std::abs(total) > static_cast<int>(edges.size()))
    throw PreconditionError("a twist of " + std::to_string(total) + " does not fit on " +
                            std::to_string(edges.size()) + " cut edges");
  std::vector<int> twist(static_cast<std::size_t>(cut.surface.side_count()), 0);
  const int sign = total < 0 ? -1 : 1;
  for (int left = std::abs(total); left > 0; --left) {
    const Side s = edges.back();
    edges.pop_back();
    const int t = cut.surface.is_turned(s) ? sign : -sign;
    twist[s.value] = twist[cut.surface.mate(s).value] = t;
  }
  return twist;
}

void split_cut_edges(MarkedSurface& cut, int edges) {
  while (true) {
    const std::vector<Side> sides = cut_edges(cut);
    int missing = edges - static_cast<int>(sides.size());
    if (missing <= 0) return;
    if (sides.empty()) throw PreconditionError("nothing is cut");
    for (auto s = sides.rbegin(); s != sides.rend() && missing > 0; ++s, --missing)
      surface::split_edge(cut, *s);
  }
}

namespace {

/// The flow of shifts on the cut graph.
class Flow {
public:
  Flow(const MarkedSurface& cut, const std::vector<int>& twist)
      : surface_(cut.surface), twist_(twist), shift_(twist.size()),
        ends_(static_cast<std::size_t>(surface_.vertex_count())), used_(twist.size(), 0),
        seen_(static_cast<std::size_t>(surface_.vertex_count()), 0) {
    for (int k = 0; k < surface_.side_count(); ++k) {
      const Side s(k);
      if (cut.is_cut(s) && s.value < surface_.mate(s).value)
        for (const bool at_start : {true, false})
          ends_[surface_.vertex({s, at_start})].push_back({s, at_start});
    }
  }

  std::vector<Shift> run(int root) && {
    walk(root);
    // The cut graph of a surface with boundary may fall apart.
    for (int v = 0; v < surface_.vertex_count(); ++v)
      if (!seen_[v] && !ends_[v].empty()) walk(v);
    // Leaves first: what comes into a vertex from above goes out to its parent.
    for (auto arrival = preorder_.rbegin(); arrival != preorder_.rend(); ++arrival)
      if (arrival->edge.side.exists()) drain(*arrival);
    return std::move(shift_);
  }

private:
  struct Arrival {
    int vertex;
    SideEnd edge; ///< the end here of the tree edge by which it was reached
  };

  /// Gives the edge of `e` a shift by what it is at that end.
  void set(SideEnd e, int at_end) {
    const int t = twist_[e.side.value];
    const Shift shift = e.at_start ? Shift{at_end, at_end + t} : Shift{at_end - t, at_end};
    const Side m = surface_.mate(e.side);
    shift_[e.side.value] = shift;
    shift_[m.value] = inverse(shift, surface_.is_turned(e.side));
  }

  /// A depth-first spanning tree; so every other edge leads back to an ancestor, at whose end its shift is 0.
  void walk(int root) {
    struct Frame {
      int vertex;
      std::size_t next;
    };
    std::vector<Frame> stack{{root, 0}};
    seen_[root] = 1;
    preorder_.push_back({root, {}});
    while (!stack.empty()) {
      Frame& top = stack.back();
      const auto& ends = ends_[top.vertex];
      if (top.next == ends.size()) {
        stack.pop_back();
        continue;
      }
      const SideEnd e = ends[top.next++];
      if (used_[e.side.value]) continue;
      used_[e.side.value] = 1;
      const SideEnd far{e.side, !e.at_start};
      const int there = surface_.vertex(far);
      if (seen_[there]) {
        set(far, 0);
      } else {
        seen_[there] = 1;
        preorder_.push_back({there, far});
        stack.push_back({there, 0});
      }
    }
  }

  /// Sets the shift of the tree edge to the parent such that the shifts around the vertex cancel: once
  /// around, level j has become j + rest + weight * (that shift).
  void drain(const Arrival& arrival) {
    int rest = 0;
    int weight = 0;
    const auto around = surface::fan(surface_, arrival.edge);
    // Entering by around[k], one leaves by the other side there.
    for (const SideEnd& e : around) {
      const SideEnd out = e.pivot();
      if (surface_.is_boundary(out.side)) return set(arrival.edge, 0); // a fan that does not close
      const int sign = surface_.is_turned(out.side) ? -1 : 1;
      rest *= sign;
      weight *= sign;
      if (const auto unknown = unknown_weight(out, arrival.edge))
        weight += *unknown;
      else
        rest += shift_[out.side.value].at(out.at_start);
    }
    if (weight == 0) throw PreconditionError("an edge of the spanning tree is a loop");
    set(arrival.edge, -rest * weight);
  }

  /// How often the shift at `wanted` counts when `out` is crossed; none if `out` is another end.
  std::optional<int> unknown_weight(SideEnd out, SideEnd wanted) const {
    if (out == wanted) return 1;
    if (out == surface_.across(wanted)) return surface_.is_turned(wanted.side) ? 1 : -1;
    return std::nullopt;
  }

  const Surface& surface_;
  const std::vector<int>& twist_;
  std::vector<Shift> shift_;
  std::vector<std::vector<SideEnd>> ends_; ///< of each vertex, the ends of cut edges there
  std::vector<char> used_;                 ///< of each edge, at the end from which it is reached
  std::vector<char> seen_;
  std::vector<Arrival> preorder_;
};

} // namespace

std::vector<Shift> shifts_of(const MarkedSurface& cut, const std::vector<int>& twist, int root) {
  return Flow(cut, twist).run(root);
}

std::vector<Side> boundary_sides(const Surface& surface) {
  std::vector<Side> sides;
  for (const auto& curve : surface::boundary_curves(surface))
    for (const SideEnd& e : curve) sides.push_back(e.side);
  return sides;
}

namespace {

/// One covering disk, and where its triangles are on the surface.
struct CoveringDisk {
  surface::Part part;
  Disk disk;
  Side below(Side s) const { return part.in_whole(s); }
};

std::vector<CoveringDisk> covering_disks(const MarkedSurface& cut) {
  const Surface open = surface::cut_open(cut);
  std::vector<CoveringDisk> disks;
  for (surface::Part& part : surface::split(open, surface::parts(open))) {
    Disk disk(std::move(part.surface));
    disks.push_back({std::move(part), std::move(disk)});
  }
  return disks;
}

/// What each side that lies on the boundary of a covering disk must have; 0 elsewhere and where it is free.
std::vector<std::int8_t> wanted_values(const MarkedSurface& cut, const std::vector<int>& twist,
                                       const std::optional<BoundaryValues>& boundary) {
  std::vector<std::int8_t> value(twist.size(), 0);
  for (int k = 0; k < cut.surface.side_count(); ++k) {
    const Side s(k);
    if (!cut.is_cut(s)) continue;
    const int t = cut.surface.is_turned(s) ? -twist[k] : twist[k];
    value[k] = static_cast<std::int8_t>(t != 0 ? -t : (cut[s] > 0 ? 1 : -1));
  }
  if (!boundary) return value;
  const std::vector<Side> sides = boundary_sides(cut.surface);
  if (sides.size() != boundary->size())
    throw PreconditionError(std::to_string(boundary->size()) + " values for " + std::to_string(sides.size()) +
                            " boundary edges");
  for (std::size_t k = 0; k < sides.size(); ++k)
    value[sides[k].value] = static_cast<std::int8_t>((*boundary)[k]);
  return value;
}

/// The pattern of one disk; where every boundary side is free, by Algorithm III, else by II, for which free
/// sides get the opposite of their predecessor's value.
CuttingResult pattern_of(const CoveringDisk& part, const std::vector<std::int8_t>& wanted) {
  const auto& sides = part.disk.boundary();
  const auto fixed =
      std::find_if(sides.begin(), sides.end(), [&](Side s) { return wanted[part.below(s).value] != 0; });
  if (fixed == sides.end()) return cut_free(part.disk);
  BoundaryValues values(sides.size());
  int last = 0;
  const auto start = static_cast<std::size_t>(fixed - sides.begin());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t at = (start + k) % sides.size();
    const int given = wanted[part.below(sides[at]).value];
    values[at] = last = given != 0 ? given : -last;
  }
  return cut_general(part.disk, values);
}

} // namespace

Values values_of(const MarkedSurface& cut, const std::vector<int>& twist,
                 const std::optional<BoundaryValues>& boundary) {
  Values out;
  const std::vector<std::int8_t> wanted = wanted_values(cut, twist, boundary);
  out.value.resize(wanted.size());
  for (const CoveringDisk& part : covering_disks(cut)) {
    const CuttingResult result = pattern_of(part, wanted);
    if (const auto* obstruction = std::get_if<Obstruction>(&result)) {
      out.obstruction = *obstruction;
      for (int& t : out.obstruction->triangles) t = part.part.triangles[t];
      return out;
    }
    const auto& pattern = std::get<CuttingPattern>(result);
    for (int k = 0; k < part.disk.side_count(); ++k)
      out.value[part.below(Side(k)).value] = static_cast<std::int8_t>(pattern[Side(k)]);
  }
  return out;
}

} // namespace tetrarch::bundle
