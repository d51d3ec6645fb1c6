// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Members of JSON objects to values. Whatever is not as expected is thrown as a JsonFault.

#include "json_tree.hpp"

#include "tetrarch/format/document.hpp"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {

[[noreturn]] void fail(JsonPath path, std::string what);
/// "found X, expected ...".
[[noreturn]] void fail_found(JsonPath path, const Json& found, const std::string& expected);

JsonPath below(JsonPath path, std::size_t index);
JsonPath below(JsonPath path, std::string key);

/// A member, or null if there is none.
Json* member(Json& object, const char* key);
/// A member that must be there; `path` is that of the object.
Json& required(Json& object, const char* key, const JsonPath& path = {});

/// The text of a member; empty if there is none.
std::string read_text(Json& object, const char* key, const JsonPath& path = {});
/// A member that is an object, which becomes null; null if there is none.
Json take_object(Json& object, const char* key);

/// Any number that a double holds, or a text of digits.
Number read_number(const Json& value, const JsonPath& path);
/// A number that a double holds.
double read_double(const Json& value, const JsonPath& path);
/// An integer in [least, greatest]; `expected` says what it is.
int read_integer(const Json& value, const JsonPath& path, int least, int greatest,
                 const std::string& expected);

/// Throws unless `list` is an array, of `count` entries where that is given; `entries` says what they are.
void require_array(const Json& list, const JsonPath& path, std::optional<std::size_t> count,
                   const std::string& entries);

/// A list of entries, each read by `read(entry, path)`. The list becomes null: what was read need not be kept
/// twice.
template <class Read>
auto take_list(Json& list, const JsonPath& path, std::optional<std::size_t> count, const std::string& entries,
               Read read) {
  require_array(list, path, count, entries);
  std::vector<decltype(read(list[0], path))> out;
  out.reserve(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) out.push_back(read(list[k], below(path, k)));
  list = nullptr;
  return out;
}

/// An array of `size` entries, each read by `read(entry, path)`.
template <std::size_t size, class Read>
auto read_array(const Json& list, const JsonPath& path, const std::string& entries, Read read) {
  require_array(list, path, size, entries);
  std::array<decltype(read(list[0], path)), size> out{};
  for (std::size_t k = 0; k < size; ++k) out[k] = read(list[k], below(path, k));
  return out;
}

} // namespace tetrarch::format
