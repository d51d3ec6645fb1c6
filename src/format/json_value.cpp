// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/json_value.hpp"

#include "tetrarch/core/error.hpp"

#include <nlohmann/json.hpp>

namespace tetrarch::format {

JsonValue::JsonValue(Json value) : value_(std::make_shared<const Json>(std::move(value))) {}

JsonValue JsonValue::parse(std::string_view text) {
  try {
    return {Json::parse(text)};
  } catch (const Json::exception& e) {
    throw InputError(e.what());
  }
}

bool JsonValue::is_null() const {
  return value_ == nullptr || value_->is_null();
}

const Json& JsonValue::get() const {
  static const Json null;
  return value_ == nullptr ? null : *value_;
}

bool operator==(const JsonValue& a, const JsonValue& b) {
  return a.value_ == b.value_ || a.get() == b.get();
}

} // namespace tetrarch::format
