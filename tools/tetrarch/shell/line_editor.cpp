// SPDX-License-Identifier: GPL-2.0-or-later
#include "line_editor.hpp"

#include <iostream>

#ifdef TETRARCH_HAS_LIBEDIT
#include "tetrarch/core/error.hpp"

#include <cstdio>
#include <histedit.h>
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace tetrarch::program {

#ifdef TETRARCH_HAS_LIBEDIT

namespace {

constexpr int history_length = 5000;

} // namespace

struct LineEditor::State {
  std::string prompt;
  std::string file;
  Completer completer;
  EditLine* line = nullptr;
  History* history = nullptr;
  HistEvent event{};

  static State& of(EditLine* line) {
    void* data = nullptr;
    el_get(line, EL_CLIENTDATA, &data);
    return *static_cast<State*>(data);
  }

  static char* prompt_of(EditLine* line) { return of(line).prompt.data(); }

  /// Inserts what all completions have in common; where that is nothing, lists them.
  static unsigned char completed(EditLine* line, int) {
    const LineInfo* info = el_line(line);
    const std::string_view text(info->buffer, static_cast<std::size_t>(info->cursor - info->buffer));
    const Completions found = of(line).completer(text);
    const std::string common = common_beginning(found.words);
    const std::size_t begun = text.size() - found.start;
    if (found.words.size() == 1) {
      const std::string rest = common.substr(begun) + (common.ends_with('/') ? "" : " ");
      return el_insertstr(line, rest.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    }
    if (common.size() > begun)
      return el_insertstr(line, common.substr(begun).c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    if (found.words.empty()) return CC_ERROR;
    winsize window{};
    const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0;
    std::cout << '\n'
              << printable(in_columns(found.words, known ? window.ws_col : 80), Lines::many) << std::flush;
    return CC_REDISPLAY;
  }

  /// Ctrl-C: the line is given up.
  static unsigned char given_up(EditLine* line, int) {
    const LineInfo* info = el_line(line);
    const auto length = static_cast<int>(info->lastchar - info->buffer);
    el_cursor(line, length);
    el_deletestr(line, length);
    std::cout << "^C\n" << std::flush;
    return CC_REDISPLAY;
  }
};

LineEditor::LineEditor(const std::string& prompt, std::string history, Completer completer)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.prompt = prompt;
  s.file = std::move(history);
  s.completer = std::move(completer);
  s.line = el_init("tetrarch", stdin, stdout, stderr);
  s.history = history_init();
  ::history(s.history, &s.event, H_SETSIZE, history_length);
  ::history(s.history, &s.event, H_SETUNIQUE, 1);
  if (!s.file.empty()) ::history(s.history, &s.event, H_LOAD, s.file.c_str());
  el_set(s.line, EL_CLIENTDATA, &s);
  el_set(s.line, EL_PROMPT, &State::prompt_of);
  el_set(s.line, EL_EDITOR, "emacs");
  el_set(s.line, EL_SIGNAL, 0);
  el_set(s.line, EL_HIST, ::history, s.history);
  // In wide letters, since libedit keeps the pointers; of narrow ones it makes copies that it never frees.
  el_wset(s.line, EL_ADDFN, L"tetrarch-complete", L"complete a word", &State::completed);
  el_set(s.line, EL_BIND, "^I", "tetrarch-complete", nullptr);
  el_set(s.line, EL_BIND, "^R", "em-inc-search-prev", nullptr);
  // While a line is typed Ctrl-C is a key like others; while a job runs, a signal.
  el_wset(s.line, EL_ADDFN, L"tetrarch-give-up", L"give the line up", &State::given_up);
  el_set(s.line, EL_SETTY, "-d", "-isig", nullptr);
  el_set(s.line, EL_BIND, "^C", "tetrarch-give-up", nullptr);
  el_source(s.line, nullptr); // the user's own ~/.editrc
}

LineEditor::~LineEditor() {
  history_end(state_->history);
  el_end(state_->line);
}

std::optional<std::string> LineEditor::line() {
  State& s = *state_;
  int length = 0;
  const char* text = el_gets(s.line, &length);
  if (text == nullptr || length <= 0) return std::nullopt;
  std::string line(text, static_cast<std::size_t>(length));
  if (line.find_first_not_of(" \t\r\n") != std::string::npos) {
    history(s.history, &s.event, H_ENTER, line.c_str());
    if (!s.file.empty()) history(s.history, &s.event, H_SAVE, s.file.c_str());
  }
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  return line;
}

#else

struct LineEditor::State {
  std::string prompt;
};

LineEditor::LineEditor(const std::string& prompt, std::string, Completer)
    : state_(std::make_unique<State>(State{prompt})) {}
LineEditor::~LineEditor() = default;

std::optional<std::string> LineEditor::line() {
  std::cout << state_->prompt << std::flush;
  std::string line;
  if (!std::getline(std::cin, line)) return std::nullopt;
  return line;
}

#endif

} // namespace tetrarch::program
