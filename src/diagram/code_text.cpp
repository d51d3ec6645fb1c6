// SPDX-License-Identifier: GPL-2.0-or-later
#include "code_text.hpp"

#include "tetrarch/format/text.hpp"

#include <algorithm>

namespace tetrarch::diagram {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

} // namespace

char CodeText::next() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#')
      at_ = std::min(text_.find('\n', at_), text_.size());
    else if (format::is_space(c))
      ++at_;
    else
      return c;
  }
  return '\0';
}

bool CodeText::take(char c) {
  if (next() != c || c == '\0') return false;
  ++at_;
  return true;
}

void CodeText::skip(std::string_view letters) {
  while (next() != '\0' && letters.find(text_[at_]) != std::string_view::npos) ++at_;
}

char CodeText::open(std::string_view expected) {
  if (take('(')) return ')';
  if (take('[')) return ']';
  if (take('{')) return '}';
  fail_expected(expected);
}

void CodeText::close(char bracket) {
  if (!take(bracket)) fail_expected(std::string("'") + bracket + "'");
}

std::string CodeText::letters() {
  std::string letters;
  next();
  for (; at_ < text_.size() && is_letter(text_[at_]); ++at_) letters += text_[at_];
  return letters;
}

std::string CodeText::word() {
  std::string small = letters();
  for (char& c : small) c = static_cast<char>(c | 0x20);
  return small;
}

bool CodeText::at_integer() {
  const char c = next();
  if (is_digit(c)) return true;
  return (c == '-' || c == '+') && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
}

int CodeText::integer(std::string_view expected) {
  if (!at_integer()) fail_expected(expected);
  const bool negative = text_[at_] == '-';
  if (!is_digit(text_[at_])) ++at_;
  std::size_t end = at_;
  while (end < text_.size() && is_digit(text_[end])) ++end;
  constexpr std::size_t most_digits = 9;
  if (end - at_ > most_digits) fail_expected(expected);
  int value = 0;
  for (; at_ < end; ++at_) value = 10 * value + (text_[at_] - '0');
  return negative ? -value : value;
}

void CodeText::fail(const std::string& message) {
  throw InputError({source_, format::line_of(text_, std::min(at_, text_.size()))}, message);
}

void CodeText::fail_expected(std::string_view expected) {
  const char c = next();
  if (c == '\0') fail("the code ends (expected " + std::string(expected) + ")");
  std::size_t end = at_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  fail("found " + in_quotes(text_.substr(at_, std::max<std::size_t>(1, end - at_))) + " (expected " +
       std::string(expected) + ")");
}

} // namespace tetrarch::diagram
