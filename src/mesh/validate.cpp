// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/validate.hpp"

#include "face_sweep.hpp"
#include "gluing.hpp"

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/mesh/volume_sign.hpp"

#include <cmath>

namespace tetrarch::mesh {
namespace {

struct KindRow {
  std::string_view name;
  Severity severity;
};

/// In the order of `Kind`.
constexpr std::array<KindRow, kind_count> kinds{{
    {"no_tetrahedra", Severity::fatal},
    {"not_finite", Severity::fatal},
    {"index_out_of_range", Severity::fatal},
    {"repeated_vertex", Severity::fatal},
    {"duplicate", Severity::repairable},
    {"face_shared", Severity::fatal},
    {"non_manifold_edge", Severity::fatal},
    {"non_manifold_vertex", Severity::fatal},
    {"inverted", Severity::repairable},
    {"flat", Severity::remark},
    {"unused_vertex", Severity::repairable},
    {"several_components", Severity::remark},
}};

/// Looks at the parts of a soup from the simplest on; each look builds on what the earlier ones left.
class Validator {
public:
  Validator(const format::Soup& soup, int listed)
      : soup_(soup), listed_(listed), left_out_(soup.tetrahedra.size(), 0), used_(soup.points.size(), 0) {}

  Report run() && {
    look_at_points();
    if (soup_.tetrahedra.empty()) {
      // A surface, perhaps: there is no need to hear of every point that it is in no tetrahedron.
      add(Kind::no_tetrahedra, 0, 0, [] { return "the mesh has no tetrahedra"; });
      std::fill(used_.begin(), used_.end(), 1);
    }
    for (std::size_t t = 0; t < soup_.tetrahedra.size(); ++t) look_at_tetrahedron(t);
    Triangulation tri = glue();
    if (report_.count(Kind::face_shared) == 0) look_at_links(tri);
    look_at_use();
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
    return std::move(report_);
  }

private:
  using Tetrahedron = std::array<int, 4>;

  template <class Text>
  void add(Kind kind, long long number, int line, Text text) {
    if (report_.counts[static_cast<std::size_t>(kind)]++ < listed_)
      report_.findings.push_back({kind, number, line, text()});
  }
  template <class Text>
  void add_tetrahedron(Kind kind, int t, Text text) {
    add(kind, number(t), soup_.tetrahedron_labels.line(t), text);
  }
  template <class Text>
  void add_vertex(Kind kind, int v, Text text) {
    add(kind, format::point_number(soup_, v), soup_.point_labels.line(v), text);
  }
  long long number(int t) const { return soup_.tetrahedron_labels.number(t, soup_.first_number); }
  std::string tetrahedron(int t) const { return "tetrahedron " + std::to_string(number(t)); }
  std::string vertex(int v) const { return "vertex " + name(v); }
  std::string name(int v) const { return std::to_string(format::point_number(soup_, v)); }

  std::string names(TetFace face) const;

  void look_at_points();
  void look_at_tetrahedron(std::size_t t);
  void look_at_volume(int t);
  Triangulation glue();
  void look_at_face(Triangulation& tri, std::span<const SortedFace> shared);
  void look_at_links(const Triangulation& tri);
  void look_at_edges(const Skeleton& skeleton, std::vector<char>& on_bad_edge);
  void look_at_vertices(const Skeleton& skeleton, const std::vector<char>& on_bad_edge);
  void look_at_use();

