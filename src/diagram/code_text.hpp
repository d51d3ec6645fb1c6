// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The text of a code, read letter by letter.

#include "tetrarch/core/error.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace tetrarch::diagram {

class CodeText {
public:
  CodeText(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  /// The next letter that is no white space and in no comment ("#" to the end of the line); 0 at the end.
  char next();
  bool at_end() { return next() == '\0'; }
  /// Passes over the letter if it comes next.
  bool take(char c);
  /// Any of these letters, or commas, come next: passes over all.
  void skip(std::string_view letters);
  /// The opening bracket of a list, "(", "[" or "{"; returns the one that closes it.
  char open(std::string_view expected);
  void close(char bracket);
  /// Letters that come next, in small letters; empty if none does.
  std::string word();
  /// The same as they are.
  std::string letters();
  /// Throws InputError for anything but an integer of at most nine digits.
  int integer(std::string_view expected);
  bool at_integer();

  [[noreturn]] void fail(const std::string& message);
  /// "found X, expected ..."
  [[noreturn]] void fail_expected(std::string_view expected);

private:
  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
};

} // namespace tetrarch::diagram
