// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// JSON that a struct keeps, without what the JSON library's own header costs those who include it.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace tetrarch::format {

/// JSON whose members keep their order. To look inside, include <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// A JSON value that never changes, and that copies share. O(1) but for `parse` and comparison.
class JsonValue {
public:
  JsonValue() = default; ///< null
  JsonValue(std::nullptr_t) {}
  JsonValue(Json value);
  /// Throws InputError if the text is no JSON.
  static JsonValue parse(std::string_view text);

  bool is_null() const;
  const Json& get() const;
  operator const Json&() const { return get(); }
  friend bool operator==(const JsonValue& a, const JsonValue& b);

private:
  std::shared_ptr<const Json> value_;
};

} // namespace tetrarch::format
