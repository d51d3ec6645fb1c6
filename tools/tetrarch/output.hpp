// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Files of triangulations as results.

#include "command.hpp"

#include "tetrarch/format/document.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/format/read.hpp"

#include <string>

namespace tetrarch::program {

/// For a command that writes one format alone: throws InputError unless the file has its extension, ".json".
/// (That files can be written is asked by the parser.) An empty path is none.
void require_extension(const std::string& path, const std::string& extension);

/// The format that the extension of an output file names. Throws InputError that lists what is known.
format::FileFormat output_format(const std::string& path);

/// The same for a mesh.
format::MeshFormat mesh_output_format(const std::string& path);

/// Adds the file to the result, and what its reader will miss to the warnings.
void add_file(Result& result, const std::string& path, const format::Document& document);

} // namespace tetrarch::program
