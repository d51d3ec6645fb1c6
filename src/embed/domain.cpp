// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/domain.hpp"

#include "cusps.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/instantiate.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <numeric>

namespace tetrarch::embed {
namespace {

std::size_t index(TetFace f) {
  return 4 * static_cast<std::size_t>(f.tet) + static_cast<std::size_t>(f.face);
}

/// Which faces the domain is cut open along: at first those of the generators; then, as long as there is an
/// edge around which only one is open, not that one (the edge makes its generator trivial).
Table<FaceId, char> open_faces(const Skeleton& skeleton, const algebra::DualPresentation& group) {
  Table<FaceId, char> open(skeleton.face_count(), 0);
  for (const TetFace f : group.generator_face) open[skeleton.face(f)] = 1;
  Table<EdgeId, int> count(skeleton.edge_count(), 0);
  std::vector<EdgeId> queue;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    for (const Walk& w : skeleton.around(e)) count[e] += open[skeleton.face(w.left_face())];
    if (count[e] == 1) queue.push_back(e);
  }
  while (!queue.empty()) {
    const EdgeId e = queue.back();
    queue.pop_back();
    for (const Walk& w : skeleton.around(e)) {
      if (!open[skeleton.face(w.left_face())]) continue;
      open[skeleton.face(w.left_face())] = 0;
      // Each of the three edges of the face is crossed by it once for each side of the triangle.
      for (int k = 0; k < 3; ++k) {
        const auto& v = face_vertex[w.left_face().face];
        const EdgeId side = skeleton.edge({w.tet, edge_number[v[k]][v[(k + 1) % 3]]});
        if (--count[side] == 1) queue.push_back(side);
      }
      break;
    }
  }
  return open;
}

/// Unites open faces that meet in an edge of the domain with just two copies around it.
void unite_around_edges(const Triangulation& tri, const Skeleton& skeleton, const Table<FaceId, char>& open,
                        std::vector<int>& group) {
  const auto unite = [&group](TetFace f, TetFace g) {
    group[numeric::find_root(group, static_cast<int>(index(f)))] =
        numeric::find_root(group, static_cast<int>(index(g)));
  };
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    std::vector<TetFace> crossed; // the left faces of the open crossings, in cyclic order
    for (const Walk& w : skeleton.around(e))
      if (open[skeleton.face(w.left_face())]) crossed.push_back(w.left_face());
    if (crossed.size() != 2) continue;
    unite(crossed[0], tri.partner(crossed[1]));
    unite(crossed[1], tri.partner(crossed[0]));
  }
}

/// Where the neighbour across f lies, f's tetrahedron being where it is: the two share the face, and are put
/// down by it on different sides of the plane y = 0.
template <class Scalar>
VertexVectors<Scalar> neighbour(const Triangulation& tri, const Skeleton& skeleton,
                                const Metric<Scalar>& lengths, const Domain<Scalar>& domain, TetFace f) {
  const auto [other, perm] = tri.gluing(f);
  const auto& v = face_vertex[f.face];
  const Perm4 hold(v[0], v[1], v[2], f.face);
  const auto here = place(hyperbolic::lengths_at(skeleton, lengths, f.tet), domain.types[f.tet], hold);
  auto there = place(hyperbolic::lengths_at(skeleton, lengths, other), domain.types[other], perm * hold);
  for (Vector4<Scalar>& vertex : there) vertex[1] = -vertex[1];
  const Matrix4<Scalar> m = motion(here, domain.vertices[f.tet], domain.types[f.tet]);
  for (Vector4<Scalar>& vertex : there) vertex = m * vertex;
  return there;
}

template <class Scalar>
void walk_tree(const Triangulation& tri, const Skeleton& skeleton, const Metric<Scalar>& lengths,
               Domain<Scalar>& domain) {
  Table<FaceId, char> tree(skeleton.face_count(), 1);
  for (const TetFace f : domain.group.generator_face) tree[skeleton.face(f)] = 0;
  const auto n = static_cast<std::size_t>(tri.size());
  domain.vertices.resize(n);
  domain.entrance.assign(n, TetFace{});
  std::vector<char> placed(n, 0);
  domain.vertices[0] = place(hyperbolic::lengths_at(skeleton, lengths, 0), domain.types[0]);
  domain.order.push_back(0);
  placed[0] = 1;
  for (std::size_t next = 0; next < domain.order.size(); ++next)
    for (int f = 0; f < 4; ++f) {
      const TetFace face{domain.order[next], f};
      const int other = tri.gluing(face).tet;
      if (!tree[skeleton.face(face)] || placed[other]) continue;
      domain.vertices[other] = neighbour(tri, skeleton, lengths, domain, face);
      domain.entrance[other] = face;
      domain.order.push_back(other);
      placed[other] = 1;
    }
}

