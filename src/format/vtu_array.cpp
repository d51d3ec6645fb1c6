// SPDX-License-Identifier: GPL-2.0-or-later
#include "vtu_array.hpp"

#include "mesh_cursor.hpp"

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace tetrarch::format {
namespace {

[[noreturn]] void refuse_array(const VtuStorage& storage, const pugi::xml_node& array,
                               const std::string& what) {
  const std::string name = array.attribute("Name").value();
  throw InputError(Place{storage.source, 0}, "the array " + in_quotes(name) + " " + what);
}

/// The values of base64's digits by their bytes, and -1.
constexpr std::array<std::int8_t, 256> base64_digits = [] {
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < digits.size(); ++k)
    values[static_cast<unsigned char>(digits[k])] = static_cast<std::int8_t>(k);
  return values;
}();

int base64_digit(char c) {
  return base64_digits[static_cast<unsigned char>(c)];
}

/// Bytes one after the other, from base64 or as they are. Padding within base64 ends a group of bytes, not
/// the data: some writers encode the header by itself.
class ByteSource {
public:
  ByteSource(const VtuStorage& storage, const pugi::xml_node& array)
      : storage_(storage), array_(array), text_(array.text().get()) {
    if (std::string_view(array.attribute("format").value()) != "appended") return;
    const auto offset = parse_integer(array.attribute("offset").value());
    if (!offset || *offset < 0 || static_cast<std::uint64_t>(*offset) > storage.appended.size())
      refuse_array(storage, array, "has no place in the appended data");
    text_ = storage.appended.substr(static_cast<std::size_t>(*offset));
    base64_ = storage.appended_base64;
  }

  std::string take(std::uint64_t size) {
    if (size > text_.size() + buffer_.size()) refuse_array(storage_, array_, "ends too early");
    std::string out;
    if (base64_) {
      buffer_.reserve(size + 3);
      decode_plain_groups(size);
      while (buffer_.size() < size) decode_group();
      const std::string rest = buffer_.substr(size); // a byte or two
      buffer_.resize(size);
      out = std::exchange(buffer_, rest);
    } else {
      out = text_.substr(0, size);
      text_.remove_prefix(size);
    }
    return out;
  }

  std::uint64_t take_header() {
    const std::string raw = take(storage_.wide_header ? 8 : 4);
    return storage_.wide_header ? load<std::uint64_t>(raw.data(), storage_.swapped)
                                : load<std::uint32_t>(raw.data(), storage_.swapped);
  }

private:
  /// Four digits by four, up to the first that is none, or until there are `size` bytes.
  void decode_plain_groups(std::uint64_t size) {
    std::size_t at = 0;
    for (; buffer_.size() < size && at + 4 <= text_.size(); at += 4) {
      const int a = base64_digit(text_[at]);
      const int b = base64_digit(text_[at + 1]);
      const int c = base64_digit(text_[at + 2]);
      const int d = base64_digit(text_[at + 3]);
      if ((a | b | c | d) < 0) break;
      const int bits = a << 18 | b << 12 | c << 6 | d;
      const std::array<char, 3> bytes{static_cast<char>(bits >> 16), static_cast<char>(bits >> 8 & 0xff),
                                      static_cast<char>(bits & 0xff)};
      buffer_.append(bytes.data(), bytes.size());
    }
    text_.remove_prefix(at);
  }

  void decode_group() {
    std::array<int, 4> digits{};
    int padding = 0;
    for (int& digit : digits) {
      while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
      if (text_.empty()) refuse_array(storage_, array_, "ends too early");
      const char c = text_.front();
      text_.remove_prefix(1);
      digit = base64_digit(c);
      if (c == '=' && &digit >= &digits[2]) {
        ++padding;
        digit = 0;
      } else if (digit < 0 || padding > 0) {
        refuse_array(storage_, array_,
                     "has " + in_quotes(std::string_view(&c, 1)) + ", expected base64 data");
      }
    }
    const int bits = digits[0] << 18 | digits[1] << 12 | digits[2] << 6 | digits[3];
    for (int byte = 0; byte < 3 - padding; ++byte)
      buffer_ += static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * byte) & 0xff));
  }

  const VtuStorage& storage_;
  pugi::xml_node array_;
  std::string_view text_;
  std::string buffer_;
  bool base64_ = true;
};

