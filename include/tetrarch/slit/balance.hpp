// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Less distortion of areas, at the cost of angles.
///
///      .-----------.          .-----------.    A conformal map keeps angles and makes a nose as small as it
///     /    .        \        /   .---.     \   must. Here vertices move until the symmetric Dirichlet energy
///     |   (o)       |  -->   |  /  o  \    |   is least, which punishes both: see unfold/relax.hpp. The
///     \    '        /        \  '-----'    /   domain stays what it was: vertices on a loop slide along its
///      '-----------'          '-----------'    circle or slit, the ends of slits stay.
///
/// Nothing is turned over by this; triangles that were before stay as they are, with their vertices. The
/// wanted shapes are those in space, the surface scaled to the area of the domain.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/slit/circular_map.hpp"

#include <complex>
#include <vector>

namespace tetrarch::slit {

struct Balanced {
  double before = 1; ///< the mean energy: 1 for an isometry
  double after = 1;
  int steps = 0;
  bool settled = false; ///< whether the energy fell no more
  int left_out = 0;     ///< triangles turned over or flat before, ears included
};

/// On the cylinder. Angles and heights are those of the balanced map then, no longer harmonic.
Balanced balance_on_cylinder(const OneForms& forms, SlitMap& map, const Progress& progress = {});
/// On the ring, where edges are straight.
Balanced balance_on_ring(const OneForms& forms, SlitMap& map, const Progress& progress = {});
/// In the disk with round holes.
Balanced balance_in_disk(const surface::TriangleMesh& mesh, CircularMap& map, const Progress& progress = {});

/// What was done at the ends of slits.
struct Softened {
  int moved = 0;     ///< vertices
  double before = 0; ///< the greatest ratio of axes there
  double after = 0;
};

/// A slit turns back between two vertices, which lie almost on one another then: the triangle on them becomes
/// a needle. Where a triangle within three steps of an end has a ratio of axes above 10, those triangles
/// alone are relaxed, their outer edges held, as above and then for their angles only; vertices of the slit
/// slide along it, its end stays. An end where that does not help stays as it was. O(n) and a little for each
/// end.
Softened soften_ends_on_cylinder(const OneForms& forms, SlitMap& map);
Softened soften_ends_on_ring(const OneForms& forms, SlitMap& map);

/// A domain whose shape is free.
struct FreeMap {
  std::vector<std::complex<double>> position; ///< of each vertex, in the unit of the surface
  Balanced balanced;
  /// Pairs of boundary edges that cross: 0 unless parts of the domain overlap.
  int crossings = 0;
};

/// From a map into the plane on: the boundary moves as well, and the surface keeps its size. Triangles that
/// meet others along one side only start with their shape in space, as round holes have no room for them.
/// O(n) and a factorization a step; crossings by a sweep.
FreeMap free_map(const surface::TriangleMesh& mesh, const std::vector<std::complex<double>>& start,
                 const Progress& progress = {});

} // namespace tetrarch::slit
