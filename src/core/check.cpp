// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/check.hpp"

namespace tetrarch {

std::string Defect::name() const {
  return kind == Kind::edge_reversed ? "edge_reversed" : "bad_vertex_link";
}

std::vector<Defect> check(const Skeleton& skeleton) {
  std::vector<Defect> defects;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    if (skeleton.is_reversed(e)) defects.push_back({Defect::Kind::edge_reversed, e, VertexId()});
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const SurfaceType& link = skeleton.link(v);
    if (!link.is_closed() && !link.is_disk()) defects.push_back({Defect::Kind::bad_vertex_link, EdgeId(), v});
  }
  return defects;
}

bool is_valid(const Skeleton& skeleton) {
  return check(skeleton).empty();
}

std::string describe(const Defect& defect, const Skeleton& skeleton) {
  if (defect.kind == Defect::Kind::edge_reversed) {
    const Walk w = skeleton.around(defect.edge).front();
    return "edge " + std::to_string(defect.edge.value) + " (edge " + std::to_string(w.from()) +
           std::to_string(w.to()) + " of tetrahedron " + std::to_string(w.tet) +
           ") is identified with itself reversed";
  }
  const TetVertex v = skeleton.preimages(defect.vertex).front();
  return "vertex " + std::to_string(defect.vertex.value) + " (vertex " + std::to_string(v.vertex) +
         " of tetrahedron " + std::to_string(v.tet) + ") has the link '" +
         skeleton.link(defect.vertex).str() + "' where a closed surface or a disk was expected";
}

} // namespace tetrarch