/// Moves everything so that the centroid of the tetrahedra's middles comes to the base point.
template <class Scalar>
void centre(Domain<Scalar>& domain) {
  std::vector<Vector4<Scalar>> middles;
  for (std::size_t t = 0; t < domain.vertices.size(); ++t)
    middles.push_back(center(domain.vertices[t], domain.types[t]));
  domain.half_space = boost_to(centroid(middles));
  const Matrix4<Scalar> back = inverse(domain.half_space);
  for (VertexVectors<Scalar>& vertices : domain.vertices)
    for (Vector4<Scalar>& v : vertices) v = back * v;
}

/// The pairing of an open face, from where its neighbour should be and where the neighbour is.
template <class Scalar>
Matrix4<Scalar> pairing(const Triangulation& tri, const Skeleton& skeleton, const Metric<Scalar>& lengths,
                        const Domain<Scalar>& domain, TetFace f) {
  const int other = tri.gluing(f).tet;
  return motion(domain.vertices[other], neighbour(tri, skeleton, lengths, domain, f), domain.types[other]);
}

template <class Scalar>
void find_gluable_faces(const Triangulation& tri, const Skeleton& skeleton, const Metric<Scalar>& lengths,
                        Domain<Scalar>& domain) {
  const Table<FaceId, char> open = open_faces(skeleton, domain.group);
  std::vector<int> group(4 * static_cast<std::size_t>(tri.size()));
  std::iota(group.begin(), group.end(), 0);
  unite_around_edges(tri, skeleton, open, group);
  domain.gluable.assign(static_cast<std::size_t>(tri.size()), {-1, -1, -1, -1});
  std::vector<int> number(group.size(), -1); // of the group of this root
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const TetFace face{t, f};
      if (!open[skeleton.face(face)]) continue;
      int& id = number[numeric::find_root(group, static_cast<int>(index(face)))];
      if (id < 0) {
        id = static_cast<int>(domain.faces.size());
        domain.faces.emplace_back();
      }
      domain.gluable[t][f] = id;
      domain.faces[id].hexagons.push_back(face);
    }
  for (std::size_t i = 0; i < domain.faces.size(); ++i) {
    const TetFace here = domain.faces[i].hexagons.front();
    const TetFace there = tri.partner(here);
    const int partner = domain.gluable[there.tet][there.face];
    domain.faces[i].partner = partner;
    domain.faces[i].pairing = partner < static_cast<int>(i) ? inverse(domain.faces[partner].pairing)
                                                            : pairing(tri, skeleton, lengths, domain, here);
  }
}

} // namespace

template <class Scalar>
Domain<Scalar> fundamental_domain(const Triangulation& tri, const Skeleton& skeleton,
                                  const Metric<Scalar>& lengths, const DomainOptions& options) {
  skeleton.require_current(tri);
  if (skeleton.has_boundary_faces())
    throw PreconditionError("fundamental_domain: the triangulation has boundary faces");
  if (lengths.size() != skeleton.edge_count())
    throw PreconditionError("fundamental_domain: one length is needed for each edge class");
  Domain<Scalar> domain;
  domain.group = algebra::dual_presentation(tri, skeleton);
  const auto types = hyperbolic::vertex_types(skeleton);
  for (int t = 0; t < tri.size(); ++t) domain.types.push_back(hyperbolic::types_at(skeleton, types, t));

  const Metric<Scalar> cut = with_cusp_area(skeleton, lengths, types, options.cusp_area);
  walk_tree(tri, skeleton, cut, domain);
  centre(domain);
  find_gluable_faces(tri, skeleton, cut, domain);
  for (const TetFace f : domain.group.generator_face) domain.holonomy.push_back(domain.across(f));
  return domain;
}

template <class Scalar>
Matrix4<Scalar> holonomy_of(const Domain<Scalar>& domain, const algebra::Word& word) {
  Matrix4<Scalar> m = identity<Scalar>();
  for (const int letter : word) {
    const Matrix4<Scalar>& g = domain.holonomy.at(static_cast<std::size_t>(std::abs(letter)) - 1);
    m = m * (letter > 0 ? g : inverse(g));
  }
  return m;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template Domain<Scalar> fundamental_domain(const Triangulation&, const Skeleton&, const Metric<Scalar>&,   \
                                             const DomainOptions&);                                          \
  template Matrix4<Scalar> holonomy_of(const Domain<Scalar>&, const algebra::Word&);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::embed
