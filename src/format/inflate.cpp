// SPDX-License-Identifier: GPL-2.0-or-later
#include "inflate.hpp"

#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <limits>
#include <zlib.h>

namespace tetrarch::format {
namespace {

/// A zlib stream that ends with its owner.
class Stream {
public:
  explicit Stream(const Place& place) {
    // 32 lets zlib tell gzip from zlib by the header.
    if (::inflateInit2(&state_, MAX_WBITS + 32) != Z_OK)
      throw InputError(place, "compressed data cannot be read: there is no memory left");
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { ::inflateEnd(&state_); }
  z_stream& state() { return state_; }

private:
  z_stream state_{};
};

/// Unpacks one stream to the end of `out` and takes it away from `packed`.
void inflate_one(std::string_view& packed, std::string& out, std::size_t limit, const Place& place) {
  Stream stream(place);
  z_stream& state = stream.state();
  constexpr std::size_t chunk = std::size_t{1} << 18;
  int result = Z_OK;
  while (result != Z_STREAM_END) {
    if (state.avail_in == 0) {
      const std::size_t size = std::min<std::size_t>(packed.size(), std::numeric_limits<uInt>::max());
      // zlib only reads these. NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
      state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
      state.avail_in = static_cast<uInt>(size);
      packed.remove_prefix(size);
    }
    const std::size_t done = out.size();
    out.resize(done + chunk);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
    state.next_out = reinterpret_cast<Bytef*>(out.data() + done);
    state.avail_out = chunk;
    result = ::inflate(&state, Z_NO_FLUSH);
    out.resize(done + chunk - state.avail_out);
    if (out.size() > limit)
      throw InputError(place, "the compressed data hold more than " + std::to_string(limit) + " bytes");
    const bool starved = result == Z_BUF_ERROR || (state.avail_in == 0 && packed.empty());
    if (result != Z_STREAM_END && (starved || result != Z_OK))
      throw InputError(place,
                       starved ? "the compressed data end too early" : "the compressed data are damaged");
  }
  packed = {packed.data() - state.avail_in, packed.size() + state.avail_in};
}

} // namespace

Inflated inflate(std::string_view packed, std::size_t limit, const Place& place) {
  Inflated out;
  const bool has_members = packed.starts_with(gzip_mark);
  inflate_one(packed, out.data, limit, place);
  while (has_members && packed.starts_with(gzip_mark)) inflate_one(packed, out.data, limit, place);
  out.left = packed.find_first_not_of('\0') == std::string_view::npos ? 0 : packed.size();
  return out;
}

std::size_t most_inflated(std::size_t packed) {
  constexpr std::size_t least = std::size_t{1} << 24;
  constexpr std::size_t best_ratio = 200;
  return std::clamp(packed, least / best_ratio, longest_file / best_ratio) * best_ratio;
}

} // namespace tetrarch::format
