// SPDX-License-Identifier: GPL-2.0-or-later
#include "mesh_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tetrarch::format {

namespace {

/// 10 to the power of `exponent` is as good as 0 or infinite beyond what doubles can hold.
double beyond_doubles(std::string_view token) {
  const double sign = token.starts_with('-') ? -1 : 1;
  const std::size_t e = token.find_first_of("eE");
  bool tiny = false;
  if (e != std::string_view::npos) {
    tiny = token.substr(e + 1, 1) == "-";
  } else {
    // No exponent: a long row of digits, before the point or after it.
    const std::size_t digit = token.find_first_of("123456789");
    tiny = token.find('.') < digit;
  }
  return tiny ? sign * 0.0 : sign * std::numeric_limits<double>::infinity();
}

/// What Microsoft's programs print for what is no number: 1.#INF, -1.#IND, 1.#QNAN.
std::optional<double> number_with_hash(std::string_view token) {
  const std::size_t hash = token.find(".#");
  if (hash == std::string_view::npos) return std::nullopt;
  const std::string_view word = token.substr(hash + 2);
  const double sign = token.starts_with('-') ? -1 : 1;
  if (word.starts_with("INF")) return sign * std::numeric_limits<double>::infinity();
  if (word.starts_with("IND") || word.find("NAN") != std::string_view::npos)
    return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

std::string_view without_plus(std::string_view token) {
  return token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+' ? token.substr(1) : token;
}

} // namespace

std::optional<std::int64_t> lenient_integer(std::string_view token) {
  return parse_integer(without_plus(token));
}

std::optional<double> lenient_double(std::string_view token) {
  token = without_plus(token);
  double value = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc() && stop == end) return value;
  if (error == std::errc::result_out_of_range && stop == end) return beyond_doubles(token);
  const std::size_t d = token.find_first_of("dD");
  if (d != std::string_view::npos && d > 0 && token.find_first_of("dD", d + 1) == std::string_view::npos &&
      token.find_first_of("iInN") == std::string_view::npos) {
    std::string with_e(token);
    with_e[d] = 'e';
    return lenient_double(with_e);
  }
  return number_with_hash(token);
}

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

void MeshCursor::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
    } else if (c == '\r') {
      if (text_.substr(at_ + 1, 1) != "\n") ++line_;
    } else if (c == comment_ && comment_ != '\0') {
      at_ = line_end(at_) - 1;
    } else if (const std::size_t next = joined(at_); next != at_) {
      ++line_;
      at_ = next - 1;
    } else if (!is_space(c)) {
      return;
    }
  }
}

std::size_t MeshCursor::joined(std::size_t at) const {
  if (!joins_lines_ || text_[at] != '\\') return at;
  std::size_t end = at + 1;
  while (end < text_.size() && (text_[end] == ' ' || text_[end] == '\t')) ++end;
  if (end == text_.size() || (text_[end] != '\n' && text_[end] != '\r')) return at;
  return end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
}

std::size_t MeshCursor::line_end(std::size_t from) const {
  return std::min(text_.find_first_of("\r\n", from), text_.size());
}

bool MeshCursor::line_goes_on() {
  while (at_ < text_.size()) {
    const std::size_t next = joined(at_);
    if (next != at_) {
      ++line_;
      at_ = next;
    } else if (is_space(text_[at_]) && text_[at_] != '\n' && text_[at_] != '\r') {
      ++at_;
    } else {
      break;
    }
  }
  return at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r' &&
         (comment_ == '\0' || text_[at_] != comment_);
}

std::string_view MeshCursor::peek() {
  skip_space();
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end]) && joined(end) == end) ++end;
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
  const std::optional<std::int64_t> value = lenient_integer(next);
  if (!value || *value < least || *value > greatest) fail(next, expected);
  return *value;
}

double MeshCursor::number(std::string_view expected) {
  const std::string_view next = token(expected);
  const std::optional<double> value = lenient_double(next);
  if (!value) fail(next, expected);
  return *value;
}

int MeshCursor::reference(std::string_view expected) {
  const double value = number(expected);
  const bool fits = value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max();
  return fits && value == std::trunc(value) ? static_cast<int>(value) : 0;
}

std::array<double, 3> MeshCursor::point() {
  std::array<double, 3> p{};
  for (double& x : p) x = number("a coordinate");
  return p;
}

std::string_view MeshCursor::rest_of_line() {
  std::size_t end = line_end(at_);
  // Not beyond the end of the line: a file of many lines would be searched to its end for each.
  const auto next_back = [&](std::size_t from) { return text_.substr(0, end).find('\\', from); };
  for (std::size_t back = joins_lines_ ? next_back(at_) : end; back < end; back = next_back(back + 1))
    if (joined(back) != back) {
      ++line_;
      end = line_end(joined(back));
    }
  const std::string_view rest = text_.substr(at_, end - at_);
  if (end < text_.size()) ++line_;
  at_ = std::min(end + (text_.substr(end, 2) == "\r\n" ? 2 : 1), text_.size());
  return trimmed(rest);
}

bool MeshCursor::next_line_begins_with(std::string_view word) const {
  std::size_t next = line_end(at_);
  if (next == text_.size()) return false;
  next += text_.substr(next, 2) == "\r\n" ? 2 : 1;
  return text_.substr(next, word.size()) == word;
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
  line_ += line_of(text_.substr(at_, found - at_), found - at_) - 1;
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
    where = line_of(text_, end);
  }
  throw InputError(Place{source_, where}, found_expected(token, expected));
}

} // namespace tetrarch::format
