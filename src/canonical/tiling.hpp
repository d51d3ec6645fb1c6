// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The tiling of hyperbolic space by the translates of a triangulation's tetrahedra, one tile at a time.
///
/// Vectors are rows of four coordinates in the basis of one tile's vertex vectors, the frame. The tile across
/// face f shares three vertices; its fourth is the combination that `look_across` gives. A functional is the
/// row of its values on the frame's vertices.

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/canonical/hull.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace tetrarch::canonical {

template <class Scalar>
using Vector4 = std::array<Scalar, 4>;

template <class Scalar>
Scalar dot(const Vector4<Scalar>& x, const Vector4<Scalar>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3];
}

/// Two vectors of one orbit are equal or far apart: rounding never gets near this.
template <class Scalar>
bool same_vector(const Vector4<Scalar>& x, const Vector4<Scalar>& y) {
  constexpr double tolerance = 1e-6;
  for (int i = 0; i < 4; ++i) {
    const auto a = static_cast<double>(x[i]);
    const auto b = static_cast<double>(y[i]);
    if (!(std::abs(a - b) <= tolerance * (1 + std::abs(a)))) return false;
  }
  return true;
}

/// A translate of tetrahedron `tet`: the coordinates of its vertex vectors in the frame.
template <class Scalar>
struct Tile {
  int tet = -1;
  std::array<Vector4<Scalar>, 4> vertex;
};

/// What the oracle looks at, in the frame.
template <class Scalar>
struct Sighting {
  Vector4<Scalar> vector;
  Scalar value; ///< phi(vector)
};

template <class Scalar>
class Tiling {
public:
  explicit Tiling(const Decorated<Scalar>& m);

  const Decorated<Scalar>& decorated() const { return m_; }
  /// <phi, psi>: the inner product of the poles of two functionals on the vertices of `tet`.
  Scalar product(int tet, const Vector4<Scalar>& phi, const Vector4<Scalar>& psi) const;
  /// The frame itself, as a tile.
  Tile<Scalar> frame(int tet) const;
  Tile<Scalar> across(const Tile<Scalar>& tile, int face) const;
  /// The matrix that takes coordinates in the frame to coordinates in the tile's basis.
  static numeric::Matrix4<Scalar> into_basis(const Tile<Scalar>& tile);

  /// Shows vectors to `visit`, each once, until it returns true or the budget is spent: those of tiles near
  /// the pole of phi come first. Returns whether it was stopped by `visit`.
  bool explore(int frame_tet, const Vector4<Scalar>& phi, const HullBudget& budget,
               const std::function<bool(const Sighting<Scalar>&)>& visit) const;

  /// A place: coordinates of a vector in the basis of a tile that contains it.
  struct Place {
    Tile<Scalar> tile;
    Vector4<Scalar> coordinates;
  };
  /// All tiles that contain a timelike vector: one, or several where it lies on their boundary within
  /// `margin`. Empty if the walk there does not end.
  std::vector<Place> locate(int frame_tet, const Vector4<Scalar>& vector, double margin) const;

private:
  double reach(int frame_tet, const Vector4<Scalar>& phi, double area) const;
  Scalar least_on_face(const Tile<Scalar>& tile, int face, const Vector4<Scalar>& values) const;
  Tile<Scalar> tile_at_pole(int frame_tet, const Vector4<Scalar>& phi) const;
  Vector4<Scalar> coordinates_across(int tet, int face, const Vector4<Scalar>& c) const;

  const Decorated<Scalar>& m_;
  std::vector<std::array<Across<Scalar>, 4>> across_;
  std::vector<numeric::Matrix4<Scalar>> inverse_; ///< of the Gram matrices
  bool some_hyperideal_ = false;
};

} // namespace tetrarch::canonical
