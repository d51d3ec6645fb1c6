// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::format {
namespace {

template <class T>
std::optional<T> parse_whole(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

} // namespace

std::string_view trimmed(std::string_view text) {
  std::size_t first = 0;
  std::size_t last = text.size();
  while (first < last && is_space(text[first])) ++first;
  while (last > first && is_space(text[last - 1])) --last;
  return text.substr(first, last - first);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  return parse_whole<std::int64_t>(text);
}

std::optional<double> parse_double(std::string_view text) {
  return parse_whole<double>(text);
}

std::string to_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

bool has_extension(std::string_view path, std::string_view extension) {
  if (path.size() < extension.size()) return false;
  const std::string_view tail = path.substr(path.size() - extension.size());
  return std::equal(tail.begin(), tail.end(), extension.begin(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::string found_expected(std::string_view token, std::string_view expected) {
  std::string text = token.empty() ? std::string("the text ends") : "found " + in_quotes(token);
  text += ", expected ";
  text += expected;
  return text;
}

int line_of(std::string_view text, std::size_t offset) {
  int line = 1;
  for (std::size_t k = 0; k < std::min(offset, text.size()); ++k)
    line += text[k] == '\n' || (text[k] == '\r' && text.substr(k + 1, 1) != "\n") ? 1 : 0;
  return line;
}

bool TextCursor::at_end() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  return at_ == text_.size();
}

// Lines are counted only when someone asks, which is when something is wrong: reading stays one plain pass.
int TextCursor::line_at(std::size_t offset) const {
  if (offset >= text_.size()) {
    offset = text_.size();
    while (offset > 0 && is_space(text_[offset - 1])) --offset;
  }
  return line_of(text_, offset);
}

int TextCursor::line() {
  at_end();
  return line_at(at_);
}

Place TextCursor::here() {
  return {source_, line()};
}

std::size_t TextCursor::token_end() const {
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end])) ++end;
  return end;
}

std::string_view TextCursor::peek() {
  if (at_end()) return text_.substr(text_.size());
  return text_.substr(at_, token_end() - at_);
}

std::string_view TextCursor::token(std::string_view expected) {
  const std::string_view next = peek();
  if (next.empty()) fail_at(next, expected);
  at_ += next.size();
  return next;
}

std::int64_t TextCursor::integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
  const std::string_view next = token(expected);
  const std::optional<std::int64_t> value = parse_integer(next);
  if (!value || *value < least || *value > greatest) fail_at(next, expected);
  return *value;
}

double TextCursor::number(std::string_view expected, bool finite) {
  const std::string_view next = token(expected);
  const std::optional<double> value = parse_double(next);
  if (!value || (finite && !std::isfinite(*value))) fail_at(next, expected);
  return *value;
}

std::string_view TextCursor::rest_of_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view rest = text_.substr(at_, end - at_);
  at_ = std::min(end + (text_.substr(end, 2) == "\r\n" ? 2 : 1), text_.size());
  return trimmed(rest);
}

Place TextCursor::place_of(std::string_view token) const {
  return {source_, line_at(static_cast<std::size_t>(token.data() - text_.data()))};
}

void TextCursor::fail_at(std::string_view token, std::string_view expected) const {
  throw InputError(place_of(token), found_expected(token, expected));
}

} // namespace tetrarch::format
