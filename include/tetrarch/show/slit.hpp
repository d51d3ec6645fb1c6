// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Slit maps to look at: the domain as a surface and as a drawing, and the surface in space with the domain
/// as its texture.
///
///       surface in space               domain as a picture
///      .-----------------.      vt      .-------.       concentric and circular: ((x + 1) / 2, (y + 1) / 2)
///      |   .-.     .-.   |     ---->    | .--.  |       cylindric and parallel: (angle / 2 pi,
///      |   '-'     '-'   |              | '--'  |                                height / 2 pi)
///      '-----------------'              '-------'
///
/// Both axes have one scale, so pictures keep their angles on the surface. Where a ring's inner radius is so
/// small that the shift by 1/2 would drown it, there is no shift: (x / 2, y / 2). A vertex on the seam of the
/// rectangle has two places there. One place may lie a little outside the square, because triangles lie
/// whole; repeating pictures hide this. Every loop has its color. Everything here is O(n).

#include "tetrarch/scene/drawing.hpp"
#include "tetrarch/scene/scene.hpp"
#include "tetrarch/slit/circular_map.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::show {

/// A mesh with its boundary loops, laid into the plane. The first places are those of the vertices, by their
/// numbers; then come the second places of those on a seam.
struct Layout {
  std::string name; ///< of the domain
  std::vector<std::array<double, 2>> places;
  /// Of each place: texture_scale * place + texture_shift. The unit square repeats.
  std::vector<std::array<double, 2>> textures;
  double texture_scale = 1;
  double texture_shift = 0;
  std::vector<int> vertex;                 ///< of each place
  std::vector<std::array<int, 3>> corners; ///< of each triangle: places
  /// Of each place where it goes in space, if the plane is to be rolled up; else empty.
  std::vector<scene::Point> rolled;
};

enum class SlitDomain : std::uint8_t { cylindric, parallel, concentric };

Layout layout(const slit::OneForms& forms, const slit::SlitMap& map, SlitDomain domain);
/// One form of the basis: (potential, conjugate), torn along the strips across which the conjugate jumps.
Layout basis_layout(const slit::OneForms& forms, int loop);
/// Vertices in the unit disk.
Layout disk_layout(const surface::TriangleMesh& mesh, const std::vector<std::complex<double>>& position);

/// Vertices anywhere in the plane: the whole is moved to where both axes start at 0, and its texture fits the
/// unit square.
Layout plane_layout(const surface::TriangleMesh& mesh, const std::vector<std::complex<double>>& position,
                    const std::string& name);

/// The domain as a surface in space, its loops as tubes: in the plane z = 0, or about the z axis.
scene::Scene slit_domain(const surface::TriangleMesh& mesh, const Layout& layout);

/// The surface itself with its texture coordinates, its loops as tubes. Vertices keep their numbers; doubles
/// of those on the seam follow.
struct Fields {
  std::vector<scene::Field> triangles;
  std::vector<scene::Field> vertices;
};
scene::Scene textured_surface(const surface::TriangleMesh& mesh, const Layout& layout,
                              const Fields& fields = {});

/// The surface as OBJ with texture coordinates for each corner: exactly its vertices and triangles, in their
/// order, so that the seam doubles texture coordinates only.
std::string textured_obj(const surface::TriangleMesh& mesh, const Layout& layout);

/// The triangulation thin, loops thick and colored.
scene::Drawing slit_drawing(const surface::TriangleMesh& mesh, const Layout& layout);

} // namespace tetrarch::show
