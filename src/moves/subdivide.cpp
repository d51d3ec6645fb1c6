// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/subdivide.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <array>
#include <string>

namespace tetrarch::moves {
namespace {

Subdivision with_pieces(std::vector<int> origin) {
  return {Triangulation(static_cast<int>(origin.size())), std::move(origin)};
}

/// Every gluing is met from both sides.
void glue_once(Triangulation& tri, TetFace f, int other, Perm4 p) {
  if (tri.is_boundary(f)) tri.glue(f, other, p);
}

/// 1-4 of the tetrahedra that are marked.
Subdivision subdivided(const Triangulation& tri, const std::vector<bool>& marked) {
  std::vector<int> origin;
  std::vector<int> first;
  for (int t = 0; t < tri.size(); ++t) {
    first.push_back(static_cast<int>(origin.size()));
    origin.insert(origin.end(), marked[t] ? 4 : 1, t);
  }
  Subdivision out = with_pieces(std::move(origin));
  const auto piece = [&](TetFace f) { return first[f.tet] + (marked[f.tet] ? f.face : 0); };
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const TetFace face{t, f};
      if (!tri.is_boundary(face))
        glue_once(out.tri, {piece(face), f}, piece(tri.partner(face)), tri.gluing(face).perm);
      for (int w = 0; marked[t] && w < f; ++w)
        out.tri.glue({piece(face), w}, piece({t, w}), Perm4::swap(f, w));
    }
  return out;
}

/// The pieces of the truncated tetrahedra by name. A piece's vertices are called after vertices of its
/// tetrahedron:
///
///     side (f, d)     a: ab, b: ba, d: centre of face f, f: centre of all
///     corner (f, a)   b: ab, d: ad, a: centre of face f, f: centre of all
///     cut (a)         b: ab, d: ad, f: af, a: centre of all
///
/// so that names follow every gluing, and pieces of one tetrahedron meet by exchanging names.
class FiniteModel {
public:
  FiniteModel(const Triangulation& tri, Cut cut) : tri_(tri) {
    const Skeleton skeleton(tri);
    std::vector<int> origin;
    for (int t = 0; t < tri.size(); ++t) {
      Pieces& at = pieces_.emplace_back();
      for (int v = 0; v < 4; ++v) {
        const VertexId vertex = skeleton.vertex({t, v});
        at.truncated[v] =
            cut == Cut::interior_vertices ? skeleton.link(vertex).is_closed() : skeleton.is_ideal(vertex);
      }
      const auto next = [&origin, t] {
        origin.push_back(t);
        return static_cast<int>(origin.size()) - 1;
      };
      for (const auto& [f, v] : face_corners()) at.side[f][v] = next();
      for (const auto& [f, v] : face_corners())
        if (at.truncated[v]) at.corner[f][v] = next();
      for (int a = 0; a < 4; ++a)
        if (at.truncated[a]) at.cut[a] = next();
    }
    out_ = with_pieces(std::move(origin));
  }

  Subdivision run() {
    for (int t = 0; t < tri_.size(); ++t)
      for (const auto& [f, v] : face_corners()) {
        glue_side(t, f, v);
        if (pieces_[t].truncated[v]) glue_corner(t, f, v);
      }
    return std::move(out_);
  }

private:
  struct Pieces {
    std::array<bool, 4> truncated{};
    std::array<std::array<int, 4>, 4> side{};   ///< [face][the vertex of the face off the side]
    std::array<std::array<int, 4>, 4> corner{}; ///< [face][the vertex cut off]
    std::array<int, 4> cut{};
  };

  /// All (face, vertex of it).
  static const std::array<std::array<int, 2>, 12>& face_corners() {
    static const std::array<std::array<int, 2>, 12> all{
        {{0, 1}, {0, 2}, {0, 3}, {1, 0}, {1, 2}, {1, 3}, {2, 0}, {2, 1}, {2, 3}, {3, 0}, {3, 1}, {3, 2}}};
    return all;
  }

  void glue_side(int t, int f, int d) {
    const Pieces& here = pieces_[t];
    const int side = here.side[f][d];
    const Gluing across = tri_.gluing({t, f});
    if (across.tet >= 0)
      glue_once(out_.tri, {side, f}, pieces_[across.tet].side[across.perm[f]][across.perm[d]], across.perm);
    // Over the tetrahedron's edge lies a side of the next face.
    glue_once(out_.tri, {side, d}, here.side[d][f], Perm4::swap(d, f));
    for (const int a : face_vertex[f]) {
      if (a == d) continue;
      const int b = 6 - f - d - a;
      // Past a there is the corner piece: ab, which is called a here and b there, the centre of the face,
      // called d here and a there. Or, where a is whole, the next side of the face.
      if (here.truncated[a])
        glue_once(out_.tri, {side, b}, here.corner[f][a], Perm4::swap(a, b) * Perm4::swap(b, d));
      else
        glue_once(out_.tri, {side, b}, here.side[f][b], Perm4::swap(b, d));
    }
  }

  /// Its two sides are glued by `glue_side`.
  void glue_corner(int t, int f, int a) {
    const Pieces& here = pieces_[t];
    const int corner = here.corner[f][a];
    const Gluing across = tri_.gluing({t, f});
    if (across.tet >= 0)
      glue_once(out_.tri, {corner, f}, pieces_[across.tet].corner[across.perm[f]][across.perm[a]],
                across.perm);
    out_.tri.glue({corner, a}, here.cut[a], Perm4::swap(a, f));
  }

  const Triangulation& tri_;
  std::vector<Pieces> pieces_;
  Subdivision out_;
};

} // namespace

Subdivision subdivided_1_4(const Triangulation& tri) {
  return subdivided(tri, std::vector<bool>(static_cast<std::size_t>(tri.size()), true));
}

Subdivision subdivided_1_4(const Triangulation& tri, const std::vector<int>& tets) {
  std::vector<bool> marked(static_cast<std::size_t>(tri.size()), false);
  for (const int t : tets) {
    if (t < 0 || t >= tri.size()) throw PreconditionError("there is no tetrahedron " + std::to_string(t));
    if (marked[t]) throw PreconditionError("tetrahedron " + std::to_string(t) + " is listed twice");
    marked[t] = true;
  }
  return subdivided(tri, marked);
}

Subdivision barycentric(const Triangulation& tri) {
  std::vector<int> origin;
  for (int t = 0; t < tri.size(); ++t) origin.insert(origin.end(), Perm4::count, t);
  Subdivision out = with_pieces(std::move(origin));
  const auto piece = [](int t, Perm4 p) { return Perm4::count * t + p.rank(); };
  for (int t = 0; t < tri.size(); ++t)
    for (int rank = 0; rank < Perm4::count; ++rank) {
      const Perm4 p = Perm4::from_rank(rank);
      // Two flags that differ in their k-dimensional part share all corners but the k-th.
      for (int k = 0; k < 3; ++k)
        glue_once(out.tri, {piece(t, p), k}, piece(t, p * Perm4::swap(k, k + 1)), Perm4());
      const Gluing g = tri.gluing({t, p[3]});
      if (g.tet >= 0) glue_once(out.tri, {piece(t, p), 3}, piece(g.tet, g.perm * p), Perm4());
    }
  return out;
}

Subdivision finite_model(const Triangulation& tri, Cut cut) {
  return FiniteModel(tri, cut).run();
}

} // namespace tetrarch::moves
