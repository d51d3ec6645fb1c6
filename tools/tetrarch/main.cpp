// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "interrupts.hpp"
#include "job.hpp"
#include "mapping.hpp"
#include "parse.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <exception>
#include <string>
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

} // namespace

int main(int argc, char** argv) {
  Status status = Status::fault;
  const std::vector<std::string> words(argv + 1, argv + argc);
  watch_signals();
  try {
    status = parse_and_run(words);
  } catch (const InputError& e) {
    status = asks_for_json(words) ? complain_in_json(e.place, e.message, Status::bad_input)
                                  : complain(program_name, e.what(), Status::bad_input);
  } catch (const std::exception& e) {
    complain(program_name, e.what(), Status::fault);
  }
  return static_cast<int>(status);
}
