// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/repair.hpp"

#include "edge_sweep.hpp"
#include "enclosed.hpp"
#include "findings.hpp"
#include "orient.hpp"
#include "orient_solid.hpp"
#include "soup_edit.hpp"
#include "thin_triangles.hpp"

#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/solid/face_sweep.hpp"
#include "tetrarch/solid/gluing.hpp"

#include <numeric>

namespace tetrarch::doctor {
namespace {

using solid::FaceSweep;
using solid::glue_shared_face;
using solid::SortedFace;

std::string counted(const std::string& verb, std::int64_t count, const std::string& what) {
  return verb + " " + std::to_string(count) + " " + what;
}

/// Flags all but the first of those on the same facet with the same apex, which `shared` has next to each
/// other.
template <class Facet>
void flag_duplicates(std::span<const Facet> shared, std::uint32_t corners, std::vector<char>& duplicate) {
  for (std::size_t i = 1; i < shared.size(); ++i)
    if (shared[i].apex == shared[i - 1].apex) duplicate[shared[i].code / corners] = 1;
}

void remove_duplicate_tetrahedra(Repaired& result) {
  format::Soup& soup = result.soup;
  std::vector<char> duplicate(soup.tetrahedra.size(), 0);
  FaceSweep sweep(soup.tetrahedra, soup.points.size(),
                  [&](std::size_t t) { return is_proper(soup, soup.tetrahedra[t]); });
  sweep.for_each_class([&](std::span<const SortedFace> shared) { flag_duplicates(shared, 4, duplicate); });
  const auto count = std::count(duplicate.begin(), duplicate.end(), 1);
  if (count == 0) return;
  remove_tetrahedra(soup, duplicate);
  result.done.push_back(counted("removed", count, "duplicate tetrahedra"));
}

void remove_counted(Repaired& result, const std::vector<char>& flagged, const std::string& what) {
  const auto count = std::count(flagged.begin(), flagged.end(), 1);
  if (count == 0) return;
  remove_triangles(result.soup, flagged);
  result.done.push_back(counted("removed", count, what));
}

/// Without duplicates: tetrahedra with their shared faces glued.
Triangulation glued(const format::Soup& soup, const std::vector<char>& proper) {
  Triangulation tri(static_cast<int>(soup.tetrahedra.size()));
  FaceSweep sweep(soup.tetrahedra, soup.points.size(), [&](std::size_t t) { return proper[t] != 0; });
  sweep.for_each_class([&](std::span<const SortedFace> shared) {
    if (shared.size() == 2) glue_shared_face(tri, soup.tetrahedra, shared[0].at(), shared[1].at());
  });
  return tri;
}

std::vector<char> proper_tetrahedra(const format::Soup& soup) {
  std::vector<char> proper;
  for (const auto& corners : soup.tetrahedra) proper.push_back(static_cast<char>(is_proper(soup, corners)));
  return proper;
}

void orient_solid(Repaired& result, const Triangulation& tri, const std::vector<char>& proper) {
  const std::vector<int> signs = solid_signs(result.soup, tri, proper);
  const auto count = std::count(signs.begin(), signs.end(), -1);
  if (count == 0) return;
  for (std::size_t t = 0; t < signs.size(); ++t)
    if (signs[t] < 0) std::swap(result.soup.tetrahedra[t][2], result.soup.tetrahedra[t][3]);
  result.done.push_back(
      counted("turned round", count, "tetrahedra, as the larger volume of their component says"));
}

/// The corners of elements, merged where elements are connected; then a point for each class.
template <std::size_t N>
class Corners {
public:
  explicit Corners(std::size_t elements) : parent_(N * elements) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void merge(std::size_t a, std::size_t b) {
    parent_[numeric::find_root(parent_, static_cast<int>(a))] =
        numeric::find_root(parent_, static_cast<int>(b));
  }

