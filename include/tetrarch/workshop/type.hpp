// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Of what type a value in a result is, said once, as the part of a JSON Schema (draft 2020-12) that demands
/// it.
///
///     type::list(type::object({{"loop", type::integer}, {"radius", type::number, type::sometimes}}))

#include "tetrarch/workshop/tree.hpp"

#include <string>
#include <vector>

namespace tetrarch::workshop {

/// A type of values.
class Type {
public:
  enum class Plain { truth, integer, number, text };
  Type() = default; ///< whatever there is
  Type(Plain plain);
  /// Of a part of a schema.
  explicit Type(Tree schema);

  /// Empty: anything.
  const Tree& schema() const { return schema_; }

private:
  Tree schema_ = Tree::object();
};

namespace type {

inline constexpr Type::Plain truth = Type::Plain::truth;
inline constexpr Type::Plain integer = Type::Plain::integer;
inline constexpr Type::Plain number = Type::Plain::number;
inline constexpr Type::Plain text = Type::Plain::text;

enum class Presence { always, sometimes };
inline constexpr Presence sometimes = Presence::sometimes;

/// A member of an object.
struct Member {
  const char* name;
  Type of;
  Presence presence = Presence::always;
};

/// An object with these members and no others.
Type object(const std::vector<Member>& members);
/// An object whose members, all of one type, have names that the data give.
Type table(const Type& value);
Type list(const Type& item);
/// A list of just so many.
Type list(const Type& item, int length);
/// A list whose items are of these types, in this order.
Type tuple(const std::vector<Type>& items);
/// One of these texts.
Type one_of(const std::vector<std::string>& words);
Type or_null(const Type& some);
/// What is of one of two types; one of them if they are the same.
Type either(const Type& one, const Type& other);

} // namespace type
} // namespace tetrarch::workshop
