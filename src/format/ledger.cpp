// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/ledger.hpp"

#include <algorithm>

namespace tetrarch::format {

void Ledger::note(std::string_view what, std::int64_t count) {
  if (count == 0) return;
  const auto known =
      std::find_if(entries_.begin(), entries_.end(), [what](const Entry& e) { return e.what == what; });
  if (known == entries_.end())
    entries_.push_back({std::string(what), count});
  else
    known->count += count;
}

void Ledger::add(const Ledger& other) {
  for (const Entry& entry : other.entries_) note(entry.what, entry.count);
}

std::string Ledger::sentence(std::string_view beginning) const {
  std::string text;
  for (const Entry& entry : entries_) {
    text += text.empty() ? std::string(beginning) + ": " : ", ";
    text += entry.what;
    if (entry.count != 1) text += " (" + std::to_string(entry.count) + ")";
  }
  return text;
}

} // namespace tetrarch::format
