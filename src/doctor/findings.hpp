// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What validators of tetrahedra and of triangles have in common: elements that name N points each.

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/validate.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::doctor {

inline bool is_finite(const std::array<double, 3>& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// The elements of a soup that a validator looks at, and what one and several of them are called.
template <std::size_t N>
struct Elements {
  const std::vector<std::array<int, N>>& corners;
  const format::Labels& labels;
  const char* noun;
  const char* plural;
};

template <std::size_t N>
class Findings {
protected:
  Findings(const format::Soup& soup, const Elements<N>& elements, int listed)
      : soup_(soup), elements_(elements), listed_(listed), left_out_(elements.corners.size(), 0),
        used_(soup.points.size(), 0) {}

  template <class Text>
  void add(Kind kind, long long number, int line, Text text) {
    if (report_.counts[static_cast<std::size_t>(kind)]++ < listed_)
      report_.findings.push_back({kind, number, line, text()});
  }
  template <class Text>
  void add_element(Kind kind, int t, Text text) {
    add(kind, number(t), elements_.labels.line(t), text);
  }
  template <class Text>
  void add_vertex(Kind kind, int v, Text text) {
    add(kind, format::point_number(soup_, v), soup_.point_labels.line(v), text);
  }

  const std::array<int, N>& corners(int t) const { return elements_.corners[static_cast<std::size_t>(t)]; }
  const std::array<double, 3>& point(int v) const { return soup_.points[static_cast<std::size_t>(v)]; }
  bool is_left_out(int t) const { return left_out_[static_cast<std::size_t>(t)] != 0; }
  int element_count() const { return static_cast<int>(elements_.corners.size()); }
  long long number(int t) const { return elements_.labels.number(t, soup_.first_number); }
  std::string element(int t) const { return elements_.noun + (" " + std::to_string(number(t))); }
  std::string name(int v) const { return std::to_string(format::point_number(soup_, v)); }
  std::string vertex(int v) const { return "vertex " + name(v); }

  void look_at_points();
  /// Leaves out the elements with an index out of range or, as `repeated`, a vertex twice.
  void look_at_corners(int t, Kind repeated);
  void look_at_use();
  /// Used points of equal coordinates; -0 is 0. O(n log n).
  void look_at_coincidence();
  /// Of the facets on one set of points, those of different elements; duplicates are left out from here on.
  template <class Facet>
  void find_different(std::span<const Facet> shared, std::vector<Facet>& different);
  /// If three or more elements share a facet: it is called `facet`, "the edge on vertices 1, 2".
  template <class Facet>
  void add_shared(Kind kind, const std::string& facet, std::vector<Facet>& different);

  Report finish() {
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
    return std::move(report_);
  }

  const format::Soup& soup_;
  Elements<N> elements_;
  std::int64_t listed_;
  std::vector<char> left_out_; ///< elements at fault by themselves
  std::vector<char> used_;     ///< points that some element names
  Report report_;
};

template <std::size_t N>
void Findings<N>::look_at_points() {
  for (int v = 0; v < static_cast<int>(soup_.points.size()); ++v) {
    if (is_finite(point(v))) continue;
    std::size_t axis = 0;
    while (std::isfinite(point(v)[axis])) ++axis;
    add_vertex(Kind::not_finite, v, [&] {
      return std::string("coordinate ") + "xyz"[axis] + " of " + vertex(v) + " is " +
             format::to_text(point(v)[axis]) + ", expected a finite number";
    });
  }
}

template <std::size_t N>
void Findings<N>::look_at_corners(int t, Kind repeated) {
  char& left_out = left_out_[static_cast<std::size_t>(t)];
  for (const int v : corners(t)) {
    if (v >= 0 && static_cast<std::size_t>(v) < soup_.points.size()) {
      used_[static_cast<std::size_t>(v)] = 1;
    } else if (!left_out) {
      left_out = 1;
      add_element(Kind::index_out_of_range, t, [&] {
        return element(t) + " names " + vertex(v) + ", which is none of the " +
               std::to_string(soup_.points.size()) + " there are";
      });
    }
  }
  for (auto v = corners(t).begin(); v != corners(t).end() && !left_out; ++v) {
    if (std::find(v + 1, corners(t).end(), *v) == corners(t).end()) continue;
    left_out = 1;
    add_element(repeated, t, [&] { return element(t) + " names " + vertex(*v) + " twice"; });
  }
}

template <std::size_t N>
void Findings<N>::look_at_use() {
  for (int v = 0; v < static_cast<int>(used_.size()); ++v)
    if (!used_[static_cast<std::size_t>(v)])
      add_vertex(Kind::unused_vertex, v, [&] { return vertex(v) + " is in no " + elements_.noun; });
}

template <std::size_t N>
void Findings<N>::look_at_coincidence() {
  std::vector<int> order;
  for (int v = 0; v < static_cast<int>(used_.size()); ++v)
    if (used_[static_cast<std::size_t>(v)] && is_finite(point(v))) order.push_back(v);
  std::sort(order.begin(), order.end(),
            [this](int a, int b) { return point(a) != point(b) ? point(a) < point(b) : a < b; });
  std::vector<std::array<int, 2>> coincident; // a vertex and the first one there
  for (std::size_t first = 0, k = 1; k < order.size(); ++k) {
    if (point(order[k]) == point(order[first]))
      coincident.push_back({order[k], order[first]});
    else
      first = k;
  }
  std::sort(coincident.begin(), coincident.end());
  for (const auto& [v, first] : coincident)
    add_vertex(Kind::coincident_vertex, v,
               [&, v = v, first = first] { return vertex(v) + " coincides with " + vertex(first); });
}

template <std::size_t N>
template <class Facet>
void Findings<N>::find_different(std::span<const Facet> shared, std::vector<Facet>& different) {
  different.clear();
  for (const Facet& facet : shared) {
    const int t = static_cast<int>(facet.code / N);
    if (is_left_out(t)) continue;
    // Of the facets of an element, the one without its largest vertex comes first in the sweep. So duplicates
    // meet there, next to each other, and are left out at their other facets.
    if (!different.empty() && different.back().apex == facet.apex) {
      left_out_[static_cast<std::size_t>(t)] = 1;
      add_element(Kind::duplicate, t, [&] {
        return element(t) + " has the same vertices as " +
               element(static_cast<int>(different.back().code / N));
      });
    } else {
      different.push_back(facet);
    }
  }
}

template <std::size_t N>
template <class Facet>
void Findings<N>::add_shared(Kind kind, const std::string& facet, std::vector<Facet>& different) {
  std::sort(different.begin(), different.end(),
            [](const Facet& a, const Facet& b) { return a.code < b.code; });
  const auto t = [&](std::size_t k) { return static_cast<int>(different[k].code / N); };
  add_element(kind, t(2), [&] {
    return facet + " is shared by " + std::to_string(different.size()) + " " + elements_.plural +
           ", among them " + std::to_string(number(t(0))) + ", " + std::to_string(number(t(1))) + ", " +
           std::to_string(number(t(2)));
  });
}

/// Throws InputError with the first finding of a kind for which `keeps(kind)` holds, the number of the others
/// of such kinds, and a hint what to do.
template <class Keeps>
void refuse(const format::Soup& soup, const Report& report, Keeps keeps, const std::string& hint = "") {
  const auto first = std::find_if(report.findings.begin(), report.findings.end(),
                                  [&](const Finding& finding) { return keeps(finding.kind); });
  if (first == report.findings.end()) return;
  std::int64_t others = -1;
  for (int k = 0; k < kind_count; ++k)
    if (keeps(static_cast<Kind>(k))) others += report.counts[static_cast<std::size_t>(k)];
  const std::string more = others > 0 ? " (and " + std::to_string(others) + " more)" : "";
  throw InputError(place_of(*first, soup), first->text + more + hint);
}

} // namespace tetrarch::doctor
