// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Several files that belong together: all of them are written, or none; and files that grow.

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tetrarch::format {

struct NewFile {
  std::string path;
  std::string_view content; ///< must outlive the call that writes it
};

/// Writes every file beside its path, and when all are there renames one after the other into place. On any
/// failure each path is as it was, nothing is left beside it, and an InputError names the path and the
/// reason; only a loss of power between two renames can leave some of them new. Symbolic links are followed;
/// what is no regular file (a device, a pipe) is written to directly, before the first is renamed, and cannot
/// be taken back. Linear in the bytes.
void write_files_atomically(std::span<const NewFile> files);

/// A file too long to be held in memory: written beside its path piece by piece, then renamed into place.
///
///     GrowingFile file("gluings.txt");
///     while (...) file.add(line);
///     file.keep();
///
/// Without `keep` the path stays as it was. What is no regular file is written to directly.
class GrowingFile {
public:
  /// Throws InputError as `write_files_atomically` does; so do the others.
  explicit GrowingFile(std::string path);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();
  void add(std::string_view content);
  void keep();

private:
  struct State;
  std::string path_;
  std::unique_ptr<State> state_;
};

} // namespace tetrarch::format
