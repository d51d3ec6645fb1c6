// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The blocks of data that VTK's XML files hold, packed one by one.

#include "tetrarch/core/error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::format {

enum class Packing : std::uint8_t { none, zlib, lz4, lzma };

/// By the name of VTK's class, vtkZLibDataCompressor and so on; none for another.
std::optional<Packing> packing_named(std::string_view compressor);

/// The `size` bytes that a block was packed from. Throws InputError at `place` if it is damaged; a block that
/// unpacks to another size is an error too, or is returned as it is.
std::string unpack(Packing packing, std::string_view packed, std::size_t size, const Place& place);

} // namespace tetrarch::format
