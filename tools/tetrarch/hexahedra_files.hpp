// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Files of hexahedra: what `hex` and `product` write alike.

#include "command.hpp"

#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/show/product.hpp"

#include <string>

namespace tetrarch::program {

/// Says who made the mesh from what.
void add_provenance(format::MeshDocument& document, const Json& provenance);

/// The text of a file of hexahedra, its format from its extension: .mesh, .json, or one of a scene.
std::string hexahedra_file(const std::string& path, const format::MeshDocument& document,
                           const show::HexahedraData& data, const std::string& title);

} // namespace tetrarch::program
