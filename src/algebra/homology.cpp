// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/homology.hpp"

#include "dual_tree.hpp"
#include "signed_graph.hpp"

#include "tetrarch/algebra/smith.hpp"
#include "tetrarch/core/error.hpp"

#include <cstdint>
#include <numeric>
#include <string>

namespace tetrarch::algebra {
namespace {

/// The part of one interior face in the map between faces and edges. Both complexes have the same incidences,
/// the dual map being the transpose of the primal one up to signs.
struct FaceRow {
  std::array<int, 3> edge{-1, -1, -1};
  std::array<std::int8_t, 3> coefficient{};

  void add(EdgeId e, int sign) {
    int slot = 0;
    while (edge[slot] >= 0 && edge[slot] != e.value) ++slot;
    edge[slot] = e.value;
    coefficient[slot] = static_cast<std::int8_t>(coefficient[slot] + sign);
  }
};
using FaceRows = Table<FaceId, FaceRow>;

bool is_finite_interior(const Skeleton& skeleton, VertexId v) {
  return skeleton.link(v).is_sphere();
}

/// The boundary of the dual disk of an edge: the arcs through the faces around it. An arc runs from the first
/// t-face of its face to the second.
FaceRows dual_disk_boundaries(const Skeleton& skeleton) {
  FaceRows rows(skeleton.face_count());
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_boundary(e)) continue;
    for (const Walk& w : skeleton.around(e)) {
      const FaceId f = skeleton.face(w.left_face());
      rows[f].add(e, skeleton.preimages(f)[0] == w.left_face() ? 1 : -1);
    }
  }
  return rows;
}

/// The boundary of a triangle, read in its first t-face with the t-vertices in increasing order.
FaceRows triangle_boundaries(const Skeleton& skeleton) {
  FaceRows rows(skeleton.face_count());
  for (const FaceId f : all<FaceId>(skeleton.face_count())) {
    if (skeleton.is_boundary(f)) continue;
    const TetFace side = skeleton.preimages(f)[0];
    const auto& v = face_vertex[side.face];
    for (int c = 0; c < 3; ++c) {
      const DirectedTetEdge along{side.tet, v[c], v[(c + 1) % 3]};
      const EdgeId e = skeleton.edge({side.tet, edge_number[along.from][along.to]});
      if (!skeleton.is_boundary(e)) rows[f].add(e, skeleton.runs_along(along) ? 1 : -1);
    }
  }
  return rows;
}

/// Removes faces whose generator dies: those of the dual forest, and then, as long as there is one, the only
/// face left at some edge, if its coefficient there is a unit. Each step splits a contractible pair of cells
/// off, or in matrix terms takes a unit pivot without fill. Returns the number of pivots; `alive` says which
/// faces are left. The last face of an edge is found by keeping the exclusive or of all its faces.
struct Coreduction {
  int pivots = 0;
  std::vector<char> alive; ///< per face

  Coreduction(const FaceRows& rows, const Table<FaceId, char>& forest, int edges);

private:
  void remove(const FaceRow& row, int face);
  std::vector<int> count_;
  std::vector<int> mixture_;
  std::vector<int> ready_;
};

Coreduction::Coreduction(const FaceRows& rows, const Table<FaceId, char>& forest, int edges)
    : alive(static_cast<std::size_t>(rows.size()), 1), count_(static_cast<std::size_t>(edges), 0),
      mixture_(static_cast<std::size_t>(edges), 0) {
  for (int f = 0; f < rows.size(); ++f) {
    const FaceRow& row = rows[FaceId(f)];
    for (int c = 0; c < 3; ++c) {
      if (row.coefficient[c] == 0) continue;
      ++count_[row.edge[c]];
      mixture_[row.edge[c]] ^= f;
    }
  }
  for (int e = 0; e < edges; ++e)
    if (count_[e] == 1) ready_.push_back(e);
  for (int f = 0; f < rows.size(); ++f)
    if (forest[FaceId(f)]) remove(rows[FaceId(f)], f);
  while (!ready_.empty()) {
    const int e = ready_.back();
    ready_.pop_back();
    if (count_[e] != 1) continue;
    const int f = mixture_[e];
    const FaceRow& row = rows[FaceId(f)];
    int slot = 0;
    while (row.edge[slot] != e) ++slot;
    if (row.coefficient[slot] != 1 && row.coefficient[slot] != -1) continue;
    ++pivots;
    remove(row, f);
  }
}

