// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Three kinds of "no", two of which are thrown.
///
/// `PreconditionError`: the caller's mistake (a face glued twice, a stale skeleton). Always checked, cheap.
/// `InputError`: bad data from outside. It names the source, the line where there is one, and the offending
/// token. The third kind, a mathematical no, is never thrown: it is a `[[nodiscard]]` result.

#include <stdexcept>
#include <string>
#include <string_view>

namespace tetrarch {

struct PreconditionError : std::logic_error {
  using std::logic_error::logic_error;
};

/// A place in some input: `source` as the user named it, and a 1-based `line` (0: the input has no lines, or
/// the place is the whole input).
struct Place {
  std::string source;
  int line = 0;
};

/// What is wrong with the data, for programs to tell apart.
enum class Cause {
  value,   ///< an argument or a number that cannot be
  option,  ///< an option that there is not, or its value
  name,    ///< no file, no name of a manifold, no signature
  kind,    ///< well-formed, but something else is expected: a group in place of a mesh
  file,    ///< a file or folder that cannot be opened, read or written
  content, ///< what stands in a file
  memory,  ///< more memory than there is, or than is allowed
};

/// A stable word: "bad_value", "bad_option", "unknown_name", "wrong_kind", "bad_file", "bad_content",
/// "no_memory".
std::string_view code_of(Cause cause);

/// Bad data from outside.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& message, Cause cause = Cause::value);
  /// `what` reads "source:line: message" (without ":line" where the line is 0).
  InputError(const Place& place, const std::string& message, Cause cause = Cause::content);

  Place place;         ///< empty: the message names no place
  std::string message; ///< without the place
  Cause cause;
};

/// A token as it may stand in an error message: quoted, control characters and what is no UTF-8 replaced by
/// question marks, cut after 40 characters.
std::string in_quotes(std::string_view token);

/// Whether lines may stand in a text.
enum class Lines { one, many };

/// A text as it may go to a terminal: control characters (of ASCII and of Unicode) and what is no UTF-8 are
/// replaced by question marks, one for each byte; line feeds and tabs stay where there may be many lines.
/// O(length).
std::string printable(std::string_view text, Lines lines = Lines::one);

} // namespace tetrarch
