// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a result holds, listed once.
///
/// A result is a struct of values. What it says to the outside is a list of fields: name, unit, meaning, and
/// how it is read off the struct. JSON, the description of JSON, Python's attributes and their docstrings are
/// made of this list, so that none of them can say what another does not.
///
///     const FieldList<Structure>& fields = fields_of<Structure>();
///     Tree tree = tree_of(structure);          {"outcome": "geometric", "volume": 6.45..., ...}

#include "tetrarch/workshop/tree.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::workshop {

/// What a field is called and what it means.
struct FieldNote {
  const char* name;    ///< the member in JSON, the attribute in Python
  const char* unit;    ///< empty: a pure number, or no number
  const char* meaning; ///< a phrase; null and its reason where that may happen
};

/// A field of a result.
template <class Result>
struct Field : FieldNote {
  Tree (*value)(const Result&);
  /// False: this result does not have it. Null: each has it.
  bool (*present)(const Result&) = nullptr;
};

template <class Result>
using FieldList = std::vector<Field<Result>>;

/// The fields of a type of result, in the order of its JSON. Specialised beside each result.
template <class Result>
const FieldList<Result>& fields_of();

/// The members that a result has.
template <class Result>
Tree tree_of(const Result& result) {
  Tree tree = Tree::object();
  for (const Field<Result>& field : fields_of<Result>())
    if (field.present == nullptr || field.present(result)) tree[field.name] = field.value(result);
  return tree;
}

/// The notes alone.
template <class Result>
std::vector<FieldNote> notes_of() {
  const FieldList<Result>& fields = fields_of<Result>();
  return {fields.begin(), fields.end()};
}

/// Those of several lists, each name once: the first to have it says what it means.
std::vector<FieldNote> each_once(const std::vector<FieldNote>& notes);

/// Lines "name   value" for people.
using Rows = std::vector<std::pair<std::string, std::string>>;

} // namespace tetrarch::workshop
