// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Registration: the correspondence between the points of two surfaces with equally many holes.
///
///     A ----------------> B        Each surface has its circular domain, which differ unless the surfaces
///     | circular          ^ back   are conformally the same. A's disk is turned to B's; each of its circles
///     v          harmonic | again  goes to the matching one by the angle; everything inside is the harmonic
///    (o o) ------------> (o o)     extension, made on A. B's triangles tell what lies there on B.
///
/// So B gets the triangulation of A, and shapes can be averaged point by point. The disk with holes of a mesh
/// is bounded by polygons: loops are taken to those, and thereby to the loops of B. Harmonic maps into a
/// domain that is not convex may invert triangles; the inverted triangles are counted. Source: Yin, section
/// 2.4.2.

#include "tetrarch/slit/circular_map.hpp"

#include <array>
#include <complex>
#include <vector>

namespace tetrarch::slit {

/// A point of a mesh: weights of the corners of a triangle, at least 0, that add up to 1.
struct MeshPoint {
  int triangle = -1;
  std::array<double, 3> weight{};
};

/// x goes to rotation x + shift.
struct RigidMotion {
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< by rows
  std::array<double, 3> shift{};
};

struct Registration {
  /// The angle by which A's disk was turned first.
  double turn = 0;
  /// Of each vertex of A: its place in B's disk, on the mesh B, and in space there: B's shape with A's
  /// vertices, and with A's triangles.
  std::vector<std::complex<double>> position;
  std::vector<MeshPoint> at;
  std::vector<std::array<double, 3>> resampled;
  /// In the middle between A and what was resampled, once that was moved to A.
  std::vector<std::array<double, 3>> average;
  RigidMotion motion;

  int outside = 0;          ///< vertices whose place is in no triangle of B's disk; the nearest one was taken
  double farthest = 0;      ///< that such a place is from it
  int moved = 0;            ///< vertices moved by `unflip`
  std::vector<int> flipped; ///< triangles of A turned over in B's disk

  /// Of each triangle of A the ratio of the axes of the linear map to B in space, at least 1; 0 for those
  /// flipped, and those of no area on B.
  std::vector<double> quasi_conformal;
  double mean_quasi_conformal = 0; ///< weighted by area on A
  double max_quasi_conformal = 0;
  int flattened = 0; ///< triangles of no area on B: all corners on a straight piece of the boundary

  double mean_distance = 0; ///< between A and what was resampled and moved, weighted by area on A
  double max_distance = 0;
};

struct RegistrationOptions {
  /// For each loop of A the matching loop of B; empty: the loop of the same number.
  std::vector<int> matching;
  /// Whether B is moved to A before the comparison, by the rigid motion of least mean squared distance,
  /// reflections excluded. Otherwise `motion` stays the identity.
  bool aligned = true;
  /// Whether vertices are moved in B's disk until no triangle is flipped, as by `unflip_in_disk`.
  bool unflip = false;
  /// Whether this is done for triangles on circles of slits alone, where there are flipped ones.
  bool unflip_at_slits = false;
};

/// The turn is the one that brings the centers of circles closest in the mean square. With two loops all
/// turns are conformal; then it is the one by which the loops themselves come closest in space after a rigid
/// motion, which is a least value: the turn has half the digits.
///
/// Throws InputError unless both have the same number of loops and `matching` is one to one, and
/// PreconditionError unless it takes the outer loop of `map_a` to that of `map_b`, and so the inner one. Two
/// right-hand sides for A's factored Laplacian, and O(m log m + n log m) for n vertices and m triangles of B.
Registration registered(const OneForms& a, const CircularMap& map_a, const surface::TriangleMesh& b,
                        const CircularMap& map_b, const RegistrationOptions& options = {},
                        const Progress& progress = {});

} // namespace tetrarch::slit
