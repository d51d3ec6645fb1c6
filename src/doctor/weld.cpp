// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/weld.hpp"

#include "edge_sweep.hpp"
#include "findings.hpp"
#include "soup_edit.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/solid/face_sweep.hpp"

#include <cmath>
#include <numeric>
#include <unordered_map>

namespace tetrarch::doctor {
namespace {

using solid::FaceSweep;
using solid::SortedFace;

using Point = std::array<double, 3>;
using Cell = std::array<double, 3>;

struct HashCell {
  std::size_t operator()(const Cell& cell) const {
    std::size_t hash = 0;
    for (const double x : cell)
      hash = (hash ^ std::hash<double>()(x + 0.0)) * 0x9e3779b97f4a7c15U + (hash >> 29); // -0 is 0
    return hash;
  }
};

/// The points that others become, in cells as wide as the tolerance.
class Representatives {
public:
  Representatives(const std::vector<Point>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}

  /// The first representative within the tolerance of point v, which is v itself if there is none.
  int of(int v) {
    const Point& p = points_[static_cast<std::size_t>(v)];
    if (tolerance_ == 0) {
      Cell exact = p;
      for (double& x : exact) x += 0.0;
      return cells_.try_emplace(exact, std::vector<int>{v}).first->second.front();
    }
    Cell middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = std::floor(p[axis] / tolerance_);
    int best = -1;
    for (int k = 0; k < 27; ++k) {
      const std::array<int, 3> step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
      const Cell cell{middle[0] + step[0], middle[1] + step[1], middle[2] + step[2]};
      const auto found = cells_.find(cell);
      if (found == cells_.end()) continue;
      for (const int w : found->second)
        if ((best < 0 || w < best) && is_near(p, points_[static_cast<std::size_t>(w)])) best = w;
    }
    if (best >= 0) return best;
    cells_[middle].push_back(v);
    return v;
  }

private:
  bool is_near(const Point& p, const Point& q) const {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= tolerance_;
  }

