// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/planes.hpp"

#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/solid/split_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;
using surface::Side;

/// In how many planes all of these vertices are.
int common_planes(const Planes& planes, std::initializer_list<int> vertices) {
  int count = 0;
  const auto& first = planes.holds[*vertices.begin()];
  for (std::size_t a = 0; a < 3; ++a)
    if (first[a] >= 0 &&
        std::all_of(vertices.begin(), vertices.end(), [&](int v) { return planes.holds[v][a] == first[a]; }))
      ++count;
  return count;
}

using Edge = std::array<int, 2>;
Edge edge_of(int v, int w) {
  return {std::min(v, w), std::max(v, w)};
}

/// Whether all corners lie on two parallel lines, so that the tetrahedron must be flat.
bool is_between_lines(const Planes& planes, const std::array<int, 4>& tet) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::set<Edge> lines;
    for (const int v : tet) lines.insert({planes.holds[v][(axis + 1) % 3], planes.holds[v][(axis + 2) % 3]});
    const bool are_lines = std::all_of(lines.begin(), lines.end(),
                                       [](const Edge& line) { return line[0] >= 0 && line[1] >= 0; });
    if (are_lines && lines.size() <= 2) return true;
  }
  return false;
}

/// The edges that must be split, in order.
std::vector<solid::EdgePoint> locked_edges(const product::Solid& solid, const Charts& charts,
                                           const Planes& planes) {
  // The most planes that the ends of an edge of the boundary may share.
  std::map<Edge, int> allowed;
  const surface::Surface& surface = solid.boundary;
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t))
      allowed[edge_of(solid.vertex[surface.from(s)], solid.vertex[surface.to(s)])] =
          charts.of[t] == charts.of[surface.mate(s).triangle()] ? 1 : 2;
  std::vector<Edge> locked;
  for (const auto& tet : solid.mesh.tetrahedra) {
    const bool is_flat = is_between_lines(planes, tet);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const int shared = common_planes(planes, {tet[i], tet[j]});
        if (is_flat && shared < 2 && !allowed.contains(edge_of(tet[i], tet[j])))
          locked.push_back(edge_of(tet[i], tet[j]));
        if (shared == 0) continue;
        const auto found = allowed.find(edge_of(tet[i], tet[j]));
        if (shared > (found == allowed.end() ? 0 : found->second)) locked.push_back(edge_of(tet[i], tet[j]));
      }
  }
  std::sort(locked.begin(), locked.end());
  locked.erase(std::unique(locked.begin(), locked.end()), locked.end());
  std::vector<solid::EdgePoint> result;
  result.reserve(locked.size());
  for (const auto& [from, to] : locked) result.push_back({from, to, 1.0 / 2});
  return result;
}

/// The label of each triangle of the boundary, which is a face of the new mesh, from the face it comes from.
template <class Origin>
LabeledSolid relabeled(const LabeledSolid& old, solid::TetMesh mesh, const Origin& origin) {
  LabeledSolid result{product::solid_of(std::move(mesh)), {}, old.image};
  for (const TetFace& face : result.solid.face) result.label.push_back(old.label[origin(face)]);
  return result;
}

LabeledSolid split_at(const LabeledSolid& old, const std::vector<solid::EdgePoint>& edges) {
  solid::SplitTets split = solid::split_edges(old.solid.mesh, edges);
  LabeledSolid result = relabeled(old, std::move(split.mesh), [&](const TetFace& f) {
    const int face = split.face_of[static_cast<std::size_t>(4) * f.tet + f.face];
    return old.solid.outside[static_cast<std::size_t>(4) * split.origin[f.tet] + face];
  });
  if (!old.image.empty())
    for (const solid::EdgePoint& e : edges)
      result.image.push_back(0.5 * (old.image[e.from] + old.image[e.to]));
  return result;
}

