// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Results that say what `info` says, and more: their members and their list.

#include "tetrarch/workshop/info.hpp"

namespace tetrarch::workshop {

/// The fields of `info`, and those of the result's own list.
template <class Result>
Tree tree_with_info(const Result& result) {
  Tree tree = tree_of(result.info);
  for (const Field<Result>& field : fields_of<Result>())
    if (field.present == nullptr || field.present(result)) tree[field.name] = field.value(result);
  return tree;
}

template <class Result>
std::vector<FieldNote> notes_with_info() {
  std::vector<FieldNote> notes = notes_of<Info>();
  notes.insert(notes.end(), fields_of<Result>().begin(), fields_of<Result>().end());
  return notes;
}

} // namespace tetrarch::workshop
