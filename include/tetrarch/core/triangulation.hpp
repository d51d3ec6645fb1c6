// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Tetrahedra and the gluings of their faces: the only stored truth about a 3-manifold.
///
/// A face is glued to at most one other face; a glued pair stores, from either side, the other tetrahedron
/// and a permutation: `gluing(f)` takes the vertices of f's tetrahedron to those of the neighbor, and f.face
/// to the face it meets. Nothing else is stored; classes of edges and vertices are read off by `Skeleton`.
/// Laws: `glue(f, t, p)` implies that the image face is glued to f by `p.inverse()`; unglue undoes glue.
/// Source: Yin, section 4.2.1 (the tetrahedron-oriented structure).

#include "tetrarch/core/tet.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetrarch {

/// What a face sees across itself: the other tetrahedron (-1: nothing, the face is on the boundary) and the
/// map.
struct Gluing {
  int tet = -1;
  Perm4 perm;
  friend constexpr bool operator==(Gluing, Gluing) = default;
};

/// Tetrahedra and the gluings of their faces.
class Triangulation {
public:
  /// `tets` tetrahedra, nothing glued.
  explicit Triangulation(int tets = 0);

  int size() const { return static_cast<int>(tets_.size()); }
  /// Adds `count` unglued tetrahedra; returns the index of the first.
  int add_tetrahedra(int count = 1);

  /// Glues f to face p[f.face] of tetrahedron `other`, vertex v to p[v].
  /// Throws PreconditionError if either face is glued already, out of range, or if f would be glued to
  /// itself. O(1).
  void glue(TetFace f, int other, Perm4 p);
  /// Makes f and its partner boundary faces; nothing happens to a boundary face. O(1).
  void unglue(TetFace f);

  bool is_boundary(TetFace f) const { return gluing(f).tet < 0; }
  Gluing gluing(TetFace f) const { return tets_[static_cast<std::size_t>(f.tet)][f.face]; }
  /// The t-face that f is glued to; f must not be a boundary face.
  TetFace partner(TetFace f) const {
    const Gluing g = gluing(f);
    return {g.tet, g.perm[f.face]};
  }
  /// Changes with every edit and is shared by copies: two triangulations of equal revision have equal
  /// gluings.
  std::uint64_t revision() const { return revision_; }

  /// The same labeled gluings; for "the same up to relabeling" see isomorphism.hpp.
  friend bool operator==(const Triangulation& a, const Triangulation& b) { return a.tets_ == b.tets_; }

private:
  void require_valid(TetFace f) const;

  std::vector<std::array<Gluing, 4>> tets_;
  std::uint64_t revision_;
};

/// Connected components: `component[t]` numbered by first tetrahedron. O(n).
struct Components {
  int count = 0;
  std::vector<int> of;
};
Components components(const Triangulation& tri);
/// The triangulation made of the tetrahedra of component c, in their old order. O(n).
Triangulation component(const Triangulation& tri, const Components& parts, int c);
/// All components; the c-th is `component(tri, parts, c)`. O(n) in all.
std::vector<Triangulation> split(const Triangulation& tri, const Components& parts);

/// +1 or -1 per tetrahedron such that every gluing between equally handed tetrahedra is odd and every other
/// one even; the first tetrahedron of each component gets +1. Nothing if some component is not orientable.
/// O(n).
std::optional<std::vector<int>> orientation(const Triangulation& tri);

/// `tri` with tetrahedron t renamed image[t] and its vertex v renamed perm[t][v].
Triangulation relabelled(const Triangulation& tri, const std::vector<int>& image,
                         const std::vector<Perm4>& perm);

} // namespace tetrarch
