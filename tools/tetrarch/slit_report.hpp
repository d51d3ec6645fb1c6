// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `slit` says of a map, as JSON and as text.

#include "report.hpp"

#include "tetrarch/mesh/opened.hpp"
#include "tetrarch/slit/balance.hpp"
#include "tetrarch/slit/circular_map.hpp"
#include "tetrarch/slit/fingerprint.hpp"
#include "tetrarch/slit/quads.hpp"
#include "tetrarch/slit/quality.hpp"
#include "tetrarch/slit/ricci.hpp"
#include "tetrarch/slit/unflip.hpp"

#include <vector>

namespace tetrarch::program {

Report loops_report(const mesh::OpenedMesh& surface, const std::vector<mesh::BoundaryLoop>& loops);
/// `on_ring`: slits have radii, else heights.
Report map_report(const slit::SlitMap& map, bool on_ring);
Report circles_report(const slit::CircularMap& map);
Report unflipped_report(const slit::Unflipped& unflipped);
Report softened_report(const slit::Softened& softened);
/// `before`: what the distortion was.
Report balanced_report(const slit::Balanced& balanced, const slit::Distortion& before);
Report distortion_report(const slit::Distortion& distortion);
Report residuals_report(const slit::Residuals& residuals);
/// `order`: the loops as the rectangles come.
Report rectangle_report(const slit::RicciRectangles& found, const mesh::OpenedMesh& surface,
                        const std::vector<mesh::BoundaryLoop>& loops, const std::vector<int>& order);
Report quads_report(const slit::QuadMesh& quads);
Report fingerprint_report(const slit::Fingerprint& fingerprint);

} // namespace tetrarch::program
