// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangulated surfaces, and the topological type of a surface.
///
/// Triangle t has corners 0,1,2 and side s opposite corner s. Two sides are glued by a map of corners that
/// takes side to side. Vertex links and boundary components are given in this form.

#include <array>
#include <string>
#include <vector>

namespace tetrarch {

/// The topological type of a connected compact surface.
struct SurfaceType {
  int euler = 2;
  int boundary_curves = 0;
  bool orientable = true;

  /// Number of handles (orientable) or crosscaps (non-orientable) of the surface with its boundary filled in.
  int genus() const { return orientable ? (2 - euler - boundary_curves) / 2 : 2 - euler - boundary_curves; }
  bool is_sphere() const { return euler == 2; }
  bool is_disk() const { return euler == 1 && boundary_curves == 1; }
  bool is_closed() const { return boundary_curves == 0; }
  /// For instance "sphere", "disk", "torus", "genus 2", "projective plane", "Klein bottle", "3 crosscaps, 1
  /// hole".
  std::string str() const;
  friend bool operator==(const SurfaceType&, const SurfaceType&) = default;
};

/// Triangles, glued along their sides.
class TriangulatedSurface {
public:
  struct Side {
    int triangle = -1;           ///< the neighbor, -1 on the boundary
    std::array<int, 3> corner{}; ///< corner c of this triangle is corner[c] of the neighbor
  };

  explicit TriangulatedSurface(int triangles = 0) : sides_(static_cast<std::size_t>(triangles)) {}
  int size() const { return static_cast<int>(sides_.size()); }
  const Side& side(int triangle, int s) const { return sides_[static_cast<std::size_t>(triangle)][s]; }
  /// Glues side s of `triangle` to side corner[s] of `other`, from both sides; the caller keeps it
  /// consistent.
  void glue(int triangle, int s, int other, const std::array<int, 3>& corner);

private:
  std::vector<std::array<Side, 3>> sides_;
};

/// The components of a surface: `of[t]` is numbered by first triangle, `type[c]` is the component's type.
/// O(n).
struct SurfaceComponents {
  std::vector<int> of;
  std::vector<SurfaceType> type;
};
SurfaceComponents classify(const TriangulatedSurface& surface);

} // namespace tetrarch
