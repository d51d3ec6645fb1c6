// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The files that `slit` writes.

#include "slit_maps.hpp"

#include "tetrarch/format/mesh_json.hpp"

#include <string>

namespace tetrarch::program {

/// The surface with its map: of each corner the place in the domain and the texture coordinates, as vertices
/// on a seam have two; and what is known at vertices and triangles.
format::MeshDocument slit_document(const MadeSlitMap& made, const SlitOptions& options);

/// The content of a file, by its extension.
std::string slit_file(const std::string& path, const MadeSlitMap& made, const SlitOptions& options);

} // namespace tetrarch::program
