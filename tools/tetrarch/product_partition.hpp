// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where the partition of a solid's boundary comes from.

#include "command.hpp"

#include "tetrarch/format/soup.hpp"
#include "tetrarch/workshop/product.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

/// Options as typed; all empty: the partition is found without help.
struct PartitionOptions {
  std::string labels; ///< "1,2": of floor and ceiling
  std::string floor;  ///< "v17": a seed
  std::string ceiling;
  double threshold = 0.3;           ///< of flooding from seeds: 1 - cosine
  std::vector<std::string> cycles;  ///< rims, "3,17,20,..." each
  std::vector<std::string> tunnels; ///< core loops of walls, likewise
  double extend = 0;                ///< of tunnels, to both sides
  std::string outer;                ///< "v17": a vertex of the outer wall
};

/// Whether any of them points anything out.
bool is_given(const PartitionOptions& options);

/// `soup` is that of the solid: its triangles may have labels. Throws InputError.
workshop::PartitionedSolid partitioned(product::Solid solid, const format::Soup& soup,
                                       const PartitionOptions& options, const Context& context);

} // namespace tetrarch::program
