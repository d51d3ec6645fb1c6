// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// JSON text to a tree, one pass, with the suspicion that files deserve.
///
/// The tree is built from the events of nlohmann's parser rather than by its own builder, because that one
/// keeps the last of two equal keys, knows no depth limit and rounds long numbers. The gluings never enter
/// the tree: as JSON values they would take some 700 bytes per tetrahedron, in a table they take 32.

#include "gluing_table.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/format/text.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// A way down from the root: member names, and positions in arrays.
struct JsonStep {
  std::string key; ///< of a member; an array entry has none
  std::size_t index = 0;
  bool is_key = false;

  explicit JsonStep(std::string k) : key(std::move(k)), is_key(true) {}
  explicit JsonStep(std::size_t i) : index(i) {}
  friend bool operator==(const JsonStep&, const JsonStep&) = default;
};
using JsonPath = std::vector<JsonStep>;

/// "metric.edge_lengths[3][2]"; empty for the root.
std::string path_text(const JsonPath& path);

/// Something in a JSON text that is not as it should be. Thrown, and turned into an InputError with a line by
/// whoever has the text.
struct JsonFault {
  JsonPath path;
  std::string what;
  int occurrence = 1; ///< 2: the second value of that path is meant
};

/// The 1-based line of the character at `offset`.
int line_at(std::string_view text, std::size_t offset);

/// The 1-based line on which the faulty value starts (an array or object: where it opens); 1 if there is no
/// such value. Reads the text again, up to there: for complaints only.
int line_of(std::string_view text, const JsonFault& fault);

/// "the string 'x'", "the number 3", "null", "an array": what was found, for a complaint.
std::string describe(const Json& value);

/// What the members "format" and "version" of the root must say.
struct JsonHeader {
  std::string_view format;
  int version = 1;
  bool has_gluings = false; ///< the member "gluings" goes into a table
};

struct JsonTree {
  Json root; ///< an object; its member "gluings" is null where it went into the table
  GluingTable gluings;
};

/// Throws InputError where the text is no JSON, JsonFault where it is JSON of the wrong shape: no object at
/// the root, a repeated key, nesting too deep, a number beyond a double, "format", "version" or "gluings"
/// missing or wrong in itself. O(length).
JsonTree parse_tree(std::string_view text, const std::string& source, const JsonHeader& header);

/// The member "format" of the object that `text` is; empty where it is none, or says nothing. O(what stands
/// before it).
std::string json_format_of(std::string_view text);

/// What `make` makes of the tree. Throws InputError with the line and the path of whatever is faulty.
template <class Make>
auto read_tree(std::string_view text, const std::string& source, const JsonHeader& header, Make make) {
  if (trimmed(text).empty()) throw InputError(Place{source, 0}, "the text is empty, expected a JSON object");
  try {
    return make(parse_tree(text, source, header));
  } catch (const JsonFault& fault) {
    const std::string path = path_text(fault.path);
    throw InputError(Place{source, line_of(text, fault)},
                     path.empty() ? fault.what : path + ": " + fault.what);
  }
}

} // namespace tetrarch::format
