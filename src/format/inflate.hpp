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

/// The unpacked data of a zlib stream, or of all members of a gzip file, one after the other (as `cat a.gz
/// b.gz` makes them). Zeros after the last one are padding; `left` says how many bytes follow that are
/// neither. Throws InputError at `place` if a stream is damaged or ends too early, or if there would be more
/// than `limit` bytes.
struct Inflated {
  std::string data;
  std::size_t left = 0;
};
Inflated inflate(std::string_view packed, std::size_t limit, const Place& place);

/// So many bytes may a file of this size unpack to: 200 times as many, but at least 16 MiB. Text packs to a
/// tenth, of triangulations with much repetition to a fiftieth; what packs better was made to fill memory.
std::size_t most_inflated(std::size_t packed);

} // namespace tetrarch::format
