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
  return both_of(notes_of<Info>(), notes_of(fields_of<Result>()));
}

/// Of a presentation as they say it.
inline Type group_type() {
  return type::object({{"generators", type::list(type::text)}, {"relators", type::list(type::text)}});
}

} // namespace tetrarch::workshop
