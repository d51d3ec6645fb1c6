// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Laws that hold for every triangulation, however strange, as functions.
///
/// Each returns the empty string where the law holds, otherwise a sentence that says what broke and where.
/// That is quicker than an assertion per step, and a law can be asked of 234,674 gluings in a second:
/// `for_each_small_gluing([&](const Triangulation& tri) { if (auto broken = laws::all_hold(tri);
/// !broken.empty()) FAIL(broken); })`.

#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tetrarch::support {

/// The gluings as text, for messages: "0: 1(0132) - - 0(1023); ...".
inline std::string gluing_text(const Triangulation& tri) {
  std::string text;
  for (int t = 0; t < tri.size(); ++t) {
    text += std::to_string(t) + ":";
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      text += g.tet < 0 ? " -" : " " + std::to_string(g.tet) + "(" + g.perm.str() + ")";
    }
    text += "; ";
  }
  return text;
}

/// What no change of triangulation may change and the core can tell: validity, orientability, number of
/// components, and the boundary components by kind and type, sorted.
inline std::string topology_text(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  std::vector<std::string> parts;
  for (const BoundaryComponent& b : boundary_components(tri, skeleton))
    parts.push_back((b.kind == BoundaryComponent::Kind::real ? "real " : "ideal ") + b.type.str());
  std::sort(parts.begin(), parts.end());
  std::string text = std::string(is_valid(skeleton) ? "valid, " : "invalid, ") +
                     (skeleton.is_orientable() ? "orientable, " : "non-orientable, ") +
                     std::to_string(skeleton.component_count()) + " component(s)";
  for (const std::string& part : parts) text += ", " + part;
  return text;
}

namespace laws {

inline std::string broken(const std::string& law, int tet, int local) {
  return law + ": broken at tetrahedron " + std::to_string(tet) + ", local number " + std::to_string(local);
}

/// A glued face sees its partner, and the partner sees it by the inverse map.
inline std::string gluings_are_mutual(const Triangulation& tri) {
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet < 0) continue;
      if (tri.gluing(tri.partner({t, f})) != Gluing{t, g.perm.inverse()} ||
          tri.partner({t, f}) == TetFace{t, f})
        return broken("gluings are mutual", t, f);
    }
  return {};
}

/// The pre-images of all classes together are all local simplices, each once, each in its own class; classes
/// are numbered by their first local simplex.
inline std::string preimages_partition(const Triangulation& tri, const Skeleton& s) {
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  for (const FaceId f : all<FaceId>(s.face_count())) {
    for (const TetFace at : s.preimages(f))
      if (s.face(at) != f) return broken("face pre-images lie in their class", at.tet, at.face);
    if (!s.is_boundary(f) && tri.partner(s.preimages(f)[0]) != s.preimages(f)[1])
      return "a face's sides are partners";
    faces += s.preimages(f).size();
  }
  for (const EdgeId e : all<EdgeId>(s.edge_count())) {
    for (const Walk& w : s.around(e))
      if (s.edge(w.edge()) != e) return broken("edge pre-images lie in their class", w.tet, w.edge().edge);
    edges += s.around(e).size();
  }
  for (const VertexId v : all<VertexId>(s.vertex_count())) {
    for (const TetVertex at : s.preimages(v))
      if (s.vertex(at) != v) return broken("vertex pre-images lie in their class", at.tet, at.vertex);
    vertices += s.preimages(v).size();
  }
  const auto n = static_cast<std::size_t>(tri.size());
  if (faces != 4 * n || edges != 6 * n || vertices != 4 * n)
    return "pre-images partition the local simplices";
  int face = 0;
  int edge = 0;
  int vertex = 0;
  const auto in_order = [](int id, int& next) { return id < next || id == next++; };
  for (int t = 0; t < tri.size(); ++t) {
    for (int k = 0; k < 4; ++k)
      if (!in_order(s.face({t, k}).value, face) || !in_order(s.vertex({t, k}).value, vertex))
        return broken("classes are numbered by their first local simplex", t, k);
    for (int k = 0; k < 6; ++k)
      if (!in_order(s.edge({t, k}).value, edge))
        return broken("edges are numbered by their first t-edge", t, k);
  }
  return {};
}