  /// Gives the corners of all but the first class at a point new points. Returns how many.
  std::int64_t split(format::Soup& soup, std::vector<std::array<int, N>>& elements,
                     const std::vector<char>& proper) {
    std::vector<int> first(soup.points.size(), -1); // the class that keeps the point
    std::vector<int> point_of(parent_.size(), -1);  // of other classes
    const std::size_t points = soup.points.size();
    for (std::size_t t = 0; t < elements.size(); ++t)
      for (std::size_t c = 0; c < N && proper[t]; ++c) {
        int& v = elements[t][c];
        const int root = numeric::find_root(parent_, static_cast<int>(N * t + c));
        if (first[static_cast<std::size_t>(v)] < 0) first[static_cast<std::size_t>(v)] = root;
        if (first[static_cast<std::size_t>(v)] == root) continue;
        if (point_of[root] < 0) point_of[root] = copied(soup, v);
        v = point_of[root];
      }
    return static_cast<std::int64_t>(soup.points.size() - points);
  }

private:
  /// The index of a new point, which has the number and line of the old one.
  static int copied(format::Soup& soup, int v) {
    const auto number = static_cast<int>(format::point_number(soup, v));
    const int line = soup.point_labels.line(v);
    if (soup.point_labels.numbers.size() < soup.points.size()) {
      for (std::size_t k = soup.point_labels.numbers.size(); k < soup.points.size(); ++k) {
        soup.point_labels.numbers.push_back(static_cast<int>(k) + soup.first_number);
        soup.point_labels.lines.push_back(0);
      }
    }
    const std::array<double, 3> point = soup.points[static_cast<std::size_t>(v)];
    soup.points.push_back(point);
    soup.point_labels.numbers.push_back(number);
    soup.point_labels.lines.push_back(line);
    return static_cast<int>(soup.points.size()) - 1;
  }

