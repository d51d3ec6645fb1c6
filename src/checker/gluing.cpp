// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluing.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetrarch::checker {
namespace {

using Gluings = std::vector<std::array<FaceGluing, 4>>;

/// Sets that grow together.
class Union {
public:
  explicit Union(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(int x, int y) { parent_[root(x)] = root(y); }
  /// Numbers the sets.
  std::vector<int> numbers() {
    std::vector<int> number(parent_.size(), -1);
    int next = 0;
    for (std::size_t x = 0; x < parent_.size(); ++x) {
      int& of_root = number[root(static_cast<int>(x))];
      if (of_root < 0) of_root = next++;
    }
    for (std::size_t x = 0; x < parent_.size(); ++x) number[x] = number[root(static_cast<int>(x))];
    return number;
  }

private:
  std::vector<int> parent_;
};

bool is_odd(const std::array<int, 4>& p) {
  bool odd = false;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) odd ^= p[j] > p[i];
  return odd;
}

bool fits_back(const Gluings& gluings, int tet, int face) {
  const FaceGluing& there = gluings[tet][face];
  const int far = there.images[face];
  const FaceGluing& back = gluings[there.tet][far];
  for (int v = 0; v < 4; ++v)
    if (back.images[there.images[v]] != v) return false;
  return back.tet == tet && !(there.tet == tet && far == face);
}

/// Calls back for all t, f, and vertices a, b of the face, a < b.
template <class Function>
void for_each_shared_edge(const Gluings& gluings, Function function) {
  for (int t = 0; t < static_cast<int>(gluings.size()); ++t)
    for (int f = 0; f < 4; ++f)
      for (const auto& [a, b] : ends_of_edge)
        if (a != f && b != f) function(t, gluings[t][f], a, b);
}

/// The number of an edge of a tetrahedron read from a to b, two for each edge.
int directed(int tet, int a, int b) {
  return 16 * tet + 4 * a + b;
}

bool is_orientable(const Gluings& gluings) {
  Union sides(2 * gluings.size()); // each tetrahedron with each handedness
  for (int t = 0; t < static_cast<int>(gluings.size()); ++t)
    for (const FaceGluing& g : gluings[t]) {
      const int turned = is_odd(g.images) ? 0 : 1;
      sides.join(2 * t, 2 * g.tet + turned);
      sides.join(2 * t + 1, 2 * g.tet + 1 - turned);
    }
  return sides.root(0) != sides.root(1);
}

bool is_connected(const Gluings& gluings) {
  Union all(gluings.size());
  for (int t = 0; t < static_cast<int>(gluings.size()); ++t)
    for (const FaceGluing& g : gluings[t]) all.join(t, g.tet);
  for (int t = 0; t < static_cast<int>(gluings.size()); ++t)
    if (all.root(t) != all.root(0)) return false;
  return true;
}

/// Ends of edges are the link's vertices, corners its triangles: chi = V - E + F with E = 3/2 F.
void find_links(Classes& found) {
  std::vector<int> twice;
  for (const auto& vertices : found.vertex)
    for (const int v : vertices) {
      if (v >= static_cast<int>(twice.size())) twice.resize(static_cast<std::size_t>(v) + 1, 0);
      --twice[v];
    }
  for (const auto& [a, b] : found.ends) {
    twice[a] += 2;
    twice[b] += 2;
  }
  for (const int euler : twice) {
    found.link.push_back(euler / 2);
    if (euler % 2 != 0 || euler == 2)
      found.fault = "a vertex link is a projective plane, which no hyperbolic vertex has";
  }
}

} // namespace

Classes classes_of(const Gluings& gluings) {
  Classes found;
  const int n = static_cast<int>(gluings.size());
  for (int t = 0; t < n; ++t)
    for (int f = 0; f < 4; ++f)
      if (!fits_back(gluings, t, f)) {
        found.fault = "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
                      " is not glued alike from both sides";
        return found;
      }
  Union edges(16 * gluings.size());
  Union vertices(4 * gluings.size());
  for_each_shared_edge(gluings, [&](int t, const FaceGluing& g, int a, int b) {
    edges.join(directed(t, a, b), directed(g.tet, g.images[a], g.images[b]));
    edges.join(directed(t, b, a), directed(g.tet, g.images[b], g.images[a]));
    vertices.join(4 * t + a, 4 * g.tet + g.images[a]);
    vertices.join(4 * t + b, 4 * g.tet + g.images[b]);
  });
  Union names(6 * gluings.size());
  for_each_shared_edge(gluings, [&](int t, const FaceGluing& g, int a, int b) {
    const auto number = [](int x, int y) {
      for (int e = 0; e < 6; ++e)
        if (ends_of_edge[e] == std::array{std::min(x, y), std::max(x, y)}) return e;
      return -1;
    };
    names.join(6 * t + number(a, b), 6 * g.tet + number(g.images[a], g.images[b]));
  });
  const std::vector<int> edge_number = names.numbers();
  const std::vector<int> vertex_number = vertices.numbers();
  for (int t = 0; t < n; ++t) {
    std::array<int, 6> six{};
    std::array<int, 4> four{};
    for (int v = 0; v < 4; ++v) four[v] = vertex_number[4 * t + v];
    for (int e = 0; e < 6; ++e) {
      six[e] = edge_number[6 * t + e];
      const auto [a, b] = ends_of_edge[e];
      if (edges.root(directed(t, a, b)) == edges.root(directed(t, b, a)))
        found.fault = "an edge is identified with itself reversed";
      if (six[e] >= static_cast<int>(found.ends.size()))
        found.ends.resize(static_cast<std::size_t>(six[e]) + 1);
      found.ends[six[e]] = {four[a], four[b]};
    }
    std::array<std::array<int, 4>, 4> ends{};
    for (int v = 0; v < 4; ++v)
      for (int w = 0; w < 4; ++w) ends[v][w] = edges.root(directed(t, v, w));
    found.end.push_back(ends);
    found.edge.push_back(six);
    found.vertex.push_back(four);
  }
  find_links(found);
  found.orientable = is_orientable(gluings);
  if (!is_connected(gluings)) found.fault = "the gluing is not connected";
  return found;
}

} // namespace tetrarch::checker
