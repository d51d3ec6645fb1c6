// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One self-contained page to look at and turn around: the viewer (tools/viewer, bundled when the program was
/// built) with the bodies in it, in R^{3,1}. The page bends them into whatever model is chosen.

#include "tetrarch/scene/body.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetrarch::scene {

/// Rows of strings below a heading; column names may be absent.
struct InfoTable {
  std::string heading;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct Page {
  std::string title;
  std::vector<InfoTable> tables;
  std::vector<Body> bodies; ///< the first is shown first
};

/// What the page's script reads, as JSON: version 1 of "tetrarch view". Points are 32-bit floats in base 64.
/// O(size); patches and arcs are cut to a chord error of 1/400 in the first copy, in the half space and the
/// ball alike.
std::string page_data(const Page& page);

/// The page, or nothing where the viewer is missing: see `viewer_missing_reason`.
std::string write_page(const Page& page);

/// The bundled viewer; empty where the program was built without it, and then why, as a sentence.
std::string_view viewer_page();
std::string_view viewer_missing_reason();

} // namespace tetrarch::scene
