// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The circular domain: a ring with concentric slits, mapped conformally so that every slit becomes a circle.
///
///      .-----------.           .-----------.      1. Each slit is opened by the square root that its ends
///     /    .--      \         /    _        \        call for, cut along the slit and not along a straight
///    |    | (O)      |  -->  |    (_)(O)     |       line; later slits are arcs no longer by then.
///     \         --' /         \         o   /     2. What is a circle after its own opening is bent by the
///      '-----------'           '-----------'         others. So curve by curve, the outer one too, the
///      outside of each (the inside of the outer one) is mapped to that of a circle, all else carried along,
///      round after round. Each takes the errors down by a factor.
///
/// Only curves are mapped: each by N samples at equal steps of a parameter t in which it is smooth. On
/// circles t is the angle; on a slit the angle is middle + half cos t, with t from 0 to pi on the bank
/// toward the origin, so that the opened slit is run through counterclockwise.
///
/// Everything is done in zeta = log z, where a ring of modulus 700 is a strip of that width, and where no
/// curve is smaller than its offsets can tell. Maps keep 0 in its place, and infinity or the unit circle.
///
/// Circular domains are unique up to Moebius maps. Here the outer circle is the unit circle, the inner one
/// has its center at 0, and the circle of the first slit its center on the positive real axis. Source: Yin,
/// section 2.3.3, for the openings; Koebe's iteration for the rest.

#include "tetrarch/core/progress.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace tetrarch::slit {

/// On the circle about 0 of this radius, from angle `start` counterclockwise to `end`, less than a full turn.
struct Arc {
  double radius = 0;
  double start = 0;
  double end = 0;
};

/// The ring between the circle of radius `inner` and the unit circle.
struct SlitRing {
  double inner = 0;
  std::vector<Arc> slits;
};

struct Circle {
  std::complex<double> center;
  double radius = 0;
  /// Greatest deviation of a sample of the curve from the circle, in radii.
  double circularity = 0;
};

/// A closed curve in the plane of zeta = log z: its samples are center + offset. Around 0, offsets end a full
/// turn above the first one.
struct LogCurve {
  std::complex<double> center;
  std::vector<std::complex<double>> offset;

  std::complex<double> at(std::size_t j) const { return center + offset[j]; }
  std::size_t size() const { return offset.size(); }
};

/// By curve: the outer circle, the inner one, then the slits in their order.
using LogCurves = std::vector<LogCurve>;

/// The circles that the slits become.
struct CircularDomain {
  std::vector<Circle> circles;
  LogCurves curves; ///< where the samples come to lie
  int rounds = 0;
  double circularity = 0; ///< the greatest
  /// The part of the curves that the samples leave unresolved, relative: see `Periodic`.
  double unresolved = 0;
  bool found = false; ///< whether circularity and unresolved are below `tolerance`
};

struct CircularOptions {
  double tolerance = 1e-9;
  int most_rounds = 60;
  int samples = 128;       ///< of each curve at first, a power of 2
  int most_samples = 8192; ///< doubled up to here while curves are not resolved and more may resolve them
};

/// Throws PreconditionError unless 0 < inner < radius < 1 and the length is positive for all slits; there is
/// no check whether slits touch. If the iteration does not converge, `found` is false and the curves are
/// those of the last round; if curves ran into each other on the way, those before the first round. For n
/// curves of N samples: O(n^2 N^2) a round, about 5 to 10 rounds; 8 N^2 bytes.
CircularDomain circular_domain(const SlitRing& ring, const CircularOptions& options = {},
                               const Progress& progress = {});

/// The curves once the first `slits` slits are open, by so many samples of each curve: those of the ring
/// itself for 0. Throws as above. O(n N^2) a slit.
LogCurves opened_slits(const SlitRing& ring, const std::vector<int>& samples, std::size_t slits);

/// The places z of curve k at any parameter. O(N log N) once, then O(1) each.
std::vector<std::complex<double>> curve_at(const CircularDomain& domain, int curve,
                                           const std::vector<double>& t);

} // namespace tetrarch::slit
