// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/edge_weights.hpp"

#include "tetrarch/core/tet.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::solid {
namespace {

using namespace numeric;

/// Of each edge of one tetrahedron. Twice the areas of two faces, as vectors n_i and n_j pointing inward, and
/// the dihedral angle between them: l_kl cot(theta_kl) = -n_i . n_j / (6 volume).
std::array<double, 6> weights(const TetMesh& mesh, const std::array<int, 4>& v) {
  const Vector a = mesh.points[v[1]] - mesh.points[v[0]];
  const Vector b = mesh.points[v[2]] - mesh.points[v[0]];
  const Vector c = mesh.points[v[3]] - mesh.points[v[0]];
  const Vector bc = cross(b, c);
  const Vector ca = cross(c, a);
  const Vector ab = cross(a, b);
  const std::array<Vector, 4> normal{-bc - ca - ab, bc, ca, ab};
  const double six_volumes = dot(a, bc);
  std::array<double, 6> weight{};
  for (int e = 0; e < 6; ++e)
    weight[e] = -dot(normal[edge_vertex[e][0]], normal[edge_vertex[e][1]]) / (6 * six_volumes);
  return weight;
}

} // namespace

std::vector<WeightedEdge> edge_weights(const TetMesh& mesh) {
  std::vector<std::size_t> first(mesh.points.size() + 1, 0);
  for (const auto& v : mesh.tetrahedra)
    for (const auto& [a, b] : edge_vertex) ++first[std::min(v[a], v[b]) + 1];
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];

  std::vector<std::pair<int, double>> parts(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& v : mesh.tetrahedra) {
    const std::array<double, 6> weight = weights(mesh, v);
    for (int e = 0; e < 6; ++e) {
      const auto [a, b] = std::minmax(v[edge_vertex[e][0]], v[edge_vertex[e][1]]);
      parts[next[a]++] = {b, weight[e]};
    }
  }

  std::vector<WeightedEdge> edges;
  for (int from = 0; from + 1 < static_cast<int>(first.size()); ++from) {
    const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(first[from]);
    const auto end = parts.begin() + static_cast<std::ptrdiff_t>(first[from + 1]);
    // By vertex alone: parts are added up in the order of the tetrahedra.
    std::stable_sort(begin, end, [](const auto& p, const auto& q) { return p.first < q.first; });
    for (auto part = begin; part != end; ++part) {
      if (part == begin || part->first != edges.back().to) edges.push_back({from, part->first, 0.0});
      edges.back().weight += part->second;
    }
  }
  return edges;
}

std::vector<double> fluxes(const std::vector<WeightedEdge>& edges, const std::vector<double>& f) {
  std::vector<double> flux(f.size(), 0.0);
  for (const WeightedEdge& e : edges) {
    const double flow = e.weight * (f[e.from] - f[e.to]);
    flux[e.from] += flow;
    flux[e.to] -= flow;
  }
  return flux;
}

} // namespace tetrarch::solid
