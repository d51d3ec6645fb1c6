// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `product` writes.

#include "command.hpp"

#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/workshop/product.hpp"

#include <string>

namespace tetrarch::program {

/// What is to be told with it.
struct ProductTitle {
  std::string input;
  std::string floor_map;
};

/// The hexahedra, or the tetrahedra with the coordinates of their vertices in the domain.
format::MeshDocument product_document(const workshop::SolidProduct& found, const ProductTitle& title);

/// The text of a file, its format from its extension; of those with pictures, the domain's instead of the
/// solid's if `in_domain`.
std::string product_file(const std::string& path, const workshop::SolidProduct& found,
                         const ProductTitle& title, bool in_domain);

} // namespace tetrarch::program
