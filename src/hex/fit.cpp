// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hex/fit.hpp"

#include "tetrarch/hex/layers.hpp"
#include "tetrarch/hex/reach.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetrarch::hex {
namespace {

using namespace numeric;
using unfold::Freedom;

std::vector<unfold::Brick> bricks_of(const SizedHexahedra& hexahedra) {
  std::vector<unfold::Brick> bricks;
  bricks.reserve(hexahedra.lengths.size());
  for (std::size_t h = 0; h < hexahedra.lengths.size(); ++h)
    bricks.push_back(unfold::brick(hexahedra.mesh.hexahedra[h], hexahedra.lengths[h]));
  return bricks;
}

double mean_length(const SizedHexahedra& hexahedra) {
  double sum = 0;
  for (const Lengths& l : hexahedra.lengths) sum += l[0] + l[1] + l[2];
  return sum / (3.0 * static_cast<double>(hexahedra.lengths.size()));
}

Freedom::Kind freedom_of(Home::Kind kind) {
  switch (kind) {
  case Home::Kind::inside:
    return Freedom::Kind::free;
  case Home::Kind::surface:
  case Home::Kind::patch:
    return Freedom::Kind::plane;
  case Home::Kind::ridge:
    return Freedom::Kind::line;
  case Home::Kind::corner:
    break;
  }
  return Freedom::Kind::fixed;
}

/// Unfolds the inside while the surface stays: elements that are folded have a smaller energy where all is
/// smaller, and springs would not hold the surface.
void settle(unfold::Problem problem, const std::vector<Home>& home, product::HexMesh& mesh,
            const Progress& progress) {
  for (std::size_t v = 0; v < home.size(); ++v)
    if (home[v].kind != Home::Kind::inside) problem.freedom[v].kind = Freedom::Kind::fixed;
  unfold::Options descent;
  descent.iterations = 40;
  descent.most_rounds = 10;
  descent.flat = 1e-4;
  descent.least_gain = 0.1;
  mesh.points = unfold::unfold(problem, std::move(mesh.points), descent, progress.silent()).points;
}

} // namespace

std::vector<char> deep_points(const product::HexMesh& mesh, const std::vector<Home>& home) {
  constexpr int layers = 6;
  std::vector<char> deep(home.size(), 1);
  for (std::size_t v = 0; v < home.size(); ++v)
    if (home[v].kind != Home::Kind::inside) deep[v] = 0;
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<char> next = deep;
    for (const product::Hexahedron& h : mesh.hexahedra)
      if (std::any_of(h.begin(), h.end(), [&](int v) { return deep[v] == 0; }))
        for (const int v : h) next[v] = 0;
    deep = std::move(next);
  }
  return deep;
}

std::vector<Vector> surface_normals(const product::HexMesh& mesh) {
  std::vector<Vector> normal(mesh.points.size(), Vector{});
  for (const SurfaceSquare& s : surface_of(mesh)) {
    const auto& side = product::outward_sides[s.side];
    const product::Hexahedron& h = mesh.hexahedra[s.hexahedron];
    const Vector area = cross(mesh.points[h[side[2]]] - mesh.points[h[side[0]]],
                              mesh.points[h[side[3]]] - mesh.points[h[side[1]]]);
    for (const int c : side) normal[h[c]] = normal[h[c]] + area;
  }
  for (Vector& n : normal) n = direction(n).value_or(Vector{});
  return normal;
}

