// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_cursor.hpp"

#include <algorithm>

namespace tetrarch::format {

void MeshCursor::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
    } else if (c == comment_ && comment_ != '\0') {
      at_ = std::min(text_.find('\n', at_), text_.size()) - 1;
    } else if (!is_space(c)) {
      return;
    }
  }
}

std::string_view MeshCursor::peek() {
  skip_space();
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view MeshCursor::token(std::string_view expected) {
  const std::string_view next = peek();
  if (next.empty()) fail(next, expected);
  at_ += next.size();
  return next;
}

std::int64_t MeshCursor::integer(std::string_view expected, std::int64_t least, std::int64_t greatest) {
  const std::string_view next = token(expected);
  const std::optional<std::int64_t> value = parse_integer(next);
  if (!value || *value < least || *value > greatest) fail(next, expected);
  return *value;
}

double MeshCursor::number(std::string_view expected) {
  const std::string_view next = token(expected);
  const std::optional<double> value = parse_double(next);
  if (!value) fail(next, expected);
  return *value;
}

std::array<double, 3> MeshCursor::point() {
  std::array<double, 3> p{};
  for (double& x : p) x = number("a coordinate");
  return p;
}

std::string_view MeshCursor::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  const std::string_view rest = text_.substr(at_, end - at_);
  if (end < text_.size()) ++line_;
  at_ = std::min(end + 1, text_.size());
  return trimmed(rest);
}

bool MeshCursor::next_line_begins_with(std::string_view word) const {
  const std::size_t end = text_.find('\n', at_);
  return end != std::string_view::npos && text_.substr(end + 1, word.size()) == word;
}

std::string_view MeshCursor::bytes(std::uint64_t size, std::string_view expected) {
  binary_ = true;
  if (size > bytes_left()) fail({}, expected);
  const std::string_view raw = text_.substr(at_, size);
  at_ += raw.size();
  return raw;
}

void MeshCursor::pass_over(std::string_view mark) {
  const std::size_t found = text_.find(mark, at_);
  if (found == std::string_view::npos) fail({}, mark);
  line_ += static_cast<int>(std::count(text_.data() + at_, text_.data() + found, '\n'));
  at_ = found + mark.size();
}

std::size_t MeshCursor::believable(std::int64_t announced, std::size_t least) const {
  return std::min(static_cast<std::size_t>(announced), bytes_left() / least + 1);
}

void MeshCursor::fail(std::string_view token, std::string_view expected) const {
  int where = line();
  if (token.empty() && !binary_) { // the text ends: the last line with anything on it
    std::size_t end = text_.size();
    while (end > 0 && is_space(text_[end - 1])) --end;
    where = 1 + static_cast<int>(std::count(text_.data(), text_.data() + end, '\n'));
  }
  throw InputError(Place{source_, where}, found_expected(token, expected));
}

} // namespace tetrarch::format
