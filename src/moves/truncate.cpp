// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/truncate.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/boundary_moves.hpp"

#include <algorithm>
#include <map>

namespace tetrarch::moves {
namespace {

void require_manifold(const Complex& complex) {
  for (int t = 0; t < complex.slot_count(); ++t) {
    for (int e = 0; e < 6; ++e)
      if (complex.is_reversed(complex.edge(TetEdge{t, e})))
        throw PreconditionError("truncate: edge " + std::to_string(e) + " of tetrahedron " +
                                std::to_string(t) + " is identified with itself backwards");
    for (int v = 0; v < 4; ++v)
      if (complex.link(complex.vertex({t, v})) == LinkKind::bad)
        throw PreconditionError("truncate: the link of vertex " + std::to_string(v) + " of tetrahedron " +
                                std::to_string(t) + " has boundary but is no disk");
  }
}

TruncateStep step_of(const std::string& name, const Complex& complex) {
  return {name, complex.size(), complex.vertex_count(), complex.edge_count()};
}

/// The conversion as it goes: the complex, and for each boundary component of the input the vertex that
/// stands for it. Before coning, a vertex on a real component; a disk lies on one component only.
class Conversion {
public:
  Conversion(const Triangulation& tri, const TruncateOptions& options)
      : complex_(tri), options_(options), greed_(options.simplify) {
    require_manifold(complex_);
    for (const auto& component : boundary_faces(complex_)) {
      const TetFace first = component.front();
      stands_for_.push_back(complex_.vertex({first.tet, face_vertex[first.face][0]}));
      out_.boundary.push_back({{}, static_cast<int>(component.size())});
    }
    real_components_ = stands_for_.size();
    for (const VertexId v : complex_.all_vertices())
      if (complex_.link(v) == LinkKind::closed) stands_for_.push_back(v);
    out_.boundary.resize(stands_for_.size());
    out_.steps.push_back(step_of("input", complex_));
  }

  Truncation run(const Progress& progress) {
    greed_.change_boundary = false;
    out_.counts.add(reduce(complex_, greed_, progress));
    out_.steps.push_back(step_of("interior vertices merged", complex_));
    cone_all();
    out_.steps.push_back(step_of("boundary coned", complex_));
    const Simplification done = simplify(complex_, greed_, progress);
    out_.counts.add(done.counts);
    for (VertexId& v : stands_for_)
      if (v.value >= 0) v = done.vertices[v];
    out_.steps.push_back(step_of("old vertices merged, simplified", complex_));
    out_.tri = complex_.triangulation();
    name_boundary();
    return std::move(out_);
  }

private:
  void cone_all() {
    std::map<VertexId, std::size_t> number;
    for (std::size_t k = 0; k < real_components_; ++k) number[complex_.current(stands_for_[k])] = k;
    for (const auto& component : boundary_faces(complex_)) {
      std::size_t found = real_components_;
      for (const TetFace f : component)
        for (const int v : face_vertex[f.face]) {
          const auto at = number.find(complex_.vertex({f.tet, v}));
          if (at != number.end()) found = at->second;
        }
      if (found == real_components_) throw PreconditionError("truncate: lost track of a boundary component");
      const TetFace first = component.front();
      if (cone(complex_, component))
        throw PreconditionError("truncate: a boundary component cannot be coned");
      const VertexId apex = complex_.last_change().new_vertices.front();
      if (options_.keep_spheres) complex_.set_link(apex, LinkKind::closed);
      // The cone point of a sphere that is not kept is an ordinary vertex: it stands for nothing.
      stands_for_[found] = complex_.link(apex) == LinkKind::sphere ? VertexId() : apex;
      if (greed_.log != nullptr) greed_.log->push_back({MoveKind::cone, first.tet, first.face});
    }
  }

  /// Finds a corner for each vertex that is left, and reads the types off the result itself.
  void name_boundary() {
    const Skeleton skeleton(out_.tri);
    std::map<VertexId, TetVertex> corner;
    for (int t = 0; t < out_.tri.size(); ++t)
      for (int v = 0; v < 4; ++v) corner.emplace(complex_.vertex({t, v}), TetVertex{t, v});
    for (std::size_t k = 0; k < stands_for_.size(); ++k) {
      BoundaryImage& image = out_.boundary[k];
      if (stands_for_[k].value < 0) continue; // a sphere, filled in
      image.vertex = corner.at(stands_for_[k]);
      image.type = skeleton.link(skeleton.vertex(image.vertex));
    }
    for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
      if (skeleton.link(v).is_sphere()) ++out_.finite_vertices;
    if (options_.keep_spheres)
      for (const BoundaryImage& image : out_.boundary) out_.finite_vertices -= image.type.is_sphere() ? 1 : 0;
  }

  Complex complex_;
  const TruncateOptions& options_;
  SimplifyOptions greed_;
  std::vector<VertexId> stands_for_;
  std::size_t real_components_ = 0;
  Truncation out_;
};

} // namespace

Truncation truncate(const Triangulation& tri, const TruncateOptions& options, const Progress& progress) {
  return Conversion(tri, options).run(progress);
}

} // namespace tetrarch::moves
