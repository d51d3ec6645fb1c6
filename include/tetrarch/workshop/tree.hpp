// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a result says, for programs: a tree in the shape of JSON, whose members keep their order.
///
///     Tree tree{{"name", "fmp2_8"}, {"angles", Tree::array()}};      pairs that begin with a text: an object
///     tree["angles"].push_back(0.5);
///
/// It is written by the JSON library, in tree.cpp alone: that library's header would cost every command two
/// seconds of compilation. Reading files is the business of the room `format`.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tetrarch::workshop {

/// Null, a truth value, a number, a text, an array or an object.
class Tree {
public:
  using Array = std::vector<Tree>;
  /// A class of its own: of a variant of vectors alone the library of GCC 12 destroys, when a copy of it
  /// throws, what was never made.
  struct Object : std::vector<std::pair<std::string, Tree>> {};

  Tree() = default; ///< null
  Tree(std::nullptr_t) {}
  Tree(bool value) : value_(value) {}
  template <std::signed_integral T>
  Tree(T value) : value_(static_cast<std::int64_t>(value)) {}
  template <std::unsigned_integral T>
  Tree(T value) : value_(static_cast<std::uint64_t>(value)) {}
  Tree(double value) : value_(value) {}
  Tree(const char* value) : value_(std::string(value)) {}
  Tree(std::string_view value) : value_(std::string(value)) {}
  Tree(std::string value) : value_(std::move(value)) {}
  /// An object if every item is a list of two of which the first is a text, else an array.
  Tree(std::initializer_list<Tree> items);
  template <std::ranges::range R>
  requires(!std::convertible_to<R, std::string_view> && !std::same_as<R, Tree>) Tree(const R& range)
      : value_(Array()) {
    for (const auto& item : range) push_back(item);
  }
  static Tree array();
  static Tree object();
  /// Of JSON text that the program wrote itself. Throws PreconditionError if it is none.
  static Tree parse(std::string_view text);

  bool is_null() const { return value_.index() == 0; }
  bool is_object() const { return std::holds_alternative<Object>(value_); }
  /// Of an array or object; 0 of anything else.
  std::size_t size() const;
  bool empty() const { return size() == 0; }

  /// The member of that name, added if there is none; null becomes an object. Linear in their number.
  /// Throws PreconditionError for what is neither.
  Tree& operator[](std::string_view key);
  /// The member of that name; throws PreconditionError if there is none.
  const Tree& operator[](std::string_view key) const;
  /// Adds the members of another object, or replaces those there are.
  void update(const Tree& other);
  void erase(std::string_view key);

  /// Null becomes an array. Throws PreconditionError for what is neither.
  void push_back(Tree item);
  const Tree& front() const;
  const Tree& back() const;
  Array::const_iterator begin() const;
  Array::const_iterator end() const;

  const std::string& text() const; ///< throws PreconditionError unless it is one
  int integer() const;             ///< throws PreconditionError unless it is one
  double number() const;           ///< likewise

  /// JSON text, in one line; with an `indent`, an item a line. Numbers that are not finite become null.
  std::string dump(int indent = -1) const;

  /// The names that lead to the first number that is none, joined by slashes; empty if there is no such
  /// number.
  std::string where_not_a_number() const;

private:
  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value_;
};

} // namespace tetrarch::workshop
