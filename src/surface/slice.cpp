// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/slice.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/cuts.hpp"
#include "tree_cotree.hpp"

#include <string>
#include <utility>

namespace tetrarch::surface {
namespace {

std::string name_of(long long vertex) {
  return "vertex " + std::to_string(vertex);
}

/// Marks one path after the other.
class Slicer {
public:
  Slicer(const OpenedMesh& opened, const std::vector<std::vector<long long>>& paths);
  void mark(const std::vector<long long>& path, int m);
  const MarkedSurface& marked() const { return marked_; }

private:
  /// The edges from one vertex to another, each as its first end.
  std::vector<SideEnd> way(int from, int to);

  const OpenedMesh& opened_;
  MarkedSurface marked_;
  std::vector<double> length_;  ///< of each side
  std::vector<char> is_barred_; ///< of each vertex, whether it is on the boundary or a path, or given
};

Slicer::Slicer(const OpenedMesh& opened, const std::vector<std::vector<long long>>& paths)
    : opened_(opened), marked_(opened.mesh.surface, opened.mesh.points), length_(side_lengths(marked_)),
      is_barred_(boundary_vertices(marked_.surface)) {
  const std::vector<char> on_boundary = is_barred_;
  for (const std::vector<long long>& path : paths)
    for (std::size_t k = 0; k < path.size(); ++k) {
      const int v = vertex_numbered(opened_, path[k]);
      const bool closes = k > 0 && k + 1 == path.size() && path[k] == path.front();
      if (on_boundary[v]) throw InputError("the path touches the boundary at " + name_of(path[k]));
      if (is_barred_[v] && !closes)
        throw InputError("paths meet at " + name_of(path[k]) + ", which is given twice");
      is_barred_[v] = 1;
    }
}

std::vector<SideEnd> Slicer::way(int from, int to) {
  const Surface& surface = marked_.surface;
  is_barred_[from] = is_barred_[to] = 0;
  const std::vector<double> length = lengths_off(surface, length_, is_barred_);
  is_barred_[from] = is_barred_[to] = 1;
  const Paths paths = shortest_paths(surface, length, {to});
  std::vector<SideEnd> steps;
  for (SideEnd e = paths.last[from]; e.side.exists(); e = paths.last[surface.vertex(e)])
    steps.push_back({e.side, !e.at_start});
  return steps;
}

void Slicer::mark(const std::vector<long long>& path, int m) {
  const bool is_closed = path.size() > 1 && path.front() == path.back();
  if (is_closed && path.size() < 4)
    throw InputError("the closed path at " + name_of(path.front()) + " names fewer than three vertices");
  int edges = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const std::vector<SideEnd> steps =
        way(vertex_numbered(opened_, path[k]), vertex_numbered(opened_, path[k + 1]));
    if (steps.empty())
      throw InputError("there is no way from " + name_of(path[k]) + " to " + name_of(path[k + 1]) +
                       " that avoids the boundary and the other paths");
    for (const SideEnd e : steps) {
      set_mark(marked_, e.side, e.at_start ? m : -m);
      is_barred_[marked_.surface.vertex(e)] = 1;
    }
    edges += static_cast<int>(steps.size());
  }
  if (edges < 2)
    throw InputError(path.empty() ? "a path has no vertices"
                                  : "the path at " + name_of(path.front()) +
                                        " has fewer than two edges and opens nothing");
}

} // namespace

OpenedMesh slice(const OpenedMesh& opened, const std::vector<std::vector<long long>>& paths) {
  Slicer slicer(opened, paths);
  for (std::size_t k = 0; k < paths.size(); ++k) slicer.mark(paths[k], static_cast<int>(k) + 1);
  OpenedMesh out = cut_along(opened, slicer.marked());
  if (parts(out.mesh.surface).count > 1) throw InputError("the closed paths cut the surface in two");
  return out;
}

} // namespace tetrarch::surface
