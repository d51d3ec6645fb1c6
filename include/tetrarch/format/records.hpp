// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A file of records that is only ever added to, and survives whatever stops the program.
///
///     Records records(folder + "/records", "census of 4 tetrahedra", Records::Open::resume);
///     if (const std::string* text = records.find("4.17")) use(*text);
///     else records.add("4.17", result);
///
/// A line is a record: its checksum, its key, its text. A record that is torn or altered is as if it had not
/// been written. One process at a time may write.

#include <memory>
#include <string>

namespace tetrarch::format {

class Records {
public:
  enum class Open {
    fresh,  ///< there must be no such file, or an empty one; it is made
    resume, ///< what is there is kept, and added to; the file is made if there is none
    read,   ///< nothing is written
  };

  /// Reads what is there, dropping a torn end. Throws InputError if the file cannot be opened, is in use by
  /// another process, is no file of records, has another heading, or holds records where `fresh` was asked
  /// for.
  Records(const std::string& path, const std::string& heading, Open how);
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;
  ~Records();

  /// The text of that key; null if there is none. The last one counts. O(log records).
  const std::string* find(const std::string& key) const;
  /// Number of keys.
  int size() const;
  /// Records that were passed over, because they were torn or altered.
  int damaged() const;

  /// Writes one and waits until the disk has it. Texts and keys have no line feed, keys no blank. Any thread.
  /// Throws InputError if it cannot be written; then the file is as before.
  void add(const std::string& key, const std::string& text);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace tetrarch::format
