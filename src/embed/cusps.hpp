// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where cusps are cut off: the horospheres that a metric's lengths are measured to.

#include "tetrarch/hyperbolic/metric.hpp"

namespace tetrarch::embed {

/// The same structure with every cusp's horosphere moved so that its cross-section has this area; all of them
/// moved further out together where an edge would come out shorter than 0.2. O(n).
template <class Scalar>
hyperbolic::Metric<Scalar> with_cusp_area(const Skeleton& skeleton, const hyperbolic::Metric<Scalar>& lengths,
                                          const Table<VertexId, hyperbolic::VertexType>& types, double area);

} // namespace tetrarch::embed
