// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `product` writes.

#include "command.hpp"
#include "report.hpp"

#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/product/hexahedra.hpp"
#include "tetrarch/product/product.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::program {

/// A solid with all that is told of it.
struct SolidProduct {
  product::SplitSolid at;
  std::vector<product::Point> uvw;
  std::vector<std::vector<product::Point>> fibers;   ///< in space
  std::vector<std::vector<product::Point>> straight; ///< the same in the domain
  std::optional<product::SolidHexahedra> hexahedra;
  std::vector<double> scaled_jacobian;
  int cells = 0; ///< of the grid: hexahedra in a layer
  Report report;
  Status status = Status::done;
  std::vector<std::string> doubts; ///< why the result is undecided, one clause each
};

/// What is to be told with it.
struct ProductTitle {
  std::string input;
  std::string floor_map;
};

/// The hexahedra, or the tetrahedra with the coordinates of their vertices in the domain.
format::MeshDocument product_document(const SolidProduct& made, const ProductTitle& title);

/// The text of a file, its format from its extension; of those with pictures, the domain's instead of the
/// solid's if `in_domain`.
std::string product_file(const std::string& path, const SolidProduct& made, const ProductTitle& title,
                         bool in_domain);

} // namespace tetrarch::program
