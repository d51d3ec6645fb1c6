// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Self-contained pages to look at and turn around: a viewer (tools/viewer, bundled at build time) together
/// with its content.
///
///     TexturePage   a surface beside its image in a domain, both with the same pattern:
///
///                       .-----------.   .-----------.
///                      / # # #  # # |   | # # # # # |    a chessboard, say, in texture coordinates; where
///                     |  # # (#) # /    | # #(#)# # |    the map is conformal its squares stay squares,
///                      \_# # #__#_/     | # # # # # |    of whatever size
///                        surface           domain
///
///                   or the boundary of a solid beside that of its domain, with fibers, a field, and patches

#include "tetrarch/scene/scene.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::scene {

/// Rows of strings below a heading; column names may be absent.
struct InfoTable {
  std::string heading;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Of each scene the first surface is shown, which must have texture coordinates, and the tubes as lines of
/// the colors of their polylines; data `loop` distinguishes them, or else their number; those with data
/// `fiber` are not distinguished. A domain all of whose points have the same z is looked at from above. Where
/// a surface has a field at points, the first can be shown with level lines; where it has data `patch`, each
/// patch in the color of its first triangle, as floor, ceiling, wall 0, ...
struct TexturePage {
  std::string title;
  std::vector<InfoTable> tables;
  Scene surface;
  Scene domain;
  std::string lines = "Loops"; ///< what the tubes are
  /// How long a unit of v is to one of u, for patterns; if absent, as in the domain.
  std::optional<double> v_by_u{};
};

/// What the page's script reads, as JSON: version 1 of "tetrarch texture". Each scene is moved and scaled
/// into the unit ball, and has the triangles, texture coordinates, field and patches only where they differ
/// from the surface's. O(size). Throws PreconditionError for scenes that break their rules (scene.hpp), or
/// have no surface with textures.
std::string page_data(const TexturePage& page);

/// The whole page: the viewer with the page's data in it.
std::string write_page(const TexturePage& page);

/// The bundled viewers (tools/viewer), with TETRARCH_SCENE where the data go.
std::string_view viewer_page();
std::string_view texture_viewer_page();

} // namespace tetrarch::scene
