// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/fields.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace tetrarch::workshop {
namespace {

auto with_name(std::vector<FieldNote>& notes, std::string_view name) {
  return std::find_if(notes.begin(), notes.end(),
                      [name](const FieldNote& note) { return std::string_view(note.name) == name; });
}

/// What `other` may be without is no longer always there.
void weaken(std::vector<FieldNote>& notes, std::vector<FieldNote> other) {
  for (FieldNote& note : notes) {
    const auto there = with_name(other, note.name);
    note.always = note.always && there != other.end() && there->always;
  }
}

} // namespace

std::vector<FieldNote> each_once(const std::vector<FieldNote>& notes) {
  std::vector<FieldNote> kept;
  for (const FieldNote& note : notes) {
    const auto there = with_name(kept, note.name);
    if (there == kept.end())
      kept.push_back(note);
    else {
      there->type = type::either(there->type, note.type);
      there->always = there->always || note.always;
    }
  }
  return kept;
}

std::vector<FieldNote> both_of(std::vector<FieldNote> notes, const std::vector<FieldNote>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

std::vector<FieldNote> sometimes(std::vector<FieldNote> notes) {
  for (FieldNote& note : notes) note.always = false;
  return notes;
}

std::vector<FieldNote> either_of(std::vector<FieldNote> one, std::vector<FieldNote> other) {
  const std::vector<FieldNote> given = one;
  weaken(one, other);
  weaken(other, given);
  return each_once(both_of(std::move(one), other));
}

Tree schema_of(const std::vector<FieldNote>& notes) {
  std::vector<type::Member> members;
  for (const FieldNote& note : notes) {
    Tree schema{{"description", note.meaning}};
    if (*note.unit != '\0') schema["unit"] = note.unit;
    schema.update(note.type.schema());
    members.push_back(
        {note.name, Type(std::move(schema)), note.always ? type::Presence::always : type::sometimes});
  }
  return type::object(members).schema();
}

} // namespace tetrarch::workshop
