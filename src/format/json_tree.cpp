// SPDX-License-Identifier: GPL-2.0-or-later
#include "json_tree.hpp"

#include "tetrarch/format/json.hpp"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace tetrarch::format {
namespace {

/// The parser's reason without its own account of the place, and without a token of any length:
/// "[...] syntax error while parsing array - invalid literal; last read: '...'; expected ']'".
std::string reason_of(std::string_view what) {
  std::string_view expected;
  const std::size_t wish = what.rfind("; expected ");
  if (wish != std::string_view::npos) {
    expected = what.substr(wish + 2);
    what = what.substr(0, wish);
  }
  what = what.substr(0, what.find("; last read: "));
  const std::size_t dash = what.find(" - ");
  if (dash != std::string_view::npos) what = what.substr(dash + 3);
  std::string reason(what.substr(0, 80));
  if (!expected.empty()) reason += ", " + std::string(expected.substr(0, 80));
  return reason;
}

std::string beyond_a_double(const std::string& number) {
  return "found the number " + in_quotes(number) + ", which is beyond a double; expected a string of digits";
}

/// What was read last, up to `end`. (The parser's own account of it may begin many tokens earlier.)
std::string_view last_word(std::string_view text, std::size_t end) {
  constexpr std::string_view delimiters = " \t\r\n,:[]{}";
  std::size_t first = end > 0 ? end - 1 : 0;
  if (first < text.size() && delimiters.find(text[first]) == std::string_view::npos)
    while (first > 0 && delimiters.find(text[first - 1]) == std::string_view::npos) --first;
  return text.substr(first, end - first);
}

/// `position` is the number of characters read.
[[noreturn]] void fail_syntax(std::string_view text, const std::string& source, std::size_t position,
                              const nlohmann::json::exception& error) {
  const std::string_view content =
      text.substr(0, trimmed(text).empty() ? 0 : text.find_last_not_of(" \t\r\n") + 1);
  if (position > content.size()) {
    const std::string wish = reason_of(error.what());
    const std::size_t expected = wish.find(", expected ");
    throw InputError(Place{source, line_at(content, content.size())},
                     "the JSON text ends too early" +
                         (expected == std::string::npos ? "" : wish.substr(expected)));
  }
  const Place place{source, line_at(text, position == 0 ? 0 : position - 1)};
  const std::string_view token = last_word(text, position);
  if (error.id == 406) // nlohmann's number for an overflow
    throw InputError(place, beyond_a_double(std::string(trimmed(token))));
  throw InputError(place,
                   "found " + in_quotes(token) + " where the JSON text breaks: " + reason_of(error.what()));
}

/// How many digits carry the value of a decimal number.
std::size_t significant_digits(std::string_view number) {
  std::string digits;
  for (const char c : number.substr(0, number.find_first_of("eE")))
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? 0 : digits.find_last_not_of('0') - first + 1;
}

/// The value of a JSON number; none if a double cannot hold it.
std::optional<double> checked_double(const std::string& number) {
  const std::optional<double> value = parse_double(number);
  constexpr std::size_t digits_of_a_double = 17;
  if (value && (significant_digits(number) <= digits_of_a_double || to_text(*value) == number)) return value;
  return std::nullopt;
}

/// Takes the events inside of the array "gluings".
class GluingReader {
public:
  GluingTable table;

  bool reading() const { return level_ > 0; }
  void open(bool is_array) {
    if (level_ == 0) {
      level_ = 1;
    } else if (is_array && level_ == 1) {
      table.emplace_back();
      face_ = 0;
      level_ = 2;
    } else if (is_array && level_ == 2 && face_ < 4) {
      slot_ = 0;
      level_ = 3;
    } else {
      fail(is_array ? "an array" : "an object");
    }
  }
  void close() {
    if ((level_ == 2 && face_ != 4) || (level_ == 3 && slot_ != 2)) fail("the end of the array");
    face_ += level_ == 3;
    --level_;
  }
  void scalar(const Json& value) {
    if (level_ == 2 && face_ < 4 && value.is_null()) {
      ++face_;
    } else if (level_ == 3 && slot_ == 0 && value.is_number_unsigned() &&
               value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
      table.back()[face_].tet = value.get<int>();
      ++slot_;
    } else if (level_ == 3 && slot_ == 1 && value.is_string()) {
      const std::optional<Perm4> perm = parse_perm(value.get_ref<const std::string&>());
      if (!perm) fail(describe(value));
      table.back()[face_].perm = *perm;
      ++slot_;
    } else {
      fail(describe(value));
    }
  }

private:
  [[noreturn]] void fail(const std::string& found) const {
    JsonPath path{JsonStep("gluings")};
    if (level_ == 1) {
      path.emplace_back(table.size());
      throw JsonFault{path, "found " + found + ", expected an array of four faces"};
    }
    path.emplace_back(table.size() - 1);
    if (level_ == 2) {
      if (found != "the end of the array") path.emplace_back(static_cast<std::size_t>(face_));
      throw JsonFault{path, "found " + found +
                                (face_ < 4 ? ", expected null or [tetrahedron, \"permutation\"]"
                                           : ", expected the end of four faces")};
    }
    path.emplace_back(static_cast<std::size_t>(face_));
    const std::array<const char*, 3> wish{"a tetrahedron, counted from 0", "a permutation like \"0132\"",
                                          "the end of [tetrahedron, \"permutation\"]"};
    throw JsonFault{path, "found " + found + ", expected " + wish[static_cast<std::size_t>(slot_)]};
  }

