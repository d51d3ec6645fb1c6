// SPDX-License-Identifier: GPL-2.0-or-later
#include "links.hpp"

#include "inverse.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tetrarch::checker {
namespace {

using Vector3 = std::array<Interval, 3>;

Vector3 sum(const Interval& a, const Vector3& x, const Interval& b, const Vector3& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

Vector3 cross(const Vector3& x, const Vector3& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

int edge_between(int a, int b) {
  for (int e = 0; e < 6; ++e)
    if (ends_of_edge[e] == std::array{std::min(a, b), std::max(a, b)}) return e;
  return -1;
}

/// One triangle of a link in the unit sphere: directions towards the other three vertices.
struct Placed {
  int tet = 0;
  int at = 0; ///< the vertex of the tetrahedron
  std::array<Vector3, 4> towards{};
  /// Facing along the direction to a, the one to c lies to the left of the one to b where left[a][b], for c
  /// the third.
  std::array<std::array<bool, 4>, 4> left{};
};

/// Lays out the link of one vertex.
class Layout {
public:
  explicit Layout(const OnBox& box) : box_(box) {}

  /// The direction of each end of an edge, by the end's number.
  std::map<int, std::pair<int, Vector3>> directions(int vertex) {
    std::map<int, std::pair<int, Vector3>> found; // with the edge's class
    std::vector<Placed> placed{first(vertex)};
    std::set<std::pair<int, int>> seen{{placed[0].tet, placed[0].at}};
    for (std::size_t k = 0; k < placed.size(); ++k)
      for (int w = 0; w < 4; ++w) {
        const Placed here = placed[k];
        if (w == here.at) continue;
        found.try_emplace(box_.classes.end[here.tet][here.at][w],
                          box_.classes.edge[here.tet][edge_between(here.at, w)], here.towards[w]);
        const FaceGluing& g = box_.gluings[here.tet][w];
        if (seen.insert({g.tet, g.images[here.at]}).second) placed.push_back(beyond(here, w, g));
      }
    return found;
  }

private:
  Placed first(int vertex) {
    Placed p;
    for (; p.tet < static_cast<int>(box_.gluings.size()); ++p.tet)
      for (p.at = 0; p.at < 4; ++p.at)
        if (box_.classes.vertex[p.tet][p.at] == vertex) {
          const int a = p.at == 0 ? 1 : 0;
          const int b = p.at <= 1 ? 2 : 1;
          const Interval c = cosine(p, a, b);
          p.towards[a] = {1, 0, 0};
          p.towards[b] = {c, sqrt(1 - c * c), 0};
          place_third(p, a, b, true);
          return p;
        }
    return p;
  }

  /// Over the side opposite w; the new corner lies on the other side of it.
  Placed beyond(const Placed& here, int w, const FaceGluing& g) {
    std::array<int, 2> shared{};
    std::size_t count = 0;
    for (int k = 0; k < 4; ++k)
      if (k != here.at && k != w) shared[count++] = k;
    const auto [a, b] = shared;
    Placed p;
    p.tet = g.tet;
    p.at = g.images[here.at];
    p.towards[g.images[a]] = here.towards[a];
    p.towards[g.images[b]] = here.towards[b];
    place_third(p, g.images[a], g.images[b], !here.left[a][b]);
    return p;
  }

  Interval cosine(const Placed& p, int a, int b) const {
    return corner_side(lengths(p.tet), kinds(p.tet), p.at, a, b);
  }

  /// From a, as far as the face's angle says, turned from b by the dihedral angle.
  void place_third(Placed& p, int a, int b, bool left) {
    const int c = 6 - p.at - a - b;
    const Interval ab = cosine(p, a, b);
    const Interval ac = cosine(p, a, c);
    const Vector3& x = p.towards[a];
    const Interval stretch = 1 / sqrt(1 - ab * ab);
    const Vector3 forward = sum(stretch, p.towards[b], -ab * stretch, x);
    const Vector3 sideways = cross(x, forward);
    const Interval& angle = box_.angles[p.tet][edge_between(p.at, a)];
    const Vector3 tangent = sum(cos(angle), forward, left ? sin(angle) : -sin(angle), sideways);
    p.towards[c] = sum(ac, x, sqrt(1 - ac * ac), tangent);
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      p.left[i][j] = left;
      p.left[j][i] = !left;
    }
  }

  std::array<Interval, 6> lengths(int tet) const {
    std::array<Interval, 6> six;
    for (int e = 0; e < 6; ++e) six[e] = box_.lengths[box_.classes.edge[tet][e]];
    return six;
  }
  Corners kinds(int tet) const { return kinds_at(box_.classes, tet); }

  const OnBox& box_;
};

} // namespace

std::vector<std::vector<Interval>> identities(const OnBox& box, const std::vector<int>& edges,
                                              int& most_ends) {
  std::vector<std::vector<Interval>> lines;
  most_ends = 0;
  for (std::size_t v = 0; v < box.classes.link.size(); ++v) {
    const std::vector<Interval> zero(edges.size());
    if (box.classes.link[v] == 0) {
      lines.push_back(zero);
      for (std::size_t k = 0; k < edges.size(); ++k)
        for (const int end : box.classes.ends[edges[k]])
          if (end == static_cast<int>(v)) lines.back()[k] = lines.back()[k] + 1;
    }
    if (box.classes.link[v] != 2) continue;
    lines.insert(lines.end(), 3, zero);
    int ends = 0;
    for (const auto& [end, direction] : Layout(box).directions(static_cast<int>(v))) {
      const auto at = std::find(edges.begin(), edges.end(), direction.first);
      if (at == edges.end()) continue;
      ++ends;
      for (std::size_t k = 0; k < 3; ++k) {
        Interval& entry = lines[lines.size() - 3 + k][at - edges.begin()];
        entry = entry + direction.second[k];
      }
    }
    most_ends = std::max(most_ends, ends);
  }
  return lines;
}

bool dropped_vanish(const OnBox& box, const std::vector<int>& dropped) {
  int ends = 0;
  const auto m = identities(box, dropped, ends);
  if (m.size() != dropped.size()) return false;
  std::vector<std::vector<double>> middle;
  for (const auto& line : m) {
    middle.emplace_back();
    for (const Interval& x : line) middle.back().push_back(x.nearest_double());
  }
  const auto y = inverse(middle);
  if (!y) return false;
  Interval largest;
  for (const int c : dropped) largest = hull(largest, abs(box.curvature[c]));
  largest = largest.upper_end();
  if (!less_equal(ends * largest, 2)) return false;
  // K = (1 - Y M) K + Y (M K), and |M K| <= (n |K|)^2 / 2: impossible for the greatest |K| unless it is 0.
  for (std::size_t i = 0; i < m.size(); ++i) {
    Interval part;
    for (std::size_t j = 0; j < m.size(); ++j) {
      Interval entry = i == j ? 1 : 0;
      for (std::size_t k = 0; k < m.size(); ++k) entry = entry - (*y)[i][k] * m[k][j];
      part = part + abs(entry) + std::abs((*y)[i][j]) * largest * (ends * ends) / 2;
    }
    if (!less(part, 1)) return false;
  }
  return true;
}

} // namespace tetrarch::checker
