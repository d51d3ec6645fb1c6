// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/element.hpp"

#include "tetrarch/workshop/collection.hpp"
#include "tetrarch/workshop/nearest.hpp"
#include "tetrarch/workshop/text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

namespace tetrarch::workshop {
namespace {

/// The numbers, from 1, of the elements whose names fit.
std::vector<std::size_t> numbers_of(const format::Collection& collection,
                                    const std::function<bool(const std::string&)>& fits) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < collection.elements.size(); ++k)
    if (fits(collection.elements[k].name)) numbers.push_back(k + 1);
  return numbers;
}

[[noreturn]] void fail_several(const std::vector<std::size_t>& numbers, const std::string& argument) {
  constexpr std::size_t listed = 5;
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < std::min(numbers.size(), listed); ++k)
    texts.push_back("#" + std::to_string(numbers[k]));
  throw InputError({argument, 0}, "this names " + std::to_string(numbers.size()) + " triangulations: " +
                                      joined(texts, ", ") + (numbers.size() > listed ? ", ..." : ""));
}

std::size_t number_named(const format::Collection& collection, const std::string& name,
                         const std::string& argument) {
  if (name.empty())
    throw InputError({argument, 0},
                     "which of its " +
                         counted(static_cast<long long>(collection.elements.size()), "triangulation") +
                         "? (#1 is the first, #NAME one by its name, #* are all)");
  std::vector<std::size_t> numbers =
      numbers_of(collection, [&](const std::string& label) { return label == name; });
  if (numbers.empty())
    numbers = numbers_of(collection, [&](const std::string& label) { return label.starts_with(name); });
  if (numbers.size() > 1) fail_several(numbers, argument);
  if (!numbers.empty()) return numbers.front();
  std::vector<std::string> labels;
  for (const format::Element& element : collection.elements) labels.push_back(element.name);
  throw InputError({argument, 0}, "none of its " +
                                      counted(static_cast<long long>(labels.size()), "triangulation") +
                                      " is called " + in_quotes(name) + near_names(name, labels));
}

} // namespace

std::string located(const std::string& argument, Locate locate) {
  return locate == nullptr ? argument : locate(argument);
}

bool is_file(const std::string& argument, Locate locate) {
  std::error_code ignored;
  return argument == "-" || std::filesystem::exists(located(argument, locate), ignored);
}

std::optional<FileElement> file_element(const std::string& argument, Locate locate) {
  if (is_file(argument, locate)) return std::nullopt;
  for (std::size_t at = argument.find('#'); at != std::string::npos; at = argument.find('#', at + 1))
    if (is_file(argument.substr(0, at), locate))
      return FileElement{argument.substr(0, at), argument.substr(at + 1)};
  return std::nullopt;
}

format::Collection read_collection(const std::string& path, Locate locate) {
  return collection_in(format::read_file(located(path, locate)), format::source_name(path));
}

format::Document chosen(format::Collection collection, const std::string& element,
                        const std::string& argument) {
  const auto count = static_cast<std::int64_t>(collection.elements.size());
  const bool is_number = !element.empty() && element.find_first_not_of("0123456789") == std::string::npos;
  const std::optional<std::int64_t> given =
      is_number ? format::parse_integer(element) : std::optional<std::int64_t>();
  if (is_number && (!given || *given < 1 || *given > count))
    throw InputError({argument, 0}, "the file holds " + counted(count, "triangulation") +
                                        ", of which the first has the number 1");
  const std::size_t number =
      given ? static_cast<std::size_t>(*given) : number_named(collection, element, argument);
  return format::document_of(std::move(collection.elements[number - 1]), collection.passed_over);
}

} // namespace tetrarch::workshop
