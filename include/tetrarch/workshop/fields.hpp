// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a result holds, listed once.
///
/// A result is a struct of values. What it says to the outside is a list of fields: name, unit, meaning,
/// type, and how it is read off the struct. JSON, its schema, the manual pages, Python's attributes, their
/// types and their docstrings are made of this list, so that none of them can say what another does not.
///
///     const FieldList<Structure>& fields = fields_of<Structure>();
///     Tree tree = tree_of(structure);          {"outcome": "geometric", "volume": 6.45..., ...}

#include "tetrarch/workshop/tree.hpp"
#include "tetrarch/workshop/type.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::workshop {

/// What a field is called and what it means.
struct FieldNote {
  const char* name;    ///< the member in JSON, the attribute in Python
  const char* unit;    ///< empty: a pure number, or no number
  const char* meaning; ///< a phrase; null and its reason where that may happen
  Type type;
  /// False: some results do not have it. Of a `Field` this follows from `present`; see `notes_of`.
  bool always = true;
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
std::vector<FieldNote> notes_of(const FieldList<Result>& fields) {
  std::vector<FieldNote> notes(fields.begin(), fields.end());
  for (std::size_t k = 0; k < fields.size(); ++k) notes[k].always = fields[k].present == nullptr;
  return notes;
}
template <class Result>
std::vector<FieldNote> notes_of() {
  return notes_of(fields_of<Result>());
}

/// Those of several lists, each name once: the first to have it says what it means, and its type is either.
std::vector<FieldNote> each_once(const std::vector<FieldNote>& notes);
/// Those of one list, then those of the other.
std::vector<FieldNote> both_of(std::vector<FieldNote> notes, const std::vector<FieldNote>& more);
/// Those of a part that a result may be without.
std::vector<FieldNote> sometimes(std::vector<FieldNote> notes);
/// Those of results of two kinds: what one of them may be without is not always there.
std::vector<FieldNote> either_of(std::vector<FieldNote> one, std::vector<FieldNote> other);

/// The part of a JSON Schema that an object with these members and no others satisfies, with the meaning and
/// the unit of each.
Tree schema_of(const std::vector<FieldNote>& notes);

/// Lines "name   value" for people.
using Rows = std::vector<std::pair<std::string, std::string>>;

} // namespace tetrarch::workshop
