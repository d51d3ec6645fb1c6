// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/type.hpp"

#include <utility>

namespace tetrarch::workshop {
namespace {

const char* json_type(Type::Plain plain) {
  switch (plain) {
  case Type::Plain::truth:
    return "boolean";
  case Type::Plain::integer:
    return "integer";
  case Type::Plain::number:
    return "number";
  case Type::Plain::text:
    break;
  }
  return "string";
}

} // namespace

Type::Type(Plain plain) : schema_(Tree{{"type", json_type(plain)}}) {}

Type::Type(Tree schema) : schema_(std::move(schema)) {}

namespace type {

Type object(const std::vector<Member>& members) {
  Tree properties = Tree::object();
  Tree required = Tree::array();
  for (const Member& member : members) {
    properties[member.name] = member.of.schema();
    if (member.presence == Presence::always) required.push_back(member.name);
  }
  return Type(Tree{{"type", "object"},
                   {"properties", std::move(properties)},
                   {"required", std::move(required)},
                   {"additionalProperties", false}});
}

Type table(const Type& value) {
  return Type(Tree{{"type", "object"}, {"additionalProperties", value.schema()}});
}

Type list(const Type& item) {
  return Type(Tree{{"type", "array"}, {"items", item.schema()}});
}

Type list(const Type& item, int length) {
  return Type(Tree{{"type", "array"}, {"items", item.schema()}, {"minItems", length}, {"maxItems", length}});
}

Type tuple(const std::vector<Type>& items) {
  Tree schemas = Tree::array();
  for (const Type& item : items) schemas.push_back(item.schema());
  return Type(Tree{{"type", "array"},
                   {"prefixItems", std::move(schemas)},
                   {"minItems", items.size()},
                   {"maxItems", items.size()}});
}

Type one_of(const std::vector<std::string>& words) {
  return Type(Tree{{"type", "string"}, {"enum", Tree(words)}});
}

Type or_null(const Type& some) {
  return either(some, Type(Tree{{"type", "null"}}));
}

Type either(const Type& one, const Type& other) {
  if (one.schema().dump() == other.schema().dump()) return one;
  Tree both = Tree::array();
  both.push_back(one.schema());
  both.push_back(other.schema());
  return Type(Tree{{"anyOf", std::move(both)}});
}

} // namespace type
} // namespace tetrarch::workshop
