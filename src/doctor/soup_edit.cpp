// SPDX-License-Identifier: GPL-2.0-or-later
#include "soup_edit.hpp"

namespace tetrarch::doctor {
namespace {

template <class Elements>
void renumber(Elements& elements, const std::vector<int>& index) {
  for (auto& corners : elements)
    for (int& v : corners) v = index[static_cast<std::size_t>(v)];
}

/// False if an index is out of range.
template <class Elements>
bool mark_used(const format::Soup& soup, const Elements& elements, std::vector<char>& unused) {
  for (const auto& corners : elements) {
    if (!in_range(soup, corners)) return false;
    for (const int v : corners) unused[static_cast<std::size_t>(v)] = 0;
  }
  return true;
}

/// Flags the triangles that name an unused point, or one that is not there.
std::vector<char> triangles_on(const format::Soup& soup, const std::vector<char>& unused) {
  std::vector<char> flagged(soup.triangles.size(), 0);
  for (std::size_t t = 0; t < flagged.size(); ++t)
    flagged[t] =
        static_cast<char>(!in_range(soup, soup.triangles[t]) ||
                          std::any_of(soup.triangles[t].begin(), soup.triangles[t].end(),
                                      [&](int v) { return unused[static_cast<std::size_t>(v)] != 0; }));
  return flagged;
}

} // namespace

void remove_tags(std::vector<int>& tags, const std::vector<char>& flagged) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tags.size(); ++t)
    if (!flagged[t]) tags[kept++] = tags[t];
  tags.resize(kept);
}

void remove_tetrahedra(format::Soup& soup, const std::vector<char>& flagged) {
  remove_flagged(soup.tetrahedra, soup.tetrahedron_labels, soup.first_number, flagged);
  remove_tags(soup.tetrahedron_tags, flagged);
}

void remove_triangles(format::Soup& soup, const std::vector<char>& flagged) {
  remove_flagged(soup.triangles, soup.triangle_labels, soup.first_number, flagged);
  remove_tags(soup.triangle_tags, flagged);
}

std::int64_t remove_unused_points(format::Soup& soup) {
  const bool is_solid = !soup.tetrahedra.empty();
  std::vector<char> unused(soup.points.size(), 1);
  if (!is_solid && soup.triangles.empty()) return 0;
  if (is_solid ? !mark_used(soup, soup.tetrahedra, unused) : !mark_used(soup, soup.triangles, unused))
    return 0;
  const auto count = std::count(unused.begin(), unused.end(), 1);
  if (count == 0) return 0;
  if (is_solid) remove_triangles(soup, triangles_on(soup, unused));
  std::vector<int> index(unused.size(), -1);
  int next = 0;
  for (std::size_t v = 0; v < unused.size(); ++v)
    if (!unused[v]) index[v] = next++;
  remove_flagged(soup.points, soup.point_labels, soup.first_number, unused);
  renumber(soup.tetrahedra, index);
  renumber(soup.triangles, index);
  return count;
}

std::vector<ListedTriangle> listed_triangles(const format::Soup& soup) {
  std::vector<ListedTriangle> list;
  for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
    list.push_back({soup.triangles[k], static_cast<int>(k)});
    std::sort(list.back().corners.begin(), list.back().corners.end());
  }
  std::sort(list.begin(), list.end(), [](const ListedTriangle& a, const ListedTriangle& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.index < b.index;
  });
  return list;
}

std::pair<std::size_t, std::size_t> on_corners(const std::vector<ListedTriangle>& list,
                                               const std::array<int, 3>& corners) {
  const auto first =
      std::lower_bound(list.begin(), list.end(), corners,
                       [](const ListedTriangle& a, const std::array<int, 3>& b) { return a.corners < b; });
  auto last = first;
  while (last != list.end() && last->corners == corners) ++last;
  return {static_cast<std::size_t>(first - list.begin()), static_cast<std::size_t>(last - list.begin())};
}

} // namespace tetrarch::doctor
