// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A scene as a file that other programs open.
///
/// | format | surfaces                                | tubes               | cells              | labels |
/// | ------ | --------------------------------------- | ------------------- | ------------------ | ------ |
/// | ply    | triangles, normals, colors, data        | swept to triangles  | their outer faces  | -      |
/// | obj    | groups, normals, textures, no colors    | swept to triangles  | their outer faces  | -      |
/// | glb    | a mesh each, normals, textures, colors  | swept to triangles  | their outer faces  | nodes  |
/// | vtu    | triangles with cell data                | polylines with data | cells with data    | -      |
///
/// Where there are data, every triangle, polyline or cell also has `element`, the number of its element: the
/// surfaces are counted from 0, then the tubes, then the cells. A missing value is -1. Fields go where data
/// go; the value of a missing field is NaN.
///
///   ply  Where only some surfaces have normals, the others get the mean of their triangles'. Coordinates in
///        double precision, colors on the faces.
///   obj  One `o` per element; white space in names becomes _.
///   glb  glTF 2.0, in single precision. y points upwards there, and a node above all others turns the scene;
///        texture coordinates are (u, 1-v), since images begin at their top; colors are turned from sRGB
///        into the linear ones that glTF wants, of 16 bits. Where triangles of different colors meet, points
///        are doubled, and the triangles of such a surface are sorted by color. No data: glTF knows none per
///        triangle.
///   vtu  Point data `radius` where there are tubes and `texture` (u, v, w) where anything has some; 0 where
///        a point has none.
/// Sources: Turk, "The PLY polygon file format" (1994); Wavefront's OBJ specification; Khronos, "glTF 2.0
/// Specification"; "VTK File Formats", the VTK user's guide (Kitware).

#include "tetrarch/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::scene {

enum class SceneFormat : std::uint8_t { ply, obj, glb, vtu };

/// By the extension, in any case.
std::optional<SceneFormat> scene_format_for_extension(std::string_view path);

/// The whole scene. Binary for ply (little endian), glb and vtu (raw appended); the same bytes for the same
/// scene. O(size), O(n log n) for n triangles of different colors in glb. Throws PreconditionError for a
/// scene that breaks its rules (scene.hpp), and for one that the format cannot hold: more than 2^31 points,
/// more than four gigabytes of glb.
std::string write_scene(const Scene& scene, SceneFormat format);

/// The tubes as surfaces: a polygon of `sides` >= 3 corners swept along each polyline by parallel transport,
/// with round-looking normals, both ends closed. Its corners are at the radius from each point of the
/// polyline, in the plane halfway between the two segments; at a sharp bend the tube is thinner. Every
/// polyline of n points becomes a sphere of n*sides + 2 points and 2*n*sides triangles. The data and colors
/// are those of the polyline. O(size). Throws PreconditionError.
Surface swept(const Tubes& tubes, int sides = 8);

/// The faces of cells that belong to one cell only, quadrilaterals cut in two, seen counterclockwise from
/// outside; a quadrilateral is never the same face as two triangles. Of the points, those on these faces,
/// with the u and v of their texture coordinates and their fields; the data and fields of a triangle are
/// those of the cell. O(size), 4 bytes for each face of a cell besides the result. Throws PreconditionError.
Surface outer_faces(const Cells& cells);

} // namespace tetrarch::scene
