// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/boundary_surface.hpp"

#include "soup_edit.hpp"

#include "tetrarch/solid/face_sweep.hpp"

namespace tetrarch::doctor {
namespace {

using solid::FaceSweep;
using solid::SortedFace;

/// Of each face its corners, counterclockwise seen from outside of a tetrahedron of positive volume.
constexpr std::array<std::array<std::size_t, 3>, 4> outward{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

} // namespace

format::Soup boundary_surface(const format::Soup& solid) {
  std::vector<std::uint32_t> alone;
  FaceSweep sweep(solid.tetrahedra, solid.points.size(),
                  [&](std::size_t t) { return is_proper(solid, solid.tetrahedra[t]); });
  sweep.for_each_class([&](std::span<const SortedFace> shared) {
    if (shared.size() == 1) alone.push_back(shared.front().code);
  });
  std::sort(alone.begin(), alone.end());
  const std::vector<ListedTriangle> list = listed_triangles(solid);
  format::Soup surface;
  surface.source = solid.source;
  surface.point_source = solid.point_source;
  surface.first_number = solid.first_number;
  surface.points = solid.points;
  surface.point_labels = solid.point_labels;
  for (const std::uint32_t code : alone) {
    const auto& corners = solid.tetrahedra[code / 4];
    const auto& [a, b, c] = outward[code % 4];
    std::array<int, 3> triangle{corners[a], corners[b], corners[c]};
    surface.triangles.push_back(triangle);
    if (solid.triangle_tags.empty()) continue;
    std::sort(triangle.begin(), triangle.end());
    const auto [first, last] = on_corners(list, triangle);
    const bool listed = first < last;
    surface.triangle_tags.push_back(listed ? solid.triangle_tags[static_cast<std::size_t>(list[first].index)]
                                           : 0);
  }
  remove_unused_points(surface);
  return surface;
}

} // namespace tetrarch::doctor
