// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The zoo: named triangulations with known invariants.
///
/// Signatures and figures of the first list are Regina 7.3's answers (`witness` names the ready-made example
/// or the file of its distribution); those that are famous are famous for the same figures: H1 of L(p,q) is
/// Z/p, the Poincare sphere is a homology sphere, H1 of the Weber-Seifert space is (Z/5)^3 (Seifert and
/// Weber, 1933). The knotted Y is typed from the dissertation.

#include "support/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/surface.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace tetrarch::support {

struct ZooEntry {
  /// So many vertices have a link of this type.
  struct Links {
    int count;
    SurfaceType type;
  };
  std::string name;
  std::string signature;
  std::string witness;
  int vertices;
  int edges;
  bool orientable;
  int betti;                ///< H1 = Z^betti + the sum of Z/torsion[i], each of which divides the next
  std::vector<int> torsion; ///< all of them > 1
  std::vector<Links> links;
  int automorphisms; ///< of the triangulation, the identity counted

  Triangulation triangulation() const { return from_signature(signature); }
};

inline const std::vector<ZooEntry>& zoo() {
  const SurfaceType sphere{2, 0, true};
  const SurfaceType disk{1, 1, true};
  const SurfaceType torus{0, 0, true};
  const SurfaceType klein_bottle{0, 0, false};
  const SurfaceType genus_two{-2, 0, true};
  // clang-format off
  static const std::vector<ZooEntry> entries{
      // name, signature, witness, vertices, edges, orientable, betti, torsion, links, automorphisms
      {"B^3, one tetrahedron", "baa", "Example3.ball", 4, 6, true, 0, {}, {{4, disk}}, 24},
      {"S^3, one tetrahedron", "bkaagj", "Example3.threeSphere", 1, 2, true, 0, {}, {{1, sphere}}, 2},
      {"S^3, boundary of a 4-simplex", "fvPQccdedeegovcfb",
       "Example3.simplicialSphere", 5, 10, true, 0, {}, {{5, sphere}}, 120},
      {"S^3, Bing's house", "cMcabbgdv", "Example3.bingsHouse", 1, 3, true, 0, {}, {{1, sphere}}, 4},
      {"RP^3", "cMcabbgqw", "Example3.lens(2, 1)", 1, 3, true, 0, {2}, {{1, sphere}}, 2},
      {"L(3,1)", "cMcabbjak", "Example3.lens(3, 1)", 1, 3, true, 0, {3}, {{1, sphere}}, 4},
      {"L(4,1)", "bkaajj", "Example3.lens(4, 1)", 1, 2, true, 0, {4}, {{1, sphere}}, 4},
      {"L(5,2)", "bkaajn", "Example3.lens(5, 2)", 1, 2, true, 0, {5}, {{1, sphere}}, 4},
      {"L(7,2)", "cMcabbjqw", "Example3.lens(7, 2)", 1, 3, true, 0, {7}, {{1, sphere}}, 2},
      {"L(8,3)", "cMcabbjqs", "Example3.lens(8, 3)", 1, 3, true, 0, {8}, {{1, sphere}}, 4},
      {"RP^3 # RP^3", "eLMkabcddbrrag", "Example3.rp3rp3", 1, 5, true, 0, {2, 2}, {{1, sphere}}, 4},
      {"S^2 x S^1", "cMcabbjaj", "Example3.s2xs1", 1, 3, true, 1, {}, {{1, sphere}}, 4},
      {"S^2 x~ S^1", "cPcbbbajs", "Example3.twistedSphereBundle", 1, 3, false, 1, {}, {{1, sphere}}, 4},
      {"RP^2 x S^1", "dLQbcccajqs", "Example3.rp2xs1", 1, 4, false, 1, {2}, {{1, sphere}}, 4},
      {"Poincare sphere", "fvPQcdecedekrsnrs", "Example3.poincare", 1, 6, true, 0, {}, {{1, sphere}}, 60},
      {"S^3 / Q_8", "cPcbbbqxh",
       "Example3.layeredLoop(2, True)", 1, 3, true, 0, {2, 2}, {{1, sphere}}, 24},
      {"Weeks manifold", "jLvAMPQadfgghhiiijaqgjqxims",
       "Example3.weeks", 1, 10, true, 0, {5, 5}, {{1, sphere}}, 1},
      {"Weber-Seifert space", "xvLvvvwMvQPPQQQQcehpjtqksntrtvoupwpsuwsvwcgacalvucahatbhapaggjgfk",
       "Example3.weberSeifert", 1, 24, true, 0, {5, 5, 5}, {{1, sphere}}, 6},
      {"Gieseking manifold m000", "bkaaid",
       "Example3.gieseking", 1, 1, false, 1, {}, {{1, klein_bottle}}, 2},
      {"figure-eight complement m004", "cPcbbbiht",
       "Example3.figureEight", 1, 2, true, 1, {}, {{1, torus}}, 8},
      {"trefoil complement", "cPcbbbadu", "Example3.trefoil", 1, 2, true, 1, {}, {{1, torus}}, 4},
      {"Whitehead link complement m129", "eLPkbdcddhgggb",
       "Example3.whiteheadLink", 2, 4, true, 2, {}, {{2, torus}}, 8},
      {"genus two torus with a cusp", "kLLvMMQkccghfihhjjjdwawwgggxxt",
       "Example3.cuspedGenusTwoTorus", 2, 10, true, 2, {}, {{1, genus_two}, {1, sphere}}, 2},
      {"solid torus LST(1,2,3)", "bGaj", "Example3.ballBundle", 1, 3, true, 1, {}, {{1, disk}}, 2},
      {"solid torus LST(3,4,7)", "dHKcbcchqn", "Example3.lst(3, 4)", 1, 5, true, 1, {}, {{1, disk}}, 2},
      {"solid Klein bottle", "cHabj", "Example3.solidKleinBottle", 2, 6, false, 1, {}, {{2, disk}}, 2},
      {"genus 2 handlebody", "eHuGabdes", "Example3.handlebody(2)", 1, 9, true, 2, {}, {{1, disk}}, 1},
      {"knotted Y", "cPcbbbihq", "Triangulation3.fromIsoSig", 1, 1, true, 2, {}, {{1, genus_two}}, 6},
      {"3-torus", "gvLQQedfedffrwawrhh",
       "closed-or-census.rga, T x S1", 1, 7, true, 3, {}, {{1, sphere}}, 48},
      {"figure-eight sister m003", "cPcbbbdxm",
       "cusped-hyp-or-census.rga, m003", 1, 2, true, 1, {5}, {{1, torus}}, 8},
  };
  // clang-format on
  return entries;
}

/// The entry of that name; throws std::out_of_range if there is none.
inline const ZooEntry& zoo(const std::string& name) {
  for (const ZooEntry& entry : zoo())
    if (entry.name == name) return entry;
  throw std::out_of_range("no zoo entry '" + name + "'");
}

/// The knotted Y as the dissertation prints it (section 4.2.3): faces A..D lie opposite the vertices a..d,
/// which are 0..3 here.
inline Triangulation knotted_y() {
  Triangulation tri(2);
  tri.glue({0, 0}, 1, Perm4(1, 2, 3, 0)); // A1 -> B2: b -> c, d -> a, c -> d
  tri.glue({0, 1}, 1, Perm4(3, 0, 1, 2)); // B1 -> A2: c -> b, d -> c, a -> d
  tri.glue({0, 2}, 1, Perm4(0, 3, 2, 1)); // C1 -> C2: a -> a, d -> b, b -> d
  tri.glue({0, 3}, 1, Perm4(0, 2, 1, 3)); // D1 -> D2: a -> a, b -> c, c -> b
  return tri;
}

} // namespace tetrarch::support
