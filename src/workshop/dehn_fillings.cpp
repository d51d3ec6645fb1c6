// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/dehn_fillings.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/snappea.hpp"
#include "tetrarch/moves/dehn_filling.hpp"
#include "tetrarch/moves/truncate.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::workshop {
namespace {

bool is_filling(const format::Ledger::Entry& entry) {
  return entry.what.starts_with(format::dehn_filling);
}

bool has_filling(const format::Ledger& ledger) {
  return std::any_of(ledger.entries().begin(), ledger.entries().end(), is_filling);
}

/// The ledger without the fillings that were carried out.
format::Ledger still_passed_over(const format::Ledger& before, const std::vector<std::string>& carried_out) {
  format::Ledger after;
  for (const auto& entry : before.entries())
    if (std::none_of(carried_out.begin(), carried_out.end(),
                     [&](const std::string& name) { return entry.what.starts_with(name); }))
      after.note(entry.what, entry.count);
  return after;
}

} // namespace

format::Document with_fillings(format::Document document, std::string_view text, const std::string& source,
                               const Progress& progress) {
  if (!has_filling(document.passed_over) || !text.starts_with(format::snappea_header)) return document;
  const format::DehnFillings fillings = format::read_dehn_fillings(text, source);
  if (fillings.named.empty()) return document;
  const std::string name = joined(fillings.named, ", ");
  if (const auto why = moves::why_not_fill(document.triangulation, fillings.curves))
    throw InputError({source, 0}, name + " cannot be carried out: " + *why);
  document.triangulation =
      moves::truncate(moves::filled(document.triangulation, fillings.curves), {}, progress).tri;
  document.passed_over = still_passed_over(document.passed_over, fillings.named);
  document.warnings.push_back(name + ": carried out, which makes " +
                              counted(document.triangulation.size(), "tetrahedron"));
  return document;
}

void require_filled(const format::Document& document, const std::string& source) {
  for (const auto& entry : document.passed_over.entries())
    if (is_filling(entry))
      throw InputError({source, 0},
                       entry.what.substr(0, entry.what.find(", which")) +
                           " is not carried out (expected a SnapPea file with peripheral curves, "
                           "and coprime integers as slope)");
}

} // namespace tetrarch::workshop
