// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Random gluings and relabellings from a seed, and cubical balls and 3-tori of any size.
///
/// The same seed gives the same triangulation everywhere.

#include "support/enumeration.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/random.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tetrarch::support {

class Random : public SplitMix64 {
public:
  using SplitMix64::SplitMix64;

  Perm4 perm() { return Perm4::from_rank(below(Perm4::count)); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (int k = static_cast<int>(items.size()) - 1; k > 0; --k) std::swap(items[k], items[below(k + 1)]);
  }
};

struct RandomGluing {
  int tets = 1;
  /// So many faces stay on the boundary; one more if the parity asks for it.
  int boundary_faces = 0;
  /// Only odd maps, so that all tetrahedra are positively handed.
  bool orientable = false;
  /// A random tree of tetrahedra is glued first. Needs boundary_faces <= 2 * tets + 2.
  bool connected = true;
};

namespace detail {

inline void glue_at_random(Triangulation& tri, TetFace f, TetFace g, bool orientable, Random& random) {
  const auto maps = face_maps(f.face, g.face);
  Perm4 p = maps[random.below(6)];
  while (orientable && p.sign() > 0) p = maps[random.below(6)];
  tri.glue(f, g.tet, p);
}

inline TetFace take_out(std::vector<TetFace>& faces, int k) {
  const TetFace f = faces[k];
  faces[k] = faces.back();
  faces.pop_back();
  return f;
}

} // namespace detail

/// Glues faces at random as asked for. O(n).
inline Triangulation random_gluing(const RandomGluing& wanted, Random& random) {
  Triangulation tri(wanted.tets);
  std::vector<TetFace> free;
  for (int t = 0; t < wanted.tets; ++t) {
    std::vector<TetFace> own{{t, 0}, {t, 1}, {t, 2}, {t, 3}};
    if (wanted.connected && t > 0) {
      const TetFace f = detail::take_out(free, random.below(static_cast<int>(free.size())));
      detail::glue_at_random(tri, f, detail::take_out(own, random.below(4)), wanted.orientable, random);
    }
    free.insert(free.end(), own.begin(), own.end());
  }
  while (static_cast<int>(free.size()) >= wanted.boundary_faces + 2) {
    const TetFace f = detail::take_out(free, random.below(static_cast<int>(free.size())));
    const TetFace g = detail::take_out(free, random.below(static_cast<int>(free.size())));
    detail::glue_at_random(tri, f, g, wanted.orientable, random);
  }
  return tri;
}

/// A random renaming of n tetrahedra and of the vertices of each.
inline Isomorphism random_relabelling(int tets, Random& random) {
  Isomorphism iso{std::vector<int>(static_cast<std::size_t>(tets)), {}};
  std::iota(iso.tet.begin(), iso.tet.end(), 0);
  random.shuffle(iso.tet);
  for (int t = 0; t < tets; ++t) iso.perm.push_back(random.perm());
  return iso;
}

namespace detail {

/// The six orders of the three axes. A cube is split along its diagonal: tetrahedron k of it runs from corner
/// 000 to corner 111 along axis axis_order[k][0], then [1], then [2]; its vertices 0..3 are the corners on
/// that way.
inline constexpr std::array<std::array<int, 3>, 6> axis_order{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

inline int order_index(int a, int b) {
  for (int k = 0; k < 6; ++k)
    if (axis_order[k][0] == a && axis_order[k][1] == b) return k;
  return -1;
}

/// The cubes of a grid, six tetrahedra each; opposite sides of the grid are glued if `wrap`. `first_tet(at)`
/// is the first tetrahedron of the cube at those three coordinates, negative where there is no cube.
template <class FirstTet>
Triangulation cubes(const std::array<int, 3>& size, bool wrap, int count, FirstTet first_tet) {
  Triangulation tri(6 * count);
  std::array<int, 3> at{};
  for (at[0] = 0; at[0] < size[0]; ++at[0])
    for (at[1] = 0; at[1] < size[1]; ++at[1])
      for (at[2] = 0; at[2] < size[2]; ++at[2])
        for (int k = 0; k < 6 && first_tet(at) >= 0; ++k) {
          const auto [a, b, c] = axis_order[k];
          const int t = first_tet(at) + k;
          // Inside the cube: exchanging two neighbouring steps keeps the three other corners of the way.
          const int first_exchanged = first_tet(at) + order_index(b, a);
          const int last_exchanged = first_tet(at) + order_index(a, c);
          if (tri.is_boundary({t, 1})) tri.glue({t, 1}, first_exchanged, Perm4());
          if (tri.is_boundary({t, 2})) tri.glue({t, 2}, last_exchanged, Perm4());
          // Out of the cube along axis a: the next cube's way that makes this step last has corners 0,1,2
          // there.
          std::array<int, 3> next = at;
          if (++next[a] == size[a]) next[a] = 0;
          if ((!wrap && next[a] == 0) || first_tet(next) < 0) continue;
          tri.glue({t, 0}, first_tet(next) + order_index(b, c), Perm4(3, 0, 1, 2));
        }
  return tri;
}

inline Triangulation all_cubes(const std::array<int, 3>& size, bool wrap) {
  return cubes(size, wrap, size[0] * size[1] * size[2], [&](const std::array<int, 3>& at) {
    return 6 * ((at[0] * size[1] + at[1]) * size[2] + at[2]);
  });
}

} // namespace detail

/// A ball of x*y*z cubes, each split into six tetrahedra around its diagonal: 6xyz tetrahedra,
/// (x+1)(y+1)(z+1) vertices.
inline Triangulation cubical_ball(int x, int y, int z) {
  return detail::all_cubes({x, y, z}, false);
}

/// The 3-torus of x*y*z cubes: 6xyz tetrahedra, xyz vertices, 7xyz edges. Its symmetries are transitive on
/// cubes.
inline Triangulation cubical_torus(int x, int y, int z) {
  return detail::all_cubes({x, y, z}, true);
}

} // namespace tetrarch::support
