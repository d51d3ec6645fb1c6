// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/closed_surface.hpp"

#include "edge_sweep.hpp"
#include "findings.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/validate_surface.hpp"

namespace tetrarch::doctor {
namespace {

bool keeps_from_filling(Kind kind) {
  return kind != Kind::flat && kind != Kind::thin && kind != Kind::unused_vertex &&
         kind != Kind::coincident_vertex && kind != Kind::inside_out;
}

[[noreturn]] void refuse_boundary(const format::Soup& surface, Side s) {
  const format::Labels& labels = surface.triangle_labels;
  throw InputError(Place{surface.source, labels.line(s.triangle())},
                   "triangle " + std::to_string(labels.number(s.triangle(), surface.first_number)) +
                       " is alone at " + edge_name(surface, s) + ": the surface is not closed");
}

} // namespace

void require_closed_surface(const format::Soup& surface) {
  refuse(surface, validate_surface(surface, 1), keeps_from_filling);
  for_each_edge(
      surface.triangles, surface.points.size(), [](int) { return true; },
      [&](std::span<const SortedSide> sides) {
        if (sides.size() == 1) refuse_boundary(surface, sides[0].at());
      });
}

} // namespace tetrarch::doctor
