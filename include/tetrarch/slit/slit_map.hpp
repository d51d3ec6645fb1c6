// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Slit maps: a sphere with holes, laid onto a cylinder, a rectangle or a ring with slits.
///
///      .-------.  height       _______                .-----------.
///      |'-----'|  = modulus   |       |  inner       /   .--       \   a slit
///      |  --   |              |  --   |             |      (O)      |  the inner circle
///      |.-----.|  0           |_______|  outer       \       --'   /
///      '-------'              0     2 pi              '-----------'
///      cylindric              parallel                 concentric
///
/// The outer loop becomes the unit circle, the inner loop the circle of radius exp(-modulus), every other
/// loop an arc about the origin that is run through to and fro: its slit.
///
/// All three are one multivalued function w = log z = log_radius + i angle. Its real part is constant on
/// every loop; its imaginary part grows by 2 pi around the outer loop, by -2 pi around the inner one and by 0
/// around the others. All maps keep the orientation, the cylinder seen from outside. (The dissertation's
/// heights (cos, sin, log r) and (angle, log r) are mirror images; here the height is -log r.) The angle is 0
/// at the start of the slit of least number, or at the first vertex of the outer loop if there is none.
/// Source: Yin, sections 2.3.2 and 2.3.3.

#include "tetrarch/slit/conjugate.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::slit {

/// The image of a loop that is neither outer nor inner.
struct Slit {
  int loop = 0;
  double radius = 0; ///< height = -log(radius)
  /// Angle at which the arc begins, counterclockwise; in [0, 2 pi). Ends lie between vertices. The three
  /// nearest vertices determine an end, and it moves by a small part of an edge if they move.
  double start = 0;
  double end = 0;       ///< above start
  int start_vertex = 0; ///< the vertex of least angle, near the start
  int end_vertex = 0;
  /// How often the angle turns back along the loop: 2 for what is a slit.
  int turns = 0;
};

/// The map w = log_radius + i angle, and the slits.
struct SlitMap {
  int outer = 0;
  int inner = 0;
  std::vector<double> log_radius; ///< of each vertex, from -modulus to 0
  std::vector<double> angle;      ///< of each vertex, in [0, 2 pi)
  /// w as a one-form. Imaginary parts are differences of `angle` modulo 2 pi only.
  HolomorphicOneForm form;
  std::vector<Slit> slits; ///< by loop

  /// log(1 / inner radius). It is never above the modulus of the surface, whose triangles are flat, because
  /// harmonic functions minimize energy. The modulus of the surface is never above `modulus_bound`, because
  /// their conjugates minimize energy too. The two approach one another at order h^2 on smooth surfaces.
  double modulus = 0;
  double modulus_bound = 0;

  std::complex<double> concentric(int vertex) const;
  /// On the cylinder of radius 1 about the z axis.
  std::array<double, 3> cylindric(int vertex) const;
};

/// Throws InputError unless `outer` and `inner` are two different loops. O(n) and a dense system of the size
/// of the number of loops.
SlitMap slit_map(const OneForms& forms, int outer, int inner);

/// Throws InputError if the modulus is 700 or more: the inner radius, or edges beside it, would be no normal
/// doubles. Heights have room for that.
void require_radii(const SlitMap& map);

struct LoopPair {
  int outer = 0;
  int inner = 1;
};

/// The two loops with the greatest modulus between them, the others left free; outer is the one through which
/// more flows if each is held against all others. This depends on the conformal structure alone, unlike the
/// numbers of loops. A dense system of the size of the number of loops.
LoopPair farthest_loops(const OneForms& forms);

/// The cylinder unrolled to a rectangle of width 2 pi.
struct ParallelDomain {
  /// Of each triangle, where its corners lie: (angle, height). A vertex on the seam has several places.
  std::vector<std::array<std::array<double, 2>, 3>> corners;
  /// The sides on the seam, of both its banks: where triangles that meet on the surface lie 2 pi apart.
  std::vector<surface::Side> seam;
};

/// Each triangle lies whole, with its centroid in [0, 2 pi); so the seam runs along edges, no farther from
/// the line of angle 0 than one triangle. O(n).
ParallelDomain parallel_domain(const surface::Surface& surface, const SlitMap& map);

} // namespace tetrarch::slit
