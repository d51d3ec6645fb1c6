// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Named values, what they were made by, and the way back.
///
///     Y = truncate tests/data/knotted_y_8k.mesh      a verb's result under a name
///     Z = fmp2_8                                     whatever an argument can be
///     move Y two_three 0 1                           `move` alone changes the value that it names
///     Y                                              a value alone is shown
///
/// A session knows nothing of terminals: shell.cpp feeds it lines.

#include "../job.hpp"
#include "../mapping.hpp"
#include "../value.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::program {

class Session {
public:
  /// `defaults` holds for every line that says nothing else.
  explicit Session(const Common& defaults);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Does what the line says; errors are told on standard error, after `speaker`. Throws nothing.
  Status run(std::string_view line, const std::string& speaker);
  /// Runs the lines of a file (or of standard input, "-") up to the first that fails, and gives its status; a
  /// proved no and an undecided question are no failures. Errors name file and line.
  Status run_file(const std::string& path);

  /// After `quit`.
  bool ended() const { return ended_; }
  const Values& values() const { return values_; }
  /// The program's commands and the session's own.
  const std::vector<Command>& verbs() const { return verbs_; }

private:
  using Lines = std::vector<std::string>;
  /// What a name was before a line changed it.
  struct Change {
    std::string name;
    ValuePointer value; ///< null: nothing
    Lines lines;
    std::string line;
  };
  /// A line, taken apart.
  struct Statement {
    std::string line;
    std::string name; ///< that is assigned to; empty: none
    std::vector<std::string> words;
  };

  Statement statement_of(std::string_view line) const;
  Status execute(const Statement& statement, const std::string& speaker);
  Status execute(Mapping mapping, const Statement& statement, const std::string& speaker);
  void name_what_is_given(const Statement& statement, const std::string& speaker);
  void assign(const std::string& name, ValuePointer value, const Statement& statement);
  bool is_verb(const std::string& word) const;
  bool changes_value(const Statement& statement) const;

  Result list() const;
  Result print(const std::vector<std::string>& names) const;
  Result log(const std::string& name) const;
  Result forget(const std::vector<std::string>& names);
  Result undo();
  std::vector<Command> own_verbs();
  void require_value(const std::string& name) const;

  Common defaults_;
  std::vector<Command> verbs_;
  Values values_;
  std::map<std::string, Lines, std::less<>> lines_; ///< by which each value was made
  std::vector<Change> changes_;
  int depth_ = 0; ///< of files that run one another
  bool ended_ = false;
};

} // namespace tetrarch::program