std::string unpacked(const VtuStorage& storage, const pugi::xml_node& array, ByteSource& bytes) {
  const std::uint64_t blocks = bytes.take_header();
  const std::uint64_t size = bytes.take_header();
  const std::uint64_t last = bytes.take_header();
  std::vector<std::uint64_t> packed;
  for (std::uint64_t b = 0; b < blocks; ++b) packed.push_back(bytes.take_header());
  std::string out;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t wanted = b + 1 == blocks && last > 0 ? last : size;
    if (out.size() > longest_file || wanted > longest_file - out.size())
      refuse_array(storage, array, "has a block of another length than announced");
    const std::string block = unpack(storage.packing, bytes.take(packed[b]), wanted, {storage.source, 0});
    if (block.size() != wanted) refuse_array(storage, array, "has a block of another length than announced");
    out += block;
  }
  return out;
}

template <class Stored, class T>
std::vector<T> converted(const VtuStorage& storage, const pugi::xml_node& array, std::string_view raw) {
  std::vector<T> out;
  out.reserve(raw.size() / sizeof(Stored));
  for (std::size_t at = 0; at + sizeof(Stored) <= raw.size(); at += sizeof(Stored)) {
    const Stored value = load<Stored>(raw.data() + at, storage.swapped);
    if constexpr (std::is_integral_v<T> && std::is_integral_v<Stored>)
      if (!std::in_range<T>(value)) refuse_array(storage, array, "holds the number " + std::to_string(value));
    out.push_back(static_cast<T>(value));
  }
  return out;
}

template <class T>
std::vector<T> from_bytes(const VtuStorage& storage, const pugi::xml_node& array) {
  ByteSource bytes(storage, array);
  const std::string raw =
      storage.packing != Packing::none ? unpacked(storage, array, bytes) : bytes.take(bytes.take_header());
  const std::string_view type = array.attribute("type").value();
  if constexpr (std::is_same_v<T, double>) {
    if (type == "Float32") return converted<float, T>(storage, array, raw);
    if (type == "Float64") return converted<double, T>(storage, array, raw);
  } else {
    if (type == "Int8") return converted<std::int8_t, T>(storage, array, raw);
    if (type == "UInt8") return converted<std::uint8_t, T>(storage, array, raw);
    if (type == "Int16") return converted<std::int16_t, T>(storage, array, raw);
    if (type == "UInt16") return converted<std::uint16_t, T>(storage, array, raw);
    if (type == "Int32") return converted<std::int32_t, T>(storage, array, raw);
    if (type == "UInt32") return converted<std::uint32_t, T>(storage, array, raw);
    if (type == "Int64") return converted<std::int64_t, T>(storage, array, raw);
    if (type == "UInt64") return converted<std::uint64_t, T>(storage, array, raw);
  }
  refuse_array(storage, array, "has numbers of type " + in_quotes(type) + ", which do not belong there");
}

template <class T>
std::vector<T> from_text(const VtuStorage& storage, const pugi::xml_node& array) {
  std::vector<T> out;
  MeshCursor in(array.text().get(), storage.source);
  while (!in.at_end()) {
    const std::string_view token = in.token("a number");
    const auto real = lenient_double(token);
    const auto integer = lenient_integer(token);
    const bool fits = std::is_same_v<T, double> ? real.has_value() : integer && std::in_range<int>(*integer);
    if (!fits) refuse_array(storage, array, "has " + in_quotes(token) + ", expected a number");
    if constexpr (std::is_same_v<T, double>) {
      out.push_back(*real);
    } else {
      out.push_back(static_cast<T>(*integer));
    }
  }
  return out;
}

template <class T>
std::vector<T> read_array(const VtuStorage& storage, const pugi::xml_node& array) {
  if (!array)
    throw InputError(Place{storage.source, 0},
                     "an array of points, connectivity, offsets or types is missing");
  const std::string_view format = array.attribute("format").value();
  if (format == "ascii" || format.empty()) return from_text<T>(storage, array);
  if (format != "binary" && format != "appended")
    refuse_array(storage, array,
                 "has the format " + in_quotes(format) + ", expected ascii, binary or appended");
  return from_bytes<T>(storage, array);
}

} // namespace

std::vector<double> read_reals(const VtuStorage& storage, const pugi::xml_node& array) {
  return read_array<double>(storage, array);
}

std::vector<int> read_integers(const VtuStorage& storage, const pugi::xml_node& array) {
  return read_array<int>(storage, array);
}

} // namespace tetrarch::format
