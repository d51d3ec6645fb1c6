// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A disk laid flat: Tutte's embedding.
///
/// The boundary goes around the unit circle in equal steps, every vertex inside is the mean of its
/// neighbors. Where the disk is simplicial and no edge inside joins two boundary vertices, no triangle is
/// inverted or flat; coarse disks may have flat triangles. Source: Tutte, "How to draw a graph" (1963).

#include "tetrarch/surface/surface.hpp"

#include <array>
#include <vector>

namespace tetrarch::surface {

/// A point in the closed unit disk for each vertex, counterclockwise. Throws `PreconditionError` unless the
/// surface is connected with one boundary curve and no turned mates. One sparse factorization.
std::vector<std::array<double, 2>> tutte_embedding(const Surface& disk);

} // namespace tetrarch::surface
