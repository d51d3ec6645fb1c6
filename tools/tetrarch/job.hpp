// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Running a job: what it gives is printed and written, what it throws becomes one line and an exit status.

#include "parse.hpp"

#include "tetrarch/core/error.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace tetrarch::program {

/// One line on standard error that begins with `speaker` ("tetrarch", "moves.txt:3"), whatever the names in
/// it are made of. Gives the status back.
Status complain(const std::string& speaker, const std::string& message, Status status);
/// The same for programs: one line { "error": { "code", "file", "line", "message" } } on standard error, null
/// where there is no file or line. The code is the cause's, or where there is none, the status's name.
Status complain_in_json(const Place& place, const std::string& message, Status status,
                        std::string_view code = {});
void warn(const std::string& speaker, const std::string& warning);

/// The text on standard output. Throws InputError if it cannot be written there.
void say(const std::string& text);

/// What sets one of many jobs apart (mapping.hpp).
struct Share {
  std::string input;                       ///< what the job is about: "knots.rga#3"
  std::string name;                        ///< that it has in its file
  std::set<std::filesystem::path> written; ///< by the jobs before
  format::Ledger passed_over;              ///< to be told with this job
};

struct JobOutcome {
  Status status = Status::done;
  ValuePointer value; ///< what the job made, if it made something
};

/// What a session does, for those who read along as programs.
struct Statement {
  std::string name; ///< that is assigned to; empty: none
  std::string line;
};

/// Runs the job, then writes its files and prints. With a statement and `--json` that is one object in one
/// line, also of an error: {"name", "line", "status", "result" or "error"}; with a share it is an object in a
/// line with the input's name. Throws nothing.
JobOutcome run_job(const Job& job, const Values* values, const std::string& speaker,
                   const Statement* statement = nullptr, Share* share = nullptr);

/// The object of a statement that is not the work of a job, or failed before there was one. Throws InputError
/// as `say` does.
void tell(const Statement& statement, Status status, const std::string& key, Json value);

/// The same of an error; silent where nobody can be told anything any more.
void tell_error(const Statement& statement, Status status, const std::string& message);

} // namespace tetrarch::program
