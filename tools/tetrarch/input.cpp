// SPDX-License-Identifier: GPL-2.0-or-later
#include "input.hpp"

#include "tetrarch/census/manifold.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"

#include <filesystem>

namespace tetrarch::program {

format::Document read_triangulation(const std::string& argument) {
  std::error_code ignored;
  if (argument == "-" || std::filesystem::exists(argument, ignored))
    return format::read_any(format::read_file(argument), format::source_name(argument));
  if (argument.starts_with("fmp")) {
    if (const auto manifold = census::find_by_name(argument))
      return format::document_of(from_signature(manifold->signature), manifold->name);
    throw InputError("no census manifold is called " + in_quotes(argument) +
                     " (expected fmp2_1 ... fmp2_8 or fmp3_1 ... fmp3_151)");
  }
  if (looks_like_signature(argument)) return format::document_of(from_signature(argument));
  throw InputError(in_quotes(argument) +
                   " is no file, and neither a census name nor an isomorphism signature");
}

} // namespace tetrarch::program
