// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/surface.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <numeric>

namespace tetrarch {
namespace {

/// +1 if corner map c keeps the cyclic order of the corners, -1 if it reverses it.
int turning(const std::array<int, 3>& c) {
  return (c[1] - c[0] + 3) % 3 == 1 ? 1 : -1;
}

/// Flood fill: numbers the components and decides which are orientable.
SurfaceComponents flood(const TriangulatedSurface& surface) {
  SurfaceComponents out{std::vector<int>(static_cast<std::size_t>(surface.size()), -1), {}};
  std::vector<int> sign(out.of.size(), 0);
  std::vector<int> stack;
  for (int root = 0; root < surface.size(); ++root) {
    if (out.of[root] >= 0) continue;
    const int c = static_cast<int>(out.type.size());
    SurfaceType type{0, 0, true};
    out.of[root] = c;
    sign[root] = 1;
    stack.push_back(root);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int s = 0; s < 3; ++s) {
        const auto& side = surface.side(t, s);
        if (side.triangle < 0) continue;
        const int wanted = -turning(side.corner) * sign[t];
        if (out.of[side.triangle] < 0) {
          out.of[side.triangle] = c;
          sign[side.triangle] = wanted;
          stack.push_back(side.triangle);
        } else if (sign[side.triangle] != wanted) {
          type.orientable = false;
        }
      }
    }
    out.type.push_back(type);
  }
  return out;
}

} // namespace

std::string SurfaceType::str() const {
  const int g = genus();
  std::string text;
  if (orientable) {
    if (boundary_curves == 1 && g == 0) return "disk";
    text = g == 0 ? "sphere" : g == 1 ? "torus" : "genus " + std::to_string(g);
  } else {
    text = g == 1 ? "projective plane" : g == 2 ? "Klein bottle" : std::to_string(g) + " crosscaps";
  }
  if (boundary_curves == 1) text += ", 1 hole";
  if (boundary_curves > 1) text += ", " + std::to_string(boundary_curves) + " holes";
  return text;
}

void TriangulatedSurface::glue(int triangle, int s, int other, const std::array<int, 3>& corner) {
  std::array<int, 3> inverse{};
  for (int c = 0; c < 3; ++c) inverse[corner[c]] = c;
  sides_[static_cast<std::size_t>(triangle)][s] = {other, corner};
  sides_[static_cast<std::size_t>(other)][corner[s]] = {triangle, inverse};
}

SurfaceComponents classify(const TriangulatedSurface& surface) {
  SurfaceComponents out = flood(surface);
  // Vertices are classes of corners; boundary curves are classes of corners joined along boundary sides too.
  std::vector<int> vertex(3 * out.of.size());
  std::iota(vertex.begin(), vertex.end(), 0);
  std::vector<char> on_boundary(vertex.size(), 0);
  for (int t = 0; t < surface.size(); ++t) {
    SurfaceType& type = out.type[out.of[t]];
    type.euler += 2; // twice: one face, minus half of each glued side, minus each boundary side
    for (int s = 0; s < 3; ++s) {
      const auto& side = surface.side(t, s);
      type.euler -= side.triangle < 0 ? 2 : 1;
      for (const int c : {(s + 1) % 3, (s + 2) % 3})
        if (side.triangle >= 0)
          vertex[numeric::find_root(vertex, 3 * t + c)] =
              numeric::find_root(vertex, 3 * side.triangle + side.corner[c]);
    }
  }
  for (int t = 0; t < surface.size(); ++t)
    for (int c = 0; c < 3; ++c)
      if (vertex[3 * t + c] == 3 * t + c) out.type[out.of[t]].euler += 2;
  for (SurfaceType& type : out.type) type.euler /= 2;
  for (int t = 0; t < surface.size(); ++t) {
    for (int s = 0; s < 3; ++s) {
      if (surface.side(t, s).triangle >= 0) continue;
      const int a = numeric::find_root(vertex, 3 * t + (s + 1) % 3);
      const int b = numeric::find_root(vertex, 3 * t + (s + 2) % 3);
      vertex[a] = b;
      on_boundary[a] = on_boundary[b] = 1;
    }
  }
  for (int t = 0; t < surface.size(); ++t)
    for (int c = 0; c < 3; ++c)
      if (vertex[3 * t + c] == 3 * t + c && on_boundary[3 * t + c]) ++out.type[out.of[t]].boundary_curves;
  return out;
}

} // namespace tetrarch
