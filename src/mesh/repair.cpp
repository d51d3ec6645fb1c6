// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/repair.hpp"

#include "edge_sweep.hpp"
#include "face_sweep.hpp"
#include "findings.hpp"
#include "orient.hpp"

#include "tetrarch/mesh/volume_sign.hpp"

namespace tetrarch::mesh {
namespace {

/// The elements whose flag is not set, with their labels.
template <class Elements>
void remove_flagged(Elements& elements, format::Labels& labels, int first_number,
                    const std::vector<char>& flagged) {
  format::Labels kept;
  std::size_t size = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (flagged[i]) continue;
    elements[size++] = elements[i];
    const auto index = static_cast<std::int64_t>(i);
    kept.numbers.push_back(static_cast<int>(labels.number(index, first_number)));
    kept.lines.push_back(labels.line(index));
  }
  elements.resize(size);
  labels = std::move(kept);
}

void remove_flagged_tags(std::vector<int>& tags, const std::vector<char>& flagged) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tags.size(); ++t)
    if (!flagged[t]) tags[kept++] = tags[t];
  tags.resize(kept);
}

template <std::size_t N>
bool in_range(const format::Soup& soup, const std::array<int, N>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < soup.points.size(); });
}

template <std::size_t N>
bool has_repeated(std::array<int, N> corners) {
  std::sort(corners.begin(), corners.end());
  return std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

template <std::size_t N>
bool is_proper(const format::Soup& soup, const std::array<int, N>& corners) {
  return in_range(soup, corners) && !has_repeated(corners);
}

bool is_inverted(const format::Soup& soup, const std::array<int, 4>& corners) {
  std::array<std::array<double, 3>, 4> p{};
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = soup.points[static_cast<std::size_t>(corners[i])];
    if (!is_finite(p[i])) return false;
  }
  return volume_sign(p[0], p[1], p[2], p[3]) < 0;
}

std::string counted(const std::string& verb, std::int64_t count, const std::string& what) {
  return verb + " " + std::to_string(count) + " " + what;
}

void turn_inverted(Repaired& result) {
  std::int64_t count = 0;
  for (auto& corners : result.soup.tetrahedra) {
    if (!is_proper(result.soup, corners) || !is_inverted(result.soup, corners)) continue;
    std::swap(corners[2], corners[3]);
    ++count;
  }
  if (count > 0) result.done.push_back(counted("turned round", count, "tetrahedra of negative volume"));
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
  remove_flagged(soup.tetrahedra, soup.tetrahedron_labels, soup.first_number, duplicate);
  remove_flagged_tags(soup.tetrahedron_tags, duplicate);
  result.done.push_back(counted("removed", count, "duplicate tetrahedra"));
}

void remove_triangles(Repaired& result, const std::vector<char>& flagged, const std::string& what) {
  const auto count = std::count(flagged.begin(), flagged.end(), 1);
  if (count == 0) return;
  format::Soup& soup = result.soup;
  remove_flagged(soup.triangles, soup.triangle_labels, soup.first_number, flagged);
  remove_flagged_tags(soup.triangle_tags, flagged);
  result.done.push_back(counted("removed", count, what));
}

void remove_degenerate(Repaired& result) {
  const auto& triangles = result.soup.triangles;
  std::vector<char> degenerate(triangles.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    degenerate[t] = static_cast<char>(in_range(result.soup, triangles[t]) && has_repeated(triangles[t]));
  remove_triangles(result, degenerate, "degenerate triangles");
}

void remove_duplicate_triangles(Repaired& result) {
  const format::Soup& soup = result.soup;
  std::vector<char> duplicate(soup.triangles.size(), 0);
  for_each_edge(
      soup.triangles, soup.points.size(), [&](int t) { return is_proper(soup, soup.triangles[t]); },
      [&](std::span<const SortedSide> shared) { flag_duplicates(shared, 3, duplicate); });
  remove_triangles(result, duplicate, "duplicate triangles");
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
  const std::vector<char> turned = minority(signs_of(std::move(mates).surface()));
  const auto count = std::count(turned.begin(), turned.end(), 1);
  if (count == 0) return;
  for (std::size_t t = 0; t < turned.size(); ++t)
    if (turned[t]) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  result.done.push_back(counted("turned round", count, "triangles against their component"));
}

template <class Elements>
void renumber(Elements& elements, const std::vector<int>& index) {
  for (auto& corners : elements)
    for (int& v : corners)
      v = v >= 0 && static_cast<std::size_t>(v) < index.size() ? index[static_cast<std::size_t>(v)] : -1;
}

/// Points that none of `elements`, a part of the soup, names.
template <class Elements>
void remove_unused(Repaired& result, const Elements& elements) {
  format::Soup& soup = result.soup;
  if (elements.empty()) return;
  std::vector<char> unused(soup.points.size(), 1);
  for (const auto& corners : elements) {
    if (!in_range(soup, corners)) return;
    for (const int v : corners) unused[static_cast<std::size_t>(v)] = 0;
  }
  const auto count = std::count(unused.begin(), unused.end(), 1);
  if (count == 0) return;
  std::vector<int> index(unused.size(), -1);
  int next = 0;
  for (std::size_t v = 0; v < unused.size(); ++v)
    if (!unused[v]) index[v] = next++;
  remove_flagged(soup.points, soup.point_labels, soup.first_number, unused);
  renumber(soup.tetrahedra, index);
  renumber(soup.triangles, index);
  result.done.push_back(counted("removed", count, "unused vertices"));
}

} // namespace

Repaired repair(format::Soup soup) {
  Repaired result{std::move(soup), {}};
  if (result.soup.tetrahedra.empty()) {
    remove_degenerate(result);
    remove_duplicate_triangles(result);
    orient(result);
    remove_unused(result, result.soup.triangles);
  } else {
    turn_inverted(result);
    remove_duplicate_tetrahedra(result);
    remove_unused(result, result.soup.tetrahedra);
  }
  return result;
}

} // namespace tetrarch::mesh
