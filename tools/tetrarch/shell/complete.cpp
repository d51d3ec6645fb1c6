// SPDX-License-Identifier: GPL-2.0-or-later
#include "complete.hpp"

#include "tetrarch/identify/names.hpp"
#include "tetrarch/moves/log.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace tetrarch::program {
namespace {

using Words = std::vector<std::string>;
using Table = std::vector<Declared>;

/// The words before the one to be completed. Quotes are left alone: nobody completes inside them.
Words words_before(std::string_view text) {
  Words words;
  while (true) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) break;
    text.remove_prefix(first);
    const std::size_t length = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  // "NAME = verb" and "tetrarch verb" begin with the verb.
  if (words.size() >= 2 && words[1] == "=") words.erase(words.begin(), words.begin() + 2);
  if (!words.empty() && words.front() == "tetrarch") words.erase(words.begin());
  return words;
}

const Declared* command_named(const Table& table, const std::string& name) {
  for (const Declared& declared : table)
    if (declared.command->name == name) return &declared;
  return nullptr;
}

/// The longest command that the words begin with.
const Declared* command_of(const Words& words, const Table& table) {
  if (words.empty()) return nullptr;
  if (words.size() > 1)
    if (const Declared* found = command_named(table, words[0] + " " + words[1])) return found;
  return command_named(table, words[0]);
}

/// The next words of all commands that begin with these words.
std::set<std::string> next_words(const Words& words, const Table& table) {
  std::string before;
  for (const std::string& word : words) before += word + " ";
  std::set<std::string> result;
  for (const Declared& declared : table) {
    const std::string name = declared.command->name;
    if (!name.starts_with(before)) continue;
    const std::string rest = name.substr(before.size());
    result.insert(rest.substr(0, rest.find(' ')));
  }
  return result;
}

void add_options(std::set<std::string>& words, const OptionTable& table) {
  words.insert("--help");
  for (const Option& option : table.options())
    if (!option.is_argument()) words.insert(option.names.begin(), option.names.end());
}

void add_files(std::set<std::string>& words, const std::string& begun) {
  namespace fs = std::filesystem;
  const std::size_t slash = begun.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : begun.substr(0, slash + 1);
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool hidden = name.starts_with('.') && begun.substr(folder.size()).empty();
    std::error_code ignored;
    if (!hidden) words.insert(folder + name + (at->is_directory(ignored) ? "/" : ""));
  }
}

/// The names of known manifolds, once two letters tell which are meant.
void add_known_names(std::set<std::string>& words, const std::string& begun) {
  if (begun.size() < 2) return;
  for (std::string& name : identify::listed_names())
    if (name.starts_with(begun)) words.insert(std::move(name));
}

void add_names(std::set<std::string>& words, const Values& values) {
  for (const auto& [name, value] : values) words.insert(name);
}

/// Whether a word after the verb is no option.
bool has_operand(const Words& words) {
  return std::any_of(words.begin() + 1, words.end(),
                     [](const std::string& w) { return !w.starts_with('-'); });
}

std::set<std::string> candidates(const Words& before, const std::string& begun, const Table& table,
                                 const Values& values) {
  std::set<std::string> words;
  const bool helped = !before.empty() && before.front() == "help";
  if (helped) return next_words({before.begin() + 1, before.end()}, table);
  const Declared* declared = command_of(before, table);
  if (declared == nullptr) {
    words = next_words(before, table);
    if (before.empty()) add_names(words, values);
    return words;
  }
  if (begun.starts_with('-')) {
    add_options(words, declared->options);
    return words;
  }
  const Option* option = declared->options.find(before.back());
  if (option != nullptr && !option->choices.empty()) {
    words.insert(option->choices.begin(), option->choices.end());
    return words;
  }
  const bool free = option == nullptr || option->is_argument() || option->is_flag();
  if (free && declared->command->name == std::string_view("move") && has_operand(before)) {
    for (std::string& name : moves::move_names()) words.insert(std::move(name));
    return words;
  }
  const std::string kind = free ? "" : option->type();
  const bool mesh = kind == "SURFACE" || kind == "MESH";
  if (free || mesh) add_names(words, values);
  if (free) add_known_names(words, begun);
  if (free || mesh || kind == "FILE") add_files(words, begun);
  return words;
}

} // namespace

Completions complete(std::string_view text, const Table& table, const Values& values) {
  const std::size_t blank = text.find_last_of(" \t=");
  Completions result;
  result.start = blank == std::string_view::npos ? 0 : blank + 1;
  const std::string begun(text.substr(result.start));
  for (const std::string& word : candidates(words_before(text.substr(0, result.start)), begun, table, values))
    if (word.starts_with(begun)) result.words.push_back(word);
  return result;
}

std::string common_beginning(const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto end = std::mismatch(common.begin(), common.end(), word.begin(), word.end());
    common.erase(end.first, common.end());
  }
  return common;
}

std::string in_columns(const std::vector<std::string>& words, std::size_t width) {
  Words shown;
  std::size_t longest = 0;
  for (const std::string& word : words) {
    const std::size_t slash = word.size() < 2 ? std::string::npos : word.rfind('/', word.size() - 2);
    shown.push_back(slash == std::string::npos ? word : word.substr(slash + 1));
    longest = std::max(longest, shown.back().size());
  }
  const std::size_t column = longest + 2;
  const std::size_t columns = std::max<std::size_t>(1, width / column);
  const std::size_t rows = (shown.size() + columns - 1) / columns;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = row; k < shown.size(); k += rows)
      text += shown[k] + (k + rows < shown.size() ? std::string(column - shown[k].size(), ' ') : "\n");
  }
  return text;
}

} // namespace tetrarch::program
