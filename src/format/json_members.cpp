// SPDX-License-Identifier: GPL-2.0-or-later
#include "json_members.hpp"

namespace tetrarch::format {

void fail(JsonPath path, std::string what) {
  throw JsonFault{std::move(path), std::move(what), 1};
}

void fail_found(JsonPath path, const Json& found, const std::string& expected) {
  fail(std::move(path), "found " + describe(found) + ", expected " + expected);
}

JsonPath below(JsonPath path, std::size_t index) {
  path.emplace_back(index);
  return path;
}

JsonPath below(JsonPath path, std::string key) {
  path.emplace_back(std::move(key));
  return path;
}

Json* member(Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

Json& required(Json& object, const char* key, const JsonPath& path) {
  Json* const found = member(object, key);
  if (found == nullptr) fail(path, "the member \"" + std::string(key) + "\" is missing");
  return *found;
}

std::string read_text(Json& object, const char* key, const JsonPath& path) {
  const Json* const text = member(object, key);
  if (text == nullptr) return {};
  if (!text->is_string()) fail_found(below(path, key), *text, "a string");
  return text->get<std::string>();
}

Json take_object(Json& object, const char* key) {
  Json* const value = member(object, key);
  if (value == nullptr) return nullptr;
  if (!value->is_object()) fail_found({JsonStep(key)}, *value, "an object");
  return std::exchange(*value, nullptr);
}

Number read_number(const Json& value, const JsonPath& path) {
  const std::string expected = "a number or a string of digits";
  if (value.is_number_float()) return Number(value.get<double>());
  if (value.is_number()) {
    // 2^53: every integer up to there is a double.
    constexpr std::int64_t last_exact = std::int64_t{1} << 53;
    const bool exact = value.is_number_unsigned() ? value.get<std::uint64_t>() <= std::uint64_t{last_exact}
                                                  : value.get<std::int64_t>() >= -last_exact;
    if (exact) return Number(value.get<double>());
    if (to_text(value.get<double>()) == value.dump()) return Number(value.get<double>());
    fail_found(path, value, "a string of digits, because a double would lose some");
  }
  if (value.is_string() && is_decimal(value.get_ref<const std::string&>()))
    return Number(value.get<std::string>());
  fail_found(path, value, expected);
}

double read_double(const Json& value, const JsonPath& path) {
  if (value.is_number_float()) return value.get<double>(); // not by way of a Number, which knows no -0
  if (!value.is_number()) fail_found(path, value, "a number");
  return read_number(value, path).value();
}

int read_integer(const Json& value, const JsonPath& path, int least, int greatest,
                 const std::string& expected) {
  // An unsigned number beyond the signed ones would come back as another one.
  const bool fits = value.is_number_integer() &&
                    (!value.is_number_unsigned() || value.get<std::uint64_t>() <= std::uint64_t{INT32_MAX});
  if (!fits || value.get<std::int64_t>() < least || value.get<std::int64_t>() > greatest)
    fail_found(path, value, expected);
  return value.get<int>();
}

void require_array(const Json& list, const JsonPath& path, std::optional<std::size_t> count,
                   const std::string& entries) {
  const std::string expected = (count ? std::to_string(*count) + " " : "") + entries;
  if (!list.is_array()) fail_found(path, list, "an array of " + expected);
  if (count && list.size() != *count)
    fail(path, "found " + std::to_string(list.size()) + " entries, expected " + expected);
}

} // namespace tetrarch::format
