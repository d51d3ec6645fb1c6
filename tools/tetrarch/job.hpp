// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Running a job: what it gives is printed and written, what it throws becomes one line and an exit status.

#include "parse.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace tetrarch::program {

/// Ctrl-C (and SIGTERM) asks the running job to stop; asked a second time, a job that does not listen ends
/// the program. In a session, of which more would be lost, this happens at the fourth time only.
void be_patient();

/// One line on standard error that begins with `speaker` ("tetrarch", "moves.txt:3"). Gives the status back.
Status complain(const std::string& speaker, const std::string& message, Status status);

/// What sets one of many jobs apart (mapping.hpp).
struct Share {
  std::string input;                       ///< what the job is about: "knots.rga#3"
  std::string name;                        ///< that it has in its file
  std::set<std::filesystem::path> written; ///< by the jobs before
  format::Ledger passed_over;              ///< to be told with this job
};

struct Done {
  Status status = Status::done;
  ValuePointer value; ///< what the job made, if it made something
};

/// Runs the job, then writes its files and prints; JSON on one line and with the input's name if it has a
/// share. Throws nothing.
Done run_job(const Job& job, const Values* values, const std::string& speaker, Share* share = nullptr);

} // namespace tetrarch::program
