// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A walk along a mesh file, which may mix text and raw bytes and hold millions of elements.
///
/// `TextCursor` counts lines when asked, from the beginning, which is right for a reader that asks once.
/// A soup asks at every element, so this one counts as it goes; it also skips comments and takes raw bytes.
/// Lines end by a line feed, a carriage return, or both. Numbers may be written as C's and Fortran's programs
/// print them: "+1.0", "1.0D+00", "1e-400" (which is 0), "1e400" (which is infinite), "1.#INF".

#include "tetrarch/format/soup.hpp"
#include "tetrarch/format/text.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// The largest number of points or elements, and the largest number that may name one.
inline constexpr std::int64_t most_elements = std::numeric_limits<int>::max();

class MeshCursor {
public:
  /// From `comment` to the end of its line is white space; 0: there are no comments.
  MeshCursor(std::string_view text, std::string source, char comment = '\0')
      : text_(text), source_(std::move(source)), comment_(comment) {}

  /// From here on a backslash at the end of a line joins the next line to it.
  void join_lines_at_backslashes() { joins_lines_ = true; }

  /// Whether nothing but white space and comments is left; moves to what comes next.
  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  /// The next token, which stays where it is; empty at the end of the text.
  std::string_view peek();
  /// The next token, and the functions below that read one: as in TextCursor.
  std::string_view token(std::string_view expected);
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest);
  /// "inf" and "nan" are numbers here: a soup says what the file says.
  double number(std::string_view expected);
  /// An integer that may be written as a real number, "3.0"; 0 for other numbers.
  int reference(std::string_view expected);
  std::array<double, 3> point();
  /// What is left of the current line, trimmed, without its end, which is passed over.
  std::string_view rest_of_line();
  /// Whether another token stands on the current line; moves to it.
  bool line_goes_on();
  /// Whether the line after the current one begins with `word`. Nothing moves.
  bool next_line_begins_with(std::string_view word) const;
  /// The next `size` bytes, in which lines mean nothing: from here on `line` is 0. Throws InputError if there
  /// are fewer.
  std::string_view bytes(std::uint64_t size, std::string_view expected);

  /// Passes over everything up to the next occurrence of `mark`, and over that. Throws InputError if there is
  /// none. O(length).
  void pass_over(std::string_view mark);

  /// The line of the token that was read last; before the first, 1; after raw bytes, 0.
  int line() const { return binary_ ? 0 : line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  const std::string& source() const { return source_; }
  /// How many of `announced` elements may still come if each takes `least` bytes or more: what may be
  /// reserved on the word of a header.
  std::size_t believable(std::int64_t announced, std::size_t least) const;

  /// Throws an InputError that reads "found 'token', expected ..." at the current line; if the token is
  /// empty, "the text ends, ...", at the last line with anything on it.
  [[noreturn]] void fail(std::string_view token, std::string_view expected) const;

private:
  void skip_space();
  /// Where the line ends that `from` stands in: its last character, or the end of the text.
  std::size_t line_end(std::size_t from) const;
  /// Where the line after that goes on, if a backslash at `at` joins it to this one; else `at`.
  std::size_t joined(std::size_t at) const;

  std::string_view text_;
  std::string source_;
  char comment_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool binary_ = false;
  bool joins_lines_ = false;
};

/// As MeshCursor reads them.
std::optional<std::int64_t> lenient_integer(std::string_view token);
std::optional<double> lenient_double(std::string_view token);

/// `text` without UTF-8's byte order mark, which some editors and programs begin files with.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

/// `text` with A to Z for a to z.
std::string capitals(std::string_view text);

/// The value whose bytes stand at `at`, in this machine's order or reversed.
template <class T>
T load(const char* at, bool swapped) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), at, sizeof(T));
  if (swapped)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(raw);
}

/// Whether bytes of this order must be reversed here.
constexpr bool swapped_if(std::endian order) {
  return order != std::endian::native;
}

} // namespace tetrarch::format
