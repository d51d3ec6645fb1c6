// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The files that `slit` writes.

#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/slit.hpp"

#include <string>

namespace tetrarch::program {

/// The surface with its map, and where it came from. `input` as it was typed.
format::MeshDocument slit_document(const workshop::ConformalMap& found, const std::string& input);

/// The content of a file, by its extension.
std::string slit_file(const std::string& path, const workshop::ConformalMap& found, const std::string& input);

} // namespace tetrarch::program
