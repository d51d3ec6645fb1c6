// SPDX-License-Identifier: GPL-2.0-or-later
#include "inflate.hpp"

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

} // namespace

std::string inflate(std::string_view packed, std::size_t limit, const Place& place) {
  Stream stream(place);
  z_stream& state = stream.state();
  std::string out;
  constexpr std::size_t chunk = std::size_t{1} << 18;
  int result = Z_OK;
  while (result != Z_STREAM_END) {
    if (state.avail_in == 0) {
      const std::size_t size = std::min<std::size_t>(packed.size(), std::numeric_limits<uInt>::max());
      state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())); // zlib only reads it
      state.avail_in = static_cast<uInt>(size);
      packed.remove_prefix(size);
    }
    const std::size_t done = out.size();
    out.resize(done + chunk);
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
  return out;
}

} // namespace tetrarch::format
