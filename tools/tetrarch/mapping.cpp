// SPDX-License-Identifier: GPL-2.0-or-later
#include "mapping.hpp"

#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/element.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

bool stands_for_all(const std::string& word) {
  if (!word.ends_with("#*")) return false;
  const std::optional<workshop::FileElement> found = workshop::file_element(word, samples_folder());
  return found && found->element == "*";
}

/// How grave a status is among those of many lines.
std::size_t gravity(Status status) {
  constexpr std::array order{Status::done,      Status::proved_no, Status::undecided,
                             Status::bad_input, Status::fault,     Status::interrupted};
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), status) - order.begin());
}

bool names_output(const std::string& word) {
  return word.starts_with("-o") || word.starts_with("--output");
}

void require_many_outputs(const Mapping& mapping) {
  const std::vector<std::string>& words = mapping.words;
  const std::size_t count = mapping.collection.elements.size();
  const auto output = std::find_if(words.begin(), words.end(), names_output);
  if (count < 2 || output == words.end()) return;
  const bool numbered = std::any_of(output, std::min(output + 2, words.end()), [](const std::string& word) {
    return word.find('*') != std::string::npos;
  });
  if (!numbered)
    throw InputError("one file cannot hold " + std::to_string(count) +
                     " results: write -o with a * where their numbers go");
}

std::string with_number(std::string word, std::size_t number) {
  const std::string digits = std::to_string(number);
  for (std::size_t at = word.find('*'); at != std::string::npos; at = word.find('*', at + digits.size()))
    word.replace(at, 1, digits);
  return word;
}

} // namespace

std::optional<Mapping> mapping_in(const std::vector<std::string>& words) {
  const auto count = std::count_if(words.begin(), words.end(), stands_for_all);
  if (count == 0) return std::nullopt;
  if (count > 1) throw InputError("only one argument can stand for all triangulations of a file");
  Mapping mapping{words, 0, {}, {}};
  mapping.at =
      static_cast<std::size_t>(std::find_if(words.begin(), words.end(), stands_for_all) - words.begin());
  mapping.path = workshop::file_element(words[mapping.at], samples_folder())->path;
  mapping.collection = workshop::read_collection(mapping.path, samples_folder());
  require_many_outputs(mapping);
  return mapping;
}

std::vector<std::string> words_for(const Mapping& mapping, std::size_t number) {
  std::vector<std::string> words = mapping.words;
  for (std::size_t k = 0; k < words.size(); ++k)
    words[k] = k == mapping.at ? mapping.path + "#" + std::to_string(number) : with_number(words[k], number);
  return words;
}

Status run_mapping(Mapping mapping, const std::vector<Command>& table, const std::string& program,
                   const Common& defaults, const Values* values, const std::string& speaker) {
  Values named = values == nullptr ? Values() : *values;
  Share share{{}, {}, {}, std::move(mapping.collection.passed_over)};
  Status gravest = Status::done;
  std::vector<format::Element>& elements = mapping.collection.elements;
  const bool in_json = std::find(mapping.words.begin(), mapping.words.end(), "--json") != mapping.words.end();
  const auto refuse = [&](const std::string& input, const std::string& message) {
    return in_json ? complain_in_json({input, 0}, message, Status::bad_input, code_of(Cause::content))
                   : complain(speaker, input + ": " + message, Status::bad_input);
  };
  if (elements.empty())
    return refuse(format::source_name(mapping.path),
                  "found no triangulations of 3-manifolds" +
                      (share.passed_over.empty() ? "" : "; " + share.passed_over.sentence()));
  for (std::size_t k = 0; k < elements.size() && gravest != Status::interrupted; ++k) {
    const std::vector<std::string> words = words_for(mapping, k + 1);
    const std::string& input = words[mapping.at];
    const Parsed parsed = parse(words, table, program, defaults);
    if (!parsed.job) { // a help page: once is enough
      say(parsed.text);
      return gravest;
    }
    share.input = input;
    share.name = elements[k].name;
    Status status = Status::bad_input;
    if (!elements[k].error) {
      share.passed_over.add(elements[k].document.passed_over);
      named[input] = std::make_shared<Value>(std::move(elements[k].document));
      status = run_job(*parsed.job, &named, speaker, nullptr, &share).status;
      share.passed_over = {};
      named.erase(input);
    } else {
      const InputError& error = *elements[k].error;
      if (in_json)
        complain_in_json({input, error.place.line}, error.message, Status::bad_input, code_of(error.cause));
      else
        refuse(input, error.what());
    }
    if (gravity(status) > gravity(gravest)) gravest = status;
  }
  return gravest;
}

} // namespace tetrarch::program
