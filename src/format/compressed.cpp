// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/compressed.hpp"

#include "tetrarch/core/error.hpp"

#include <array>
#include <cstdint>
#include <lzma.h>
#include <memory>
#include <new>
#include <string_view>

namespace tetrarch::format {
namespace {

constexpr std::string_view first_bytes("\xFD"
                                       "7zXZ\0",
                                       6);

struct End {
  void operator()(lzma_stream* stream) const { ::lzma_end(stream); }
};

} // namespace

std::string unpacked(std::string bytes, const std::string& source, std::size_t limit) {
  if (!bytes.starts_with(first_bytes)) return bytes;
  constexpr std::uint64_t most_memory = std::uint64_t{1}
                                        << 28U; // the highest preset's dictionary takes 65 MiB
  lzma_stream stream{};
  const std::unique_ptr<lzma_stream, End> ending(&stream);
  if (::lzma_stream_decoder(&stream, most_memory, LZMA_CONCATENATED) != LZMA_OK) throw std::bad_alloc();
  // liblzma works on bytes of its own type. NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast)
  stream.next_in = reinterpret_cast<const std::uint8_t*>(bytes.data());
  stream.avail_in = bytes.size();
  std::string text;
  std::array<char, std::size_t{1} << 16U> part{};
  lzma_ret code = LZMA_OK;
  while (code == LZMA_OK) {
    stream.next_out = reinterpret_cast<std::uint8_t*>(part.data());
    stream.avail_out = part.size();
    code = ::lzma_code(&stream, LZMA_FINISH);
    text.append(part.data(), part.size() - stream.avail_out);
    if (text.size() > limit)
      throw InputError({source, 0}, "unpacks to more than " + std::to_string(limit) + " bytes");
  }
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  if (code != LZMA_STREAM_END) throw InputError({source, 0}, "this xz file is damaged, or it ends too early");
  return text;
}

std::string packed(std::string_view bytes) {
  std::string result(::lzma_stream_buffer_bound(bytes.size()), '\0');
  std::size_t size = 0;
  // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast)
  const lzma_ret code = ::lzma_easy_buffer_encode(
      LZMA_PRESET_DEFAULT, LZMA_CHECK_CRC64, nullptr, reinterpret_cast<const std::uint8_t*>(bytes.data()),
      bytes.size(), reinterpret_cast<std::uint8_t*>(result.data()), &size, result.size());
  // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
  if (code != LZMA_OK) throw std::bad_alloc();
  result.resize(size);
  return result;
}

} // namespace tetrarch::format
