// SPDX-License-Identifier: GPL-2.0-or-later
#include "../command.hpp"
#include "../describe.hpp"
#include "../interrupts.hpp"
#include "line_editor.hpp"
#include "session.hpp"

#include "tetrarch/core/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace tetrarch::program {
namespace {

constexpr const char* prompt = "tetrarch> ";

/// $XDG_STATE_HOME/tetrarch/history, by default ~/.local/state/tetrarch/history. Empty where that cannot be.
std::string history_file() {
  namespace fs = std::filesystem;
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if ((state == nullptr || *state == 0) && (home == nullptr || *home == 0)) return {};
  const fs::path folder =
      (state != nullptr && *state != 0 ? fs::path(state) : fs::path(home) / ".local/state") / "tetrarch";
  std::error_code error;
  fs::create_directories(folder, error);
  return error ? "" : (folder / "history").string();
}

Status converse(Session& session) {
  std::cout << "Tetrarch " TETRARCH_VERSION
               ". 'help' lists the verbs, 'help VERB' explains one, 'quit' ends.\n";
  const std::vector<Declared> table = declared(session.verbs());
  const auto completer = [&](std::string_view text) { return complete(text, table, session.values()); };
  LineEditor editor(prompt, history_file(), completer);
  while (!session.ended()) {
    std::optional<std::string> line = editor.line();
    if (!line) {
      std::cout << '\n';
      break;
    }
    // A line pasted with its prompt.
    if (line->starts_with(prompt)) line->erase(0, std::char_traits<char>::length(prompt));
    while (Session::is_open(*line)) { // an empty line gives it up
      const std::optional<std::string> more = editor.line();
      if (!more || more->empty()) break;
      *line += "\n" + *more;
    }
    session.run(*line, "tetrarch");
  }
  return Status::done;
}

} // namespace

Run declare_shell(OptionTable& table) {
  const auto file = std::make_shared<std::string>();
  table.add("FILE", *file, "a script with one command per line, or - for standard input (default: a prompt)");
  const auto keeps_going = std::make_shared<bool>(false);
  table.add("--keep-going", *keeps_going,
            "go on after a line that fails; the status is that of the first one");
  return [file, keeps_going](const Context& context) {
    Session session(context, *keeps_going);
    Result result;
    const bool typed = file->empty() && isatty(STDIN_FILENO) == 1;
    if (typed) be_patient();
    result.status = typed ? converse(session) : session.run_file(file->empty() ? "-" : *file);
    return result;
  };
}

} // namespace tetrarch::program
