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
#include <functional>
#include <map>
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

  /// Adds to the entry of that name, or begins it. Nothing happens where `count` is 0. O(log
  /// of the number of entries).
  void note(std::string_view what, std::int64_t count = 1);
  /// The entries of the other one are added to these.
  void add(const Ledger& other);

  bool empty() const { return entries_.empty(); }
  /// In the order in which they were first noted.
  const std::vector<Entry>& entries() const { return entries_; }
  /// "passed over: text packet (3), script packet"; empty if there is nothing to say. No more than fifty
  /// entries are named.
  std::string sentence(std::string_view beginning = "passed over") const;
  friend bool operator==(const Ledger&, const Ledger&) = default;

private:
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t, std::less<>> places_; ///< in entries_
};

} // namespace tetrarch::format
