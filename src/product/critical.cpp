// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/critical.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetrarch::product {
namespace {

/// Relative to the whole height: what is less between two vertices is rounding.
constexpr double flat_rise = 1e-12;

/// The tetrahedra around each vertex: those of v are at first[v] .. first[v+1]-1.
struct Stars {
  std::vector<int> first;
  std::vector<int> tet;
};

Stars stars(const Solid& solid) {
  Stars s;
  s.first.assign(solid.mesh.points.size() + 1, 0);
  for (const auto& corners : solid.mesh.tetrahedra)
    for (const int v : corners) ++s.first[v + 1];
  for (std::size_t v = 1; v < s.first.size(); ++v) s.first[v] += s.first[v - 1];
  s.tet.resize(4 * solid.mesh.tetrahedra.size());
  std::vector<int> next(s.first.begin(), s.first.end() - 1);
  for (int t = 0; t < solid.size(); ++t)
    for (const int v : solid.corners(t)) s.tet[next[v]++] = t;
  return s;
}

/// The link of a vertex, with what is lower and what is higher than it.
class Link {
public:
  Link(int vertex, const std::vector<double>& w, const std::vector<int>& base)
      : vertex_(vertex), w_(w), base_(base) {}

  void clear() {
    members_.clear();
    joints_.clear();
  }
  /// A triangle or an edge of the link, by its vertices.
  template <class Cell>
  void add(const Cell& cell) {
    for (std::size_t k = 0; k < cell.size(); ++k) {
      members_.push_back(cell[k]);
      for (std::size_t j = 0; j < k; ++j) joints_.emplace_back(cell[j], cell[k]);
    }
  }
  /// How many parts are lower (-1) or higher (+1).
  int parts(int sign) {
    std::sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    std::vector<int> parent(members_.size());
    std::iota(parent.begin(), parent.end(), 0);
    int count = 0;
    for (const int u : members_) count += side(u) == sign ? 1 : 0;
    for (const auto& [a, b] : joints_) {
      if (side(a) != sign || side(b) != sign) continue;
      const int here = numeric::find_root(parent, place(a));
      const int there = numeric::find_root(parent, place(b));
      if (here == there) continue;
      parent[here] = there;
      --count;
    }
    return count;
  }

private:
  /// 0 for vertices of the same base.
  int side(int u) const {
    if (base_[u] >= 0 && base_[u] == base_[vertex_]) return 0;
    return std::pair(w_[u], u) < std::pair(w_[vertex_], vertex_) ? -1 : 1;
  }
  int place(int u) const {
    return static_cast<int>(std::lower_bound(members_.begin(), members_.end(), u) - members_.begin());
  }

  int vertex_;
  const std::vector<double>& w_;
  const std::vector<int>& base_;
  std::vector<int> members_;
  std::vector<std::pair<int, int>> joints_;
};

/// Whether the link is cut once: below and above it hang together. A vertex of the floor has nothing below,
/// one of the ceiling nothing above.
bool is_regular(int base, int lower, int upper) {
  return lower == (base == floor_patch ? 0 : 1) && upper == (base == ceiling_patch ? 0 : 1);
}

} // namespace

CriticalPlaces critical_places(const Solid& solid, const Partition& partition, const std::vector<double>& w) {
  CriticalPlaces places;
  const double height = *std::max_element(w.begin(), w.end());
  for (int t = 0; t < solid.size(); ++t) {
    const auto [low, high] = std::minmax_element(solid.corners(t).begin(), solid.corners(t).end(),
                                                 [&](int a, int b) { return w[a] < w[b]; });
    if (!(w[*high] - w[*low] > flat_rise * height)) places.flat.push_back(t);
  }

  const std::vector<int> base = bases_of_vertices(solid, partition);
  std::vector<std::vector<int>> walls(solid.vertex.size());
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3 && partition.patch[t] >= first_wall; ++c)
      walls[solid.boundary.corners(t)[c]].push_back(t);

  const Stars around = stars(solid);
  for (int v = 0; v < static_cast<int>(w.size()); ++v) {
    if (around.first[v] == around.first[v + 1]) continue; // a point that belongs to nothing
    Link link(v, w, base);
    for (int k = around.first[v]; k < around.first[v + 1]; ++k) {
      std::array<int, 3> face{};
      std::copy_if(solid.corners(around.tet[k]).begin(), solid.corners(around.tet[k]).end(), face.begin(),
                   [&](int u) { return u != v; });
      link.add(face);
    }
    const int lower = link.parts(-1);
    const int upper = link.parts(1);
    bool regular = is_regular(base[v], lower, upper);
    const int b = solid.on_boundary[v];
    const bool on_wall = b >= 0 && !walls[b].empty();
    if (on_wall) {
      link.clear();
      for (const int t : walls[b]) {
        std::array<int, 2> edge{};
        int count = 0;
        for (int c = 0; c < 3; ++c)
          if (solid.corner(t, c) != v) edge[count++] = solid.corner(t, c);
        link.add(edge);
      }
      regular = regular && is_regular(base[v], link.parts(-1), link.parts(1));
    }
    if (!regular) places.vertices.push_back({v, lower, upper, on_wall});
  }
  return places;
}

} // namespace tetrarch::product