/// Stepping left and then right, or right and then left, changes nothing; a step fails only at the boundary
/// and then changes nothing either.
inline std::string steps_undo_each_other(const Triangulation& tri) {
  for (int t = 0; t < tri.size(); ++t)
    for (int rank = 0; rank < Perm4::count; ++rank) {
      const Walk start{t, Perm4::from_rank(rank)};
      Walk w = start;
      if (w.step_left(tri) == tri.is_boundary(start.left_face()))
        return broken("left steps stop at the boundary", t, rank);
      if (w != start && (!w.step_right(tri) || w != start))
        return broken("a right step undoes a left step", t, rank);
      w = start;
      if (w.step_right(tri) == tri.is_boundary(start.right_face()))
        return broken("right steps stop at the boundary", t, rank);
      if (w != start && (!w.step_left(tri) || w != start))
        return broken("a left step undoes a right step", t, rank);
    }
  return {};
}

/// `around(e)` goes by left steps, and round: a last left step from an inner edge leads back to the first
/// t-edge, with its ends exchanged exactly if the edge is reversed; a boundary edge has boundary faces at
/// both its ends.
inline std::string edges_are_walked_round(const Triangulation& tri, const Skeleton& s) {
  for (const EdgeId e : all<EdgeId>(s.edge_count())) {
    const auto walks = s.around(e);
    for (std::size_t k = 0; k + 1 < walks.size(); ++k) {
      Walk w = walks[k];
      if (!w.step_left(tri) || w != walks[k + 1])
        return broken("around goes by left steps", w.tet, w.edge().edge);
    }
    const Walk first = walks.front();
    Walk last = walks.back();
    if (tri.is_boundary(last.left_face()) != s.is_boundary(e) ||
        tri.is_boundary(first.right_face()) != s.is_boundary(e))
      return broken("a boundary edge starts and ends on the boundary", first.tet, first.edge().edge);
    if (s.is_boundary(e) && s.is_reversed(e))
      return broken("a boundary edge is not reversed", first.tet, first.edge().edge);
    if (s.is_boundary(e)) continue;
    last.step_left(tri);
    const Perm4 ends = s.is_reversed(e) ? Perm4::swap(0, 1) : Perm4();
    if (last != Walk{first.tet, first.hold * ends})
      return broken("around comes home", first.tet, first.edge().edge);
  }
  return {};
}

/// A class's direction is carried along by every gluing (unless the class is reversed), and its walks run
/// along it.
inline std::string directions_agree(const Triangulation& tri, const Skeleton& s) {
  for (int t = 0; t < tri.size(); ++t)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        if (a == b || s.is_reversed(s.edge({t, edge_number[a][b]}))) continue;
        const bool along = s.runs_along({t, a, b});
        if (along == s.runs_along({t, b, a}))
          return broken("one of two directions runs along", t, edge_number[a][b]);
        const auto [from, to] = s.ends(s.edge({t, edge_number[a][b]}));
        if (s.vertex({t, along ? a : b}) != from || s.vertex({t, along ? b : a}) != to)
          return broken("ends follow the direction", t, edge_number[a][b]);
        for (int f = 0; f < 4; ++f) {
          const Gluing g = tri.gluing({t, f});
          if (f == a || f == b || g.tet < 0) continue;
          if (s.runs_along({g.tet, g.perm[a], g.perm[b]}) != along)
            return broken("gluings carry directions", t, edge_number[a][b]);
        }
      }
  for (const EdgeId e : all<EdgeId>(s.edge_count()))
    for (const Walk& w : s.around(e))
      if (!s.is_reversed(e) && !s.runs_along({w.tet, w.from(), w.to()}))
        return broken("walks run along", w.tet, w.edge().edge);
  return {};
}

