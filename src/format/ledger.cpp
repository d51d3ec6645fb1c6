// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/ledger.hpp"

namespace tetrarch::format {

void Ledger::note(std::string_view what, std::int64_t count) {
  if (count == 0) return;
  const auto known = places_.find(what);
  if (known != places_.end()) {
    entries_[known->second].count += count;
  } else {
    places_.emplace(what, entries_.size());
    entries_.push_back({std::string(what), count});
  }
}

void Ledger::add(const Ledger& other) {
  for (const Entry& entry : other.entries_) note(entry.what, entry.count);
}

std::string Ledger::sentence(std::string_view beginning) const {
  constexpr std::size_t most_told = 50; // a file of ten thousand arrays is no reason for as many names
  std::string text;
  for (const Entry& entry : entries_) {
    if (&entry == entries_.data() + most_told)
      return text + " and " + std::to_string(entries_.size() - most_told) + " other kinds of things";
    text += text.empty() ? std::string(beginning) + ": " : ", ";
    text += entry.what;
    if (entry.count != 1) text += " (" + std::to_string(entry.count) + ")";
  }
  return text;
}

} // namespace tetrarch::format
