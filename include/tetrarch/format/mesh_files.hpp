// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Any mesh file, recognised by what stands in it.
///
/// | format | extension  | holds       | begins with                            |
/// | ------ | ---------- | ----------- | -------------------------------------- |
/// | medit  | .mesh      | both        | MeshVersionFormatted                   |
/// | meshb  | .meshb     | both        | the integer 1 as bytes                 |
/// | gmsh   | .msh       | both        | $MeshFormat, $Comments or $NOD         |
/// | tetgen | .node .ele | both        | numbers: known by its extension only   |
/// | vtk    | .vtk       | both        | # vtk DataFile                         |
/// | vtu    | .vtu .vtp  | both        | <VTKFile, within the first kilobytes   |
/// | obj    | .obj       | a surface   | v, vn, vt, o, g, mtllib or usemtl      |
/// | off    | .off       | a surface   | OFF, COFF, NOFF and the like           |
/// | stl    | .stl       | a surface   | solid, or the length says so (binary)  |
/// | ply    | .ply       | a surface   | ply                                    |
/// | json   | none       | both        | { and the member "format" says so      |
///
/// Where the text says nothing, the extension of the source does; .json is that of triangulations as well.
/// What JSON holds beyond a soup is had by mesh_json.hpp.

#include "tetrarch/format/soup.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::format {

enum class MeshFormat : std::uint8_t { medit, meshb, gmsh, tetgen, vtk, vtu, obj, off, stl, ply, json };

/// "medit", "meshb", "gmsh", "tetgen" and so on.
std::string name_of(MeshFormat format);
/// By the extension, in any case; none for others than those above.
std::optional<MeshFormat> mesh_format_for_extension(std::string_view path);

/// The format of `text`; none where neither the text nor the extension of `source` tells. O(1) but for white
/// space and comments at the beginning.
std::optional<MeshFormat> recognise_mesh(std::string_view text, const std::string& source);
inline bool looks_like_mesh(std::string_view text, const std::string& source) {
  return recognise_mesh(text, source).has_value();
}

/// The soup in `text`. Throws InputError of one line that names place and cause; among them: a format that is
/// not known, and TetGen's, of which one text is only half. O(length), a little more as the readers say.
Soup read_soup(std::string_view text, const std::string& source);
/// The same of a file, or of standard input for "-". Of TetGen's two files either may be named; the other is
/// found beside it.
Soup read_soup_file(const std::string& path);

/// Formats for a surface get the triangles alone. Throws InputError where an index is out of range, where a
/// format for surfaces would be left empty, and for TetGen's format, which is two texts.
/// O(size).
std::string write_soup(const Soup& soup, MeshFormat format);
/// What of a soup the format cannot hold.
Ledger not_held(const Soup& soup, MeshFormat format);
/// Writes to `path`, and with it to the others of TetGen's files, by the extension of `path`. Each
/// file appears whole or not at all. Throws InputError, also for an extension that is not known.
void write_soup_file(const Soup& soup, const std::string& path);

} // namespace tetrarch::format
