// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/marked_surface.hpp"

#include "tetrarch/core/error.hpp"

#include <numeric>
#include <utility>

namespace tetrarch::surface {
namespace {

void add_mean(std::vector<std::array<double, 3>>& points, const std::array<int, 3>& of, std::size_t count) {
  if (points.empty()) return;
  std::array<double, 3> mean{};
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      mean[axis] += points[static_cast<std::size_t>(of[k])][axis] / static_cast<double>(count);
  points.push_back(mean);
}

} // namespace

MarkedSurface::MarkedSurface(Surface s, std::vector<std::array<double, 3>> p)
    : surface(std::move(s)), points(std::move(p)), mark(static_cast<std::size_t>(surface.side_count()), 0),
      origin(static_cast<std::size_t>(surface.triangle_count())) {
  if (!points.empty() && static_cast<int>(points.size()) != surface.vertex_count())
    throw PreconditionError("a point for each vertex is needed, or none");
  std::iota(origin.begin(), origin.end(), 0);
}

void set_mark(MarkedSurface& surface, Side s, int m) {
  if (surface.surface.is_boundary(s)) throw PreconditionError("a boundary side cannot be marked");
  surface.mark[s.value] = m;
  surface.mark[surface.surface.mate(s).value] = -m;
}

int split_edge(MarkedSurface& surface, Side s) {
  const std::array<int, 3> of{surface.surface.from(s), surface.surface.to(s), -1};
  add_mean(surface.points, of, 2);
  surface.splits.push_back({surface.surface.vertex_count(), of});
  surface.edits.push_back({Edit::Kind::split_edge, s});
  return surface.surface.split_edge(s, &surface.mark, &surface.origin);
}

int split_face(MarkedSurface& surface, int triangle) {
  const std::array<int, 3> of = surface.surface.corners(triangle);
  add_mean(surface.points, of, 3);
  surface.splits.push_back({surface.surface.vertex_count(), of});
  surface.edits.push_back({Edit::Kind::split_face, Side(triangle, 0)});
  return surface.surface.split_face(triangle, &surface.mark, &surface.origin);
}

void turn_triangles(MarkedSurface& surface, const std::vector<int>& sign) {
  std::vector<char> over(sign.size(), 0);
  for (std::size_t t = 0; t < sign.size(); ++t) over[t] = static_cast<char>(sign[t] < 0);
  surface.surface.turn(over);
  for (int t = 0; t < surface.surface.triangle_count(); ++t)
    if (over[t]) std::swap(surface.mark[Side(t, 1).value], surface.mark[Side(t, 2).value]);
}

void flip_edge(MarkedSurface& surface, Side s) {
  surface.edits.push_back({Edit::Kind::flip_edge, s});
  surface.surface.flip_edge(s, &surface.mark);
}

void repeat(MarkedSurface& surface, const Edit& edit, std::vector<int>& name) {
  const Side s(name[static_cast<std::size_t>(edit.side.triangle())], edit.side.corner());
  const int before = surface.surface.triangle_count();
  switch (edit.kind) {
  case Edit::Kind::split_edge:
    split_edge(surface, s);
    break;
  case Edit::Kind::split_face:
    split_face(surface, s.triangle());
    break;
  case Edit::Kind::flip_edge:
    flip_edge(surface, s);
    break;
  }
  for (int t = before; t < surface.surface.triangle_count(); ++t) name.push_back(t);
}

Surface cut_open(const MarkedSurface& surface) {
  const Surface& whole = surface.surface;
  Table<Side, Side> mate(whole.side_count());
  std::vector<char> turned(static_cast<std::size_t>(whole.side_count()), 0);
  for (int k = 0; k < whole.side_count(); ++k) {
    const Side s(k);
    if (surface.is_cut(s)) continue;
    mate[s] = whole.mate(s);
    turned[k] = static_cast<char>(whole.is_turned(s));
  }
  return Surface(mate, std::move(turned));
}

} // namespace tetrarch::surface
