// SPDX-License-Identifier: GPL-2.0-or-later
// Where in a JSON text a value stands, found by reading it again: only complaints need it, and they are rare.
// And what a text says that it is, found by reading no farther.
#include "json_tree.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/json.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

namespace tetrarch::format {
namespace {

/// Reads characters and remembers how far it has come.
class TrackedIterator {
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  TrackedIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  TrackedIterator operator++(int) {
    TrackedIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const TrackedIterator& a, const TrackedIterator& b) { return a.at_ == b.at_; }

private:
  const char* at_;
  const char** reached_;
};

/// Follows the events until the value at `path` starts. Every event answers "go on" until then.
class Locator {
public:
  Locator(const JsonPath& path, int occurrence) : path_(path), wanted_(occurrence) {}
  bool found() const { return wanted_ == 0; }

  bool null() { return value(); }
  bool boolean(bool) { return value(); }
  bool number_integer(std::int64_t) { return value(); }
  bool number_unsigned(std::uint64_t) { return value(); }
  bool number_float(double, const std::string&) { return value(); }
  bool string(std::string&) { return value(); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return start(JsonStep(std::string())); }
  bool start_array(std::size_t) { return start(JsonStep(std::size_t{0})); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool key(std::string& name) {
    at_.back().key = std::move(name);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) { return false; }

private:
  bool value() {
    wanted_ -= at_ == path_;
    advance();
    return !found();
  }
  bool start(JsonStep first) {
    wanted_ -= at_ == path_;
    at_.push_back(std::move(first));
    return !found();
  }
  bool end() {
    at_.pop_back();
    advance();
    return true;
  }
  void advance() {
    if (!at_.empty() && !at_.back().is_key) ++at_.back().index;
  }

  const JsonPath& path_;
  int wanted_; ///< matches still to come
  JsonPath at_;
};

/// Goes on until the member "format" of the root was read.
class FormatFinder {
public:
  std::string format;

  bool null() { return other(); }
  bool boolean(bool) { return other(); }
  bool number_integer(std::int64_t) { return other(); }
  bool number_unsigned(std::uint64_t) { return other(); }
  bool number_float(double, const std::string&) { return other(); }
  bool string(std::string& value) {
    if (at_format_) format = std::move(value);
    return other();
  }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return start(); }
  bool start_array(std::size_t) { return depth_ > 0 && start(); }
  bool end_object() { return --depth_ > 0; }
  bool end_array() { return --depth_ > 0; }
  bool key(const std::string& name) {
    at_format_ = depth_ == 1 && name == "format";
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) { return false; }

private:
  bool other() const { return depth_ > 0 && !at_format_; }
  bool start() {
    ++depth_;
    return !at_format_ && depth_ <= json_deepest_nesting;
  }

  int depth_ = 0;
  bool at_format_ = false;
};

} // namespace

std::string json_format_of(std::string_view text) {
  FormatFinder finder;
  Json::sax_parse(text.begin(), text.end(), &finder);
  return finder.format;
}

int line_at(std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

std::string path_text(const JsonPath& path) {
  std::string text;
  for (const JsonStep& step : path) {
    if (!step.is_key)
      text += "[" + std::to_string(step.index) + "]";
    else
      text += (text.empty() ? "" : ".") + step.key;
  }
  // A key may be of any length and hold anything.
  if (text.size() > 60 || std::any_of(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }))
    return in_quotes(text);
  return text;
}

int line_of(std::string_view text, const JsonFault& fault) {
  const char* reached = text.data();
  Locator locator(fault.path, fault.occurrence);
  const char* const end = text.data() + text.size();
  Json::sax_parse(TrackedIterator(text.data(), &reached), TrackedIterator(end, &reached), &locator);
  // One character may have been read ahead, and it may be the end of the line.
  if (!locator.found() || reached == text.data()) return 1;
  return line_at(text, static_cast<std::size_t>(reached - text.data()) - 1);
}

} // namespace tetrarch::format
