// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/validate.hpp"

#include "findings.hpp"
#include "orient_solid.hpp"
#include "soup_edit.hpp"

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/solid/face_sweep.hpp"
#include "tetrarch/solid/gluing.hpp"

namespace tetrarch::doctor {
namespace {

using solid::FaceSweep;
using solid::glue_shared_face;
using solid::SortedFace;

struct KindRow {
  std::string_view name;
  Severity severity;
};

/// In the order of `Kind`.
constexpr std::array<KindRow, kind_count> kinds{{
    {"no_tetrahedra", Severity::fatal},
    {"no_triangles", Severity::fatal},
    {"not_finite", Severity::fatal},
    {"index_out_of_range", Severity::fatal},
    {"repeated_vertex", Severity::fatal},
    {"degenerate", Severity::repairable},
    {"duplicate", Severity::repairable},
    {"face_shared", Severity::fatal},
    {"non_manifold_edge", Severity::fatal},
    {"non_manifold_vertex", Severity::fatal},
    {"inverted", Severity::repairable},
    {"folded", Severity::remark},
    {"turned", Severity::repairable},
    {"flat", Severity::remark},
    {"thin", Severity::remark},
    {"not_orientable", Severity::remark},
    {"unused_vertex", Severity::repairable},
    {"coincident_vertex", Severity::remark},
    {"stray_triangle", Severity::remark},
    {"inside_out", Severity::remark},
    {"several_components", Severity::remark},
}};

/// Looks at the parts of a soup from the simplest on; each look builds on what the earlier ones left.
class Validator : Findings<4> {
public:
  Validator(const format::Soup& soup, int listed)
      : Findings(soup, {soup.tetrahedra, soup.tetrahedron_labels, "tetrahedron", "tetrahedra"}, listed) {}

  Report run() && {
    look_at_points();
    if (element_count() == 0) {
      // A surface, perhaps: there is no need to hear of every point that it is in no tetrahedron.
      add(Kind::no_tetrahedra, 0, 0, [&] {
        return soup_.triangles.empty() && !soup_.points.empty()
                   ? "there are points only: no triangles and no tetrahedra"
                   : "the mesh has no tetrahedra";
      });
      std::fill(used_.begin(), used_.end(), 1);
    }
    for (int t = 0; t < element_count(); ++t) look_at_corners(t, Kind::repeated_vertex);
    std::vector<char> proper(left_out_);
    for (char& p : proper) p = static_cast<char>(!p);
    Triangulation tri = glue();
    const std::vector<int> signs = solid_signs(soup_, tri, proper);
    for (int t = 0; t < element_count(); ++t)
      if (proper[t]) look_at_volume(t, signs[t]);
    look_at_triangles();
    if (report_.count(Kind::face_shared) == 0) look_at_links(tri);
    look_at_use();
    if (element_count() > 0) look_at_coincidence();
    return finish();
  }

private:
  std::array<int, 3> sorted_corners(TetFace face) const;
  std::string names(TetFace face) const;

  void look_at_volume(int t, int sign);
  void look_at_triangles();
  Triangulation glue();
  void look_at_face(Triangulation& tri, std::span<const SortedFace> shared);
  void look_at_links(const Triangulation& tri);
  void look_at_edges(const Skeleton& skeleton, std::vector<char>& on_bad_edge);
  void look_at_vertices(const Skeleton& skeleton, const std::vector<char>& on_bad_edge);

