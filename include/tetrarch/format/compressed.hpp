// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// Compressed files may grow to this.
inline constexpr std::size_t longest_unpacked = std::size_t{1} << 30U;

/// `bytes` of a file as they are, or unpacked if they begin as those of xz do. Throws InputError that names
/// `source` if they are damaged, end too early, or unpack to more than `limit` bytes. Linear.
std::string unpacked(std::string bytes, const std::string& source, std::size_t limit = longest_unpacked);

/// The bytes as a file of xz, of its default preset. Throws std::bad_alloc if there is no memory for it (some
/// 100 MB). About 3 MB of text a second.
std::string packed(std::string_view bytes);

} // namespace tetrarch::format
