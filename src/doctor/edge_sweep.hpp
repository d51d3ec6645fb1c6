// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// All sides of a list of triangles, gathered by their two ends, and mates made of them: what
/// solid/face_sweep.hpp does for tetrahedra, by the same two linear passes.

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/surface/surface.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::doctor {

using surface::Side;
using surface::Surface;

/// A side among those with the same lesser end.
struct SortedSide {
  int greater = 0;        ///< the other end
  int apex = 0;           ///< the third vertex of the triangle
  std::uint32_t code = 0; ///< 3t+s
  Side at() const { return Side(static_cast<int>(code)); }
};

/// Calls `visit(std::span<const SortedSide>)` for every set of sides on the same two vertices, in the order
/// of these; within the set, by apex, then by triangle. The sides of triangle t count where `use(t)` holds;
/// the vertices of such a t are in 0..points-1 and differ. O(n + points) and O(k log k) for each vertex, if
/// it is the lesser end of k sides.
template <class Use, class Visit>
void for_each_edge(const std::vector<Surface::Triangle>& triangles, std::size_t points, Use use,
                   Visit visit) {
  if (triangles.size() > std::numeric_limits<int>::max() / 3)
    throw PreconditionError("there are too many triangles");
  std::vector<std::size_t> start(points + 2, 0);
  const auto each_side = [&](auto job) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
      if (!use(t)) continue;
      for (int c = 0; c < 3; ++c) {
        const auto [lesser, greater] = std::minmax(triangles[t][(c + 1) % 3], triangles[t][(c + 2) % 3]);
        job(lesser, SortedSide{greater, triangles[t][c], static_cast<std::uint32_t>(3 * t + c)});
      }
    }
  };
  each_side([&](int lesser, const SortedSide&) { ++start[lesser + 2]; });
  for (std::size_t v = 2; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<SortedSide> sides(start.back());
  // start[v + 1] runs through the sides of v and ends where those of v + 1 begin.
  each_side([&](int lesser, const SortedSide& side) { sides[start[lesser + 1]++] = side; });
  for (std::size_t v = 0; v + 2 < start.size(); ++v) {
    const auto own = std::span(sides).subspan(start[v], start[v + 1] - start[v]);
    std::sort(own.begin(), own.end(), [](const SortedSide& a, const SortedSide& b) {
      if (a.greater != b.greater) return a.greater < b.greater;
      return a.apex != b.apex ? a.apex < b.apex : a.code < b.code;
    });
    for (std::size_t first = 0, last = 0; first < own.size(); first = last) {
      while (last < own.size() && own[last].greater == own[first].greater) ++last;
      visit(std::span<const SortedSide>(own.subspan(first, last - first)));
    }
  }
}

/// "the edge on vertices 4, 7", as the file counts them.
inline std::string edge_name(const format::Soup& soup, Side s) {
  const auto& corners = soup.triangles[static_cast<std::size_t>(s.triangle())];
  const auto [lesser, greater] = std::minmax(corners[s.next().corner()], corners[s.previous().corner()]);
  return "the edge on vertices " + std::to_string(format::point_number(soup, lesser)) + ", " +
         std::to_string(format::point_number(soup, greater));
}

/// Mates found one by one, for a surface that names its vertices by fans.
class Mates {
public:
  explicit Mates(const std::vector<Surface::Triangle>& triangles)
      : triangles_(triangles), mate_(static_cast<int>(3 * triangles.size())),
        turned_(3 * triangles.size(), 0) {}

  /// Two sides with the same ends.
  void glue(Side a, Side b) {
    mate_[a] = b;
    mate_[b] = a;
    turned_[a.value] = turned_[b.value] = static_cast<char>(from(a) == from(b));
  }
  Surface surface() && { return Surface(mate_, std::move(turned_)); }

private:
  int from(Side s) const { return triangles_[s.triangle()][s.next().corner()]; }

  const std::vector<Surface::Triangle>& triangles_;
  Table<Side, Side> mate_;
  std::vector<char> turned_;
};

} // namespace tetrarch::doctor
