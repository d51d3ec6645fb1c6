// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/identify/recognise.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/algebra/torsion.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace tetrarch::identify {
namespace {

using algebra::Integer;

/// A vector of the plane that covers the torus; its lattice are the classes of H_1.
struct Vector {
  Integer x;
  Integer y;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
  friend bool operator==(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y; }
};

Integer determinant(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

/// A tetrahedron of the chain, flattened: its vertices in the plane are the corners of a unit parallelogram.
/// The faces below are glued to what came before; those above, opposite vertices upper[0] and upper[1], lead
/// on.
struct Flattened {
  int tet = -1;
  std::array<Vector, 4> at;
  std::array<int, 2> upper{};
};

/// A face of the parallelogram is glued to the other one by p. This is a fold: it keeps one of the three
/// edges and exchanges the other two, f and g, so that f - g bounds a disk. (Even maps would be half turns or
/// sixth turns, of which the third power is one: some edge would meet itself backwards, which is no
/// manifold.)
Vector folded_slope(const Flattened& flat, int face, Perm4 p) {
  Vector slope;
  for (const auto& [i, j] : edge_vertex) {
    if (i == face || j == face) continue;
    const Vector change = (flat.at[j] - flat.at[i]) - (flat.at[p[j]] - flat.at[p[i]]);
    if (change != Vector{0, 0}) slope = change;
  }
  return slope;
}

struct Chain {
  Flattened last;
  Vector meridian; ///< the slope that the first fold kills
};

/// The start of a chain: face a of the tetrahedron is glued to face b, and this closes it up to a solid
/// torus. (The transposition of a and b would keep the edge that the two faces share: a ball.)
std::optional<Chain> start_of_chain(const Triangulation& tri, TetFace below) {
  const Gluing g = tri.gluing(below);
  const int a = below.face;
  if (g.tet != below.tet || g.perm.sign() > 0 || g.perm[g.perm[a]] == a) return std::nullopt;
  const int b = g.perm[a];
  Chain chain;
  Flattened& flat = chain.last;
  flat.tet = below.tet;
  for (int v = 0, k = 0; v < 4; ++v)
    if (v != a && v != b) flat.upper[k++] = v;
  flat.at[flat.upper[0]] = {0, 0};
  flat.at[a] = {1, 0};
  flat.at[b] = {0, 1};
  flat.at[flat.upper[1]] = {1, 1};
  chain.meridian = folded_slope(flat, a, g.perm);
  return chain;
}

/// The tetrahedron that lies on both upper faces, or nothing if these do not lead to one, or not side by
/// side.
std::optional<Flattened> layered_on(const Triangulation& tri, const Flattened& flat) {
  const Gluing first = tri.gluing({flat.tet, flat.upper[0]});
  const Gluing second = tri.gluing({flat.tet, flat.upper[1]});
  if (first.tet != second.tet || first.tet < 0 || first.tet == flat.tet) return std::nullopt;
  Flattened next;
  next.tet = first.tet;
  const int a = first.perm[flat.upper[0]];
  const int b = second.perm[flat.upper[1]];
  for (int v = 0; v < 4; ++v)
    if (v != flat.upper[0]) next.at[first.perm[v]] = flat.at[v];
  for (int v = 0, k = 0; v < 4; ++v)
    if (v != a && v != b) next.upper[k++] = v;
  // The second face belongs beside the first, along the edge that they share in the new tetrahedron.
  const auto [c, d] = next.upper;
  const auto old = [&](int v) -> const Vector& { return flat.at[second.perm.preimage(v)]; };
  next.at[a] = old(a) + next.at[c] - old(c);
  // Each triangle has but one edge of that direction, so this makes the two a parallelogram again.
  return old(d) - old(c) == next.at[d] - next.at[c] ? std::optional(next) : std::nullopt;
}

/// x, y with a x + b y = gcd(a, b), up to sign.
std::pair<Integer, Integer> bezout(const Integer& a, const Integer& b) {
  if (b == 0) return {1, 0};
  const Integer quotient = a / b;
  const auto [x, y] = bezout(b, a - quotient * b);
  return {y, x - quotient * y};
}

std::string lens_space_name(const Integer& p, const std::string& q) {
  if (p == 0) return "S^2 x S^1";
  if (p == 1) return "S^3";
  if (p == 2) return "RP^3";
  return "L(" + p.str() + "," + q + ")";
}

/// Two solid tori glued along their boundary, with these meridians in H_1 of the torus: with det(meridian, l)
/// = 1 the second one is q meridian + p l.
std::string lens_space(const Vector& meridian, const Vector& other) {
  const Integer p = abs(determinant(meridian, other));
  if (p < 3) return lens_space_name(p, "1");
  const auto [y, x] = bezout(meridian.x, meridian.y); // meridian.x y + meridian.y x = +-1
  const Vector l{-x, y};
  const Integer q = determinant(other, l) * determinant(meridian, l);
  const auto mod_p = [&](const Integer& k) { return Integer((k % p + p) % p); };
  const Integer inverse = bezout(mod_p(q), p).first;
  return lens_space_name(p, std::min({mod_p(q), mod_p(-q), mod_p(inverse), mod_p(-inverse)}).str());
}

/// Follows the chain of layers that starts below face `below`, of a manifold. It ends when the upper faces
/// are glued to each other, and no tetrahedron can come twice, since each layer uses up all its faces.
std::optional<std::string> layered_lens_space(const Triangulation& tri, TetFace below) {
  std::optional<Chain> chain = start_of_chain(tri, below);
  if (!chain) return std::nullopt;
  while (const auto next = layered_on(tri, chain->last)) chain->last = *next;
  const Flattened& last = chain->last;
  const Gluing g = tri.gluing({last.tet, last.upper[0]});
  if (g.tet != last.tet || g.perm[last.upper[0]] != last.upper[1]) return std::nullopt;
  return lens_space(chain->meridian, folded_slope(last, last.upper[0], g.perm));
}

std::pair<int, std::size_t> size_of(const algebra::Presentation& group) {
  std::size_t letters = 0;
  for (const algebra::Word& w : group.relators) letters += w.size();
  return {group.generators, letters};
}

/// The group with x written as x y in every relator, simplified. This is an automorphism of the free group,
/// so it is the same group. Letters as in algebra/group.hpp.
algebra::Presentation twisted(algebra::Presentation group, int x, int y, const Progress& progress) {
  for (algebra::Word& w : group.relators) {
    algebra::Word out;
    for (const int letter : w) {
      if (letter == -x) out.push_back(-y);
      out.push_back(letter);
      if (letter == x) out.push_back(y);
    }
    w = out;
  }
  return algebra::simplified(group, {}, progress);
}

/// The simplified group, and shorter yet where a Nielsen move helps: < a, b | aabbb, aaaaaBB > is Z/19. Each
/// round but the last one takes off a letter or a generator. A long presentation is left as it is: it will
/// not become visible.
algebra::Presentation visible(algebra::Presentation group, const Progress& progress) {
  constexpr std::pair<int, std::size_t> most{9, 200};
  for (bool shorter = true; shorter && size_of(group) < most;) {
    shorter = false;
    const algebra::Presentation before = group;
    for (int x = -before.generators; x <= before.generators; ++x)
      for (int y = -before.generators; y <= before.generators; ++y) {
        if (x == 0 || y == 0 || std::abs(x) == std::abs(y)) continue;
        const algebra::Presentation changed = twisted(before, x, y, progress);
        if (size_of(changed) >= size_of(group)) continue;
        group = changed;
        shorter = true;
      }
  }
  return group;
}

/// The order of the group < a | relators >, 0 for Z.
Integer cyclic_order(const algebra::Presentation& group) {
  const algebra::AbelianGroup cyclic = algebra::abelianized(group);
  if (cyclic.rank() > 0) return 0;
  return cyclic.is_trivial() ? Integer(1) : cyclic.torsion().front();
}

/// Three generators and three commutators. (Each pair has its own: a simplified presentation has no relator
/// twice.)
bool is_visibly_z3(const algebra::Presentation& group) {
  const auto commutator = [](const algebra::Word& w) {
    return w.size() == 4 && w[0] == -w[2] && w[1] == -w[3];
  };
  return group.generators == 3 && group.relators.size() == 3 &&
         std::all_of(group.relators.begin(), group.relators.end(), commutator);
}

std::string handlebody_name(int genus, bool orientable) {
  if (genus == 0) return "B^3";
  if (genus == 1) return orientable ? "solid torus" : "solid Klein bottle";
  return (orientable ? "" : "non-orientable ") + ("genus " + std::to_string(genus)) + " handlebody";
}

Recognition closed_by_group(const algebra::Presentation& group, bool orientable) {
  if (group.generators == 0)
    return {"S^3", Recognition::By::group, "closed with trivial group (Poincare conjecture)"};
  if (group.generators == 1) {
    const Integer p = cyclic_order(group);
    if (p == 0)
      return {orientable ? "S^2 x S^1" : "S^2 x~ S^1", Recognition::By::group,
              "closed with group Z: a sphere bundle over the circle (Hempel 5.2, Poincare conjecture)"};
    if (p == 1) return {"S^3", Recognition::By::group, "closed with trivial group (Poincare conjecture)"};
    // No other q is prime to these p, up to sign.
    const bool one_q = p <= 6 && p != 5;
    return {lens_space_name(p, one_q ? "1" : "?"), Recognition::By::group,
            "closed with group Z/" + p.str() + ": a lens space (geometrization)" +
                (one_q ? "" : "; the group does not tell which, and the triangulation is not layered")};
  }
  if (orientable && is_visibly_z3(group))
    return {"T^3", Recognition::By::group,
            "closed orientable with group Z^3 (Waldhausen, Poincare conjecture)"};
  return {};
}

/// Every compact manifold with a free group is a connected sum of handlebodies, balls among them, one for
/// each boundary component, and of sphere bundles over the circle; so one boundary component of full genus
/// leaves one handlebody.
Recognition bounded_by_group(const algebra::Presentation& group, bool orientable,
                             const std::vector<BoundaryComponent>& boundary) {
  const int rank = group.generators;
  if (!group.relators.empty() || boundary.size() != 1 || boundary.front().type.euler != 2 - 2 * rank)
    return {};
  return {handlebody_name(rank, orientable), Recognition::By::group,
          "free group of rank " + std::to_string(rank) +
              ", and one boundary component, of Euler characteristic " + std::to_string(2 - 2 * rank) +
              " (Hempel 5.2, Poincare conjecture)"};
}

/// For error messages; a long presentation says nothing to anybody.
std::string shortened(const std::string& text) {
  return text.size() <= 200 ? text : text.substr(0, 200) + " ...";
}

/// By the group as this triangulation presents it; `group` is told what was seen.
Recognition by_group(const Triangulation& tri, algebra::Presentation& group, const Progress& progress) {
  const Skeleton skeleton(tri);
  group = visible(algebra::simplified(algebra::dual_presentation(tri, skeleton).presentation, {}, progress),
                  progress);
  const auto boundary = boundary_components(tri, skeleton);
  return boundary.empty() ? closed_by_group(group, skeleton.is_orientable())
                          : bounded_by_group(group, skeleton.is_orientable(), boundary);
}

/// Whether homology leaves a chance that the group has a name here: free of the rank that one boundary
/// component asks for, or that of a closed manifold with a cyclic or free abelian group.
bool may_be_named(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  const auto boundary = boundary_components(tri, skeleton);
  const algebra::AbelianGroup h1 = algebra::homology(tri, skeleton, 1);
  if (!boundary.empty())
    return boundary.size() == 1 && h1.torsion().empty() && boundary.front().type.euler == 2 - 2 * h1.rank();
  return h1.torsion().empty() ? h1.rank() == 0 || h1.rank() == 1 || h1.rank() == 3
                              : h1.rank() == 0 && h1.torsion().size() == 1;
}

} // namespace

Recognition recognise(const Triangulation& tri, const Progress& progress) {
  const Skeleton skeleton(tri);
  if (tri.size() == 0 || !skeleton.is_connected())
    return {"", Recognition::By::nothing, "empty or not connected"};
  if (const auto defects = check(skeleton); !defects.empty())
    return {"", Recognition::By::nothing, "no manifold: " + describe(defects.front(), skeleton)};
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (const auto name = layered_lens_space(tri, {t, f}))
        return {*name, Recognition::By::triangulation, "a layered lens space"};

  algebra::Presentation group;
  Recognition found = by_group(tri, group, progress);
  const std::string first = shortened(group.str());
  // Other triangulations present the same group otherwise: one in six free groups of handlebodies of genus 2
  // to 5 was not visible at first, and all were after a few changes.
  constexpr int changes = 20;
  constexpr int moves_each = 20;
  if (!found && may_be_named(tri)) {
    SplitMix64 random(1);
    moves::Complex complex(tri);
    for (int k = 0; k < changes && !found; ++k) {
      moves::shake(complex, moves_each, random);
      moves::reduce(complex);
      found = by_group(complex.triangulation(), group, progress);
    }
  }
  if (!found)
    found.because = "no layered lens space, and the group " + first + " with " +
                    std::to_string(boundary_components(tri, skeleton).size()) +
                    " boundary component(s) tells no name";
  return found;
}

} // namespace tetrarch::identify
