// SPDX-License-Identifier: GPL-2.0-or-later
#include "json_text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace tetrarch::format {

std::string indent(int depth) {
  return std::string(static_cast<std::size_t>(2 * depth), ' ');
}

std::string dumped(const Json& value, int depth) {
  const std::string flat = value.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (const char c : flat) { // a line break stands between tokens only: in strings it is escaped
    text += c;
    if (c == '\n') text += indent(depth);
  }
  return text;
}

std::string object_text(const Json& read, std::vector<JsonMember> known, int depth) {
  std::string text;
  constexpr std::size_t more = 64; // for its key, and what stands around it
  std::size_t size = more;
  for (const JsonMember& m : known) size += m.text ? m.text->size() + more : 0;
  text.reserve(size);
  const auto add = [&](const std::string& key, std::optional<std::string> value) {
    text += (text.empty() ? "{\n" : ",\n") + indent(depth + 1) + dumped(Json(key), 0) + ": ";
    text += *value;
  };
  if (read.is_object()) {
    for (const auto& [key, value] : read.items()) {
      const auto at =
          std::find_if(known.begin(), known.end(), [&k = key](const JsonMember& m) { return m.key == k; });
      if (at == known.end())
        add(key, dumped(value, depth + 1));
      else if (at->text)
        add(key, std::exchange(at->text, std::nullopt));
    }
  }
  for (JsonMember& m : known)
    if (m.text) add(m.key, std::exchange(m.text, std::nullopt));
  if (text.empty()) return "{}";
  text += "\n" + indent(depth) + "}";
  return text;
}

std::vector<JsonMember> first_members(std::string_view format, int version, const std::string& name) {
  std::vector<JsonMember> members{{"format", dumped(Json(std::string(format)), 0)},
                                  {"version", std::to_string(version)},
                                  {"name", std::nullopt}};
  if (!name.empty()) members.back().text = dumped(Json(name), 0);
  return members;
}

JsonMember provenance_member(const Json& provenance) {
  if (provenance.is_null()) return {"provenance", std::nullopt};
  if (!provenance.is_object()) throw PreconditionError("the provenance of a document must be an object");
  return {"provenance", dumped(provenance, 1)};
}

std::string double_text(double value) {
  if (std::isnan(value)) return "null";
  if (std::isinf(value)) throw PreconditionError("JSON holds no infinite numbers");
  if (value == 0 && std::signbit(value)) return "-0.0"; // -0 would be read as the integer 0
  return to_text(value);
}

} // namespace tetrarch::format
