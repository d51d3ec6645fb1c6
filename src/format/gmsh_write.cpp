// SPDX-License-Identifier: GPL-2.0-or-later
#include "gmsh_numbers.hpp"
#include "mesh_text.hpp"

#include "tetrarch/format/gmsh.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace tetrarch::format {
namespace {

/// The elements of one dimension by their labels: each label is an entity in the physical group of that
/// number. Gmsh's groups count from 1; all other elements are one entity, which is in none.
class Blocks {
public:
  Blocks(std::size_t elements, const std::vector<int>& tags) {
    for (std::size_t k = 0; k < elements; ++k)
      of_label_[tags.empty() ? 0 : std::max(tags[k], 0)].push_back(k);
    while (of_label_.contains(free_)) ++free_;
  }

  std::size_t size() const { return of_label_.size(); }
  const std::map<int, std::vector<std::size_t>>& of_label() const { return of_label_; }
  int entity(int label) const { return label > 0 ? label : free_; }

private:
  std::map<int, std::vector<std::size_t>> of_label_;
  int free_ = 1;
};

std::string box_of(const Soup& soup) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> least{infinity, infinity, infinity};
  std::array<double, 3> greatest{-infinity, -infinity, -infinity};
  for (const auto& p : soup.points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], p[axis]);
      greatest[axis] = std::max(greatest[axis], p[axis]);
    }
  if (soup.points.empty()) least = greatest = {0, 0, 0};
  std::string out;
  append_line(out, least, " ");
  append_line(out, greatest, " ");
  return out;
}

void append_entities(std::string& out, const Blocks& blocks, const std::string& box) {
  for (const auto& [label, elements] : blocks.of_label()) {
    out += std::to_string(blocks.entity(label)) + " " + box;
    out += label > 0 ? "1 " + std::to_string(label) + " 0\n" : "0 0\n";
  }
}

template <class Elements>
void append_blocks(std::string& out, int dimension, int type, const Elements& elements, const Blocks& blocks,
                   std::size_t first_tag) {
  for (const auto& [label, members] : blocks.of_label()) {
    out += std::to_string(dimension) + " " + std::to_string(blocks.entity(label)) + " " +
           std::to_string(type) + " " + std::to_string(members.size()) + "\n";
    for (const std::size_t k : members) {
      append_number(out, first_tag++);
      out += ' ';
      append_line(out, elements[k], "\n", 1);
    }
  }
}

/// The first line of a section of so many elements in so many blocks.
std::string section_head(std::size_t blocks, std::size_t count) {
  const std::string number = std::to_string(count);
  return std::to_string(blocks) + " " + number + (count == 0 ? " 0 " : " 1 ") + number + "\n";
}

} // namespace

std::string write_gmsh(const Soup& soup) {
  const Blocks surfaces(soup.triangles.size(), soup.triangle_tags);
  const Blocks volumes(soup.tetrahedra.size(), soup.tetrahedron_tags);
  // Gmsh knows no node or element of an entity that is not announced; points alone need a volume, too.
  const bool only_points = surfaces.size() + volumes.size() == 0;
  const std::string box = box_of(soup);
  std::string out = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 " +
                    std::to_string(surfaces.size()) + " " + std::to_string(only_points ? 1 : volumes.size()) +
                    "\n";
  append_entities(out, surfaces, box);
  append_entities(out, volumes, box);
  if (only_points) out += "1 " + box + "0 0\n";
  const bool on_volume = volumes.size() > 0 || only_points;
  const Blocks& carriers = on_volume ? volumes : surfaces;
  const int carrier = only_points ? 1 : carriers.entity(carriers.of_label().begin()->first);
  const std::size_t points = soup.points.size();
  out += "$EndEntities\n$Nodes\n" + section_head(1, points) + (on_volume ? "3 " : "2 ") +
         std::to_string(carrier) + " 0 " + std::to_string(points) + "\n";
  for (std::size_t i = 1; i <= points; ++i) {
    append_number(out, i);
    out += '\n';
  }
  for (const auto& p : soup.points) append_line(out, p, "\n");
  out += "$EndNodes\n$Elements\n" +
         section_head(surfaces.size() + volumes.size(), soup.triangles.size() + soup.tetrahedra.size());
  append_blocks(out, 2, gmsh_triangle, soup.triangles, surfaces, 1);
  append_blocks(out, 3, gmsh_tetrahedron, soup.tetrahedra, volumes, soup.triangles.size() + 1);
  return out + "$EndElements\n";
}

} // namespace tetrarch::format
