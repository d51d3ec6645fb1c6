// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Maps of triangles into the plane, brought nearer to isometries without a fold.
///
///        .               .             The linear map of a triangle from its wanted shape has singular
///       / .             | .           values s1, s2 > 0. Its energy, weight times
///      /   .    --->    |  .
///     .-----.           .---.             (s1^2 + s2^2 + 1/s1^2 + 1/s2^2) / 4,
///
/// is 1 for isometries and infinite where the triangle folds: the symmetric Dirichlet energy. It is the
/// product of what angles suffer and what areas suffer, (s1/s2 + s2/s1)/2 and (s1 s2 + 1/(s1 s2))/2, so it
/// trades one for the other.
///
/// Points move freely, along a line, or round a circle. Far from the minimum the quadratic model is that of
/// reweighted least squares, which goes straight for the rotation nearest by; then Newton's, made positive by
/// the energy's known eigenvalues. No step goes as far as where a triangle becomes flat, and each lowers the
/// energy. Only the edges of triangles are kept, so the plane may as well be a cylinder.
///
/// Sources: Rabinovich, Poranne, Panozzo and Sorkine-Hornung, "Scalable locally injective mappings" (2017);
/// Smith and Schaefer, "Bijective parameterization with free boundaries" (2015), for the length of steps;
/// Smith, de Goes and Kim, "Analytic eigensystems for isotropic distortion energies" (2019).

#include "tetrarch/core/progress.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace tetrarch::unfold {

/// Two edges of a triangle, from corner 0 to corners 1 and 2.
using FlatEdges = std::array<std::complex<double>, 2>;

struct FlatElement {
  std::array<int, 3> corner{}; ///< points
  FlatEdges wanted{};          ///< counterclockwise
  FlatEdges now{};             ///< where the triangle lies, counterclockwise too
  double weight = 1;
};

/// Whether both triangles are counterclockwise, as `relaxed` wants them: rounding may have turned thin ones
/// over.
bool is_counterclockwise(const FlatElement& element);

/// Where a point may go.
struct FlatFreedom {
  enum class Kind : std::uint8_t { free, line, circle, fixed } kind = Kind::free;
  std::complex<double> arm{}; ///< along the line; from the center of the circle to the point
};

struct FlatOptions {
  int most_steps = 200;
  double least_gain = 1e-4; ///< of the energy in a step, in terms of it: with less it is done
};

struct Relaxed {
  std::vector<std::complex<double>> shift; ///< of each point
  double before = 1;                       ///< mean energy
  double after = 1;
  int steps = 0;
  bool settled = false; ///< whether the gain became as small as wanted
};

/// Throws PreconditionError where an element is turned over or flat, or a corner is no point; Stopped. Points
/// of no element stay. If the energy is too large for a double, nothing moves. One sparse factorization of
/// two numbers a point in each step, some 10 to 50 steps.
[[nodiscard]] Relaxed relaxed(std::vector<FlatElement> elements, std::vector<FlatFreedom> freedom,
                              const FlatOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::unfold
