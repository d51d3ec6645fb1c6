// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A finite presentation of a group as a JSON object, versioned.
///
///     {
///       "format": "tetrarch-group",
///       "version": 1,
///       "name": "figure eight",
///       "generators": 2,
///       "relators": [
///         [1, -2, 1, 2, -1]
///       ],
///       "provenance": { ... }
///     }
///
/// Only name and provenance may be missing. Generator g is the letter g+1 and its inverse the letter -(g+1);
/// a word reads from left to right.
///
/// The schema is census/schema/group.schema.json. Laws as in json.hpp.

#include "tetrarch/format/document.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

inline constexpr std::string_view group_json_format_tag = "tetrarch-group";
inline constexpr int group_json_format_version = 1;

/// The first two members are those of algebra::Presentation, a room that this one does not know.
struct GroupDocument {
  int generators = 0;
  std::vector<std::vector<int>> relators;
  std::string name;     ///< UTF-8; empty: none
  JsonValue provenance; ///< an object that says where all this came from; null: none
  JsonValue members; ///< the object as it was read, for its unknown members and their order; null: not read
};

/// Throws InputError with the line, the member and the cause for anything that is not as described above,
/// letters that name no generator among them. O(length).
GroupDocument read_group_json(std::string_view text, const std::string& source);

/// Canonical text. Throws PreconditionError for a letter that names no generator. O(size).
std::string write_group_json(const GroupDocument& group);

/// Whether `text` is a JSON object whose member "format" says "tetrarch-group". O(what stands before it).
bool looks_like_group_json(std::string_view text);

} // namespace tetrarch::format
