// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Invariants of handlebodies in space, where no structure decides: images in finite groups.
///
///     kernel of the handlebody  <  group of the boundary  -->  group of the exterior  --rho-->  G
///
/// For each homomorphism rho to a small group G the orders of the images of the three: how many rho have each
/// triple of orders is an invariant of the pair, because a homeomorphism of pairs takes each group to its
/// counterpart. The exterior alone determines only the last two. Source: the invariant is that of Bellettini,
/// Paolini and Wang, "On closed oriented surfaces in the 3-sphere" (2019), in its plainest form.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/moves/monodromy.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::identify {

/// The groups asked, small ones first: "S3", "A4", "S4", "A5".
std::vector<std::string> finite_groups();

/// How many homomorphisms have which orders: of the exterior's image, the boundaries' and the kernels', each
/// sorted by boundary component. Nothing where there are more candidates than `most` to look at.
using ImageCounts = std::map<std::vector<int>, long long>;
std::optional<ImageCounts> image_counts(const Triangulation& tri, const moves::Monodromy& monodromy,
                                        const std::string& group, long long most = 3'000'000,
                                        const Progress& progress = {});

} // namespace tetrarch::identify
