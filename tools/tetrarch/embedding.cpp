// SPDX-License-Identifier: GPL-2.0-or-later
#include "embedding.hpp"

#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"

#include <algorithm>
#include <limits>

namespace tetrarch::program {
PlacedInput placed(const std::string& input, double cusp_area, const Context& context) {
  if (!(cusp_area > 0)) throw InputError("--cusp-area " + fixed(cusp_area, 3) + ": expected a positive area");
  format::Document document = read_triangulation(input, context);
  require_manifold(document.triangulation, input);
  workshop::require_filled(document, input);
  const std::string name = document.name.empty() ? input : document.name;
  PlacedInput found{
      workshop::placement(document.triangulation, {name, context.seed, cusp_area}, context.progress),
      std::move(document.warnings)};
  if (const std::string why = found.placement.why_not(); !why.empty())
    throw InputError({input, 0}, "there is no structure to embed: " + why);
  return found;
}

void require_memory(const std::string& what, double bytes, double gigabytes) {
  if (!(gigabytes > 0)) throw InputError("--memory: expected a positive number of gigabytes");
  if (bytes > 1e9 * gigabytes)
    throw InputError(what + ": about " + in_bytes(bytes) + " would be needed, and " +
                     in_bytes(1e9 * gigabytes) + " are allowed (--memory)");
}

embed::PieceBounds allowed_bounds(const embed::PieceBounds& wanted, double gigabytes) {
  // Not piece_bytes of all: that number of bytes need not be one of 64 bits.
  const double bytes = static_cast<double>(embed::piece_bytes(1)) * static_cast<double>(wanted.copies);
  require_memory("--copies " + std::to_string(wanted.copies), bytes, gigabytes);
  const double most = std::min(1e9 * gigabytes / static_cast<double>(embed::piece_bytes(1)),
                               double{std::numeric_limits<int>::max()});
  embed::PieceBounds bounds = wanted;
  if (bounds.copies == 0) bounds.copies = std::max<std::int64_t>(1, static_cast<std::int64_t>(most));
  return bounds;
}

void require_complete(const embed::Piece& piece, const embed::PieceBounds& wanted, double gigabytes) {
  if (wanted.copies > 0 || piece.complete) return;
  throw InputError(std::string(wanted.radius > 0 ? "--radius" : "--word-length") + ": more than " +
                   std::to_string(piece.copies.size()) + " copies, which do not fit into the " +
                   in_bytes(1e9 * gigabytes) + " allowed (--memory)");
}

} // namespace tetrarch::program