void Coreduction::remove(const FaceRow& row, int face) {
  alive[face] = 0;
  for (int c = 0; c < 3; ++c) {
    if (row.coefficient[c] == 0) continue;
    const int e = row.edge[c];
    mixture_[e] ^= face;
    if (--count_[e] == 1) ready_.push_back(e);
  }
}

/// The Smith form of the map between faces and edges. The faces of the dual forest may be left out: what the
/// other faces' rows say determines theirs (the neighbouring map composes with this one to zero, and on the
/// forest it is invertible), in the absolute complex as a choice of basis of the cycles, in the relative one
/// because those triangles' boundaries are sums of the others.
SmithForm face_edge_form(const Triangulation& tri, const Skeleton& skeleton, const FaceRows& rows) {
  const Coreduction reduced(rows, dual_spanning_forest(tri, skeleton), skeleton.edge_count());
  const int left = std::accumulate(reduced.alive.begin(), reduced.alive.end(), 0);
  std::vector<int> column(static_cast<std::size_t>(skeleton.edge_count()), -1);
  int columns = 0;
  SparseMatrix rest(left, skeleton.edge_count() - reduced.pivots);
  for (int f = 0, r = 0; f < rows.size(); ++f) {
    if (!reduced.alive[f]) continue;
    const FaceRow& row = rows[FaceId(f)];
    for (int c = 0; c < 3; ++c) {
      if (row.coefficient[c] == 0) continue;
      int& number = column[row.edge[c]];
      if (number < 0) number = columns++;
      rest.add(r, number, row.coefficient[c]);
    }
    ++r;
  }
  SmithForm form = smith_normal_form(rest);
  form.units += reduced.pivots;
  return form;
}

/// The map between interior edges and finite vertices, a graph: an end outside the complex is grounded.
/// Its arcs join likewise ends (-1, +1) in the relative complex.
SmithForm edge_ends_form(const Skeleton& skeleton) {
  SignedGraph graph(skeleton.vertex_count());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (!is_finite_interior(skeleton, v)) graph.ground(v.value);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_boundary(e)) continue;
    const auto [from, to] = skeleton.ends(e);
    graph.join(from.value, to.value, 1);
  }
  return graph.form();
}

/// The turning sense of every vertex link, relative to each t-vertex's own: flooded over the link, +1 at its
/// first t-vertex. Meaningful for orientable links, in particular spheres.
std::vector<std::array<std::int8_t, 4>> link_senses(const Triangulation& tri, const Skeleton& skeleton) {
  std::vector<std::array<std::int8_t, 4>> sense(static_cast<std::size_t>(tri.size()));
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    std::vector<TetVertex> flood{skeleton.preimages(v)[0]};
    sense[flood[0].tet][flood[0].vertex] = 1;
    for (std::size_t next = 0; next < flood.size(); ++next) {
      const TetVertex at = flood[next];
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri.gluing({at.tet, f});
        if (f == at.vertex || g.tet < 0) continue;
        std::int8_t& there = sense[g.tet][g.perm[at.vertex]];
        if (there != 0) continue;
        there = static_cast<std::int8_t>(-g.perm.sign() * sense[at.tet][at.vertex]);
        flood.push_back({g.tet, g.perm[at.vertex]});
      }
    }
  }
  return sense;
}

