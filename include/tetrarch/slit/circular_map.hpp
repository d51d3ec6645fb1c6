// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The circular slit map: a sphere with holes, laid into the unit disk so that every loop is a circle.
///
/// The ring of the slit map goes to its circular domain, loops only; this gives the place of each vertex of a
/// loop on its circle. The rest is the harmonic extension of the log of z over the ring's own map, so errors
/// are relative to |z|, and those near the end of a slit, where square roots enlarge them, do not spread.
/// Circles on long side branches have logs of their own about their centers. Source: Yin, section 2.3.3.

#include "tetrarch/slit/circular_domain.hpp"
#include "tetrarch/slit/slit_map.hpp"

namespace tetrarch::slit {

struct CircularMap {
  /// Loops by curve of the domain: the outer one, the inner one, then the slits'.
  std::vector<int> loop;
  CircularDomain domain;
  std::vector<std::complex<double>> position; ///< of each vertex
};

/// The ring with slits that a slit map leads to. Throws InputError with the loop if rounding leaves a slit no
/// place inside the ring, closes it or makes it a point, and for moduli of 700 and more, whose radii doubles
/// cannot hold.
SlitRing slit_ring(const SlitMap& map);

/// Two right-hand sides more for the factored Laplacian, and `circular_domain`. Check `domain.found`. Throws
/// as `slit_ring`.
CircularMap circular_map(const OneForms& forms, const SlitMap& map, const CircularOptions& options = {},
                         const Progress& progress = {});

/// The case of one loop: Riemann's map of a disk, in which vertex `center` goes to 0 and the first vertex of
/// the loop to 1. Green's function with its pole at `center` tells how the boundary goes round; near the pole
/// itself, where it is rough, it is not used. Throws InputError unless the mesh is an oriented disk with
/// vertex `center` inside, or if edges of the loop see so little of the center that doubles do not tell their
/// ends apart on the circle. One sparse factorization, three right-hand sides.
CircularMap disk_map(const surface::TriangleMesh& mesh, int center);

/// A vertex with as many edges between it and the boundary as any; -1 if all vertices are on the boundary.
/// O(n).
[[nodiscard]] int innermost_vertex(const surface::TriangleMesh& mesh);

/// The places of the vertices after this many slits were opened: stage 0 is the ring, the last one the domain
/// of `circular_map` before its circles are made round.
std::vector<std::complex<double>> opening_stage(const OneForms& forms, const SlitMap& map,
                                                const CircularMap& circular, std::size_t stage);

} // namespace tetrarch::slit
