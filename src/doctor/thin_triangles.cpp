// SPDX-License-Identifier: GPL-2.0-or-later
#include "thin_triangles.hpp"

#include "soup_edit.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace tetrarch::doctor {
namespace {

using numeric::Point;
using numeric::Vector;
using TriangleCorners = std::array<int, 3>;

/// Of the longest edge: below, a needle's edge is collapsed; above, it is a cap.
constexpr double needle = 1e-9;

class ThinMender {
public:
  explicit ThinMender(format::Soup& soup)
      : soup_(soup), gone_(soup.triangles.size(), 0), around_(soup.points.size()) {}

  ThinMended run() {
    for (int t = 0; t < static_cast<int>(soup_.triangles.size()); ++t)
      if (is_thin_now(t)) waiting_.push_back(t);
    if (waiting_.empty()) return {};
    for (int t = 0; t < static_cast<int>(soup_.triangles.size()); ++t)
      for (const int v : corners(t)) add(t, v);
    // A flip may leave another thin triangle behind, and so on along a line.
    std::size_t budget = 20 * waiting_.size();
    for (; !waiting_.empty() && budget > 0; --budget) {
      const int t = waiting_.front();
      waiting_.pop_front();
      if (!gone_[t] && is_thin_now(t)) mend(t);
    }
    mended_.ended_early = !waiting_.empty();
    remove_triangles(soup_, gone_);
    return mended_;
  }

private:
  const TriangleCorners& corners(int t) const { return soup_.triangles[static_cast<std::size_t>(t)]; }
  const Point& point(int v) const { return soup_.points[static_cast<std::size_t>(v)]; }
  void add(int t, int v) { around_[static_cast<std::size_t>(v)].push_back(t); }
  /// The triangles at v. Those that have left v are dropped here, when the list is read, not one by one when
  /// they leave: a vertex may have very many.
  const std::vector<int>& at(int v) {
    std::vector<int>& list = around_[static_cast<std::size_t>(v)];
    std::erase_if(list, [&](int t) { return gone_[t] || !has(t, v); });
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }
  bool is_thin_now(int t) const {
    const auto& [a, b, c] = corners(t);
    return is_thin(point(a), point(b), point(c));
  }
  bool has(int t, int v) const {
    return std::find(corners(t).begin(), corners(t).end(), v) != corners(t).end();
  }

  /// The triangles on an edge.
  std::vector<int> on_edge(int u, int v) {
    const std::size_t of_u = around_[static_cast<std::size_t>(u)].size();
    const std::size_t of_v = around_[static_cast<std::size_t>(v)].size();
    std::vector<int> found;
    for (const int t : of_u < of_v ? at(u) : at(v))
      if (has(t, u) && has(t, v)) found.push_back(t);
    return found;
  }
  struct Neighborhood {
    std::vector<int> vertices; ///< increasing
    bool is_open = false;      ///< the vertex lies on the boundary
  };
  Neighborhood neighborhood(int v) {
    Neighborhood found;
    std::vector<int>& all =
        found.vertices; // each as often as there are triangles on the edge that leads to it
    for (const int t : at(v))
      for (const int w : corners(t))
        if (w != v) all.push_back(w);
    std::sort(all.begin(), all.end());
    auto end = all.begin();
    for (auto first = all.begin(); first != all.end();) {
      const int w = *first;
      const auto last = std::upper_bound(first, all.end(), w);
      found.is_open = found.is_open || last - first == 1;
      *end++ = w;
      first = last;
    }
    all.erase(end, all.end());
    return found;
  }

  void take_away(int t) { gone_[t] = 1; }
  void set(int t, const TriangleCorners& now) {
    soup_.triangles[static_cast<std::size_t>(t)] = now;
    for (const int v : now) add(t, v);
    if (is_thin_now(t)) waiting_.push_back(t);
  }
  /// The two other corners of t, increasing.
  std::pair<int, int> across(int t, int v) const {
    const auto& c = corners(t);
    const auto k = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
    return std::minmax({c[(k + 1) % 3], c[(k + 2) % 3]});
  }

  Vector normal_of(const TriangleCorners& c) const {
    using namespace numeric;
    return cross(point(c[1]) - point(c[0]), point(c[2]) - point(c[0]));
  }

