// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Data that zlib or gzip packed.

#include "tetrarch/core/error.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// The beginning of every gzip file.
inline constexpr std::string_view gzip_mark = "\x1f\x8b";

/// The unpacked data of a zlib or gzip stream; what follows the stream is ignored. Throws InputError at
/// `place` if the stream is damaged or ends too early, or if there would be more than `limit` bytes.
std::string inflate(std::string_view packed, std::size_t limit, const Place& place);

} // namespace tetrarch::format
