// SPDX-License-Identifier: GPL-2.0-or-later
#include "embedding.hpp"

#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/workshop/dehn_fillings.hpp"

#include <algorithm>
#include <limits>

namespace tetrarch::program {
namespace {

/// Finds the structure as `hyperbolize` does, and takes the triangulation that carries it.
void find_structure(Embedding& e, const std::string& input, const Context& context) {
  hyperbolic::SearchOptions how;
  how.seed = context.seed;
  hyperbolic::Search found = hyperbolic::find_structure(e.tri, how, context.progress);
  if (found.structure.outcome != hyperbolic::Outcome::geometric)
    throw InputError({input, 0}, "there is no structure to embed: " +
                                     describe(found.structure, Skeleton(found.triangulation)) + " (" +
                                     describe(found) + ")");
  if (found.filled_spheres > 0)
    e.warnings.push_back(counted(found.filled_spheres, "boundary sphere") +
                         " filled with balls: this is another manifold than the given one");
  if (found.changed)
    e.warnings.push_back("the structure was found on another triangulation, of " +
                         counted(found.triangulation.size(), "tetrahedron") + ": " +
                         signature(found.triangulation));
  e.tri = std::move(found.triangulation);
  e.skeleton = Skeleton(e.tri);
  e.structure = std::move(found.structure);
}

std::string in_gigabytes(double bytes) {
  return fixed(bytes / 1e9, bytes < 1e10 ? 1 : 0) + " GB";
}

} // namespace

Embedding embedded(const std::string& input, double cusp_area, const Context& context) {
  if (!(cusp_area > 0)) throw InputError("--cusp-area " + fixed(cusp_area, 3) + ": expected a positive area");
  format::Document document = read_triangulation(input, context);
  require_manifold(document.triangulation, input);
  workshop::require_filled(document, input);
  Embedding e{std::move(document.triangulation), Skeleton(Triangulation()), std::move(document.name), {}, {},
              std::move(document.warnings)};
  if (e.name.empty()) e.name = input;
  find_structure(e, input, context);
  e.domain = embed::fundamental_domain(e.tri, e.skeleton, e.structure, {cusp_area}, context.progress);
  return e;
}

void require_memory(const std::string& what, double bytes, double gigabytes) {
  if (!(gigabytes > 0)) throw InputError("--memory: expected a positive number of gigabytes");
  if (bytes > 1e9 * gigabytes)
    throw InputError(what + ": about " + in_gigabytes(bytes) + " would be needed, and " +
                     in_gigabytes(1e9 * gigabytes) + " are allowed (--memory)");
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
                   in_gigabytes(1e9 * gigabytes) + " allowed (--memory)");
}

} // namespace tetrarch::program
