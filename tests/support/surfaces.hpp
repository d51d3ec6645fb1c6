// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Surfaces of every type: spheres, tori, Klein bottles, handles and crosscaps, holes, polygons with sides
/// glued, and random retriangulations of all of them.
///
/// The simplicial ones are lists of triangles, oriented where they can be; polygons may have one vertex.

#include "support/random.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tetrarch::support {

struct TriangleList {
  std::vector<surface::Surface::Triangle> triangles;
  std::vector<std::array<double, 3>> points; ///< of each vertex, or empty
  int vertices = 0;

  surface::Surface surface() const { return {vertices, triangles}; }
  surface::MarkedSurface marked() const { return surface::MarkedSurface(surface(), points); }
};

/// The boundary of a tetrahedron: 4 triangles.
inline TriangleList tetrahedron_surface() {
  return {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
          4};
}

/// The boundary of a cube: 12 triangles. Vertex 4x+2y+z is the corner (x,y,z).
inline TriangleList cube_surface() {
  TriangleList cube;
  cube.vertices = 8;
  for (int v = 0; v < 8; ++v) cube.points.push_back({v / 4 * 1.0, v / 2 % 2 * 1.0, v % 2 * 1.0});
  for (const auto& [a, b, c, d] :
       {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    cube.triangles.push_back({a, b, c});
    cube.triangles.push_back({a, c, d});
  }
  return cube;
}

namespace detail {

/// The vertex in the middle of an edge, made when first asked for.
class Middles {
public:
  explicit Middles(TriangleList& mesh) : mesh_(mesh) {}
  int operator()(int a, int b) {
    const auto [at, is_new] = made_.try_emplace(std::minmax(a, b), mesh_.vertices);
    if (!is_new) return at->second;
    std::array<double, 3> p{};
    double norm = 0;
    for (int k = 0; k < 3; ++k) {
      p[k] = mesh_.points[a][k] + mesh_.points[b][k];
      norm += p[k] * p[k];
    }
    for (double& x : p) x /= std::sqrt(norm);
    mesh_.points.push_back(p);
    return mesh_.vertices++;
  }

private:
  TriangleList& mesh_;
  std::map<std::pair<int, int>, int> made_;
};

} // namespace detail

/// An octahedron whose triangles are split into four `levels` times, on the unit sphere: 8 * 4^levels
/// triangles.
inline TriangleList icosphere(int levels) {
  TriangleList mesh;
  mesh.vertices = 6;
  mesh.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int level = 0; level < levels; ++level) {
    detail::Middles middle(mesh);
    const auto coarse = std::exchange(mesh.triangles, {});
    for (const auto& [a, b, c] : coarse) {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      for (const auto& t : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
        mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

namespace detail {

/// Two triangles for each square of an m x n grid; `vertex(i, j)` for 0 <= i <= m, 0 <= j <= n.
template <class Vertex>
TriangleList grid(int m, int n, Vertex vertex) {
  TriangleList mesh;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh;
}

} // namespace detail

/// A torus of m x n squares, 2mn triangles, simplicial for m, n >= 3; a ring of radii 2 and 1.
inline TriangleList torus_grid(int m, int n) {
  TriangleList mesh = detail::grid(m, n, [&](int i, int j) { return i % m * n + j % n; });
  mesh.vertices = m * n;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = 2 + std::cos(turn * j / n);
      mesh.points.push_back({r * std::cos(turn * i / m), r * std::sin(turn * i / m), std::sin(turn * j / n)});
    }
  return mesh;
}

/// A Klein bottle of m x n squares, simplicial for m, n >= 4. Without points.
inline TriangleList klein_grid(int m, int n) {
  TriangleList mesh =
      detail::grid(m, n, [&](int i, int j) { return i < m ? i * n + j % n : (2 * n - j) % n; });
  mesh.vertices = m * n;
  return mesh;
}

/// The projective plane with six vertices: 10 triangles, opposite ones of the icosahedron identified.
inline TriangleList projective_plane() {
  return {{{0, 1, 2},
           {0, 2, 3},
           {0, 3, 4},
           {0, 4, 5},
           {0, 5, 1},
           {1, 2, 4},
           {2, 3, 5},
           {3, 4, 1},
           {4, 5, 2},
           {5, 1, 3}},
          {},
          6};
}

/// The connected sum: the last triangle of `a` and the first one of `b` go, their boundaries become one.
/// Oriented where both are. Without points.
inline TriangleList connected_sum(TriangleList a, const TriangleList& b) {
  const auto hole = a.triangles.back();
  const auto& plug = b.triangles.front();
  std::vector<int> name(static_cast<std::size_t>(b.vertices), -1);
  name[plug[0]] = hole[0];
  name[plug[1]] = hole[2];
  name[plug[2]] = hole[1];
  a.points.clear();
  a.triangles.pop_back();
  for (int& v : name)
    if (v < 0) v = a.vertices++;
  for (auto t = b.triangles.begin() + 1; t != b.triangles.end(); ++t)
    a.triangles.push_back({name[(*t)[0]], name[(*t)[1]], name[(*t)[2]]});
  return a;
}

/// The orientable surface of genus g: torus grids of m x n squares in a chain, or an octahedron. The necks
/// are single triangles, so this is hard on whatever needs many paths through them.
inline TriangleList genus_surface(int g, int m = 4, int n = 4) {
  if (g == 0) return icosphere(0);
  TriangleList torus = torus_grid(m, n);
  // The next torus is joined at the last triangle, the one before far from it.
  std::swap(torus.triangles.front(), torus.triangles[2 * (m / 2 * n + n / 2)]);
  TriangleList sum = torus;
  for (int k = 1; k < g; ++k) sum = connected_sum(std::move(sum), torus);
  return sum;
}

/// The boundary of a slab of unit cubes with `rows` times `columns` square holes, each a cube wide, a cube
/// apart: genus rows * columns, 20 triangles a handle and those of the rim, with points.
inline TriangleList plate_surface(int rows, int columns) {
  const auto is_solid = [&](int i, int j) {
    return i >= 0 && j >= 0 && i <= 2 * rows && j <= 2 * columns && (i % 2 == 0 || j % 2 == 0);
  };
  TriangleList mesh;
  std::map<std::array<int, 3>, int> name;
  const auto quad = [&](const std::array<std::array<int, 3>, 4>& corners) {
    std::array<int, 4> v{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& p = corners[k];
      const auto [at, is_new] = name.try_emplace(p, mesh.vertices);
      if (is_new) {
        ++mesh.vertices;
        mesh.points.push_back({1.0 * p[0], 1.0 * p[1], 1.0 * p[2]});
      }
      v[k] = at->second;
    }
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
  };
  for (int i = 0; i <= 2 * rows; ++i)
    for (int j = 0; j <= 2 * columns; ++j) {
      if (!is_solid(i, j)) continue;
      quad({{{i, j, 1}, {i + 1, j, 1}, {i + 1, j + 1, 1}, {i, j + 1, 1}}});
      quad({{{i, j, 0}, {i, j + 1, 0}, {i + 1, j + 1, 0}, {i + 1, j, 0}}});
      if (!is_solid(i - 1, j)) quad({{{i, j, 0}, {i, j, 1}, {i, j + 1, 1}, {i, j + 1, 0}}});
      if (!is_solid(i + 1, j)) quad({{{i + 1, j, 0}, {i + 1, j + 1, 0}, {i + 1, j + 1, 1}, {i + 1, j, 1}}});
      if (!is_solid(i, j - 1)) quad({{{i, j, 0}, {i + 1, j, 0}, {i + 1, j, 1}, {i, j, 1}}});
      if (!is_solid(i, j + 1)) quad({{{i, j + 1, 0}, {i, j + 1, 1}, {i + 1, j + 1, 1}, {i + 1, j + 1, 0}}});
    }
  return mesh;
}

/// The sum of k >= 1 projective planes.
inline TriangleList crosscaps(int k) {
  TriangleList sum = projective_plane();
  for (int i = 1; i < k; ++i) sum = connected_sum(std::move(sum), projective_plane());
  return sum;
}

/// Without the stars of `holes` vertices that have no neighbour in common, in the order of the vertices.
inline TriangleList with_holes(const TriangleList& mesh, int holes) {
  std::vector<std::vector<int>> star(static_cast<std::size_t>(mesh.vertices));
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (const int v : mesh.triangles[t]) star[v].push_back(t);
  std::vector<char> gone(mesh.triangles.size(), 0);
  std::vector<char> taken(static_cast<std::size_t>(mesh.vertices), 0);
  for (int v = 0; v < mesh.vertices && holes > 0; ++v) {
    const auto each_corner = [&](auto job) {
      for (const int t : star[v])
        for (const int w : mesh.triangles[t]) job(w);
    };
    bool free = true;
    each_corner([&](int w) { free = free && !taken[w]; });
    if (!free) continue;
    each_corner([&](int w) { taken[w] = 1; });
    for (const int t : star[v]) gone[t] = 1;
    --holes;
  }
  if (holes > 0) throw std::invalid_argument("no room for so many holes");
  TriangleList out;
  std::vector<int> name(static_cast<std::size_t>(mesh.vertices), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (gone[t]) continue;
    out.triangles.push_back(mesh.triangles[t]);
    for (int& v : out.triangles.back()) {
      if (name[v] < 0) {
        name[v] = out.vertices++;
        if (!mesh.points.empty()) out.points.push_back(mesh.points[v]);
      }
      v = name[v];
    }
  }
  return out;
}

/// A polygon fanned from its first corner, word.size() - 2 triangles, with sides glued: +k and -k name the
/// two copies of a side, reversed to one another; twice +k are a crosscap; a letter that occurs once is
/// boundary. Needs three sides.
inline surface::Surface glued_polygon(const std::vector<int>& word) {
  using surface::Side;
  const int n = static_cast<int>(word.size());
  Table<Side, Side> mate(3 * (n - 2));
  std::vector<char> turned(static_cast<std::size_t>(mate.size()), 0);
  const auto glue = [&](Side s, Side m, bool together) {
    mate[s] = m;
    mate[m] = s;
    turned[s.value] = turned[m.value] = static_cast<char>(together);
  };
  for (int t = 0; t + 1 < n - 2; ++t) glue({t, 1}, {t + 1, 2}, false);
  // Triangle t has polygon corners 0, t+1, t+2.
  const auto side = [&](int k) { return k == 0 ? Side(0, 2) : k == n - 1 ? Side(n - 3, 1) : Side(k - 1, 0); };
  for (int k = 0; k < n; ++k)
    for (int l = k + 1; l < n; ++l)
      if (std::abs(word[k]) == std::abs(word[l])) glue(side(k), side(l), word[k] == word[l]);
  return surface::Surface(mate, turned);
}

/// 1 2 -1 -2 3 4 -3 -4 ..., 4g letters.
inline std::vector<int> canonical_word(int genus) {
  std::vector<int> word;
  for (int k = 1; k < 2 * genus; k += 2)
    for (const int letter : {k, k + 1, -k, -k - 1}) word.push_back(letter);
  return word;
}

namespace detail {

/// A list of triangles that can be flipped and split, kept simplicial.
class Retriangulation {
public:
  explicit Retriangulation(TriangleList mesh) : mesh_(std::move(mesh)) {
    for (int t = 0; t < count(); ++t)
      for (int c = 0; c < 3; ++c) at_edge_[edge(t, c)].push_back(t);
  }
  const TriangleList& mesh() const { return mesh_; }

  void flip(int t, int c) {
    const auto both = at_edge_.at(edge(t, c));
    if (both.size() != 2) return;
    const int u = both[0] == t ? both[1] : both[0];
    const auto [a, b] = ends(t, c);
    const int p = mesh_.triangles[t][c];
    const int q = opposite(u, a, b);
    if (at_edge_.count(std::minmax(p, q)) > 0) return;
    replace(t, {a, q, p});
    replace(u, {q, b, p});
  }
  void split_edge(int t, int c) {
    const auto both = at_edge_.at(edge(t, c));
    const auto [a, b] = ends(t, c);
    const int m = add_vertex({a, b});
    for (const int u : both) {
      auto half = mesh_.triangles[u];
      std::replace(half.begin(), half.end(), a, m);
      auto rest = mesh_.triangles[u];
      std::replace(rest.begin(), rest.end(), b, m);
      replace(u, rest);
      add(half);
    }
  }
  void split_face(int t) {
    const auto [a, b, c] = mesh_.triangles[t];
    const int m = add_vertex({a, b, c});
    replace(t, {a, b, m});
    add({b, c, m});
    add({c, a, m});
  }

private:
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  std::pair<int, int> ends(int t, int c) const {
    return {mesh_.triangles[t][(c + 1) % 3], mesh_.triangles[t][(c + 2) % 3]};
  }
  std::pair<int, int> edge(int t, int c) const {
    const auto [a, b] = ends(t, c);
    return std::minmax(a, b);
  }
  int opposite(int t, int a, int b) const {
    for (const int v : mesh_.triangles[t])
      if (v != a && v != b) return v;
    return -1;
  }
  int add_vertex(const std::vector<int>& of) {
    if (!mesh_.points.empty()) {
      std::array<double, 3> mean{};
      for (const int v : of)
        for (int k = 0; k < 3; ++k) mean[k] += mesh_.points[v][k] / static_cast<double>(of.size());
      mesh_.points.push_back(mean);
    }
    return mesh_.vertices++;
  }
  void replace(int t, const surface::Surface::Triangle& corners) {
    for (int c = 0; c < 3; ++c) {
      const auto found = at_edge_.find(edge(t, c));
      auto& at = found->second;
      at.erase(std::find(at.begin(), at.end(), t));
      if (at.empty()) at_edge_.erase(found);
    }
    mesh_.triangles[t] = corners;
    for (int c = 0; c < 3; ++c) at_edge_[edge(t, c)].push_back(t);
  }
  void add(const surface::Surface::Triangle& corners) {
    mesh_.triangles.push_back(corners);
    for (int c = 0; c < 3; ++c) at_edge_[edge(count() - 1, c)].push_back(count() - 1);
  }

  TriangleList mesh_;
  std::map<std::pair<int, int>, std::vector<int>> at_edge_;
};

} // namespace detail

/// The same surface after so many splits of random edges and triangles, and so many random flips, less those
/// that would make it no simplicial complex. Random vertex names are kept; see `relabelled`.
inline TriangleList retriangulated(TriangleList mesh, Random& random, int flips, int splits) {
  detail::Retriangulation work(std::move(mesh));
  for (int left = flips + splits; left > 0; --left) {
    const int t = random.below(static_cast<int>(work.mesh().triangles.size()));
    const int c = random.below(3);
    if (random.below(left) < flips) {
      work.flip(t, c);
      --flips;
    } else if (random.below(2) == 0) {
      work.split_edge(t, c);
    } else {
      work.split_face(t);
    }
  }
  return work.mesh();
}

/// Triangles in another order, started at other corners; vertices renamed.
inline TriangleList relabelled(TriangleList mesh, Random& random) {
  std::vector<int> name(static_cast<std::size_t>(mesh.vertices));
  for (int v = 0; v < mesh.vertices; ++v) name[v] = v;
  random.shuffle(name);
  const auto points = mesh.points;
  for (int v = 0; v < static_cast<int>(points.size()); ++v) mesh.points[name[v]] = points[v];
  random.shuffle(mesh.triangles);
  for (auto& t : mesh.triangles) {
    for (int& v : t) v = name[v];
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
  }
  return mesh;
}

} // namespace tetrarch::support
