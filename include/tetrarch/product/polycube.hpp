// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra from a polycube: a solid made of cubes, whose surface is the image of the given solid's surface.
///
///        solid M            polycube M^P          Given is, for each vertex of M's boundary, a point on the
///        .------.            .-------.            surface of M^P. Its inside is filled with cubes; they are
///       (   .---'  <------   |   .---'            carried to M along the fibers of both: from a corner of a
///        `-'                 '---'                cube down to the floor of M^P, by the given map to that of
///                                                 M, and up to the same w.
///
/// So fibers go to fibers and levels to levels; corners may stand anywhere on both bases, which need not be
/// flat. Source: Yin, section 3.5, with heights of 1 on both sides.

#include "tetrarch/product/hexahedra.hpp"
#include "tetrarch/product/partition.hpp"

#include <array>
#include <vector>

namespace tetrarch::product {

/// A set of cubes of a lattice.
struct Polycube {
  double edge = 1;                       ///< of a cube; lattice point (x, y, z) lies at edge (x, y, z)
  std::vector<std::array<int, 3>> cubes; ///< by the corners of least coordinates, in lexicographic order
};

/// The cubes inside of a surface that consists of squares of the lattice with this step, each cut into
/// `cells`^3. `image` holds the image of each vertex of `boundary`. Throws InputError with the triangle
/// (counted from 0) and its image, unless images are finite, each triangle lies in a plane of the lattice and
/// has area, and all triangles together cover exactly the faces of a set of cubes, seen from outside;
/// PreconditionError unless there is an image of each vertex, `step` > 0 and `cells` >= 1. O(m + c) for m
/// triangles and c cubes of the bounding box.
Polycube filled_polycube(const surface::Surface& boundary, const std::vector<Point>& image, double step = 1,
                         int cells = 1);

/// One for each cube, in order; points are numbered by first use. O(n).
HexMesh hexahedra(const Polycube& polycube);
/// Six for each cube, around its diagonal, on the same points. Throws InputError where cubes touch along an
/// edge or at a point only. O(n log n).
solid::TetMesh tetrahedra(const Polycube& polycube);

struct PolycubeOptions {
  double step = 1; ///< of the lattice on which the polycube's corners lie
  int cells = 4;   ///< hexahedra along a step of the lattice
  int finer = 2;   ///< for the polycube's own field each hexahedron is cut into this many along each edge
  /// Across a ridge between two walls, as polycubes have them, smoothed vectors are small and point anywhere
  /// along it; the gradient turns round the corner.
  Direction direction = Direction::gradient;
  int threads = 1;
};

struct PolycubeHexahedra {
  HexMesh cubes;        ///< as `hexahedra(Polycube)`, and in the same places
  SolidHexahedra solid; ///< the same in M; points whose fiber was stuck are left out, and what is beside them
  std::vector<int> cube; ///< of each hexahedron in M
  double farthest = 0;   ///< that a foot of a fiber on the floor of M^P was from the image of M's floor
};

/// `image` holds the image of each vertex of the solid's boundary, `base` the base of each of its triangles
/// in the form of `partition`. Throws as `filled_polycube` and `partition` do, and InputError where the rims
/// of bases do not follow edges of the lattice. Two harmonic fields, and two fibers for each corner of a
/// cube.
PolycubeHexahedra polycube_hexahedra(const Solid& solid, const std::vector<Point>& image,
                                     const std::vector<int>& base, const PolycubeOptions& options = {},
                                     const Progress& progress = {});

} // namespace tetrarch::product