  int level_ = 0; ///< 1 in the list, 2 in a tetrahedron, 3 in a face
  int face_ = 0;
  int slot_ = 0;
};

/// What nlohmann's parser calls. A fault is thrown, so every event answers "go on".
class TreeBuilder {
public:
  JsonTree tree;

  TreeBuilder(std::string_view text, const std::string& source, const JsonHeader& header)
      : text_(text), source_(source), header_(header) {}

  bool null() { return scalar(nullptr); }
  bool boolean(bool value) { return scalar(value); }
  bool number_integer(std::int64_t value) { return scalar(value); }
  bool number_unsigned(std::uint64_t value) { return scalar(value); }
  bool number_float(double, std::string raw) {
    // The parser spells the decimal point as the C locale does; every other character is known.
    for (char& c : raw)
      if ((c < '0' || c > '9') && c != 'e' && c != 'E' && c != '+' && c != '-') c = '.';
    const std::optional<double> value = checked_double(raw);
    if (!value) throw JsonFault{here(), beyond_a_double(raw)};
    return scalar(*value);
  }
  bool string(std::string& value) { return scalar(std::move(value)); }
  bool binary(Json::binary_t&) { return false; } // JSON text has none

  bool start_object(std::size_t) { return open(Json::object(), false); }
  bool start_array(std::size_t) { return open(Json::array(), true); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    if (gluings_.reading()) return true;
    if (!open_.back().keys.insert(name).second) {
      JsonPath path = here();
      path.pop_back();
      path.emplace_back(name);
      throw JsonFault{path, "the member is there twice", 2};
    }
    open_.back().key = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error) {
    fail_syntax(text_, source_, position, error);
  }

private:
  struct Open {
    Json* value;
    std::string key;                      ///< the member being read
    std::unordered_set<std::string> keys; ///< all so far: a look-up in the ordered object would be linear
  };

  /// The path of the value that comes next. Arrays further out already count the one that is open in them.
  JsonPath here() const {
    JsonPath path;
    for (const Open& o : open_) {
      if (o.value->is_array())
        path.emplace_back(o.value->size() - (&o == &open_.back() ? 0 : 1));
      else
        path.emplace_back(o.key);
    }
    return path;
  }

  bool at_member(std::string_view name) const { return open_.size() == 1 && open_.back().key == name; }

  bool scalar(Json value) {
    if (gluings_.reading()) {
      gluings_.scalar(value);
      return true;
    }
    if (open_.empty()) throw JsonFault{{}, "found " + describe(value) + ", expected an object"};
    check_header(value);
    add(std::move(value));
    return true;
  }

  /// At once, so that a file of another version is not blamed for its gluings.
  void check_header(const Json& value) const {
    if (at_member("format") && value != header_.format)
      throw JsonFault{here(),
                      "found " + describe(value) + ", expected \"" + std::string(header_.format) + "\""};
    if (at_member("version") && !(value.is_number_integer() && value == header_.version))
      throw JsonFault{here(),
                      "found " + describe(value) + ", expected version " + std::to_string(header_.version)};
    if (header_.has_gluings && at_member("gluings"))
      throw JsonFault{here(),
                      "found " + describe(value) + ", expected an array with one entry per tetrahedron"};
  }

  Json* add(Json&& value) {
    Json& parent = *open_.back().value;
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    // Around the ordered object's own insertion, which looks for the key first and is linear.
    Json::object_t::Container& members = parent.get_ref<Json::object_t&>();
    members.emplace_back(open_.back().key, std::move(value));
    return &members.back().second;
  }

  bool open(Json empty, bool is_array) {
    if (gluings_.reading()) {
      gluings_.open(is_array);
      return true;
    }
    if (open_.empty()) {
      if (is_array) throw JsonFault{{}, "found an array, expected an object"};
      tree.root = std::move(empty);
      open_.push_back({&tree.root, {}, {}});
      return true;
    }
    if (open_.size() >= static_cast<std::size_t>(json_deepest_nesting))
      throw JsonFault{here(), "nested more than " + std::to_string(json_deepest_nesting) + " deep"};
    if (header_.has_gluings && at_member("gluings") && is_array) {
      gluings_.open(true);
      return true;
    }
    check_header(empty);
    Json* const added = add(std::move(empty));
    open_.push_back({added, {}, {}});
    return true;
  }

  bool close() {
    if (!gluings_.reading()) {
      open_.pop_back();
      return true;
    }
    gluings_.close();
    if (!gluings_.reading()) {
      tree.gluings = std::move(gluings_.table);
      add(nullptr);
    }
    return true;
  }

  std::string_view text_;
  const std::string& source_;
  const JsonHeader& header_;
  std::vector<Open> open_;
  GluingReader gluings_;
};

} // namespace

std::string describe(const Json& value) {
  if (value.is_string()) return "the string " + in_quotes(value.get_ref<const std::string&>());
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  return (value.is_number() ? "the number " : "") + value.dump();
}

JsonTree parse_tree(std::string_view text, const std::string& source, const JsonHeader& header) {
  TreeBuilder builder(text, source, header);
  Json::sax_parse(text.begin(), text.end(), &builder);
  for (const char* const key : {"format", "version"})
    if (!builder.tree.root.contains(key))
      throw JsonFault{{}, "the member \"" + std::string(key) + "\" is missing"};
  return std::move(builder.tree);
}

} // namespace tetrarch::format
