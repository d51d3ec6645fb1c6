// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/cusped.hpp"

#include "tables.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tetrarch::catalogue {
namespace {

/// The word at the beginning of the text, which is taken away with the blank after it.
std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

/// A line: the name, the signature, and the isometry signature where it is another one.
Cusped read_line(std::string_view line) {
  const std::string_view name = take_word(line);
  const std::string_view signature = take_word(line);
  return {name, signature, line.empty() ? signature : line};
}

std::vector<Cusped> read_cusped(std::string_view text) {
  std::vector<Cusped> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const std::string_view line = text.substr(0, end); !line.empty() && !line.starts_with('#'))
      all.push_back(read_line(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

/// Read at the first call, which other threads wait for; half a millisecond.
const std::vector<Cusped>& census() {
  static const std::vector<Cusped> all = read_cusped(detail::embedded_cusped());
  return all;
}

/// Where each manifold stands in the census by one of its texts; of two that share it, the first.
using Index = std::unordered_map<std::string_view, std::size_t>;

Index index_by(std::string_view Cusped::*member) {
  Index index;
  index.reserve(census().size());
  for (std::size_t k = 0; k < census().size(); ++k) index.emplace(census()[k].*member, k);
  return index;
}

std::optional<Cusped> find(std::string_view text, const Index& index) {
  const auto found = index.find(text);
  return found == index.end() ? std::nullopt : std::optional(census()[found->second]);
}

} // namespace

std::optional<Cusped> find_cusped(std::string_view name) {
  static const Index by_name = index_by(&Cusped::name);
  return find(name, by_name);
}

std::optional<Cusped> find_cusped_by_isometry_signature(std::string_view signature) {
  static const Index by_isometry_signature = index_by(&Cusped::isometry_signature);
  return find(signature, by_isometry_signature);
}

int cusped_count() {
  return static_cast<int>(census().size());
}

Cusped cusped_at(int index) {
  if (index < 0 || index >= cusped_count())
    throw PreconditionError("the cusped census has " + std::to_string(cusped_count()) +
                            " manifolds, no number " + std::to_string(index));
  return census()[static_cast<std::size_t>(index)];
}

} // namespace tetrarch::catalogue
