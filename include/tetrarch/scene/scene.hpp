// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A neutral description of a picture: surfaces, tubes, solid cells, labels.
///
///     Surface   triangles on shared points      a face, a boundary, a mesh with texture coordinates
///     Tubes     polylines with a radius         edges, fibers, axes
///     Cells     tetrahedra and hexahedra        a mesh of a solid, with data on every cell
///     Label     a word at a point
///
/// Every front end describes its content in these terms, and every writer (files.hpp) understands all of
/// them. So a new front end needs no new writer, and a new file format needs no new front end. Coordinates
/// are Euclidean and right-handed, z upwards, without a unit; a model comes first for hyperbolic space
/// (in_model.hpp). Indices count from 0 within their own element. Writers throw PreconditionError for an
/// index out of range, lists of lengths that do not fit, numbers that are not finite, and normals that are
/// not unit vectors (to a thousandth).

#include "tetrarch/numeric/vector.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::scene {

using numeric::Point;

/// In sRGB, as screens and painting programs count.
struct Color {
  std::uint8_t red = 200;
  std::uint8_t green = 200;
  std::uint8_t blue = 200;
  std::uint8_t alpha = 255; ///< 255: opaque
  friend bool operator==(Color, Color) = default;
};

/// An integer on every triangle, polyline or cell: its tetrahedron, its copy, its class.
struct Data {
  /// Letters, digits and _; the same name means the same thing throughout a scene. Not element, red, green,
  /// blue, alpha, vertex_indices: files have columns of these names.
  std::string name;
  std::vector<int> values;
};

/// A real number on every triangle or cell, or at every point: an error, a potential, an angle.
struct Field {
  /// As for data, and different from the names of data; at points also not x, y, z, nx, ny, nz, radius,
  /// texture.
  std::string name;
  std::vector<double> values; ///< finite
};

struct Surface {
  std::string name;
  std::vector<Point> points;
  std::vector<Point> normals;                  ///< none, or a unit vector per point
  std::vector<std::array<double, 2>> textures; ///< none, or (u, v) per point, v upwards
  std::vector<std::array<int, 3>> triangles;   ///< counterclockwise from outside
  std::vector<Color> colors;                   ///< one per triangle, or one for all, or none
  std::vector<Data> data;                      ///< per triangle
  std::vector<Field> cell_fields{};            ///< per triangle
  std::vector<Field> point_fields{};           ///< per point
};

struct Tubes {
  std::string name;
  std::vector<Point> points;
  std::vector<double> radii;  ///< one per point, not negative
  std::vector<int> starts{0}; ///< polyline k has the points starts[k] .. starts[k+1]-1, at least two; the
                              ///< last entry is the number of points
  std::vector<Color> colors;  ///< one per polyline, or one for all, or none
  std::vector<Data> data;     ///< per polyline
};

struct Cells {
  std::string name;
  std::vector<Point> points;
  std::vector<std::array<int, 4>> tetrahedra;  ///< of either orientation
  std::vector<std::array<int, 8>> hexahedra;   ///< bottom counterclockwise from above, then top likewise
  std::vector<std::array<double, 3>> textures; ///< none, or (u, v, w) per point
  std::vector<Data> data;                      ///< per cell: the tetrahedra, then the hexahedra
  std::vector<Field> cell_fields{};            ///< likewise
  std::vector<Field> point_fields{};           ///< per point
};

struct Label {
  Point at{};
  std::string text;
};

/// The whole picture.
struct Scene {
  std::string title;
  std::vector<Surface> surfaces;
  std::vector<Tubes> tubes;
  std::vector<Cells> cells;
  std::vector<Label> labels;
};

} // namespace tetrarch::scene
