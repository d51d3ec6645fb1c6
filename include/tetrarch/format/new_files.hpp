// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Several files that belong together: all of them are written, or none.

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

} // namespace tetrarch::format
