// SPDX-License-Identifier: GPL-2.0-or-later
#include "unpack.hpp"

#include "inflate.hpp"

#include "tetrarch/format/text.hpp"

#include <limits>
#include <lz4.h>
#include <lzma.h>

namespace tetrarch::format {
namespace {

[[noreturn]] void refuse_damaged(const char* form, const Place& place) {
  throw InputError(place, std::string("the data compressed by ") + form + " are damaged");
}

/// LZ4 and xz pack zeros to less than a two-hundredth; nothing that is no hostile file packs better.
constexpr std::size_t most_ratio = 20000;

std::string unpack_lz4(std::string_view packed, std::size_t size, const Place& place) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (packed.size() > most || size > most || size / most_ratio > packed.size()) refuse_damaged("LZ4", place);
  std::string out(size, '\0');
  const int done = ::LZ4_decompress_safe(packed.data(), out.data(), static_cast<int>(packed.size()),
                                         static_cast<int>(size));
  if (done < 0) refuse_damaged("LZ4", place);
  out.resize(static_cast<std::size_t>(done));
  return out;
}

std::string unpack_lzma(std::string_view packed, std::size_t size, const Place& place) {
  if (size / most_ratio > packed.size()) refuse_damaged("LZMA", place);
  std::string out(size, '\0');
  std::uint64_t memory = std::uint64_t{1} << 28; // the highest preset's dictionary takes 65 MiB
  std::size_t read = 0;
  std::size_t written = 0;
  // liblzma works on bytes of its own type. NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast)
  const lzma_ret result = ::lzma_stream_buffer_decode(
      &memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read, packed.size(),
      reinterpret_cast<std::uint8_t*>(out.data()), &written, size);
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  if (result != LZMA_OK) refuse_damaged("LZMA", place);
  out.resize(written);
  return out;
}

} // namespace

std::optional<Packing> packing_named(std::string_view compressor) {
  if (compressor == "vtkZLibDataCompressor") return Packing::zlib;
  if (compressor == "vtkLZ4DataCompressor") return Packing::lz4;
  if (compressor == "vtkLZMADataCompressor") return Packing::lzma;
  return std::nullopt;
}

std::string unpack(Packing packing, std::string_view packed, std::size_t size, const Place& place) {
  switch (packing) {
  case Packing::none:
    return std::string(packed);
  case Packing::zlib:
    return inflate(packed, longest_file, place).data;
  case Packing::lz4:
    return unpack_lz4(packed, size, place);
  case Packing::lzma:
    return unpack_lzma(packed, size, place);
  }
  throw PreconditionError("no such packing");
}

} // namespace tetrarch::format
