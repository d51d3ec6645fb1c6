// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Text with positions, and numbers and files without surprises.
///
/// A `TextCursor` walks along a text by tokens (runs of characters without white space) or by lines, and
/// knows at every moment on which line it stands, so that every complaint can say "source:line: found this,
/// expected that". Numbers are read and written by std::from_chars and std::to_chars: no locale ever changes
/// them. A file is written beside its place and renamed into it: either the old content is there or the new.

#include "tetrarch/core/error.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// Space, tab, and the characters that end or feed a line. The same in every locale.
constexpr bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
/// `text` without white space at either end. O(length).
std::string_view trimmed(std::string_view text);

/// The 1-based line of `text` that the byte `offset` stands on. Lines end as anywhere: by a line feed, a
/// carriage return, or both. O(offset).
int line_of(std::string_view text, std::size_t offset);

/// A view of some text, which must outlive the cursor. Every reading function is linear in what it passes
/// over.
class TextCursor {
public:
  /// `source` is what error messages call the text: a file name, "standard input", "argument 1".
  TextCursor(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  /// Whether nothing but white space is left; moves to what comes next.
  bool at_end();
  /// The 1-based line of the next token; at the end of the text, the last line with anything on it.
  int line();
  /// The place of the next token.
  Place here();

  /// The next token, on whatever line; `expected` completes the sentence "found X, expected ...".
  /// Throws InputError at the end of the text.
  std::string_view token(std::string_view expected);
  /// The first character of the next token, which stays where it is; 0 at the end of the text. O(white
  /// space).
  char next_char() { return at_end() ? '\0' : text_[at_]; }
  /// The next token, which stays where it is; empty at the end of the text.
  std::string_view peek();
  /// A decimal integer in [least, greatest]. Throws InputError for anything else.
  std::int64_t integer(std::string_view expected, std::int64_t least, std::int64_t greatest);
  /// A decimal number; "inf" and "nan" only where `finite` is false. Throws InputError for anything else.
  double number(std::string_view expected, bool finite = true);
  /// What is left of the current line, trimmed, without its end, which is passed over.
  std::string_view rest_of_line();

  /// The place of a view that this cursor handed out.
  Place place_of(std::string_view token) const;
  /// Throws an InputError that reads "found 'token', expected ..." at the place of `token`, a view handed out
  /// by this cursor.
  [[noreturn]] void fail_at(std::string_view token, std::string_view expected) const;

private:
  int line_at(std::size_t offset) const;
  std::size_t token_end() const;

  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
};

/// "the text ends" or "found 'token'", then ", expected ...".
std::string found_expected(std::string_view token, std::string_view expected);

/// The whole of `text` as a decimal integer or number, or nothing. A leading '+' is not accepted.
std::optional<std::int64_t> parse_integer(std::string_view text);
std::optional<double> parse_double(std::string_view text);

/// The shortest text that reads back as exactly `value`: "0.1", "1e+22", "-0", "inf".
std::string to_text(double value);
/// The same of any number, at the end of `out`.
template <class T>
void append_number(std::string& out, T value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), result.ptr);
}

/// Whether `path` ends with `extension` (in small letters), whose letters may be of either case in `path`.
bool has_extension(std::string_view path, std::string_view extension);

/// No file that anyone means is longer; it keeps an endless one (a device, a pipe) from filling the memory.
inline constexpr std::size_t longest_file = std::size_t{1} << 30;

/// The bytes of a file, or of standard input if `path` is "-". Throws InputError that names the path if it
/// does not exist, is a directory, cannot be read or holds more than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = longest_file);
/// What error messages call `path`: itself, or "standard input" for "-".
std::string source_name(const std::string& path);

/// Writes `content` beside `path` and renames it into place; on any failure `path` is as it was, nothing is
/// left beside it, and an InputError names the path and the reason. A symbolic link is followed; what is no
/// regular file (a device, a pipe) is written to directly.
void write_file_atomically(const std::string& path, std::string_view content);

/// Whether `write_file_atomically` can begin with this path, tried by making a file beside it and removing it
/// again. Throws InputError as that would.
void require_writable(const std::string& path);

/// For a program that ends without return: removes what lies beside files that are just being written, and
/// lets no other one be begun.
void remove_unfinished_files();

} // namespace tetrarch::format
