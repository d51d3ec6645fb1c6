// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Meshes, and what is known at their vertices and elements, as a JSON object, versioned.
///
///     {
///       "format": "tetrarch-mesh",
///       "version": 1,
///       "name": "a ring",
///       "vertices": [
///         [0, 0, 0],
///         ...
///       ],
///       "triangles": [ [0, 1, 2], ... ],
///       "triangle_tags": [ 1, ... ],
///       "tetrahedra": [ [0, 1, 2, 3], ... ],
///       "tetrahedron_tags": [ 1, ... ],
///       "hexahedra": [ [0, 1, 2, 3, 4, 5, 6, 7], ... ],
///       "fields": [
///         { "name": "angle", "on": "vertices", "values": [ 0.25, ... ] },
///         { "name": "uv", "on": "triangle corners", "values": [ [0, 0.5], ... ] }
///       ],
///       "provenance": { ... }
///     }
///
/// Only format, version and vertices must be there. A tag says to which patch a triangle, or to
/// which region a tetrahedron belongs; a hexahedron names its bottom, then its top, both counter-clockwise
/// from above. Entries of arrays stand one a line.
///
/// Indices count from 0 and are in range. A field has one entry for each thing that it is on: corners of
/// triangles count 3 t + c, of tetrahedra 4 t + c. An entry is a number, or an array of two or three of them,
/// alike all over the field; null stands where there is no value. The schema is
/// census/schema/mesh.schema.json. Laws as in json.hpp; numbers keep every bit.

#include "tetrarch/format/document.hpp"
#include "tetrarch/format/soup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

inline constexpr std::string_view mesh_json_format_tag = "tetrarch-mesh";
inline constexpr int mesh_json_format_version = 1;

/// Numbers at the vertices, elements or corners of a mesh.
struct MeshField {
  enum class On : std::uint8_t {
    vertices,
    triangles,
    tetrahedra,
    hexahedra,
    triangle_corners,
    tetrahedron_corners
  };
  std::string name;
  On on = On::vertices;
  int components = 1;         ///< of an entry, 1 to 3
  std::vector<double> values; ///< entry after entry; NaN: none
  JsonValue members;          ///< the object as it was read; null: not read
};

struct MeshDocument {
  Soup soup;
  std::vector<std::array<int, 8>> hexahedra;
  std::string name; ///< UTF-8; empty: none
  std::vector<MeshField> fields;
  JsonValue provenance; ///< an object that says where all this came from; null: none
  JsonValue members; ///< the object as it was read, for its unknown members and their order; null: not read
};

/// The points, elements and tags of a soup.
MeshDocument mesh_document_of(Soup soup);

/// How many entries a field on those has.
std::size_t entries(const MeshDocument& mesh, MeshField::On on);

/// A field of one, two or three numbers at each place.
MeshField field_of(std::string name, MeshField::On on, const std::vector<double>& values);
MeshField field_of(std::string name, MeshField::On on, const std::vector<std::array<double, 2>>& values);
MeshField field_of(std::string name, MeshField::On on, const std::vector<std::array<double, 3>>& values);

/// The field of that name, or null if there is none.
const MeshField* find_field(const MeshDocument& mesh, std::string_view name);

/// Throws InputError with the line, the member and the cause for anything that is not as described above.
/// While it is read, an element takes some 150 bytes. O(length).
MeshDocument read_mesh_json(std::string_view text, const std::string& source);

/// Canonical text. Throws InputError where an index is out of range, PreconditionError for a field of another
/// number of entries, for infinite numbers, and for a number of components other than 1 to 3. O(size).
std::string write_mesh_json(const MeshDocument& mesh);

/// Whether `text` is a JSON object whose member "format" says "tetrarch-mesh". O(what stands before it).
bool looks_like_mesh_json(std::string_view text);

} // namespace tetrarch::format
