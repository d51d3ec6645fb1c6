// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Circle bundles for tests: on the longest cut graphs, and what their homology must be.

#include "bundle/disks.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/bundle/cut.hpp"
#include "tetrarch/bundle/proof.hpp"
#include "tetrarch/bundle/twist.hpp"

#include <string>
#include <tuple>
#include <vector>

namespace tetrarch::support {

/// Marks all edges that a spanning tree of the triangles does not cross, each a curve of its own.
inline void mark_tree_cut(surface::MarkedSurface& cut) {
  const surface::Surface& s = cut.surface;
  std::vector<char> crossed(static_cast<std::size_t>(s.side_count()), 0);
  std::vector<char> seen(static_cast<std::size_t>(s.triangle_count()), 0);
  std::vector<int> stack{0};
  seen[0] = 1;
  while (!stack.empty()) {
    const int t = stack.back();
    stack.pop_back();
    for (const surface::Side a : surface::sides_of(t)) {
      if (s.is_boundary(a) || seen[s.mate(a).triangle()]) continue;
      seen[s.mate(a).triangle()] = 1;
      crossed[a.value] = crossed[s.mate(a).value] = 1;
      stack.push_back(s.mate(a).triangle());
    }
  }
  int curve = 0;
  for (int k = 0; k < s.side_count(); ++k) {
    const surface::Side a(k);
    if (!crossed[k] && !s.is_boundary(a) && k < s.mate(a).value) surface::set_mark(cut, a, ++curve);
  }
}

inline bundle::CircleBundle bundle_on_tree_cut(surface::Surface surface, int e, int fiber) {
  surface::MarkedSurface cut(std::move(surface));
  mark_tree_cut(cut);
  bundle::orient_parts(cut);
  const int total = e * fiber;
  bundle::split_cut_edges(cut, std::abs(total));
  if (static_cast<int>(bundle::cut_edges(cut).size()) == std::abs(total)) bundle::give_inner_vertices(cut);
  const std::vector<int> twist = bundle::spread_twist(cut, total);
  bundle::Values values = bundle::values_of(cut, twist);
  return bundle::assemble({cut.surface, fiber, bundle::shifts_of(cut, twist, 0), std::move(values.value)});
}

/// D^2 x S^1.
inline bundle::CircleBundle trivial_bundle(const bundle::Disk& disk, const bundle::CuttingPattern& pattern,
                                           int fiber) {
  std::vector<std::int8_t> value(static_cast<std::size_t>(disk.side_count()));
  for (int k = 0; k < disk.side_count(); ++k) value[k] = static_cast<std::int8_t>(pattern[bundle::Side(k)]);
  return bundle::assemble({disk, fiber, std::vector<bundle::Shift>(value.size()), std::move(value)});
}

/// H1 of the circle bundle of Euler number e over a closed surface, of orientable total space. By hand: the
/// group is < a_i, h | relator = h^e, h central > of which H1 = Z^2g + Z/|e|; over k crosscaps a_i h a_i^-1 =
/// h^-1 and the relator is a_1^2 ... a_k^2, so 2h = 0 and 2 (a_1 + ... + a_k) = e h.
inline std::string expected_homology(const SurfaceType& type, int e) {
  std::string text;
  const int rank = type.orientable ? 2 * type.genus() + (e == 0 ? 1 : 0) : type.genus() - 1;
  if (rank > 0) text = rank == 1 ? "Z" : "Z^" + std::to_string(rank);
  std::string torsion;
  if (type.orientable && std::abs(e) > 1) torsion = "Z/" + std::to_string(std::abs(e));
  if (!type.orientable) torsion = e % 2 == 0 ? "Z/2 + Z/2" : "Z/4";
  if (text.empty() && torsion.empty()) return "0";
  return text.empty() ? torsion : torsion.empty() ? text : text + " + " + torsion;
}

/// Bundles with fibres of one edge, small enough for Regina to name.
struct SmallBundle {
  std::string name;
  surface::Surface surface;
  int euler;
};
inline std::vector<SmallBundle> small_bundles() {
  std::vector<SmallBundle> out;
  const auto add = [&](const std::string& name, const surface::Surface& surface,
                       const std::vector<int>& eulers) {
    for (const int e : eulers) out.push_back({name + ", e = " + std::to_string(e), surface, e});
  };
  add("sphere", tetrahedron_surface().surface(), {0, 1, 2, 3});
  add("torus", glued_polygon(canonical_word(1)), {0, 1, 2});
  add("genus 2", glued_polygon(canonical_word(2)), {-2, 0, 1});
  add("genus 3", glued_polygon(canonical_word(3)), {-4});
  add("projective plane", projective_plane().surface(), {1, 2, 3});
  add("Klein bottle", glued_polygon({1, 1, 2, 2}), {0, 1});
  add("three crosscaps", glued_polygon({1, 1, 2, 2, 3, 3}), {-1});
  return out;
}

} // namespace tetrarch::support
