// SPDX-License-Identifier: GPL-2.0-or-later
#include "job.hpp"

#include "progress_bar.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"

#include <csignal>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <semaphore.h>
#include <set>
#include <stop_token>
#include <thread>

namespace tetrarch::program {
namespace {

/// Ctrl-C asks the job to stop instead of killing it. A thread waits for the signal by way of a semaphore:
/// libraries have threads of their own, older than `main`, to which a signal that is only blocked would go.
class InterruptWatch {
public:
  InterruptWatch() {
    sem_init(&came_, 0, 0);
    struct sigaction action {};
    action.sa_handler = [](int) { sem_post(&came_); };
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::thread([this] {
      while (true) {
        while (sem_wait(&came_) != 0) {
        }
        const std::lock_guard lock(mutex_);
        source_.request_stop();
        if (++asked_ == patience_)
          std::_Exit(static_cast<int>(Status::interrupted)); // the job does not listen
      }
    }).detach();
  }

  /// So many times is a job asked before the program ends.
  void set_patience(int times) {
    const std::lock_guard lock(mutex_);
    patience_ = times;
  }

  /// For the next job.
  std::stop_token token() {
    const std::lock_guard lock(mutex_);
    source_ = std::stop_source();
    asked_ = 0;
    return source_.get_token();
  }

private:
  inline static sem_t came_{};
  std::mutex mutex_;
  std::stop_source source_;
  int asked_ = 0;
  int patience_ = 2;
};

/// Its thread outlives every function.
InterruptWatch& interrupts() {
  static InterruptWatch watch;
  return watch;
}

/// One file cannot hold two results. `paths` are those of earlier ones, to which these are added.
void require_different(const std::vector<Result::File>& files, std::set<std::filesystem::path>& paths) {
  for (const Result::File& file : files)
    if (!paths.insert(std::filesystem::weakly_canonical(std::filesystem::absolute(file.path))).second)
      throw InputError({file.path, 0}, "two results have this file name; nothing was written");
}

Json ledger_json(const format::Ledger& ledger) {
  Json list = Json::array();
  for (const format::Ledger::Entry& e : ledger.entries())
    list.push_back({{"what", e.what}, {"count", e.count}});
  return list;
}

/// Adds to the result what was passed over by those who read for it.
void tell_reads(Result& result, const Reads& reads) {
  if (!reads.any) return;
  if (!reads.passed_over.empty())
    result.warnings.insert(result.warnings.begin(), reads.passed_over.sentence());
  if (result.json.is_object()) result.json["passed_over"] = ledger_json(reads.passed_over);
}

/// Adds whose result it is.
void tell_input(Result& result, const Share& share) {
  for (std::string& warning : result.warnings) warning.insert(0, share.input + ": ");
  if (result.json.is_object()) {
    Json named{{"input", share.input}};
    if (!share.name.empty()) named["name"] = share.name;
    named.update(result.json);
    result.json = std::move(named);
  }
  result.text = share.input + (share.name.empty() ? "" : "  " + share.name) + "\n" + result.text + "\n";
}

/// No command is done whose result holds a number that is none.
void require_numbers(Result& result) {
  const std::string where = result.json.where_not_a_number();
  if (where.empty() || result.status != Status::done) return;
  result.status = Status::undecided;
  result.warnings.push_back("rounding errors were too great: " + where + " is no number");
}

void deliver(const Result& result, const Common& common, const std::string& speaker,
             const Statement* statement, Share* share) {
  std::set<std::filesystem::path> paths;
  require_different(result.files, share == nullptr ? paths : share->written);
  for (const Result::File& file : result.files) format::write_file_atomically(file.path, file.content);
  if (!common.quiet)
    for (const std::string& warning : result.warnings)
      std::cerr << speaker << ": warning: " << warning << '\n';
  if (common.json && statement != nullptr) {
    if (!result.json.is_null())
      tell(*statement, result.status, "result", result.json);
    else if (!result.text.empty())
      tell(*statement, result.status, "result", result.text);
  } else if (common.json && !result.json.is_null())
    std::cout << result.json.dump(share == nullptr ? 2 : -1) << '\n';
  else
    std::cout << result.text;
  std::cout.flush();
  if (!std::cout) throw InputError("cannot write to standard output");
}

} // namespace

void be_patient() {
  constexpr int patience = 4;
  interrupts().set_patience(patience);
}

Status complain(const std::string& speaker, const std::string& message, Status status) {
  std::cerr << speaker << ": " << message.substr(0, message.find('\n')) << '\n';
  return status;
}

void tell(const Statement& statement, Status status, const std::string& key, Json value) {
  Json json;
  json["name"] = statement.name.empty() ? Json() : Json(statement.name);
  json["line"] = statement.line;
  json["status"] = static_cast<int>(status);
  json[key] = std::move(value);
  std::cout << json.dump() << std::endl;
}

JobOutcome run_job(const Job& job, const Values* values, const std::string& speaker,
                   const Statement* statement, Share* share) {
  const Common& common = job.common;
  const auto failed = [&](const std::string& message, Status status) {
    if (common.json && statement != nullptr) tell(*statement, status, "error", message);
    const bool says_whose = share == nullptr || message.starts_with(share->input);
    return JobOutcome{complain(speaker, says_whose ? message : share->input + ": " + message, status),
                      nullptr};
  };
  const ProgressBar bar(!common.quiet);
  try {
    Context context;
    static_cast<Common&>(context) = common;
    context.progress = Progress(bar.report(), interrupts().token());
    context.values = values;
    if (share != nullptr) context.reads->passed_over.add(share->passed_over);
    Result result = job.run(context);
    bar.clear();
    require_numbers(result);
    tell_reads(result, *context.reads);
    if (share != nullptr) tell_input(result, *share);
    deliver(result, common, speaker, statement, share);
    return {result.status, std::move(result.value)};
  } catch (const Stopped&) {
    bar.clear();
    return failed("interrupted; nothing was written", Status::interrupted);
  } catch (const InputError& e) {
    bar.clear();
    return failed(e.what(), Status::bad_input);
  } catch (const numeric::MatrixTooLarge& e) {
    bar.clear();
    return failed(e.what(), Status::bad_input);
  } catch (const std::bad_alloc&) {
    bar.clear();
    return failed("out of memory", Status::fault);
  } catch (const std::exception& e) {
    bar.clear();
    return failed(std::string("internal error, please report it: ") + e.what(), Status::fault);
  }
}

} // namespace tetrarch::program
