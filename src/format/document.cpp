// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/document.hpp"

#include "tetrarch/format/text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tetrarch::format {
namespace {

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  return at;
}

/// JSON's grammar: -? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?
bool has_decimal_shape(std::string_view text) {
  std::size_t at = text.substr(0, 1) == "-" ? 1 : 0;
  const std::size_t whole = at;
  at = skip_digits(text, at);
  if (at == whole || (text[whole] == '0' && at > whole + 1)) return false;
  if (at < text.size() && text[at] == '.') {
    const std::size_t fraction = at + 1;
    at = skip_digits(text, fraction);
    if (at == fraction) return false;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t exponent = at;
    at = skip_digits(text, at);
    if (at == exponent) return false;
  }
  return at == text.size();
}

} // namespace

bool is_decimal(std::string_view text) {
  return has_decimal_shape(text) && parse_double(text).has_value();
}

// Adding zero turns -0 into 0: as JSON, "-0" would come back as the integer 0.
Number::Number(double value) : value_(value + 0.0), text_(to_text(value + 0.0)) {
  if (!std::isfinite(value)) throw PreconditionError("a number in a document must be finite, not " + text_);
}

Number::Number(std::string digits) : text_(std::move(digits)), is_text_(true) {
  if (!is_decimal(text_)) throw PreconditionError(in_quotes(text_) + " is no decimal number");
  value_ = *parse_double(text_);
}

std::string clean_line(std::string_view text) {
  // nlohmann's writer is the one UTF-8 checker in the house; what it writes, it reads.
  const Json any = std::string(text);
  std::string line = Json::parse(any.dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return std::string(trimmed(line));
}

Document document_of(Triangulation triangulation, std::string name) {
  Document document;
  document.triangulation = std::move(triangulation);
  document.name = std::move(name);
  return document;
}

} // namespace tetrarch::format
