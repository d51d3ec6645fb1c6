// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/validate_surface.hpp"

#include "edge_sweep.hpp"
#include "enclosed.hpp"
#include "findings.hpp"
#include "orient.hpp"
#include "thin_triangles.hpp"

#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <numeric>

namespace tetrarch::doctor {
namespace {

using Point = std::array<double, 3>;

/// Whether the triangle's shadow in the plane of two axes is flat, decided exactly: the volume over it of a
/// prism of height one is zero.
bool is_flat_along(int axis, Point a, Point b, Point c) {
  const auto k = static_cast<std::size_t>(axis);
  a[k] = b[k] = c[k] = 0;
  Point above = a;
  above[k] = 1;
  return numeric::volume_sign(a, b, c, above) == numeric::Sign::zero;
}

/// Whether three points lie on a line: whether all three shadows are flat.
bool is_flat(const Point& a, const Point& b, const Point& c) {
  // Along the largest component of the normal first: there doubles decide, unless the triangle is flat.
  std::array<double, 3> normal{};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    normal[k] = std::fabs((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
  }
  const int first = static_cast<int>(std::max_element(normal.begin(), normal.end()) - normal.begin());
  for (int k = 0; k < 3; ++k)
    if (!is_flat_along((first + k) % 3, a, b, c)) return false;
  return true;
}

/// Looks at the parts of a soup from the simplest on; each look builds on what the earlier ones left.
class SurfaceValidator : Findings<3> {
public:
  SurfaceValidator(const format::Soup& soup, int listed)
      : Findings(soup, {soup.triangles, soup.triangle_labels, "triangle", "triangles"}, listed),
        on_bad_edge_(soup.points.size(), 0) {}

  Report run() && {
    look_at_points();
    for (int t = 0; t < element_count(); ++t) {
      look_at_corners(t, Kind::degenerate);
      if (!is_left_out(t)) look_at_area(t);
    }
    if (report_.count(Kind::degenerate) == element_count()) add_no_triangles();
    const Surface surface = glue();
    look_at_vertices(surface);
    const Signs signs = signs_of(surface);
    look_at_orientation(surface, signs);
    look_at_components(signs.parts);
    if (report_.count(Kind::not_finite) == 0) look_at_insides(surface, signs);
    look_at_use();
    look_at_coincidence();
    return finish();
  }

private:
  void look_at_area(int t);
  void add_no_triangles();
  Surface glue();
  void look_at_edge(Mates& mates, std::span<const SortedSide> shared);
  void look_at_vertices(const Surface& surface);
  void look_at_orientation(const Surface& surface, const Signs& signs);
  void look_at_components(const Parts& parts);
  void look_at_insides(const Surface& surface, const Signs& signs);

  std::vector<SortedSide> different_;
  std::vector<char> on_bad_edge_;          ///< points on an edge of three or more triangles
  std::vector<std::array<int, 2>> joined_; ///< triangles connected through such an edge
};

void SurfaceValidator::look_at_area(int t) {
  const auto& [a, b, c] = corners(t);
  if (!is_finite(point(a)) || !is_finite(point(b)) || !is_finite(point(c))) return;
  if (is_flat(point(a), point(b), point(c)))
    add_element(Kind::flat, t, [&] { return element(t) + " has no area"; });
  else if (is_thin(point(a), point(b), point(c)))
    add_element(Kind::thin, t, [&] { return element(t) + " is thin: it has an angle below 1e-10"; });
}

/// Repair would leave none. Points that lie about are then nobody's concern.
void SurfaceValidator::add_no_triangles() {
  add(Kind::no_triangles, 0, 0, [&] {
    return std::string("the surface has no triangles") + (element_count() > 0 ? " but degenerate ones" : "");
  });
  std::fill(used_.begin(), used_.end(), 1);
}

/// The surface in which fans of triangles are vertices.
Surface SurfaceValidator::glue() {
  Mates mates(soup_.triangles);
  for_each_edge(
      soup_.triangles, soup_.points.size(), [&](int t) { return !is_left_out(t); },
      [&](std::span<const SortedSide> shared) { look_at_edge(mates, shared); });
  return std::move(mates).surface();
}

void SurfaceValidator::look_at_edge(Mates& mates, std::span<const SortedSide> shared) {
  find_different(shared, different_);
  if (different_.size() == 2) mates.glue(different_[0].at(), different_[1].at());
  if (different_.size() < 3) return;
  const Side s = different_[0].at();
  add_shared(Kind::non_manifold_edge, edge_name(soup_, s), different_);
  for (const Side end : {s.next(), s.previous()}) on_bad_edge_[corners(s.triangle())[end.corner()]] = 1;
  for (const SortedSide& other : different_) joined_.push_back({s.triangle(), other.at().triangle()});
}

/// A vertex of the mesh with two or more fans is no manifold's.
void SurfaceValidator::look_at_vertices(const Surface& surface) {
  struct Fans {
    int count = 0;
    std::array<int, 2> triangle{}; ///< the first of each of the first two
  };
  std::vector<Fans> fans(soup_.points.size());
  std::vector<char> seen(static_cast<std::size_t>(surface.vertex_count()), 0);
  for (int t = 0; t < element_count(); ++t)
    for (int c = 0; c < 3 && !is_left_out(t); ++c) {
      char& is_known = seen[surface.corners(t)[c]];
      Fans& here = fans[corners(t)[c]];
      if (!is_known && here.count++ < 2) here.triangle[here.count - 1] = t;
      is_known = 1;
    }
  for (int v = 0; v < static_cast<int>(fans.size()); ++v) {
    const Fans& here = fans[v];
    if (here.count < 2 || on_bad_edge_[v]) continue;
    add_vertex(Kind::non_manifold_vertex, v, [&] {
      return "the triangles around " + vertex(v) + " fall apart into " + std::to_string(here.count) +
             " fans, among them those of " + element(here.triangle[0]) + " and " +
             std::to_string(number(here.triangle[1]));
    });
  }
}

void SurfaceValidator::look_at_orientation(const Surface& surface, const Signs& signs) {
  std::vector<char> told(signs.orientable);
  for (int t = 0; t < element_count(); ++t) {
    if (std::exchange(told[signs.parts.of[t]], 1)) continue;
    add_element(Kind::not_orientable, t,
                [&] { return "the component of " + element(t) + " is not orientable"; });
  }
  const std::vector<char> turned = minority(signs);
  const auto upright_neighbour = [&](int t) {
    for (const Side s : sides_of(t))
      if (surface.is_turned(s)) return s;
    return Side();
  };
  for (const bool has_one : {true, false})
    for (int t = 0; t < element_count(); ++t) {
      if (!turned[t]) continue;
      const Side s = upright_neighbour(t);
      if (s.exists() != has_one) continue;
      add_element(Kind::turned, t, [&] {
        return has_one ? element(t) + " is turned against its neighbor " +
                             std::to_string(number(surface.mate(s).triangle())) + " at " + edge_name(soup_, s)
                       : element(t) + " is turned, and its neighbors with it";
      });
    }
}

void SurfaceValidator::look_at_components(const Parts& parts) {
  std::vector<int> component(static_cast<std::size_t>(parts.count));
  std::iota(component.begin(), component.end(), 0);
  for (const auto& [a, b] : joined_)
    component[numeric::find_root(component, parts.of[a])] = numeric::find_root(component, parts.of[b]);
  std::vector<char> seen(component.size(), 0);
  std::vector<int> first; ///< triangles of the components
  for (int t = 0; t < element_count(); ++t)
    if (!is_left_out(t) && !std::exchange(seen[numeric::find_root(component, parts.of[t])], 1))
      first.push_back(t);
  if (first.size() < 2) return;
  add_element(Kind::several_components, first[1], [&] {
    return "the surface falls apart into " + std::to_string(first.size()) +
           " components: " + element(first[1]) + " is not connected with " + element(first[0]);
  });
}

void SurfaceValidator::look_at_insides(const Surface& surface, const Signs& signs) {
  std::vector<char> left_out(left_out_);
  const Enclosed enclosed = enclosed_volumes(soup_, surface, signs, left_out);
  std::vector<char> told(enclosed.inside_out.size(), 0);
  for (int t = 0; t < element_count(); ++t) {
    const int part = signs.parts.of[t];
    if (!enclosed.inside_out[part] || std::exchange(told[part], 1)) continue;
    add_element(Kind::inside_out, t, [&] {
      return "the closed component of " + element(t) + " is inside out: the volume in it is " +
             format::to_text(enclosed.volume[part]);
    });
  }
}

} // namespace

Report validate_surface(const format::Soup& soup, int listed) {
  return SurfaceValidator(soup, listed).run();
}

} // namespace tetrarch::doctor