/// The map between dual balls and dual disks: the disk of an edge bounds one ball at either end, with the
/// sign by which its turning sense agrees with that of the link there.
SmithForm dual_ball_form(const Triangulation& tri, const Skeleton& skeleton) {
  const auto sense = link_senses(tri, skeleton);
  SignedGraph graph(skeleton.vertex_count());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (!is_finite_interior(skeleton, v)) graph.ground(v.value);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_boundary(e)) continue;
    const Walk& w = skeleton.around(e)[0];
    const int at_start = w.hold.sign() * sense[w.tet][w.from()];
    const int at_end = -w.hold.sign() * sense[w.tet][w.to()];
    const auto [from, to] = skeleton.ends(e);
    graph.join(from.value, to.value, -at_start * at_end);
  }
  return graph.form();
}

/// The map between tetrahedra and interior faces: a face counts in the tetrahedra on its two sides with
/// opposite signs if the gluing keeps the local orientations, and a boundary face not at all.
SmithForm tetrahedra_form(const Triangulation& tri, const Skeleton& skeleton, bool with_orientation) {
  SignedGraph graph(tri.size());
  for (const FaceId f : all<FaceId>(skeleton.face_count())) {
    if (skeleton.is_boundary(f)) continue;
    const TetFace side = skeleton.preimages(f)[0];
    const Gluing g = tri.gluing(side);
    graph.join(side.tet, g.tet, with_orientation ? -g.perm.sign() : 1);
  }
  return graph.form();
}

struct CellCounts {
  int tets = 0;
  int faces = 0;
  int edges = 0;
  int vertices = 0;
};

CellCounts count_cells(const Skeleton& skeleton) {
  CellCounts n{skeleton.tetrahedron_count(), skeleton.face_count() - skeleton.boundary_face_count(), 0, 0};
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) n.edges += skeleton.is_boundary(e) ? 0 : 1;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    n.vertices += is_finite_interior(skeleton, v) ? 1 : 0;
  return n;
}

/// H_k from the number of k-cells and the Smith forms of the maps out of and into them.
AbelianGroup quotient(int cells, const SmithForm& out, const SmithForm& in) {
  return AbelianGroup(cells - out.rank() - in.rank(), in.factors);
}

void require_dimension(int k) {
  if (k < 0 || k > 3)
    throw PreconditionError("there is no homology of dimension " + std::to_string(k) +
                            " here: k must be 0, 1, 2 or 3");
}

} // namespace

AbelianGroup homology(const Triangulation& tri, const Skeleton& skeleton, int k) {
  require_dimension(k);
  require_manifold(tri, skeleton, "homology");
  const CellCounts n = count_cells(skeleton);
  const auto d1 = [&] { return tetrahedra_form(tri, skeleton, false); };
  const auto d2 = [&] { return face_edge_form(tri, skeleton, dual_disk_boundaries(skeleton)); };
  const auto d3 = [&] { return dual_ball_form(tri, skeleton); };
  if (k == 0) return quotient(n.tets, {}, d1());
  if (k == 1) return quotient(n.faces, d1(), d2());
  if (k == 2) return quotient(n.edges, d2(), d3());
  return quotient(n.vertices, d3(), {});
}

AbelianGroup relative_homology(const Triangulation& tri, const Skeleton& skeleton, int k) {
  require_dimension(k);
  require_manifold(tri, skeleton, "homology");
  const CellCounts n = count_cells(skeleton);
  const auto d1 = [&] { return edge_ends_form(skeleton); };
  const auto d2 = [&] { return face_edge_form(tri, skeleton, triangle_boundaries(skeleton)); };
  const auto d3 = [&] { return tetrahedra_form(tri, skeleton, true); };
  if (k == 0) return quotient(n.vertices, {}, d1());
  if (k == 1) return quotient(n.edges, d1(), d2());
  if (k == 2) return quotient(n.faces, d2(), d3());
  return quotient(n.tets, d3(), {});
}

} // namespace tetrarch::algebra
