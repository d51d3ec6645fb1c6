// SPDX-License-Identifier: GPL-2.0-or-later
#include "program.hpp"

#include "command.hpp"
#include "interrupts.hpp"
#include "job.hpp"
#include "mapping.hpp"
#include "memory.hpp"
#include "parse.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace tetrarch::program {
namespace {

Status parse_and_run(const char* name, const std::vector<std::string>& words) {
  if (std::optional<Mapping> mapping = mapping_in(words))
    return run_mapping(std::move(*mapping), commands(), name, usual_options(), nullptr, name);
  const Parsed parsed = parse(words, commands(), name, usual_options());
  if (parsed.job) return run_job(*parsed.job, nullptr, name).status;
  say(parsed.text);
  return Status::done;
}

bool asks_for_json(const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), "--json") != words.end();
}

Status speak(const char* name, const std::vector<std::string>& words) {
  try {
    return parse_and_run(name, words);
  } catch (const InputError& e) {
    return asks_for_json(words) ? complain_in_json(e.place, e.message, Status::bad_input, code_of(e.cause))
                                : complain(name, e.what(), Status::bad_input);
  }
}

/// A line for when there is no memory left to make one.
Status say_little(const char* name, std::string_view message, Status status) {
  for (const std::string_view part :
       {std::string_view(name), std::string_view(": "), message, std::string_view("\n")})
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) return Status::fault;
  return status;
}

} // namespace

int run_program(const char* name, char** argv) {
  Status status = Status::fault;
  try {
    prepare_for_want(argv);
    watch_signals();
    bound_memory(usual_memory());
    std::vector<std::string> words;
    for (char** word = argv + 1; *word != nullptr; ++word) words.emplace_back(*word);
    status = speak(name, words);
  } catch (const std::bad_alloc&) {
    status = say_little(name, "out of memory", Status::bad_input);
  } catch (const std::system_error& e) { // of threads, for one
    status = say_little(name, e.what(), Status::bad_input);
  } catch (const std::exception& e) {
    status = say_little(name, e.what(), Status::fault);
  }
  return static_cast<int>(status);
}

} // namespace tetrarch::program