/// Two routes to a vertex link agree: the count of its cells, and the surface built and classified.
inline std::string links_agree(const Triangulation& tri, const Skeleton& s) {
  for (const VertexId v : all<VertexId>(s.vertex_count())) {
    const SurfaceComponents built = classify(vertex_link(tri, s, v));
    const TetVertex at = s.preimages(v).front();
    if (built.type.size() != 1) return broken("a link is connected", at.tet, at.vertex);
    if (built.type.front() != s.link(v))
      return broken("link by counting is the link built", at.tet, at.vertex);
  }
  return {};
}

/// The sum of the links' Euler characteristics is 2E - R - 3F + 4T, where R edges are reversed. (An edge has
/// two ends, a reversed one has one; a face has three corners.) Closed and none reversed: 2(E - T).
inline std::string links_add_up(const Triangulation& tri, const Skeleton& s) {
  int sum = 0;
  int reversed = 0;
  for (const VertexId v : all<VertexId>(s.vertex_count())) sum += s.link(v).euler;
  for (const EdgeId e : all<EdgeId>(s.edge_count())) reversed += s.is_reversed(e);
  if (sum != 2 * s.edge_count() - reversed - 3 * s.face_count() + 4 * tri.size())
    return "links add up to 2E-R-3F+4T";
  if (!s.has_boundary_faces() && reversed == 0 && sum != 2 * (s.edge_count() - tri.size()))
    return "closed: links add up to 2(E-T)";
  return {};
}

/// Signs of an orientation fit all gluings, and the first tetrahedron of every component has +1.
inline std::string orientation_fits(const Triangulation& tri, const Skeleton& s) {
  const auto sign = orientation(tri);
  if (sign.has_value() != s.is_orientable()) return "skeleton and orientation agree";
  if (!sign) return {};
  const Components parts = components(tri);
  std::vector<char> seen(static_cast<std::size_t>(parts.count), 0);
  for (int t = 0; t < tri.size(); ++t) {
    if (!seen[parts.of[t]] && (*sign)[t] != 1) return broken("the first tetrahedron has sign +1", t, 0);
    seen[parts.of[t]] = 1;
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet >= 0 && (*sign)[g.tet] != -g.perm.sign() * (*sign)[t])
        return broken("orientation fits", t, f);
    }
  }
  return {};
}

/// Every boundary face lies in one real component; of a valid triangulation, the Euler characteristics of all
/// boundary components are twice that of the manifold (V - E + F - T with a section in place of each ideal
/// vertex).
inline std::string boundary_adds_up(const Triangulation& tri, const Skeleton& s) {
  std::vector<TetFace> faces;
  int euler = 0;
  int ideal = 0;
  for (const BoundaryComponent& b : boundary_components(tri, s)) {
    faces.insert(faces.end(), b.faces.begin(), b.faces.end());
    euler += b.type.euler;
    ideal += b.kind == BoundaryComponent::Kind::ideal;
  }
  std::sort(faces.begin(), faces.end());
  std::size_t next = 0;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (tri.is_boundary({t, f}) && (next == faces.size() || faces[next++] != TetFace{t, f}))
        return broken("every boundary face lies in one component", t, f);
  if (next != faces.size()) return "components hold boundary faces only";
  if (!is_valid(s)) return {};
  int cells = s.vertex_count() - ideal - s.edge_count() + s.face_count() - tri.size();
  for (const VertexId v : all<VertexId>(s.vertex_count()))
    if (s.is_ideal(v)) cells += s.link(v).euler; // the section put in the vertex's place
  if (euler != 2 * cells) return "chi(boundary) is twice chi of the manifold";
  return {};
}

/// All laws above.
inline std::string all_hold(const Triangulation& tri) {
  const Skeleton s(tri);
  for (const std::string& broken_law :
       {gluings_are_mutual(tri), preimages_partition(tri, s), steps_undo_each_other(tri),
        edges_are_walked_round(tri, s), directions_agree(tri, s), links_agree(tri, s), links_add_up(tri, s),
        orientation_fits(tri, s), boundary_adds_up(tri, s)})
    if (!broken_law.empty()) return broken_law + " in " + gluing_text(tri);
  return {};
}

} // namespace laws
} // namespace tetrarch::support
