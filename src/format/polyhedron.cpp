// SPDX-License-Identifier: GPL-2.0-or-later
#include "cells.hpp"

#include "mesh_text.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace tetrarch::format {
namespace {

using Triangle = std::array<int, 3>;

/// Less of the cube of a cell's size, or of the square of a face's, is flat: coordinates are rounded.
constexpr double flat = 1e-10;

numeric::Vector between(const Soup& soup, int from, int to) {
  using namespace numeric;
  return soup.points[static_cast<std::size_t>(to)] - soup.points[static_cast<std::size_t>(from)];
}

double six_volumes(const Soup& soup, int apex, const Triangle& t) {
  using namespace numeric;
  return dot(between(soup, apex, t[0]), cross(between(soup, apex, t[1]), between(soup, apex, t[2])));
}

double size_of(const Soup& soup, const std::vector<int>& corners) {
  double size = 0;
  for (const int v : corners) size = std::max(size, numeric::length(between(soup, corners.front(), v)));
  return size;
}

/// Whether each edge of the faces is met once in each direction.
bool are_oriented_alike(const std::vector<std::vector<int>>& faces) {
  std::set<std::pair<int, int>> edges;
  for (const std::vector<int>& face : faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      if (!edges.emplace(face[k], face[(k + 1) % face.size()]).second) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) > 0;
  });
}

} // namespace

int Cells::add_middle(const std::vector<int>& corners) {
  std::array<double, 3> middle{};
  for (const int v : corners)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += soup_.points[static_cast<std::size_t>(v)][k] / static_cast<double>(corners.size());
  const int number = static_cast<int>(soup_.points.size());
  soup_.points.push_back(middle);
  note(soup_.point_labels, number, 0);
  soup_.passed_over.note("polyhedra, for which a point was added");
  return number;
}

/// Both cells at a face cut it alike.
std::vector<Triangle> Cells::cut_face(const std::vector<int>& face) {
  const auto fan = [&](int apex, std::size_t first, std::size_t last) {
    std::vector<Triangle> triangles;
    for (std::size_t k = first; k < last; ++k)
      triangles.push_back({apex, face[k % face.size()], face[(k + 1) % face.size()]});
    return triangles;
  };
  const auto least = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  std::vector<Triangle> triangles = fan(face[least], least + 1, least + face.size() - 1);
  const double size = size_of(soup_, face);
  const bool is_flat = std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    const auto normal = numeric::cross(between(soup_, t[0], t[1]), between(soup_, t[0], t[2]));
    return numeric::length(normal) <= flat * size * size;
  });
  if (!is_flat) return triangles;
  std::vector<int> key = face;
  std::sort(key.begin(), key.end());
  const auto [at, is_new] = middles_.try_emplace(std::move(key), -1);
  if (is_new) at->second = add_middle(face);
  return fan(at->second, 0, face.size());
}

void Cells::add_polyhedron(const std::vector<std::vector<int>>& faces, const CellName& name) {
  std::vector<int> corners;
  for (const std::vector<int>& face : faces) corners.insert(corners.end(), face.begin(), face.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<std::vector<Triangle>> skin;
  skin.reserve(faces.size());
  for (const std::vector<int>& face : faces) skin.push_back(cut_face(face));

  // Seen from outside: all faces are turned, or each that is.
  const int middle_of_all = static_cast<int>(soup_.points.size());
  std::array<double, 3> middle{};
  for (const int v : corners)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += soup_.points[static_cast<std::size_t>(v)][k] / static_cast<double>(corners.size());
  soup_.points.push_back(middle);
  const auto seen_from_middle = [&](const std::vector<Triangle>& face) {
    double sum = 0;
    for (const Triangle& t : face) sum += six_volumes(soup_, middle_of_all, t);
    return sum;
  };
  const bool alike = are_oriented_alike(faces);
  double all = 0;
  for (const auto& face : skin) all += seen_from_middle(face);
  for (auto& face : skin)
    if ((alike ? all : seen_from_middle(face)) < 0)
      for (Triangle& t : face) std::swap(t[1], t[2]);
  soup_.points.pop_back();

  const int least = corners.front();
  const double size = size_of(soup_, corners);
  double smallest = std::numeric_limits<double>::infinity();
  const auto touches = [](const Triangle& t, int v) { return std::find(t.begin(), t.end(), v) != t.end(); };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::find(faces[f].begin(), faces[f].end(), least) != faces[f].end() && skin[f].front()[0] == least)
      continue;
    for (const Triangle& t : skin[f])
      if (!touches(t, least))
        smallest = std::min(smallest, six_volumes(soup_, least, t));
      else
        smallest = 0;
  }
  const int apex = smallest > flat * size * size * size ? least : add_middle(corners);
  for (const auto& face : skin)
    for (const Triangle& t : face)
      if (!touches(t, apex)) add_tetrahedron({apex, t[0], t[1], t[2]}, name);
  soup_.passed_over.note("polyhedron, cut into tetrahedra");
}

} // namespace tetrarch::format