void fit(SizedHexahedra& hexahedra, const std::vector<Home>& home, const Targets& targets,
         const FitOptions& options, const Progress& progress) {
  product::HexMesh& mesh = hexahedra.mesh;
  unfold::Problem problem;
  problem.bricks = bricks_of(hexahedra);
  problem.freedom.assign(mesh.points.size(), {});
  const std::vector<char> deep = deep_points(mesh, home);
  for (std::size_t v = 0; v < home.size(); ++v)
    if (deep[v] != 0) problem.freedom[v].kind = Freedom::Kind::fixed;
  const double size = mean_length(hexahedra);
  unfold::Options descent;
  descent.iterations = options.iterations;
  descent.most_rounds = 2;
  descent.flat = options.flat;
  descent.reach = 0.01;
  settle(problem, home, mesh, progress);
  constexpr double spoiled = 0.05; // scaled Jacobian
  // In terms of a cell: what the solid sticks out by without asking, and by how much it draws in a round.
  constexpr double unnoticed = 0.1;
  constexpr double longest_way = 1;
  constexpr double of_reach = 0.3; // part of the springs' weight
  constexpr double strongest_reach = 100;
  const std::vector<SurfaceSample> samples = surface_samples(targets, size / 2);
  bool was_good = false;
  for (int round = 0; round < options.rounds; ++round) {
    progress.step("fitting", round / static_cast<double>(options.rounds));
    const double part = options.rounds > 1 ? round / (options.rounds - 1.0) : 1;
    const double weight =
        options.weakest * std::pow(options.strongest / options.weakest, part) / (size * size);
    const std::vector<Vector> normals = surface_normals(mesh);
    problem.pulls.clear();
    for (std::size_t v = 0; v < home.size(); ++v) {
      if (home[v].kind == Home::Kind::inside) continue;
      const Place place = targets.place(home[v], mesh.points[v], &normals[v]);
      problem.pulls.push_back(
          {static_cast<int>(v), {freedom_of(home[v].kind), place.direction}, place.at, weight});
    }
    const std::vector<Vector> way =
        reach(mesh, samples, unnoticed * size, longest_way * size, progress.silent());
    for (std::size_t v = 0; v < home.size(); ++v)
      if (way[v] != Vector{} && (home[v].kind == Home::Kind::surface || home[v].kind == Home::Kind::patch))
        problem.pulls.push_back({static_cast<int>(v),
                                 {Freedom::Kind::fixed, {}},
                                 mesh.points[v] + way[v],
                                 of_reach * std::min(weight, strongest_reach / (size * size))});
    if (round + 1 == options.rounds) {
      descent.most_rounds = 8;
      descent.flat /= 10;
    }
    std::vector<Point> before = mesh.points;
    mesh.points = unfold::unfold(problem, std::move(mesh.points), descent, progress.silent()).last;
    // Springs that squeeze hexahedra flat are too strong: what is left of the way is for `land`.
    const double least = product::quality(mesh).minimum;
    if (was_good && least < spoiled) {
      mesh.points = std::move(before);
      break;
    }
    was_good = least >= spoiled;
  }
  if (options.ends_there) land(mesh, home, targets, progress);
}

int land(product::HexMesh& mesh, const std::vector<Home>& home, const Targets& targets,
         const Progress& progress, double least) {
  constexpr int most_halvings = 5;
  const std::vector<Vector> normals = surface_normals(mesh);
  const std::vector<Point> start = mesh.points;
  std::vector<Point> end = start;
  for (std::size_t v = 0; v < home.size(); ++v)
    if (home[v].kind != Home::Kind::inside) end[v] = targets.place(home[v], start[v], &normals[v]).at;
  const product::HexQuality before = product::quality(mesh);
  std::vector<int> halvings(start.size());
  for (bool is_done = false; !is_done;) {
    progress.step("fitting");
    is_done = true;
    for (std::size_t v = 0; v < start.size(); ++v)
      mesh.points[v] = halvings[v] > most_halvings ? start[v]
                       : halvings[v] == 0          ? end[v]
                                          : start[v] + std::ldexp(1.0, -halvings[v]) * (end[v] - start[v]);
    const product::HexQuality now = product::quality(mesh);
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
      if (now.scaled_jacobian[h] >= std::min(least, 0.9 * before.scaled_jacobian[h])) continue;
      for (const int v : mesh.hexahedra[h])
        if (end[v] != start[v] && halvings[v] <= most_halvings) {
          ++halvings[v];
          is_done = false;
        }
    }
  }
  return static_cast<int>(std::count_if(halvings.begin(), halvings.end(), [](int h) { return h > 0; }));
}

} // namespace tetrarch::hex
