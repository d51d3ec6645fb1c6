// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/build.hpp"

#include "findings.hpp"
#include "orient.hpp"

#include "tetrarch/doctor/validate_surface.hpp"

#include <utility>

namespace tetrarch::doctor {
namespace {

using surface::TriangleMesh;

/// Duplicates can be repaired, but a mesh cannot have them.
bool keeps_from_meshing(Kind kind) {
  return (severity_of(kind) == Severity::fatal && kind != Kind::non_manifold_vertex) ||
         kind == Kind::duplicate;
}

int turned_count(const Surface& surface) {
  int count = 0;
  for (int k = 0; k < surface.side_count(); ++k) count += surface.is_turned(Side(k));
  return count;
}

/// The surface with triangles turned along a tree, if that leaves fewer turned mates than there are.
Surface with_few_turned(Surface surface) {
  const Signs signs = signs_of(surface);
  std::vector<Surface::Triangle> triangles = surface.triangles();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (signs.sign[t] < 0) std::swap(triangles[t][1], triangles[t][2]);
  Surface other(surface.vertex_count(), std::move(triangles));
  if (turned_count(other) < turned_count(surface)) return other;
  return surface;
}

} // namespace

solid::TetMesh build(format::Soup soup) {
  const Report report = validate(soup, 1);
  return build(std::move(soup), report);
}

solid::TetMesh build(format::Soup soup, const Report& report) {
  refuse(soup, report, keeps_from_meshing);
  refuse(
      soup, report, [](Kind kind) { return kind == Kind::non_manifold_vertex; }, "; --repair splits it");
  return {std::move(soup.points), std::move(soup.tetrahedra)};
}

TriangleMesh build_surface(format::Soup soup) {
  const Report report = validate_surface(soup, 1);
  return build_surface(std::move(soup), report);
}

TriangleMesh build_surface(format::Soup soup, const Report& report) {
  const auto is_pinch = [](Kind kind) { return kind == Kind::non_manifold_vertex; };
  refuse(soup, report, [&](Kind kind) {
    return (severity_of(kind) == Severity::fatal && !is_pinch(kind)) || kind == Kind::several_components;
  });
  refuse(soup, report, is_pinch, "; --repair splits it");
  refuse(
      soup, report, [](Kind kind) { return severity_of(kind) == Severity::repairable; },
      "; --repair mends this");
  const int vertices = static_cast<int>(soup.points.size());
  Surface surface(vertices, std::move(soup.triangles));
  if (report.count(Kind::not_orientable) > 0) surface = with_few_turned(std::move(surface));
  return {std::move(soup.points), std::move(surface)};
}

} // namespace tetrarch::doctor
