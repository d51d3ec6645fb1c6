// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Random tetrahedra of every mixture of vertex types, and cyclic covers of gluings.

#include "support/random.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/hyperbolic/tetrahedron.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::hyperbolic::samples {

using support::Random;

/// Uniform in [low, high).
inline double between(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

/// All 3^4 assignments of types to the four vertices.
inline std::vector<VertexTypes> all_mixtures() {
  std::vector<VertexTypes> mixtures;
  for (int code = 0; code < 81; ++code) {
    int rest = code;
    VertexTypes types{};
    for (VertexType& type : types) {
      type = static_cast<VertexType>(rest % 3);
      rest /= 3;
    }
    mixtures.push_back(types);
  }
  return mixtures;
}

inline bool has_finite(const VertexTypes& types) {
  for (const VertexType type : types)
    if (type == VertexType::finite) return true;
  return false;
}

inline std::string name(const VertexTypes& types) {
  std::string text;
  for (const VertexType type : types) text += std::string(text.empty() ? "" : ", ") + to_string(type);
  return text;
}

/// Lengths in a range where many tetrahedra exist.
inline SixNumbers<double> some_lengths(const VertexTypes& types, Random& random) {
  SixNumbers<double> lengths{};
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const bool ideal = types[i] == VertexType::ideal || types[j] == VertexType::ideal;
    lengths[e] = ideal ? between(random, -0.7, 1.2) : between(random, 0.3, 2);
  }
  return lengths;
}

/// Lengths of a tetrahedron that exists with room to spare: small changes of the lengths leave it alive.
inline SixNumbers<double> existing_lengths(const VertexTypes& types, Random& random) {
  for (;;) {
    const SixNumbers<double> lengths = some_lengths(types, random);
    const auto angles = dihedral_angles(lengths, types);
    if (!angles) continue;
    bool roomy = true;
    for (const double theta : *angles) roomy = roomy && theta > 0.05 && theta < 3.09;
    if (roomy) return lengths;
  }
}

/// The cyclic cover of degree n whose sheets shift by shift[f] across face class f (in the direction of its
/// first pre-image). Tetrahedron t on sheet i is number t + i * tri.size().
inline Triangulation cyclic_cover(const Triangulation& tri, const Skeleton& skeleton,
                                  const std::vector<int>& shift, int n) {
  Triangulation cover(n * tri.size());
  for (int f = 0; f < skeleton.face_count(); ++f) {
    const TetFace from = skeleton.preimages(FaceId(f))[0];
    const Gluing g = tri.gluing(from);
    for (int i = 0; i < n; ++i)
      cover.glue({from.tet + i * tri.size(), from.face}, g.tet + (i + shift[f] + n) % n * tri.size(), g.perm);
  }
  return cover;
}

/// The first cover, over shifts -1, 0, 1, that is connected and unbranched (n times as many edges).
inline std::optional<Triangulation> some_cyclic_cover(const Triangulation& tri, int n) {
  const Skeleton skeleton(tri);
  int codes = 1;
  for (int f = 0; f < skeleton.face_count(); ++f) codes *= 3;
  for (int code = 0; code < codes; ++code) {
    std::vector<int> shift;
    for (int f = 0, rest = code; f < skeleton.face_count(); ++f, rest /= 3) shift.push_back(rest % 3 - 1);
    Triangulation cover = cyclic_cover(tri, skeleton, shift, n);
    const Skeleton covering(cover);
    if (covering.is_connected() && covering.edge_count() == n * skeleton.edge_count()) return cover;
  }
  return std::nullopt;
}

} // namespace tetrarch::hyperbolic::samples
