// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/ledger.hpp"

#include <algorithm>
#include <functional>

namespace tetrarch::format {

std::size_t& Ledger::place_of(std::string_view what) {
  std::size_t at = std::hash<std::string_view>()(what) % places_.size();
  while (places_[at] != 0 && entries_[places_[at] - 1].what != what) at = (at + 1) % places_.size();
  return places_[at];
}

void Ledger::make_room() {
  constexpr std::size_t least = 16;
  places_.assign(std::max(least, 4 * entries_.size()), 0);
  for (std::size_t k = 0; k < entries_.size(); ++k) place_of(entries_[k].what) = k + 1;
}

void Ledger::note(std::string_view what, std::int64_t count) {
  if (count == 0) return;
  if (2 * entries_.size() >= places_.size()) make_room();
  std::size_t& place = place_of(what);
  if (place == 0) {
    entries_.push_back({std::string(what), 0});
    place = entries_.size();
  }
  entries_[place - 1].count += count;
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
