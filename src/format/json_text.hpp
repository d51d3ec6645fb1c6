// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The canonical layout: lists with one entry a line, all else indented by two; members in the order in which
/// they were read, then new ones in the order of the format.

#include "tetrarch/format/document.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// A member and its value as text; no text: the document has no such member.
struct JsonMember {
  std::string key;
  std::optional<std::string> text;
};

/// Any value. Strings of a document are UTF-8; what is not becomes U+FFFD rather than an exception in the
/// midst of saving.
std::string dumped(const Json& value, int depth);

/// Two spaces for each level.
std::string indent(int depth);

/// The members of `read` in their order, known ones with their new text, then the known ones that are new.
/// The text of each is let go as soon as it is copied: of a large document the whole is there once, not
/// twice.
std::string object_text(const Json& read, std::vector<JsonMember> known, int depth);

/// An array of `size` entries, one a line, the k-th as `text(k)` says.
template <class Text>
std::string array_text(std::size_t size, int depth, Text text) {
  if (size == 0) return "[]";
  std::string array = "[";
  const std::string start = "\n" + indent(depth + 1);
  // Room for all is made once, as the first entries say, and a tenth more: growth by doubling needs thrice.
  constexpr std::size_t sample = 1000;
  for (std::size_t k = 0; k < size; ++k) {
    if (k > 0) array += ',';
    array += start;
    array += text(k);
    if (k == sample) array.reserve(size / sample * array.size() / 10 * 11);
  }
  array += "\n" + indent(depth) + "]";
  return array;
}

/// The members that every format has: "format" and "version", "name" if there is one ...
std::vector<JsonMember> first_members(std::string_view format, int version, const std::string& name);
/// ... and "provenance". Throws PreconditionError unless it is an object or null.
JsonMember provenance_member(const Json& provenance);

/// The fewest digits that read back as the same double, signed zeros included; null for what is no number.
/// Throws PreconditionError if `value` is infinite.
std::string double_text(double value);

/// `entries` in brackets, each as `text(entry)` says.
template <class Entries, class Text>
std::string row_text(const Entries& entries, Text text) {
  std::string line;
  for (const auto& entry : entries) line += (line.empty() ? "[" : ", ") + text(entry);
  return (line.empty() ? "[" : line) + "]";
}

/// `list` as an array with one entry a line, each as `text(entry)` says; nothing if it is empty.
template <class List, class Text>
std::optional<std::string> list_text(const List& list, int depth, Text text) {
  if (list.empty()) return std::nullopt;
  return array_text(list.size(), depth, [&](std::size_t k) { return text(list[k]); });
}

/// Each entry an array of integers.
template <class List>
std::optional<std::string> integer_rows_text(const List& list, int depth) {
  const auto integer = [](int value) { return std::to_string(value); };
  return list_text(list, depth, [&integer](const auto& row) { return row_text(row, integer); });
}

} // namespace tetrarch::format
