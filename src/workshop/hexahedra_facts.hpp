// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What results with hexahedra say alike: where they are bad, and the file that keeps them.

#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/product/hex_mesh.hpp"
#include "tetrarch/workshop/tree.hpp"
#include "tetrarch/workshop/type.hpp"

#include <string>
#include <vector>

namespace tetrarch::workshop {

/// "(1, 0.5, 2)".
std::string text_of(const product::Point& p);
/// "h12 -0.0345 at (1, 0.5, 2)".
std::string text_of(const product::BadHexahedron& bad);
/// The same of each, separated by commas.
std::string text_of(const std::vector<product::BadHexahedron>& bad);

/// Of each: hexahedron, scaled_jacobian, at.
Tree tree_of(const std::vector<product::BadHexahedron>& bad);
/// Of that tree.
Type bad_hexahedra_type();

/// Hexahedra of a scaled Jacobian below 0.2; solvers are content above.
long long count_below_good(const product::HexQuality& quality);

/// The hexahedra, with the field scaled_jacobian on them.
format::MeshDocument document_of(const product::HexMesh& mesh, const std::vector<double>& scaled_jacobian);

} // namespace tetrarch::workshop
