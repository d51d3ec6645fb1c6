// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/mesh/repair.hpp"

#include "face_sweep.hpp"

#include "tetrarch/mesh/volume_sign.hpp"

#include <cmath>

namespace tetrarch::mesh {
namespace {

using Tetrahedra = std::vector<std::array<int, 4>>;

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

bool in_range(const format::Soup& soup, const std::array<int, 4>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < soup.points.size(); });
}

bool is_proper(const format::Soup& soup, const std::array<int, 4>& corners) {
  std::array<int, 4> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  return in_range(soup, corners) && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

bool is_inverted(const format::Soup& soup, const std::array<int, 4>& corners) {
  std::array<std::array<double, 3>, 4> p{};
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = soup.points[static_cast<std::size_t>(corners[i])];
    for (const double x : p[i])
      if (!std::isfinite(x)) return false;
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

void remove_duplicates(Repaired& result) {
  format::Soup& soup = result.soup;
  std::vector<char> duplicate(soup.tetrahedra.size(), 0);
  FaceSweep sweep(soup.tetrahedra, soup.points.size(),
                  [&](std::size_t t) { return is_proper(soup, soup.tetrahedra[t]); });
  sweep.for_each_class([&](std::span<const SortedFace> shared) {
    for (std::size_t i = 1; i < shared.size(); ++i)
      if (shared[i].apex == shared[i - 1].apex) duplicate[static_cast<std::size_t>(shared[i].at().tet)] = 1;
  });
  const auto count = std::count(duplicate.begin(), duplicate.end(), 1);
  if (count == 0) return;
  remove_flagged(soup.tetrahedra, soup.tetrahedron_labels, soup.first_number, duplicate);
  result.done.push_back(counted("removed", count, "duplicate tetrahedra"));
}

template <class Elements>
void renumber(Elements& elements, const std::vector<int>& index) {
  for (auto& corners : elements)
    for (int& v : corners)
      v = v >= 0 && static_cast<std::size_t>(v) < index.size() ? index[static_cast<std::size_t>(v)] : -1;
}

void remove_unused(Repaired& result) {
  format::Soup& soup = result.soup;
  if (soup.tetrahedra.empty()) return; // a surface, perhaps
  std::vector<char> unused(soup.points.size(), 1);
  for (const auto& corners : soup.tetrahedra) {
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
  turn_inverted(result);
  remove_duplicates(result);
  remove_unused(result);
  return result;
}

} // namespace tetrarch::mesh