  std::vector<SortedFace> different_;
  std::vector<ListedTriangle> triangles_ = listed_triangles(soup_);
  std::vector<char> is_face_ = std::vector<char>(triangles_.size(), 0); ///< of tetrahedra
};

std::array<int, 3> Validator::sorted_corners(TetFace face) const {
  std::array<int, 3> v{};
  for (std::size_t c = 0; c < 3; ++c)
    v[c] = corners(face.tet)[static_cast<std::size_t>(face_vertex[static_cast<std::size_t>(face.face)][c])];
  std::sort(v.begin(), v.end());
  return v;
}

/// The three vertices of a face, in increasing order.
std::string Validator::names(TetFace face) const {
  const std::array<int, 3> v = sorted_corners(face);
  return name(v[0]) + ", " + name(v[1]) + ", " + name(v[2]);
}

/// `sign`: whether the tetrahedron is listed as its component is oriented; 0: that cannot be said.
void Validator::look_at_volume(int t, int sign) {
  const auto& [a, b, c, d] = corners(t);
  for (const int v : corners(t))
    if (!is_finite(point(v))) return;
  const int volume = static_cast<int>(numeric::volume_sign(point(a), point(b), point(c), point(d)));
  if (volume == 0) {
    add_element(Kind::flat, t, [&] { return element(t) + " is flat"; });
  } else if (volume < 0 && sign < 0) {
    add_element(Kind::inverted, t, [&] { return element(t) + " has negative volume"; });
  } else if (sign != 0 ? volume != sign : volume < 0) {
    add_element(Kind::folded, t,
                [&] { return element(t) + " is inverted against its component: it is folded over"; });
  }
}

void Validator::look_at_triangles() {
  if (element_count() == 0) return;
  std::vector<int> stray;
  for (std::size_t k = 0; k < triangles_.size(); ++k)
    if (!is_face_[k]) stray.push_back(triangles_[k].index);
  std::sort(stray.begin(), stray.end());
  for (const int t : stray) {
    const long long number = soup_.triangle_labels.number(t, soup_.first_number);
    add(Kind::stray_triangle, number, soup_.triangle_labels.line(t),
        [&] { return "triangle " + std::to_string(number) + " is no face of a tetrahedron"; });
  }
}

Triangulation Validator::glue() {
  Triangulation tri(static_cast<int>(soup_.tetrahedra.size()));
  FaceSweep sweep(soup_.tetrahedra, soup_.points.size(), [&](std::size_t t) { return !left_out_[t]; });
  sweep.for_each_class([&](std::span<const SortedFace> shared) { look_at_face(tri, shared); });
  return tri;
}

void Validator::look_at_face(Triangulation& tri, std::span<const SortedFace> shared) {
  if (!triangles_.empty()) {
    const auto [first, last] = on_corners(triangles_, sorted_corners(shared.front().at()));
    for (std::size_t k = first; k < last; ++k) is_face_[k] = 1;
  }
  find_different(shared, different_);
  if (different_.size() == 2) glue_shared_face(tri, soup_.tetrahedra, different_[0].at(), different_[1].at());
  if (different_.size() > 2)
    add_shared(Kind::face_shared, "the face on vertices " + names(different_[0].at()), different_);
}

void Validator::look_at_links(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  std::vector<char> on_bad_edge(soup_.points.size(), 0);
  look_at_edges(skeleton, on_bad_edge);
  look_at_vertices(skeleton, on_bad_edge);
  const auto alone = std::count(left_out_.begin(), left_out_.end(), 1);
  const std::int64_t components = skeleton.component_count() - alone;
  if (components > 1)
    add(Kind::several_components, 0, 0,
        [&] { return "the mesh has " + std::to_string(components) + " components"; });
}

/// An edge of the mesh with two or more edge classes on it has tetrahedra that are not connected around it.
void Validator::look_at_edges(const Skeleton& skeleton, std::vector<char>& on_bad_edge) {
  struct MeshEdge {
    std::uint64_t ends; ///< the points, the smaller one in the upper half
    int tet;            ///< the first of its class
  };
  std::vector<MeshEdge> edges;
  edges.reserve(static_cast<std::size_t>(skeleton.edge_count()));
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    const Walk& first = skeleton.around(e).front();
    if (is_left_out(first.tet)) continue;
    const auto [smaller, larger] =
        std::minmax(corners(first.tet)[first.from()], corners(first.tet)[first.to()]);
    edges.push_back(
        {static_cast<std::uint64_t>(smaller) << 32 | static_cast<std::uint64_t>(larger), first.tet});
  }
  std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.tet < b.tet;
  });
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    const auto [ends, tet] = edges[first];
    while (last < edges.size() && edges[last].ends == ends) ++last;
    if (last - first < 2) continue;
    const int a = static_cast<int>(ends >> 32);
    const int b = static_cast<int>(ends & 0xffffffffU);
    on_bad_edge[static_cast<std::size_t>(a)] = on_bad_edge[static_cast<std::size_t>(b)] = 1;
    add_element(Kind::non_manifold_edge, edges[first + 1].tet, [&, tet = tet] {
      return "the tetrahedra around the edge on vertices " + name(a) + ", " + name(b) + " fall apart into " +
             std::to_string(last - first) + " fans, among them those of " + element(tet) + " and " +
             std::to_string(number(edges[first + 1].tet));
    });
  }
}

void Validator::look_at_vertices(const Skeleton& skeleton, const std::vector<char>& on_bad_edge) {
  struct Pieces {
    int count = 0;
    VertexId first;
  };
  std::vector<Pieces> pieces(soup_.points.size());
  for (const VertexId id : all<VertexId>(skeleton.vertex_count())) {
    const TetVertex at = skeleton.preimages(id).front();
    if (is_left_out(at.tet)) continue;
    Pieces& here = pieces[static_cast<std::size_t>(corners(at.tet)[at.vertex])];
    if (here.count++ == 0) here.first = id;
  }
  for (int v = 0; v < static_cast<int>(pieces.size()); ++v) {
    const Pieces& here = pieces[static_cast<std::size_t>(v)];
    if (here.count == 0 || on_bad_edge[static_cast<std::size_t>(v)]) continue;
    const SurfaceType& link = skeleton.link(here.first);
    if (here.count > 1) {
      add_vertex(Kind::non_manifold_vertex, v, [&] {
        return "the tetrahedra around " + vertex(v) + " fall apart into " + std::to_string(here.count) +
               " pieces";
      });
    } else if (!link.is_sphere() && !link.is_disk()) {
      add_vertex(Kind::non_manifold_vertex, v, [&] {
        return "the link of " + vertex(v) + " is a surface of type " + link.str() +
               ", expected a sphere or a disk";
      });
    }
  }
}

} // namespace

std::string_view name_of(Kind kind) {
  return kinds[static_cast<std::size_t>(kind)].name;
}

Severity severity_of(Kind kind) {
  return kinds[static_cast<std::size_t>(kind)].severity;
}

Place place_of(const Finding& finding, const format::Soup& soup) {
  const bool about_point = finding.kind == Kind::not_finite || finding.kind == Kind::non_manifold_vertex ||
                           finding.kind == Kind::unused_vertex || finding.kind == Kind::coincident_vertex;
  return {about_point && !soup.point_source.empty() ? soup.point_source : soup.source, finding.line};
}

std::int64_t Report::count(Severity severity) const {
  std::int64_t total = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (kinds[k].severity == severity) total += counts[k];
  return total;
}

Report validate(const format::Soup& soup, int listed) {
  return Validator(soup, listed).run();
}

} // namespace tetrarch::doctor