/// Splits faces inside of three vertices of one plane: a tetrahedron that has one becomes a cone over its
/// faces, such faces being cut in three.
LabeledSolid with_faces_split(const LabeledSolid& old, const Planes& planes, bool& is_changed) {
  const product::Solid& solid = old.solid;
  solid::TetMesh mesh{solid.mesh.points, {}};
  std::vector<int> origin; // of each tetrahedron, the face at its base, as 4 t + f, or -1
  std::map<std::array<int, 3>, int> middle_of;
  std::vector<Point> image = old.image;
  const auto middle = [&](const std::vector<int>& vertices) {
    const auto mean = [&vertices](const std::vector<Point>& points) {
      Point sum{};
      for (const int v : vertices) sum = sum + points[v];
      return (1.0 / static_cast<double>(vertices.size())) * sum;
    };
    mesh.points.push_back(mean(mesh.points));
    if (!image.empty()) image.push_back(mean(image));
    return static_cast<int>(mesh.points.size()) - 1;
  };
  for (int t = 0; t < solid.size(); ++t) {
    const auto& v = solid.corners(t);
    std::array<int, 4> centers{-1, -1, -1, -1};
    for (int f = 0; f < 4; ++f) {
      std::array<int, 3> face{v[face_vertex[f][0]], v[face_vertex[f][1]], v[face_vertex[f][2]]};
      if (solid.outside[static_cast<std::size_t>(4) * t + f] >= 0 ||
          common_planes(planes, {face[0], face[1], face[2]}) == 0)
        continue;
      std::sort(face.begin(), face.end());
      const auto [found, is_new] = middle_of.try_emplace(face, 0);
      if (is_new) found->second = middle({face.begin(), face.end()});
      centers[f] = found->second;
    }
    if (std::all_of(centers.begin(), centers.end(), [](int c) { return c < 0; })) {
      mesh.tetrahedra.push_back(v);
      origin.push_back(4 * t);
      continue;
    }
    is_changed = true;
    const int apex = middle({v.begin(), v.end()});
    for (int f = 0; f < 4; ++f) {
      // The corner opposite to the face becomes the apex, which keeps the handedness.
      std::array<int, 4> cone = v;
      cone[f] = apex;
      if (centers[f] < 0) {
        mesh.tetrahedra.push_back(cone);
        origin.push_back(4 * t);
        continue;
      }
      for (const int corner : face_vertex[f]) {
        std::array<int, 4> third = cone;
        third[corner] = centers[f];
        mesh.tetrahedra.push_back(third);
        origin.push_back(-1);
      }
    }
  }
  LabeledSolid result = relabeled(old, std::move(mesh), [&](const TetFace& f) {
    return solid.outside[static_cast<std::size_t>(origin[f.tet]) + f.face];
  });
  result.image = std::move(image);
  return result;
}

} // namespace

Planes planes(const product::Solid& solid, const Charts& charts) {
  std::vector<int> parent;
  parent.reserve(static_cast<std::size_t>(charts.count()));
  for (int chart = 0; chart < charts.count(); ++chart) parent.push_back(chart);
  for (const std::vector<int>& around : charts.around)
    for (const int a : around)
      for (const int b : around)
        if (axis_of(charts.label[a]) == axis_of(charts.label[b]))
          parent[find_root(parent, a)] = find_root(parent, b);
  Planes result;
  std::vector<int> number(parent.size(), -1);
  for (int chart = 0; chart < charts.count(); ++chart) {
    int& plane = number[find_root(parent, chart)];
    if (plane < 0) {
      plane = result.count();
      result.axis.push_back(axis_of(charts.label[chart]));
      result.area.push_back(0);
    }
    result.of_chart.push_back(plane);
    result.area[plane] += charts.area[chart];
  }
  result.holds.assign(solid.mesh.points.size(), {-1, -1, -1});
  for (std::size_t v = 0; v < charts.around.size(); ++v)
    for (const int chart : charts.around[v])
      result.holds[solid.vertex[v]][axis_of(charts.label[chart])] = result.of_chart[chart];
  return result;
}

LabeledSolid with_room(LabeledSolid labeled, const Progress& progress) {
  // Halves of an edge are locked no more, but new edges of tetrahedra that were split may be.
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    progress.step("room between planes");
    const Charts charts = polycube::charts(labeled.solid, Facets(labeled.solid), labeled.label);
    const Planes planes = polycube::planes(labeled.solid, charts);
    if (const auto edges = locked_edges(labeled.solid, charts, planes); !edges.empty()) {
      labeled = split_at(labeled, edges);
      continue;
    }
    bool is_changed = false;
    LabeledSolid split = with_faces_split(labeled, planes, is_changed);
    if (!is_changed) break;
    labeled = std::move(split);
  }
  return labeled;
}

LabeledSolid refined(const LabeledSolid& labeled, const std::vector<int>& tetrahedra,
                     const Progress& progress) {
  const auto edges_of = [&](int t) {
    std::vector<Edge> edges;
    edges.reserve(6);
    const auto& v = labeled.solid.corners(t);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) edges.push_back(edge_of(v[i], v[j]));
    return edges;
  };
  std::set<Edge> first;
  for (const int t : tetrahedra)
    for (const Edge& e : edges_of(t)) first.insert(e);
  std::set<Edge> all = first;
  for (int t = 0; t < labeled.solid.size(); ++t) {
    const std::vector<Edge> edges = edges_of(t);
    if (std::any_of(edges.begin(), edges.end(), [&](const Edge& e) { return first.contains(e); }))
      all.insert(edges.begin(), edges.end());
  }
  std::vector<solid::EdgePoint> splits;
  splits.reserve(all.size());
  for (const auto& [from, to] : all) splits.push_back({from, to, 1.0 / 2});
  return with_room(split_at(labeled, splits), progress);
}

} // namespace tetrarch::polycube
