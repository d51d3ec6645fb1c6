// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A self-contained page (scene/page.hpp) of bodies in R^{3,1}, which it bends into whatever model is chosen.

#include "tetrarch/scene/page.hpp"
#include "tetrarch/show/body.hpp"

#include <string>
#include <vector>

namespace tetrarch::show {

struct Page {
  std::string title;
  std::vector<scene::InfoTable> tables;
  std::vector<Body> bodies; ///< the first is shown first
};

/// What the page's script reads, as JSON: version 1 of "tetrarch view". Points are 32-bit floats in base 64.
/// O(size); patches and arcs are cut to a chord error of 1/400 in the first copy, in the half space and the
/// ball alike.
std::string page_data(const Page& page);

/// The whole page: the viewer with the page's data in it.
std::string write_page(const Page& page);

} // namespace tetrarch::show
