// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Slit maps to look at: the domain as a surface and as a drawing, and the surface in space with the domain
/// as its texture.
///
///       surface in space               domain in the unit square
///      .-----------------.      vt      .-------.       concentric: ((x + 1) / 2, (y + 1) / 2)
///      |   .-.     .-.   |     ---->    | .--.  |       cylindric and parallel: (angle / 2 pi,
///      |   '-'     '-'   |              | '--'  |                                height / modulus)
///      '-----------------'              '-------'
///
/// A vertex on the seam of the rectangle has two places there, one of them a little outside of the square
/// perhaps, as triangles lie whole; pictures that repeat show nothing of it. Every loop has its colour.
/// Everything here is O(n).

#include "tetrarch/scene/drawing.hpp"
#include "tetrarch/scene/scene.hpp"
#include "tetrarch/slit/slit_map.hpp"

#include <cstdint>
#include <string>

namespace tetrarch::scene {

enum class SlitDomain : std::uint8_t { cylindric, parallel, concentric };

/// The domain as a surface in space, its loops as tubes: the ring in the plane z = 0, the cylinder about the
/// z axis, the rectangle in the plane z = 0. Vertices keep their numbers; on the rectangle the second places
/// of those on the seam follow.
Scene slit_domain(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain);

/// The surface itself with its texture coordinates, its loops as tubes. Vertices keep their numbers; doubles
/// of those on the seam follow.
Scene textured_surface(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain);

/// The surface as OBJ with texture coordinates for each corner: its vertices and triangles are all there in
/// their order and no others, so that texture coordinates alone are doubled on the seam.
std::string textured_obj(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain);

/// The triangulation thin, loops thick and coloured. The cylinder is shown unrolled.
Drawing slit_drawing(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain);

} // namespace tetrarch::scene
