// SPDX-License-Identifier: GPL-2.0-or-later
#include "job.hpp"

#include "finish.hpp"
#include "interrupts.hpp"
#include "memory.hpp"
#include "progress_bar.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"

#include <filesystem>
#include <iostream>
#include <set>
#include <system_error>
#include <unistd.h>

namespace tetrarch::program {
namespace {

/// Adds whose result it is.
void tell_input(Result& result, const Share& share) {
  for (std::string& warning : result.warnings) warning.insert(0, share.input + ": ");
  if (result.json.is_object()) {
    Json named{{"input", share.input}};
    if (!share.name.empty()) named["name"] = share.name;
    named.update(result.json);
    result.json = std::move(named);
  }
  result.text =
      printable(share.input + (share.name.empty() ? "" : "  " + share.name)) + "\n" + result.text + "\n";
}

void deliver(const Result& result, const Common& common, const std::string& speaker,
             const Statement* statement, Share* share) {
  std::set<std::filesystem::path> paths;
  require_different(result.files, share == nullptr ? paths : share->written);
  if (!result.files.empty()) note_writing();
  std::vector<format::NewFile> files;
  for (const Result::File& file : result.files) files.push_back({file.path, file.content});
  format::write_files_atomically(files);
  if (!common.quiet)
    for (const std::string& warning : result.warnings) warn(speaker, warning);
  if (common.json && statement != nullptr) {
    if (!result.json.is_null())
      tell(*statement, result.status, "result", result.json);
    else if (!result.text.empty())
      tell(*statement, result.status, "result", result.text);
  } else if (common.json && !result.json.is_null())
    say(result.json.dump(share == nullptr ? 2 : -1) + "\n");
  else
    say(result.is_file && isatty(STDOUT_FILENO) == 0 ? result.text : printable(result.text, Lines::many));
}

} // namespace

Status complain(const std::string& speaker, const std::string& message, Status status) {
  std::cerr << printable(speaker + ": " + message) << std::endl;
  return status;
}

void warn(const std::string& speaker, const std::string& warning) {
  std::cerr << printable(speaker + ": warning: " + warning) << '\n';
}

void say(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw InputError("cannot write to standard output");
}

void tell(const Statement& statement, Status status, const std::string& key, Json value) {
  Json json;
  json["name"] = statement.name.empty() ? Json() : Json(statement.name);
  json["line"] = statement.line;
  json["status"] = static_cast<int>(status);
  json[key] = std::move(value);
  say(json.dump() + "\n");
}

void tell_error(const Statement& statement, Status status, const std::string& message) {
  try {
    tell(statement, status, "error", message);
  } catch (const InputError&) {
  }
}

namespace {

const char* code_of(Status status) {
  switch (status) {
  case Status::done:
    return "done";
  case Status::proved_no:
    return "proved_no";
  case Status::bad_input:
    return "bad_input";
  case Status::undecided:
    return "undecided";
  case Status::interrupted:
    return "interrupted";
  case Status::fault:
    break;
  }
  return "fault";
}

} // namespace

Status complain_in_json(const Place& place, const std::string& message, Status status,
                        std::string_view code) {
  const Json error{{"code", code.empty() ? std::string_view(code_of(status)) : code},
                   {"file", place.source.empty() ? Json() : Json(place.source)},
                   {"line", place.line > 0 ? Json(place.line) : Json()},
                   {"message", message}};
  std::cerr << Json{{"error", error}}.dump() << std::endl;
  return status;
}

JobOutcome run_job(const Job& job, const Values* values, const std::string& speaker,
                   const Statement* statement, Share* share) {
  const Common& common = job.common;
  const auto failed = [&](const std::string& message, Status status, std::string_view code = {},
                          const InputError* error = nullptr) {
    if (common.json && statement != nullptr) tell_error(*statement, status, message);
    if (common.json && statement == nullptr) {
      Place place = error == nullptr ? Place() : error->place;
      if (place.source.empty() && share != nullptr) place.source = share->input;
      return JobOutcome{complain_in_json(place, error == nullptr ? message : error->message, status, code),
                        nullptr};
    }
    const bool says_whose = share == nullptr || message.starts_with(share->input);
    return JobOutcome{complain(speaker, says_whose ? message : share->input + ": " + message, status),
                      nullptr};
  };
  const ProgressBar bar(!common.quiet);
  bool printed = false;
  const double most_memory = common.memory ? *common.memory : usual_memory();
  try {
    restore_reserves(); // an earlier job may have used them
    bound_memory(most_memory);
    Context context;
    static_cast<Common&>(context) = common;
    context.progress = Progress(bar.report(), token_of_next_job());
    context.values = values;
    if (!common.json && share == nullptr)
      context.print = [&](const std::string& text) {
        bar.clear();
        say(printable(text, Lines::many));
        printed = true;
      };
    if (share != nullptr) context.reads->passed_over.add(share->passed_over);
    Result result = job.run(context);
    bar.clear();
    finish(result, *context.reads);
    if (share != nullptr) tell_input(result, *share);
    deliver(result, common, speaker, statement, share);
    return {result.status, std::move(result.value)};
  } catch (const Stopped&) {
    bar.clear();
    return take_leave() ? failed(printed ? "interrupted; what was printed is not all"
                                         : "interrupted; nothing was written",
                                 Status::interrupted)
                        : JobOutcome{Status::interrupted, nullptr};
  } catch (const InputError& e) {
    bar.clear();
    return failed(e.what(), Status::bad_input, code_of(e.cause), &e);
  } catch (const numeric::MatrixTooLarge& e) {
    bar.clear();
    return failed(e.what(), Status::bad_input, code_of(Cause::memory));
  } catch (const std::bad_alloc&) {
    bar.clear();
    return failed("out of memory: the job takes more than there is, or than the " +
                      in_bytes(1e9 * most_memory) + " allowed (--memory)",
                  Status::bad_input, code_of(Cause::memory));
  } catch (const std::system_error& e) { // the file system is not what the job took it for
    bar.clear();
    return failed(e.what(), Status::bad_input, code_of(Cause::file));
  } catch (const std::exception& e) {
    bar.clear();
    return failed(std::string("internal error, please report it: ") + e.what(), Status::fault);
  }
}

} // namespace tetrarch::program
