// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The identification functions again, by a second route that shares nothing with `Skeleton`.
///
/// No walking and no flooding: every gluing identifies directed edges, vertices, and the two turning senses
/// of the corners' small triangles; union-find over all of them gives the classes. An edge is reversed if ab
/// and ba fall into one class, a link is non-orientable if a triangle's two senses do.

#include "tetrarch/core/check.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <numeric>
#include <vector>

namespace tetrarch::naive {

class UnionFind {
public:
  explicit UnionFind(int size) : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void unite(int x, int y) { parent_[find(x)] = find(y); }
  bool same(int x, int y) { return find(x) == find(y); }

private:
  std::vector<int> parent_;
};

/// How many different numbers below a bound were added.
class Tally {
public:
  explicit Tally(int bound) : seen_(static_cast<std::size_t>(bound), 0) {}
  void add(int x) {
    count_ += seen_[x] == 0;
    seen_[x] = 1;
  }
  int count() const { return count_; }

private:
  std::vector<char> seen_;
  int count_ = 0;
};

/// Whether two ways to put things into classes are the same up to the classes' names: tell it both names of
/// each thing.
class SamePartition {
public:
  explicit SamePartition(int bound) : right_(static_cast<std::size_t>(bound), -1), left_(right_) {}
  bool agrees(int left, int right) {
    if (right_[left] < 0 && left_[right] < 0) {
      right_[left] = right;
      left_[right] = left;
    }
    return right_[left] == right && left_[right] == left;
  }

private:
  std::vector<int> right_;
  std::vector<int> left_;
};

inline int directed(int t, int a, int b) {
  return 16 * t + 4 * a + b;
}

struct Classes {
  UnionFind edge;   ///< over directed(t, a, b)
  UnionFind vertex; ///< over 4t + v
  UnionFind sense;  ///< over 2(4t + v) + (0 or 1): a link triangle with one of its turning senses
  UnionFind hand;   ///< over 2t + (0 or 1): a tetrahedron with one of its orientations
  UnionFind curve;  ///< edge, and both ends of every boundary side of a link triangle

  explicit Classes(const Triangulation& tri)
      : edge(16 * tri.size()), vertex(4 * tri.size()), sense(8 * tri.size()), hand(2 * tri.size()), curve(0) {
    for (int t = 0; t < tri.size(); ++t)
      for (int f = 0; f < 4; ++f) identify(tri.gluing({t, f}), t, f);
    curve = edge;
    for (int t = 0; t < tri.size(); ++t)
      for (int f = 0; f < 4; ++f)
        for (int v = 0; v < 4; ++v) {
          if (!tri.is_boundary({t, f}) || v == f) continue;
          const int c = face_corner(f, v);
          curve.unite(directed(t, v, face_vertex[f][(c + 1) % 3]),
                      directed(t, v, face_vertex[f][(c + 2) % 3]));
        }
  }
  bool is_reversed(int t, int a, int b) { return edge.same(directed(t, a, b), directed(t, b, a)); }

private:
  void identify(const Gluing& g, int t, int f) {
    if (g.tet < 0) return;
    const int turn = g.perm.sign() < 0 ? 0 : 1;
    for (int s = 0; s < 2; ++s) hand.unite(2 * t + s, 2 * g.tet + (s ^ turn));
    for (int a = 0; a < 4; ++a) {
      if (a == f) continue;
      vertex.unite(4 * t + a, 4 * g.tet + g.perm[a]);
      for (int s = 0; s < 2; ++s) sense.unite(2 * (4 * t + a) + s, 2 * (4 * g.tet + g.perm[a]) + (s ^ turn));
      for (int b = 0; b < 4; ++b)
        if (b != a && b != f) edge.unite(directed(t, a, b), directed(g.tet, g.perm[a], g.perm[b]));
    }
  }
};

/// The link of the vertex class of 4t + v == root: cells counted class by class.
inline SurfaceType link_type(const Triangulation& tri, Classes& classes, int root) {
  Tally corners(16 * tri.size());
  Tally curves(16 * tri.size());
  int triangles = 0;
  int boundary_sides = 0;
  bool orientable = true;
  for (int t = 0; t < tri.size(); ++t)
    for (int v = 0; v < 4; ++v) {
      if (!classes.vertex.same(4 * t + v, root)) continue;
      ++triangles;
      orientable = orientable && !classes.sense.same(2 * (4 * t + v), 2 * (4 * t + v) + 1);
      for (int w = 0; w < 4; ++w) {
        if (w == v) continue;
        corners.add(classes.edge.find(directed(t, v, w)));
        if (!tri.is_boundary({t, w})) continue; // the link triangle's side in face w
        ++boundary_sides;
        curves.add(classes.curve.find(directed(t, v, face_vertex[w][face_corner(w, v) == 0 ? 1 : 0])));
      }
    }
  const int sides = (3 * triangles + boundary_sides) / 2;
  return {corners.count() - sides + triangles, curves.count(), orientable};
}

/// The types of the real boundary components, in the order of their first boundary face.
inline std::vector<SurfaceType> real_boundary(const Triangulation& tri, Classes& classes) {
  UnionFind faces(4 * tri.size());
  UnionFind corners(16 * tri.size()); // face 4t + f at its vertex v: 16t + 4f + v
  UnionFind sides(8 * tri.size());    // a face with one of its orientations
  const auto on_boundary = [&](int k) { return tri.is_boundary({k / 4, k % 4}); };
  for (int p = 0; p < 4 * tri.size(); ++p)
    for (int q = 0; q <= p && on_boundary(p); ++q)
      for (int i = 0; i < 9 && on_boundary(q); ++i) {
        const auto& v = face_vertex[p % 4];
        const auto& w = face_vertex[q % 4];
        const int side = i / 3;
        const int other = i % 3;
        if (p == q && side <= other) continue; // one side does not meet itself
        for (int flip = 0; flip < 2; ++flip) {
          const int a = v[(side + 1) % 3];
          const int b = v[(side + 2) % 3];
          const int c = w[(other + 1 + flip) % 3];
          const int d = w[(other + 2 - flip) % 3];
          if (!classes.edge.same(directed(p / 4, a, b), directed(q / 4, c, d))) continue;
          faces.unite(p, q);
          corners.unite(4 * p + a, 4 * q + c);
          corners.unite(4 * p + b, 4 * q + d);
          // Both run along the shared edge in their cyclic order (no flip): their orientations disagree.
          for (int s = 0; s < 2; ++s) sides.unite(2 * p + s, 2 * q + (s ^ (flip == 0 ? 1 : 0)));
        }
      }
  std::vector<SurfaceType> types;
  for (int first = 0; first < 4 * tri.size(); ++first) {
    if (!on_boundary(first)) continue;
    Tally vertices(16 * tri.size());
    int count = 0;
    bool is_first = true;
    bool orientable = true;
    for (int p = 0; p < 4 * tri.size() && is_first; ++p) {
      if (!on_boundary(p) || !faces.same(p, first)) continue;
      is_first = p >= first;
      ++count;
      orientable = orientable && !sides.same(2 * p, 2 * p + 1);
      for (const int v : face_vertex[p % 4]) vertices.add(corners.find(4 * p + v));
    }
    if (is_first) types.push_back({vertices.count() - count / 2, 0, orientable});
  }
  return types;
}

} // namespace tetrarch::naive
