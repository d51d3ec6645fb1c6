// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a read passed over: everything that stood in the input and is not in the result.
///
///     text packet        3
///     peripheral curve   2
///
/// A reader notes each thing where it leaves it; whoever shows the result says the whole ledger in one line.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

class Ledger {
public:
  struct Entry {
    std::string what; ///< a noun in the singular: "text packet"
    std::int64_t count = 0;
    friend bool operator==(const Entry&, const Entry&) = default;
  };

  /// Adds to the entry of that name, or begins it. Nothing happens where `count` is 0. O(1) in the mean.
  void note(std::string_view what, std::int64_t count = 1);
  /// The entries of the other one are added to these.
  void add(const Ledger& other);

  bool empty() const { return entries_.empty(); }
  /// In the order in which they were first noted.
  const std::vector<Entry>& entries() const { return entries_; }
  /// "passed over: text packet (3), script packet"; empty if there is nothing to say. No more than fifty
  /// entries are named.
  std::string sentence(std::string_view beginning = "passed over") const;
  friend bool operator==(const Ledger& a, const Ledger& b) { return a.entries_ == b.entries_; }

private:
  /// Where `places_` has that name, or room for it.
  std::size_t& place_of(std::string_view what);
  void make_room();

  std::vector<Entry> entries_;
  std::vector<std::size_t> places_; ///< by hash, half empty at least: the number of an entry, from 1; 0: none
};

} // namespace tetrarch::format
