// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Signals that ask the program to end: SIGINT (Ctrl-C), SIGTERM and SIGHUP.
///
/// The first one asks the running job to stop. A job looks between units of work; one that does not, because
/// it waits for input or for a reader of its output, or is busy without looking, is ended after half a second
/// together with the program: no unfinished file stays behind, and the status is 130. Only a conversation, of
/// which more would be lost, gives Ctrl-C to its jobs alone and ends at the fourth. A file that grows beyond
/// a limit (SIGXFSZ) is an error of writing like any other.

#include <stop_token>

namespace tetrarch::program {

/// From now on; called once, before anything is read.
void watch_signals();

/// Stops when a signal comes. What came before is forgotten.
std::stop_token token_of_next_job();

/// Ctrl-C is for the jobs of a conversation.
void be_patient();

/// The job writes its files: "nothing was written" is no longer true.
void note_writing();

/// Whether the caller is the one to say that the program was interrupted; not if that was said already.
bool take_leave();

} // namespace tetrarch::program
