// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Files of triangulations as results.

#include "command.hpp"

#include "tetrarch/format/document.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/read.hpp"

#include <functional>
#include <string>

namespace tetrarch::program {

/// For `Option::output_file`, of a command that writes one format alone: refuses files without its extension,
/// ".json".
std::function<void(const std::string&)> with_extension(const std::string& extension);

/// For `Option::output_file`: refuses files whose extension names no format of triangulations.
void require_triangulation(const std::string& path);

/// The format that the extension of an output file names. Throws InputError that lists what is known.
format::FileFormat output_format(const std::string& path);

/// The same for a mesh.
format::MeshFormat mesh_output_format(const std::string& path);

/// Adds the file to the result, and what its reader will miss to the warnings.
void add_file(Result& result, const std::string& path, const format::Document& document);

} // namespace tetrarch::program
