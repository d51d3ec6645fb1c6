// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/tree.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tetrarch::workshop {
namespace {

/// Writes a tree; scalars as the JSON library writes them.
class Writer {
public:
  explicit Writer(int indent) : indent_(indent) {}

  void line(std::size_t depth) {
    if (indent_ < 0) return;
    text += '\n';
    text.append(depth * static_cast<std::size_t>(indent_), ' ');
  }

  /// Items between brackets; `write(k)` writes the k-th.
  void list(const char* brackets, std::size_t count, std::size_t depth, const auto& write) {
    text += brackets[0];
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) text += ',';
      line(depth + 1);
      write(k);
    }
    if (count > 0) line(depth);
    text += brackets[1];
  }

  void key(const std::string& name) {
    scalar(name);
    text += indent_ < 0 ? ":" : ": ";
  }

  void scalar(const auto& value) {
    using Library = nlohmann::ordered_json;
    append_escaped(Library(value).dump(-1, ' ', false, Library::error_handler_t::replace));
  }

  std::string text;

private:
  /// The library escapes the control characters below the blank; a terminal obeys DEL and those of U+0080 to
  /// U+009F too.
  void append_escaped(const std::string& written) {
    for (std::size_t k = 0; k < written.size(); ++k) {
      const auto byte = [&written](std::size_t i) {
        return i < written.size() ? static_cast<unsigned char>(written[i]) : static_cast<unsigned char>(0);
      };
      const bool is_pair = byte(k) == 0xc2 && byte(k + 1) >= 0x80 && byte(k + 1) < 0xa0;
      if (byte(k) != 0x7f && !is_pair) {
        text += written[k];
        continue;
      }
      if (is_pair) ++k;
      constexpr const char* digits = "0123456789abcdef";
      text += "\\u00";
      text += digits[byte(k) / 16];
      text += digits[byte(k) % 16];
    }
  }

  int indent_;
};

Tree tree_of_json(const nlohmann::ordered_json& value) {
  Tree json;
  if (value.is_object()) {
    json = Tree::object();
    for (const auto& [key, member] : value.items()) json[key] = tree_of_json(member);
  } else if (value.is_array()) {
    json = Tree::array();
    for (const auto& item : value) json.push_back(tree_of_json(item));
  } else if (value.is_string()) {
    json = value.get<std::string>();
  } else if (value.is_boolean()) {
    json = value.get<bool>();
  } else if (value.is_number_float()) {
    json = value.get<double>();
  } else if (value.is_number_unsigned()) {
    json = value.get<std::uint64_t>();
  } else if (value.is_number()) {
    json = value.get<std::int64_t>();
  }
  return json;
}

[[noreturn]] void refuse_kind(const char* expected) {
  throw PreconditionError(std::string("a JSON value is no ") + expected);
}

} // namespace

Tree::Tree(std::initializer_list<Tree> items) {
  const auto is_member = [](const Tree& item) {
    const Array* const pair = std::get_if<Array>(&item.value_);
    return pair != nullptr && pair->size() == 2 && std::holds_alternative<std::string>(pair->front().value_);
  };
  if (!std::all_of(items.begin(), items.end(), is_member)) {
    value_ = Array(items);
    return;
  }
  Object members;
  members.reserve(items.size());
  for (const Tree& item : items) {
    const Array& pair = std::get<Array>(item.value_);
    members.emplace_back(std::get<std::string>(pair[0].value_), pair[1]);
  }
  value_ = std::move(members);
}

Tree Tree::array() {
  Tree json;
  json.value_ = Array();
  return json;
}

Tree Tree::object() {
  Tree json;
  json.value_ = Object();
  return json;
}

Tree Tree::parse(std::string_view text) {
  try {
    return tree_of_json(nlohmann::ordered_json::parse(text));
  } catch (const nlohmann::ordered_json::exception& e) {
    throw PreconditionError(e.what());
  }
}

std::size_t Tree::size() const {
  if (const Array* const items = std::get_if<Array>(&value_)) return items->size();
  const Object* const members = std::get_if<Object>(&value_);
  return members == nullptr ? 0 : members->size();
}