  void mend(int t) {
    using namespace numeric;
    TriangleCorners c = corners(t); // turned until its longest edge runs from the first corner to the second
    std::array<double, 3> length_of{};
    for (std::size_t k = 0; k < 3; ++k) length_of[k] = length(point(c[(k + 1) % 3]) - point(c[k]));
    const auto longest = std::max_element(length_of.begin(), length_of.end()) - length_of.begin();
    const auto shortest = std::min_element(length_of.begin(), length_of.end()) - length_of.begin();
    if (length_of[shortest] <= needle * length_of[longest] && collapse(c[shortest], c[(shortest + 1) % 3]))
      return;
    std::rotate(c.begin(), c.begin() + longest, c.end());
    const std::vector<int> beside = on_edge(c[0], c[1]);
    if (beside.size() == 1) remove_cap(t, c);
    if (beside.size() == 2) flip(t, beside[0] == t ? beside[1] : beside[0], c);
  }

  /// By the link condition: what the surface is glued like does not change.
  bool collapse(int u, int v) {
    const std::vector<int> sides = on_edge(u, v);
    if (sides.empty() || sides.size() > 2) return false;
    const Neighborhood of_u = neighborhood(u);
    const Neighborhood of_v = neighborhood(v);
    if (sides.size() == 2 && of_u.is_open && of_v.is_open) return false;
    std::vector<int> common;
    std::set_intersection(of_u.vertices.begin(), of_u.vertices.end(), of_v.vertices.begin(),
                          of_v.vertices.end(), std::back_inserter(common));
    if (common.size() != sides.size() || at(u).size() + at(v).size() <= 2 * sides.size()) return false;
    const int kept = of_u.is_open == of_v.is_open ? std::min(u, v) : of_u.is_open ? u : v;
    const int other = kept == u ? v : u;
    std::vector<std::pair<int, int>> there;
    for (const int t : at(kept)) there.push_back(across(t, kept));
    std::sort(there.begin(), there.end());
    std::vector<std::pair<int, TriangleCorners>> changed;
    for (const int t : at(other)) {
      if (has(t, kept)) continue;
      TriangleCorners now = corners(t);
      std::replace(now.begin(), now.end(), other, kept);
      if (!is_thin_now(t) && !(numeric::dot(normal_of(corners(t)), normal_of(now)) > 0)) return false;
      if (std::binary_search(there.begin(), there.end(), across(t, other))) return false;
      changed.emplace_back(t, now);
    }
    for (const int t : sides) take_away(t);
    for (const auto& [t, now] : changed) set(t, now);
    ++mended_.collapsed;
    return true;
  }

  /// `c`: the corners of t, the first two on the longest edge, behind which `other` lies.
  void flip(int t, int other, const TriangleCorners& c) {
    const auto& theirs = corners(other);
    const int d = *std::find_if(theirs.begin(), theirs.end(), [&](int v) { return v != c[0] && v != c[1]; });
    if (d == c[2] || !on_edge(c[2], d).empty()) return;
    const TriangleCorners first{c[0], d, c[2]};
    const TriangleCorners second{d, c[1], c[2]};
    const Vector before = normal_of(theirs);
    const bool turns = !is_thin_now(other) && (numeric::dot(before, normal_of(first)) < 0 ||
                                               numeric::dot(before, normal_of(second)) < 0);
    if (turns) return;
    set(t, first);
    set(other, second);
    ++mended_.flipped;
  }

  /// Where the cap's vertex lies on the boundary, too, its triangle would be all that holds it together.
  void remove_cap(int t, const TriangleCorners& c) {
    const bool is_ear = on_edge(c[1], c[2]).size() == 1 || on_edge(c[2], c[0]).size() == 1;
    const bool is_alone = on_edge(c[1], c[2]).size() == 1 && on_edge(c[2], c[0]).size() == 1;
    if (is_alone || (!is_ear && neighborhood(c[2]).is_open)) return;
    take_away(t);
    ++mended_.removed;
  }

  format::Soup& soup_;
  std::vector<char> gone_;
  std::vector<std::vector<int>> around_; ///< the triangles at each point
  std::deque<int> waiting_;
  ThinMended mended_;
};

} // namespace

bool is_thin(const Point& a, const Point& b, const Point& c) {
  using namespace numeric;
  // The sine of the least angle, squared, from products that neither underflow nor overflow: for nearly all.
  const Vector normal = cross(b - a, c - a);
  std::array<double, 3> squares{dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)};
  std::sort(squares.begin(), squares.end());
  const double product = squares[1] * squares[2];
  constexpr double certainly = 1e-18;
  constexpr double least_product = 1e-200;
  if (product > least_product && std::isfinite(product) && dot(normal, normal) > certainly * product)
    return false;
  constexpr double greatest = 1e10;
  // Written so that NaN, from three points in one place, is thin.
  return !(std::abs(cotangent(a, b, c)) < greatest && std::abs(cotangent(b, c, a)) < greatest &&
           std::abs(cotangent(c, a, b)) < greatest);
}

ThinMended mend_thin_triangles(format::Soup& soup) {
  return ThinMender(soup).run();
}

} // namespace tetrarch::doctor
