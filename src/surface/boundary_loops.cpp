// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/boundary_loops.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetrarch::surface {
namespace {

using namespace numeric;

BoundaryLoop measured(const TriangleMesh& mesh, std::vector<SideEnd> sides) {
  const auto point = [&](SideEnd e) -> const Vector& { return mesh.points[mesh.surface.vertex(e)]; };
  // Seen from one of its points, a loop far from the origin loses no digits.
  const Vector origin = point(sides.front());
  std::vector<double> lengths;
  Vector twice_area{};
  for (const SideEnd e : sides) {
    const SideEnd next{e.side, !e.at_start};
    const Vector along = point(next) - point(e);
    const Vector p = point(e) - origin;
    const Vector q = point(next) - origin;
    lengths.push_back(length(along));
    for (int k = 0; k < 3; ++k)
      twice_area[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  }
  // Summed in order of size, congruent loops are equally long, wherever they begin.
  std::sort(lengths.begin(), lengths.end());
  return {std::move(sides), std::accumulate(lengths.begin(), lengths.end(), 0.0), length(twice_area) / 2};
}

} // namespace

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh) {
  struct Entry {
    BoundaryLoop loop;
    int least;
  };
  std::vector<Entry> entries;
  for (auto& sides : boundary_curves(mesh.surface)) {
    int least = mesh.surface.vertex_count();
    for (const SideEnd e : sides) least = std::min(least, mesh.surface.vertex(e));
    entries.push_back({measured(mesh, std::move(sides)), least});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.loop.length != b.loop.length ? a.loop.length > b.loop.length : a.least < b.least;
  });
  std::vector<BoundaryLoop> loops;
  loops.reserve(entries.size());
  for (Entry& entry : entries) loops.push_back(std::move(entry.loop));
  return loops;
}

int loop_through(const std::vector<BoundaryLoop>& loops, const Surface& surface, int vertex) {
  const auto found = std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& loop) {
    return std::any_of(loop.sides.begin(), loop.sides.end(),
                       [&](SideEnd e) { return surface.vertex(e) == vertex; });
  });
  return found == loops.end() ? -1 : static_cast<int>(found - loops.begin());
}

std::vector<int> loops_of_vertices(const std::vector<BoundaryLoop>& loops, const Surface& surface) {
  std::vector<int> result(static_cast<std::size_t>(surface.vertex_count()), -1);
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const SideEnd e : loops[k].sides) result[surface.vertex(e)] = static_cast<int>(k);
  return result;
}

} // namespace tetrarch::surface
