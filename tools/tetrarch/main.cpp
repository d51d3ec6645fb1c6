// SPDX-License-Identifier: GPL-2.0-or-later
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

namespace {

using namespace tetrarch;
using namespace tetrarch::program;

constexpr const char* program_name = "tetrarch";

Status parse_and_run(const std::vector<std::string>& words) {
  if (std::optional<Mapping> mapping = mapping_in(words))
    return run_mapping(std::move(*mapping), commands(), program_name, usual_options(), nullptr, program_name);
  const Parsed parsed = parse(words, commands(), program_name, usual_options());
  if (parsed.job) return run_job(*parsed.job, nullptr, program_name).status;
  say(parsed.text);
  return Status::done;
}

bool asks_for_json(const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), "--json") != words.end();
}

Status speak(const std::vector<std::string>& words) {
  try {
    return parse_and_run(words);
  } catch (const InputError& e) {
    return asks_for_json(words) ? complain_in_json(e.place, e.message, Status::bad_input, code_of(e.cause))
                                : complain(program_name, e.what(), Status::bad_input);
  }
}

/// A line for when there is no memory left to make one.
Status say_little(std::string_view message, Status status) {
  for (const std::string_view part : {std::string_view("tetrarch: "), message, std::string_view("\n")})
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) return Status::fault;
  return status;
}

} // namespace

int main(int argc, char** argv) {
  Status status = Status::fault;
  try {
    prepare_for_want(argv);
    watch_signals();
    bound_memory(usual_memory());
    status = speak({argv + 1, argv + argc});
  } catch (const std::bad_alloc&) {
    status = say_little("out of memory", Status::bad_input);
  } catch (const std::system_error& e) { // of threads, for one
    status = say_little(e.what(), Status::bad_input);
  } catch (const std::exception& e) {
    status = say_little(e.what(), Status::fault);
  }
  return static_cast<int>(status);
}