  const std::vector<Point>& points_;
  double tolerance_;
  std::unordered_map<Cell, std::vector<int>, HashCell> cells_;
};

/// Flags elements that had no vertex twice and have one now.
template <std::size_t N>
std::vector<char> rename(const format::Soup& soup, std::vector<std::array<int, N>>& elements,
                         const std::vector<int>& target) {
  std::vector<char> collapsed(elements.size(), 0);
  for (std::size_t t = 0; t < elements.size(); ++t) {
    if (!in_range(soup, elements[t])) continue;
    const bool before = has_repeated(elements[t]);
    for (int& v : elements[t]) v = target[static_cast<std::size_t>(v)];
    collapsed[t] = static_cast<char>(!before && has_repeated(elements[t]));
  }
  return collapsed;
}

void tell(Repaired& result, const char* verb, std::int64_t count, const char* what) {
  if (count > 0) result.done.push_back(std::string(verb) + " " + std::to_string(count) + " " + what);
}

/// The component of each element, numbered by its first one; -1 for elements at fault.
std::vector<int> numbered(std::vector<int> parent, const std::vector<char>& proper, int& count) {
  std::vector<int> number(parent.size(), -1);
  std::vector<int> of(parent.size(), -1);
  count = 0;
  for (std::size_t t = 0; t < parent.size(); ++t) {
    if (!proper[t]) continue;
    int& own = number[static_cast<std::size_t>(numeric::find_root(parent, static_cast<int>(t)))];
    if (own < 0) own = count++;
    of[t] = own;
  }
  return of;
}

std::vector<int> components_of(const format::Soup& soup, int& count) {
  const bool is_solid = !soup.tetrahedra.empty();
  const std::size_t size = is_solid ? soup.tetrahedra.size() : soup.triangles.size();
  std::vector<char> proper(size, 0);
  for (std::size_t t = 0; t < size; ++t)
    proper[t] = static_cast<char>(is_solid ? is_proper(soup, soup.tetrahedra[t])
                                           : is_proper(soup, soup.triangles[t]));
  std::vector<int> parent(size);
  std::iota(parent.begin(), parent.end(), 0);
  const auto join = [&parent](int a, int b) {
    parent[numeric::find_root(parent, b)] = numeric::find_root(parent, a);
  };
  if (is_solid) {
    FaceSweep sweep(soup.tetrahedra, soup.points.size(), [&](std::size_t t) { return proper[t] != 0; });
    sweep.for_each_class([&](std::span<const SortedFace> shared) {
      for (const SortedFace& f : shared) join(shared.front().at().tet, f.at().tet);
    });
  } else {
    for_each_edge(
        soup.triangles, soup.points.size(), [&](int t) { return proper[t] != 0; },
        [&](std::span<const SortedSide> shared) {
          for (const SortedSide& s : shared) join(shared.front().at().triangle(), s.at().triangle());
        });
  }
  return numbered(std::move(parent), proper, count);
}

/// The triangles that are no faces of the tetrahedra.
std::vector<char> stray_triangles(const format::Soup& soup) {
  std::vector<char> stray(soup.triangles.size(), 1);
  const std::vector<ListedTriangle> list = listed_triangles(soup);
  for (const auto& corners : soup.tetrahedra)
    for (std::size_t f = 0; f < 4 && !list.empty(); ++f) {
      std::array<int, 3> face{corners[(f + 1) % 4], corners[(f + 2) % 4], corners[(f + 3) % 4]};
      std::sort(face.begin(), face.end());
      const auto [first, last] = on_corners(list, face);
      for (std::size_t k = first; k < last; ++k) stray[static_cast<std::size_t>(list[k].index)] = 0;
    }
  return stray;
}

} // namespace

Repaired weld(format::Soup soup, double tolerance) {
  if (!(tolerance >= 0)) throw PreconditionError("weld: the tolerance is negative or no number");
  Repaired result{std::move(soup), {}};
  format::Soup& all = result.soup;
  Representatives representatives(all.points, tolerance);
  std::vector<int> target(all.points.size());
  std::vector<char> gone(all.points.size(), 0);
  for (int v = 0; v < static_cast<int>(target.size()); ++v) {
    target[v] = is_finite(all.points[static_cast<std::size_t>(v)]) ? representatives.of(v) : v;
    gone[v] = static_cast<char>(target[v] != v);
  }
  const auto welded = std::count(gone.begin(), gone.end(), 1);
  if (welded == 0) return result;
  const std::vector<char> flat = rename(all, all.tetrahedra, target);
  const std::vector<char> thin = rename(all, all.triangles, target);
  remove_tetrahedra(all, flat);
  remove_triangles(all, thin);
  tell(result, "welded", welded, "vertices to others");
  tell(result, "removed", std::count(flat.begin(), flat.end(), 1), "tetrahedra that collapsed");
  tell(result, "removed", std::count(thin.begin(), thin.end(), 1), "triangles that collapsed");
  std::vector<int> index(target.size(), -1);
  int next = 0;
  for (std::size_t v = 0; v < index.size(); ++v)
    if (!gone[v]) index[v] = next++;
  const auto renumber = [&](auto& elements) {
    for (auto& corners : elements)
      for (int& v : corners)
        v = v >= 0 && static_cast<std::size_t>(v) < index.size() ? index[static_cast<std::size_t>(v)] : v;
  };
  renumber(all.tetrahedra);
  renumber(all.triangles);
  remove_flagged(all.points, all.point_labels, all.first_number, gone);
  return result;
}

int component_count(const format::Soup& soup) {
  int count = 0;
  components_of(soup, count);
  return count;
}

format::Soup component(format::Soup soup, int k) {
  int count = 0;
  const std::vector<int> of = components_of(soup, count);
  if (k < 0 || k >= count)
    throw InputError(Place{soup.source, 0}, "there is no component " + std::to_string(k) + ": there are " +
                                                std::to_string(count) + ", counted from 0");
  std::vector<char> other(of.size(), 0);
  for (std::size_t t = 0; t < of.size(); ++t) other[t] = static_cast<char>(of[t] != k);
  if (soup.tetrahedra.empty()) {
    remove_triangles(soup, other);
  } else {
    remove_tetrahedra(soup, other);
    remove_triangles(soup, stray_triangles(soup));
  }
  remove_unused_points(soup);
  return soup;
}

} // namespace tetrarch::doctor
