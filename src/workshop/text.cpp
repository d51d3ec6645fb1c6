// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/text.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace tetrarch::workshop {
namespace {

std::string formatted(double x, std::chars_format format, int decimals) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, format, decimals);
  return {buffer.data(), end.ptr};
}

} // namespace

std::string block(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.first.size());
  std::string text;
  for (const auto& [name, value] : rows)
    text.append(printable(name)).append(width - name.size() + 2, ' ').append(printable(value)).append("\n");
  return text;
}

std::string fixed(double x, int decimals) {
  const std::string text = formatted(x, std::chars_format::fixed, decimals);
  // No "-0.000".
  return text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-') ? text.substr(1) : text;
}
std::string scientific(double x, int decimals) {
  return formatted(x, std::chars_format::scientific, decimals);
}

std::string rounded(double x) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), x, std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

std::string in_bytes(double bytes) {
  constexpr std::array<std::pair<double, const char*>, 4> units{
      {{1e9, " GB"}, {1e6, " MB"}, {1e3, " kB"}, {1, " bytes"}}};
  const auto* const unit =
      std::find_if(units.begin(), units.end() - 1, [bytes](const auto& u) { return bytes >= u.first; });
  const double number = bytes / unit->first;
  return fixed(number, unit->first > 1 && number < 10 ? 1 : 0) + unit->second;
}

std::string joined(const std::vector<std::string>& items, const std::string& separator) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k) text += (k > 0 ? separator : "") + items[k];
  return text;
}

std::string counted(long long n, const std::string& noun) {
  std::string text = std::to_string(n) + " " + noun;
  if (n == 1) return text;
  if (noun.ends_with("hedron")) return text.replace(text.size() - 2, 2, "a");
  if (noun.ends_with("vertex")) return text.replace(text.size() - 2, 2, "ices");
  return text + "s";
}

} // namespace tetrarch::workshop
