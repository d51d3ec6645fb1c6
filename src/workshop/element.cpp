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

namespace fs = std::filesystem;

constexpr std::string_view prefix = "samples/";

std::string names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return joined(names, ", ");
}

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

std::string located(const std::string& argument, const Samples& samples) {
  std::error_code ignored;
  if (!samples || !argument.starts_with(prefix) || fs::exists(argument, ignored)) return argument;
  const fs::path folder = *samples;
  const fs::path sample = folder / argument.substr(prefix.size());
  if (fs::is_regular_file(sample, ignored)) return sample.string();
  const std::string names = names_in(folder);
  throw InputError({argument, 0}, names.empty()
                                      ? "no such file, and no samples are installed in " + folder.string()
                                      : "no such file, and no such sample (expected one of " + names + ")");
}

bool is_file(const std::string& argument, const Samples& samples) {
  std::error_code ignored;
  return argument == "-" || fs::exists(located(argument, samples), ignored);
}

std::optional<FileElement> file_element(const std::string& argument, const Samples& samples) {
  if (is_file(argument, samples)) return std::nullopt;
  for (std::size_t at = argument.find('#'); at != std::string::npos; at = argument.find('#', at + 1))
    if (is_file(argument.substr(0, at), samples))
      return FileElement{argument.substr(0, at), argument.substr(at + 1)};
  return std::nullopt;
}

format::Collection read_collection(const std::string& path, const Samples& samples) {
  return collection_in(format::read_file(located(path, samples)), format::source_name(path));
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
