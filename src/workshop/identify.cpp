// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/identify.hpp"

#include "tetrarch/core/signature.hpp"
#include "tetrarch/workshop/text.hpp"

namespace tetrarch::workshop {

using identify::Identification;

namespace {

Tree or_null(const std::string& text) {
  return text.empty() ? Tree() : Tree(text);
}

} // namespace

Verdict verdict_of(const Identification& found) {
  return found ? Verdict::yes : Verdict::undecided;
}

Rows rows_of(const Identification& found) {
  Rows rows{{"name", found ? found.name : "none found"}};
  if (found) rows.emplace_back("by", to_string(found.by));
  if (found.volume) rows.emplace_back("volume", fixed(*found.volume, 12));
  for (std::size_t k = 0; k < found.tried.size(); ++k)
    rows.emplace_back(k == 0 ? "tried" : "", found.tried[k]);
  return rows;
}

template <>
const FieldList<Identification>& fields_of<Identification>() {
  using I = const Identification&;
  static const FieldList<Identification> fields{
      {{"name", "", "the name; null: none found", type::or_null(type::text)},
       [](I i) { return or_null(i.name); }},
      {{"by", "", "what the name rests on: isometry signature, triangulation, or group",
        type::or_null(type::one_of({"isometry signature", "triangulation", "group"}))},
       [](I i) { return i ? Tree(to_string(i.by)) : Tree(); }},
      {{"volume", "curvature -1", "the volume; null without a structure", type::or_null(type::number)},
       [](I i) { return i.volume ? Tree(*i.volume) : Tree(); }},
      {{"isometry_signature", "", "of the canonical cells; null without a structure",
        type::or_null(type::text)},
       [](I i) { return or_null(i.isometry_signature); }},
      {{"signature", "", "isomorphism signature of the triangulation that carries the structure", type::text},
       [](I i) -> Tree { return signature(i.triangulation); }},
      {{"confirmed_only", "", "whether the cells rest on numbers that are zero to 60 digits, without proof",
        type::truth},
       [](I i) -> Tree { return i.confirmed_only; }},
      {{"tried", "", "a sentence for each step", type::list(type::text)},
       [](I i) -> Tree { return i.tried; }}};
  return fields;
}

} // namespace tetrarch::workshop