  std::vector<int> parent_;
};

/// Triangles follow the faces that they lie on.
void follow_faces(format::Soup& soup, const std::vector<std::array<int, 4>>& before) {
  const std::vector<ListedTriangle> list = listed_triangles(soup);
  std::vector<char> done(soup.triangles.size(), 0);
  for (std::size_t t = 0; t < before.size() && !list.empty(); ++t)
    for (std::size_t f = 0; f < 4; ++f) {
      std::array<int, 3> face{before[t][(f + 1) % 4], before[t][(f + 2) % 4], before[t][(f + 3) % 4]};
      std::sort(face.begin(), face.end());
      const auto [first, last] = on_corners(list, face);
      for (std::size_t k = first; k < last; ++k) {
        const auto index = static_cast<std::size_t>(list[k].index);
        if (std::exchange(done[index], 1)) continue;
        for (int& v : soup.triangles[index])
          v = soup.tetrahedra[t][static_cast<std::size_t>(std::find(before[t].begin(), before[t].end(), v) -
                                                          before[t].begin())];
      }
    }
}

void split_pinched_solid(Repaired& result, const Triangulation& tri, const std::vector<char>& proper) {
  format::Soup& soup = result.soup;
  Corners<4> corners(soup.tetrahedra.size());
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing gluing = tri.gluing({t, f});
      for (int v = 0; v < 4 && gluing.tet >= 0; ++v)
        if (v != f)
          corners.merge(std::size_t{4} * static_cast<std::size_t>(t) + static_cast<std::size_t>(v),
                        std::size_t{4} * static_cast<std::size_t>(gluing.tet) +
                            static_cast<std::size_t>(gluing.perm[v]));
    }
  const std::vector<std::array<int, 4>> before = soup.tetrahedra;
  const std::int64_t count = corners.split(soup, soup.tetrahedra, proper);
  if (count == 0) return;
  follow_faces(soup, before);
  result.done.push_back(counted("split off", count, "vertices where tetrahedra fell apart"));
}

/// Where three or more triangles share an edge, all of them stay together there.
void split_pinched_surface(Repaired& result) {
  format::Soup& soup = result.soup;
  Corners<3> corners(soup.triangles.size());
  std::vector<char> proper;
  for (const auto& triangle : soup.triangles) proper.push_back(static_cast<char>(is_proper(soup, triangle)));
  for_each_edge(
      soup.triangles, soup.points.size(), [&](int t) { return proper[t] != 0; },
      [&](std::span<const SortedSide> shared) {
        for (std::size_t k = 1; k < shared.size(); ++k) {
          const Side a = shared[k - 1].at();
          const Side b = shared[k].at();
          const auto corner = [](Side s, Side end) {
            return std::size_t{3} * static_cast<std::size_t>(s.triangle()) +
                   static_cast<std::size_t>(end.corner());
          };
          const auto vertex = [&](Side s, Side end) { return soup.triangles[s.triangle()][end.corner()]; };
          const bool alike = vertex(a, a.next()) == vertex(b, b.next());
          corners.merge(corner(a, a.next()), corner(b, alike ? b.next() : b.previous()));
          corners.merge(corner(a, a.previous()), corner(b, alike ? b.previous() : b.next()));
        }
      });
  const std::int64_t count = corners.split(soup, soup.triangles, proper);
  if (count > 0) result.done.push_back(counted("split off", count, "vertices where triangles fell apart"));
}

void remove_degenerate(Repaired& result) {
  const auto& triangles = result.soup.triangles;
  std::vector<char> degenerate(triangles.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    degenerate[t] = static_cast<char>(in_range(result.soup, triangles[t]) && has_repeated(triangles[t]));
  remove_counted(result, degenerate, "degenerate triangles");
}

void remove_duplicate_triangles(Repaired& result) {
  const format::Soup& soup = result.soup;
  std::vector<char> duplicate(soup.triangles.size(), 0);
  for_each_edge(
      soup.triangles, soup.points.size(), [&](int t) { return is_proper(soup, soup.triangles[t]); },
      [&](std::span<const SortedSide> shared) { flag_duplicates(shared, 3, duplicate); });
  remove_counted(result, duplicate, "duplicate triangles");
}

bool all_finite(const format::Soup& soup) {
  return std::all_of(soup.points.begin(), soup.points.end(), is_finite);
}

/// The triangles are oriented by now, and those that were not proper are gone.
void mend_thin(Repaired& result) {
  format::Soup& soup = result.soup;
  const auto is_fit = [&soup](const auto& triangle) { return is_proper(soup, triangle); };
  if (!all_finite(soup) || !std::all_of(soup.triangles.begin(), soup.triangles.end(), is_fit)) return;
  const ThinMended mended = mend_thin_triangles(soup);
  if (mended.collapsed > 0) result.done.push_back(counted("collapsed", mended.collapsed, "edges of needles"));
  if (mended.flipped > 0) result.done.push_back(counted("flipped", mended.flipped, "edges behind caps"));
  if (mended.removed > 0) result.done.push_back(counted("removed", mended.removed, "caps at the boundary"));
  if (mended.ended_early) result.done.emplace_back("left thin triangles for another repair");
}

/// The triangles are oriented by now.
void turn_inside_out(Repaired& result, const Surface& surface, const Signs& signs) {
  format::Soup& soup = result.soup;
  if (!all_finite(soup)) return;
  std::vector<char> left_out;
  for (const auto& corners : soup.triangles) left_out.push_back(static_cast<char>(!in_range(soup, corners)));
  const std::vector<char> bad = oriented_inside_out(soup, surface, signs, left_out);
  std::int64_t count = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (bad[signs.parts.of[t]]) {
      std::swap(soup.triangles[t][1], soup.triangles[t][2]);
      ++count;
    }
  if (count > 0) result.done.push_back(counted("turned round", count, "triangles of components inside out"));
}

/// Without degenerate and duplicate triangles.
void orient(Repaired& result) {
  format::Soup& soup = result.soup;
  Mates mates(soup.triangles);
  for_each_edge(
      soup.triangles, soup.points.size(), [&](int t) { return in_range(soup, soup.triangles[t]); },
      [&](std::span<const SortedSide> shared) {
        if (shared.size() == 2) mates.glue(shared[0].at(), shared[1].at());
      });
  const Surface surface = std::move(mates).surface();
  const Signs signs = signs_of(surface);
  const std::vector<char> turned = minority(signs);
  const auto turn = [&soup](std::size_t t) { std::swap(soup.triangles[t][1], soup.triangles[t][2]); };
  const auto count = std::count(turned.begin(), turned.end(), 1);
  for (std::size_t t = 0; t < turned.size(); ++t)
    if (turned[t]) turn(t);
  if (count > 0) result.done.push_back(counted("turned round", count, "triangles against their component"));
  turn_inside_out(result, surface, signs);
}

} // namespace

Repaired split_pinches(format::Soup surface) {
  Repaired result{std::move(surface), {}};
  split_pinched_surface(result);
  return result;
}

Repaired repair(format::Soup soup) {
  Repaired result{std::move(soup), {}};
  const bool is_surface = result.soup.tetrahedra.empty();
  if (is_surface) {
    remove_degenerate(result);
    remove_duplicate_triangles(result);
    orient(result);
    split_pinched_surface(result);
    mend_thin(result);
  } else {
    remove_duplicate_tetrahedra(result);
    const std::vector<char> proper = proper_tetrahedra(result.soup);
    orient_solid(result, glued(result.soup, proper), proper);
    // Again, for their last two corners may be exchanged now.
    split_pinched_solid(result, glued(result.soup, proper), proper);
  }
  const std::size_t triangles = result.soup.triangles.size();
  const std::int64_t unused = remove_unused_points(result.soup);
  const std::size_t stray = triangles - result.soup.triangles.size();
  if (unused > 0) result.done.push_back(counted("removed", unused, "unused vertices"));
  if (stray > 0)
    result.done.push_back(counted("removed", static_cast<std::int64_t>(stray), "triangles on such vertices"));
  return result;
}

} // namespace tetrarch::doctor
