// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From the cells that files hold to the triangles and tetrahedra that a soup holds.
///
///      3-------2       A quadrilateral is cut from its corner of the smallest index, a volume cell is the
///      cone |     / |       from its vertex of the smallest index over the faces that do not touch it. Two
///      cells |   /   |       that share a face cut it alike, whatever their shapes are: the diagonal starts
///      at the | /     |       smallest index. So conforming cells become conforming tetrahedra. 0-------1
///
/// Cells of higher order are read by their corners; points that are only midside nodes are left out. Of all
/// this, and of points and lines, the ledger of the soup says how many there were.
/// Source: Dompierre, Labbe, Vallet, Camarero, "How to subdivide pyramids, prisms, and hexahedra into
/// tetrahedra" (1999), for the rule of the smallest index.

#include "tetrarch/format/soup.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace tetrarch::format {

/// Shapes with their corners in the order of Gmsh and MEDIT: a base counterclockwise seen from what lies
/// above it, then what lies above.
enum class Shape : std::uint8_t {
  vertex,
  line,
  triangle,
  quadrilateral,
  tetrahedron,
  pyramid,
  prism,
  hexahedron,
  pentagonal_prism,
  hexagonal_prism
};

int corner_count(Shape shape);
/// 0 to 3.
int dimension_of(Shape shape);

/// How the file names a cell.
struct CellName {
  int number = 0;
  int line = 0;
  int tag = 0;
};

class Cells {
public:
  explicit Cells(Soup& soup) : soup_(soup) {}

  /// Nodes after the corners are midside nodes. There must be no fewer nodes than corners.
  void add(Shape shape, std::span<const int> nodes, const CellName& name);
  /// A face of any number of corners, in order around it.
  void add_polygon(std::span<const int> corners, const CellName& name);
  /// A convex cell by its faces, each in order around it, which need not be seen from outside. The cone is
  /// from the vertex of the smallest index, or from a new point in the middle where that would be flat or
  /// turned over, as beside faces that lie in one plane; so with faces that have corners in a row. All points
  /// of the faces must be there.
  void add_polyhedron(const std::vector<std::vector<int>>& faces, const CellName& name);
  /// Triangles on each three consecutive points, every other one turned; a negative index begins another
  /// strip.
  void add_strip(std::span<const int> points, const CellName& name);

  /// Cuts the polygons, which needs all points, leaves out midside nodes and tags that tell nothing, and
  /// closes the ledger. O(n), for a polygon O(corners times reflex corners).
  void finish();
  /// The same, but prisms are turned round together if most of their volume is negative: VTK's
  /// documentation has another order of corners than half of the programs that write VTK's files.
  void finish_turning_prisms();

private:
  void add_triangle(const std::array<int, 3>& corners, const CellName& name);
  void add_tetrahedron(const std::array<int, 4>& corners, const CellName& name);
  void add_cone(Shape shape, std::span<const int> nodes, const CellName& name);
  int add_middle(const std::vector<int>& corners);
  std::vector<std::array<int, 3>> cut_face(const std::vector<int>& face);
  void cut_polygons();
  void leave_out_midside_nodes();
  void turn_prisms();

  struct Polygon {
    std::size_t first = 0; ///< in polygon_corners_
    std::size_t triangles_before = 0;
    CellName name;
  };

  Soup& soup_;
  std::vector<Polygon> polygons_;
  std::vector<int> polygon_corners_;
  std::vector<int> midside_nodes_;
  std::map<std::vector<int>, int>
      middles_;                     ///< of faces that needed one, by their corners in increasing order
  std::vector<std::size_t> prisms_; ///< the tetrahedra that were prisms
};

/// The triangles of a polygon, as positions in `corners`: a fan from the smallest index if the polygon is
/// convex, else ears, one after the other. A polygon of n corners becomes n - 2 triangles whatever its shape.
/// O(n), and O(n times reflex corners) where it is not convex.
std::vector<std::array<std::size_t, 3>> cut_polygon(std::span<const int> corners,
                                                    const std::vector<std::array<double, 3>>& points);

} // namespace tetrarch::format