Tree& Tree::operator[](std::string_view key) {
  if (is_null()) value_ = Object();
  Object* const members = std::get_if<Object>(&value_);
  if (members == nullptr) refuse_kind("object");
  const auto found = std::find_if(members->begin(), members->end(),
                                  [key](const auto& member) { return member.first == key; });
  return found != members->end() ? found->second : members->emplace_back(key, Tree()).second;
}

const Tree& Tree::operator[](std::string_view key) const {
  if (const Object* const members = std::get_if<Object>(&value_))
    for (const auto& [name, value] : *members)
      if (name == key) return value;
  refuse_kind("object with this member");
}

void Tree::update(const Tree& other) {
  const Object* const members = std::get_if<Object>(&other.value_);
  if (members == nullptr) refuse_kind("object");
  for (const auto& [key, value] : *members) (*this)[key] = value;
}

void Tree::erase(std::string_view key) {
  if (Object* const members = std::get_if<Object>(&value_))
    std::erase_if(*members, [key](const auto& member) { return member.first == key; });
}

void Tree::push_back(Tree item) {
  if (is_null()) value_ = Array();
  Array* const items = std::get_if<Array>(&value_);
  if (items == nullptr) refuse_kind("array");
  items->push_back(std::move(item));
}

const Tree& Tree::front() const {
  if (empty()) refuse_kind("array with items");
  return *begin();
}

const Tree& Tree::back() const {
  if (empty()) refuse_kind("array with items");
  return *(end() - 1);
}

Tree::Array::const_iterator Tree::begin() const {
  const Array* const items = std::get_if<Array>(&value_);
  if (items == nullptr) refuse_kind("array");
  return items->begin();
}

Tree::Array::const_iterator Tree::end() const {
  const Array* const items = std::get_if<Array>(&value_);
  if (items == nullptr) refuse_kind("array");
  return items->end();
}

const std::string& Tree::text() const {
  const std::string* const value = std::get_if<std::string>(&value_);
  if (value == nullptr) refuse_kind("text");
  return *value;
}

int Tree::integer() const {
  if (const auto* const value = std::get_if<std::int64_t>(&value_)) return static_cast<int>(*value);
  if (const auto* const value = std::get_if<std::uint64_t>(&value_)) return static_cast<int>(*value);
  refuse_kind("integer");
}

double Tree::number() const {
  if (const auto* const value = std::get_if<double>(&value_)) return *value;
  return integer();
}

std::string Tree::where_not_a_number() const {
  const auto inside = [](std::string name, const Tree& value) {
    const double* const number = std::get_if<double>(&value.value_);
    if (number != nullptr) return std::isfinite(*number) ? std::string() : name;
    const std::string found = value.where_not_a_number();
    return found.empty() ? found : std::move(name) + "/" + found;
  };
  if (const Object* const object = std::get_if<Object>(&value_); object != nullptr)
    for (const auto& [name, value] : *object)
      if (std::string found = inside(name, value); !found.empty()) return found;
  if (const Array* const array = std::get_if<Array>(&value_); array != nullptr)
    for (std::size_t k = 0; k < array->size(); ++k)
      if (std::string found = inside(std::to_string(k), (*array)[k]); !found.empty()) return found;
  return {};
}

std::string Tree::dump(int indent) const {
  Writer writer(indent);
  const auto write = [&writer](const auto& self, const Tree& json, std::size_t depth) -> void {
    if (const Array* const items = std::get_if<Array>(&json.value_)) {
      writer.list("[]", items->size(), depth, [&](std::size_t k) { self(self, (*items)[k], depth + 1); });
    } else if (const Object* const members = std::get_if<Object>(&json.value_)) {
      writer.list("{}", members->size(), depth, [&](std::size_t k) {
        writer.key((*members)[k].first);
        self(self, (*members)[k].second, depth + 1);
      });
    } else {
      std::visit(
          [&writer](const auto& value) {
            using T = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<T, std::monostate>)
              writer.scalar(nullptr);
            else if constexpr (!std::is_same_v<T, Array> && !std::is_same_v<T, Object>)
              writer.scalar(value);
          },
          json.value_);
    }
  };
  write(write, *this, 0);
  return writer.text;
}

} // namespace tetrarch::workshop
