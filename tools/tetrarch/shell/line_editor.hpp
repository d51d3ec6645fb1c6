// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Lines typed at a terminal, with history and completion, by libedit. Where the program was built without
/// it, lines are read plainly.

#include "complete.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tetrarch::program {

class LineEditor {
public:
  using Completer = std::function<Completions(std::string_view left_of_cursor)>;

  /// `history`: the file in which lines are kept from one session to the next; empty: none.
  LineEditor(const std::string& prompt, std::string history, Completer completer);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// The next line, without its end; nothing after Ctrl-D. Ctrl-C empties the line.
  std::optional<std::string> line();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace tetrarch::program
