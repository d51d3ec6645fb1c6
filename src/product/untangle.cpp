// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/untangle.hpp"

#include "hexahedron.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;
using unfold::Freedom;

/// Normals whose sine is less than this are of one plane: points slide along it by many edges, and what they
/// then leave the plane by must be far below an edge.
constexpr double same_plane = 1e-6;

/// The planes around a point, by their normals; more than two do not matter.
struct Planes {
  std::vector<Vector> normals;
  bool is_on_surface = false;
  bool is_curved = false;

  void add(const Vector& normal) {
    is_on_surface = true;
    const auto same = [&](const Vector& n) { return norm(cross(n, normal)) < same_plane; };
    if (normals.size() < 3 && std::none_of(normals.begin(), normals.end(), same)) normals.push_back(normal);
  }
};

/// Adds a square to the planes around its points: those of its corners must all be one.
void add(const HexMesh& mesh, const std::array<int, 4>& square, std::vector<Planes>& planes) {
  std::vector<Vector> normals;
  for (std::size_t k = 0; k < 4; ++k) {
    const Point& p = mesh.points[square[k]];
    const auto n =
        direction(cross(mesh.points[square[(k + 1) % 4]] - p, mesh.points[square[(k + 3) % 4]] - p));
    if (n) normals.push_back(*n);
  }
  const bool is_flat = !normals.empty() && std::all_of(normals.begin(), normals.end(), [&](const Vector& n) {
    return norm(cross(n, normals.front())) < same_plane;
  });
  for (const int v : square) {
    planes[v].is_on_surface = true;
    if (is_flat)
      planes[v].add(normals.front());
    else
      planes[v].is_curved = true;
  }
}

double mean_hex_edge(const HexMesh& mesh) {
  double sum = 0;
  for (const Hexahedron& h : mesh.hexahedra)
    for (std::size_t c = 0; c < 8; ++c)
      for (const int n : corner_neighbors[c]) sum += distance(mesh.points[h[c]], mesh.points[h[n]]);
  return sum / (24.0 * static_cast<double>(mesh.hexahedra.size()));
}

unfold::Problem problem_of(const HexMesh& mesh, const std::vector<Sliding>& may,
                           const std::vector<char>& fixed) {
  unfold::Problem problem;
  const double size = mean_hex_edge(mesh);
  for (const Hexahedron& h : mesh.hexahedra) problem.bricks.push_back(unfold::brick(h, {size, size, size}));
  for (std::size_t v = 0; v < may.size(); ++v) {
    Freedom f;
    f.direction = may[v].direction;
    const bool stays = may[v].kind == Sliding::Kind::fixed || (!fixed.empty() && fixed[v] != 0);
    f.kind = stays                                 ? Freedom::Kind::fixed
             : may[v].kind == Sliding::Kind::plane ? Freedom::Kind::plane
             : may[v].kind == Sliding::Kind::ridge ? Freedom::Kind::line
                                                   : Freedom::Kind::free;
    problem.freedom.push_back(f);
  }
  return problem;
}

} // namespace

std::vector<Sliding> sliding(const HexMesh& mesh) {
  std::vector<Planes> planes(mesh.points.size());
  for (const auto& square : surface_squares(mesh)) add(mesh, square, planes);
  std::vector<Sliding> result(planes.size());
  for (std::size_t v = 0; v < planes.size(); ++v) {
    const Planes& p = planes[v];
    if (!p.is_on_surface) continue;
    result[v].kind = Sliding::Kind::fixed;
    if (p.is_curved) continue;
    if (p.normals.size() == 1) result[v] = {Sliding::Kind::plane, p.normals[0]};
    if (p.normals.size() == 2)
      if (const auto along = direction(cross(p.normals[0], p.normals[1])))
        result[v] = {Sliding::Kind::ridge, *along};
  }
  return result;
}

Untangled untangle(HexMesh& mesh, const std::vector<char>& fixed, const Progress& progress) {
  if (!fixed.empty() && fixed.size() != mesh.points.size())
    throw PreconditionError("untangle: each point needs a flag that says whether it is fixed");
  Untangled result;
  const HexQuality before = quality(mesh);
  result.bad_before = result.bad_after = static_cast<int>(before.bad.size());
  result.minimum_before = result.minimum_after = before.minimum;
  if (mesh.hexahedra.empty() || !(mean_hex_edge(mesh) > 0)) return result;
  const unfold::Problem problem = problem_of(mesh, sliding(mesh), fixed);
  for (const Freedom& f : problem.freedom)
    if (f.kind == Freedom::Kind::plane || f.kind == Freedom::Kind::line) ++result.sliding;
  unfold::Unfolded done = unfold::unfold(problem, mesh.points, {}, progress);
  result.iterations = done.iterations;
  HexMesh other{std::move(done.points), mesh.hexahedra};
  const HexQuality after = quality(other);
  if (!is_better(after, before)) return result;
  mesh = std::move(other);
  result.bad_after = static_cast<int>(after.bad.size());
  result.minimum_after = after.minimum;
  return result;
}

} // namespace tetrarch::product