  const format::Soup& soup_;
  std::int64_t listed_;
  std::vector<char> left_out_; ///< tetrahedra at fault by themselves
  std::vector<char> used_;     ///< points that some tetrahedron names
  std::vector<SortedFace> different_;
  Report report_;
};

/// The three vertices of a face, in increasing order.
std::string Validator::names(TetFace face) const {
  const Tetrahedron& corners = soup_.tetrahedra[static_cast<std::size_t>(face.tet)];
  std::array<int, 3> v{};
  for (std::size_t c = 0; c < 3; ++c)
    v[c] = corners[static_cast<std::size_t>(face_vertex[static_cast<std::size_t>(face.face)][c])];
  std::sort(v.begin(), v.end());
  return name(v[0]) + ", " + name(v[1]) + ", " + name(v[2]);
}

void Validator::look_at_points() {
  for (std::size_t v = 0; v < soup_.points.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = soup_.points[v][axis];
      if (std::isfinite(x)) continue;
      const int index = static_cast<int>(v);
      add_vertex(Kind::not_finite, index, [&] {
        return std::string("coordinate ") + "xyz"[axis] + " of " + vertex(index) + " is " +
               format::to_text(x) + ", expected a finite number";
      });
      break;
    }
  }
}

void Validator::look_at_tetrahedron(std::size_t t) {
  const Tetrahedron& corners = soup_.tetrahedra[t];
  const int index = static_cast<int>(t);
  for (const int v : corners) {
    if (v >= 0 && static_cast<std::size_t>(v) < soup_.points.size()) {
      used_[static_cast<std::size_t>(v)] = 1;
    } else if (!left_out_[t]) {
      left_out_[t] = 1;
      add_tetrahedron(Kind::index_out_of_range, index, [&] {
        return tetrahedron(index) + " names " + vertex(v) + ", which is none of the " +
               std::to_string(soup_.points.size()) + " there are";
      });
    }
  }
  if (left_out_[t]) return;
  for (int i = 0; i < 3; ++i) {
    if (std::find(corners.begin() + i + 1, corners.end(), corners[i]) == corners.end()) continue;
    left_out_[t] = 1;
    add_tetrahedron(Kind::repeated_vertex, index,
                    [&] { return tetrahedron(index) + " names " + vertex(corners[i]) + " twice"; });
    return;
  }
  look_at_volume(index);
}

void Validator::look_at_volume(int t) {
  const Tetrahedron& corners = soup_.tetrahedra[static_cast<std::size_t>(t)];
  const auto point = [&](int i) -> const auto& {
    return soup_.points[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
  };
  for (int i = 0; i < 4; ++i)
    for (const double x : point(i))
      if (!std::isfinite(x)) return;
  const int sign = volume_sign(point(0), point(1), point(2), point(3));
  if (sign < 0) add_tetrahedron(Kind::inverted, t, [&] { return tetrahedron(t) + " has negative volume"; });
  if (sign == 0) add_tetrahedron(Kind::flat, t, [&] { return tetrahedron(t) + " is flat"; });
}

Triangulation Validator::glue() {
  Triangulation tri(static_cast<int>(soup_.tetrahedra.size()));
  FaceSweep sweep(soup_.tetrahedra, soup_.points.size(), [&](std::size_t t) { return !left_out_[t]; });
  sweep.for_each_class([&](std::span<const SortedFace> shared) { look_at_face(tri, shared); });
  return tri;
}

void Validator::look_at_face(Triangulation& tri, std::span<const SortedFace> shared) {
  different_.clear();
  for (const SortedFace& face : shared) {
    const auto t = static_cast<std::size_t>(face.at().tet);
    if (left_out_[t]) continue;
    // Of the four faces of a tetrahedron, the one without its largest vertex comes first in the sweep. So
    // duplicates meet there, next to each other, and are left out at their other faces.
    if (!different_.empty() && different_.back().apex == face.apex) {
      left_out_[t] = 1;
      add_tetrahedron(Kind::duplicate, face.at().tet, [&] {
        return tetrahedron(face.at().tet) + " has the same vertices as " +
               tetrahedron(different_.back().at().tet);
      });
    } else {
      different_.push_back(face);
    }
  }
  if (different_.size() == 2) glue_shared_face(tri, soup_.tetrahedra, different_[0].at(), different_[1].at());
  if (different_.size() < 3) return;
  std::sort(different_.begin(), different_.end(),
            [](const SortedFace& a, const SortedFace& b) { return a.code < b.code; });
  add_tetrahedron(Kind::face_shared, different_[2].at().tet, [&] {
    return "the face on vertices " + names(different_[0].at()) + " is shared by " +
           std::to_string(different_.size()) + " tetrahedra, among them " +
           std::to_string(number(different_[0].at().tet)) + ", " +
           std::to_string(number(different_[1].at().tet)) + ", " +
           std::to_string(number(different_[2].at().tet));
  });
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
    if (left_out_[static_cast<std::size_t>(first.tet)]) continue;
    const Tetrahedron& corners = soup_.tetrahedra[static_cast<std::size_t>(first.tet)];
    const auto [smaller, larger] = std::minmax(corners[first.from()], corners[first.to()]);
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
    add_tetrahedron(Kind::non_manifold_edge, edges[first + 1].tet, [&, tet = tet] {
      return "the tetrahedra around the edge on vertices " + name(a) + ", " + name(b) + " fall apart into " +
             std::to_string(last - first) + " fans, among them those of " + tetrahedron(tet) + " and " +
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
    if (left_out_[static_cast<std::size_t>(at.tet)]) continue;
    Pieces& here =
        pieces[static_cast<std::size_t>(soup_.tetrahedra[static_cast<std::size_t>(at.tet)][at.vertex])];
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

void Validator::look_at_use() {
  for (std::size_t v = 0; v < used_.size(); ++v)
    if (!used_[v])
      add_vertex(Kind::unused_vertex, static_cast<int>(v),
                 [&] { return vertex(static_cast<int>(v)) + " is in no tetrahedron"; });
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
                           finding.kind == Kind::unused_vertex;
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

} // namespace tetrarch::mesh
