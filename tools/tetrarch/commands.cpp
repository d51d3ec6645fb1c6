// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"

namespace tetrarch::program {

const std::vector<Command>& commands() {
  static const std::vector<Command> table{
      {"info", "sizes, validity, orientability, vertex links, boundary, homology, group, signature",
       "tetrarch info cPcbbbihq", declare_info},
      {"convert", "between all triangulation formats, and between mesh formats",
       "tetrarch convert cPcbbbiht -o figure8.tri", declare_convert},
      {"check", "everything that is wrong with a mesh or a surface, by element and line; its boundary loops",
       "tetrarch check tests/data/knotted_y_8k.mesh", declare_check},
      {"simplify", "fewer tetrahedra, the same manifold", "tetrarch simplify gvLQQedfedffrwawrhh",
       declare_simplify},
      {"truncate", "from a mesh of a solid to a few truncated tetrahedra",
       "tetrarch truncate tests/data/knotted_y_8k.mesh -o knotted_y.json", declare_truncate},
      {"subdivide", "more tetrahedra, the same manifold; real boundary in place of ideal vertices",
       "tetrarch subdivide cPcbbbihq --finite --barycentric 1 -o knotted_y_mesh.json", declare_subdivide},
      {"hyperbolize", "the structure with geodesic boundary and cusps, by Newton's method or Luo's flow",
       "tetrarch hyperbolize cPcbbbihq", declare_hyperbolize},
      {"canonize", "canonical cells, isometry signature and isometry group", "tetrarch canonize fmp3_1",
       declare_canonize},
      {"isometric", "decide whether two manifolds are isometric", "tetrarch isometric cPcbbbihq fmp2_1",
       declare_isometric},
      {"embed", "the fundamental domain and its copies in hyperbolic space, the holonomy, boundary tilings",
       "tetrarch embed cPcbbbihq --copies 60 --model ball -o knotted_y.glb", declare_embed},
      {"view", "a self-contained page to look at the manifold and turn it around",
       "tetrarch view cPcbbbihq -o knotted_y.html", declare_view},
      {"bundle", "the unit tangent bundle of a surface, or the circle bundle of any Euler number",
       "tetrarch bundle tests/data/mesh/torus.off --fiber 6 -o torus_bundle.json", declare_bundle},
      {"slit",
       "a sphere with holes, laid conformally onto a cylinder, rectangle or ring with slits, or a disk",
       "tetrarch slit tests/data/mesh/ring_two_holes.off -o ring_two_holes.svg", declare_slit},
      {"register",
       "a surface with holes resampled with the triangles of another one, through circular domains",
       "tetrarch register tests/data/mesh/ring_two_holes.off tests/data/mesh/ring_two_holes.off",
       declare_register},
      {"product", "coordinates of a handlebody in (a disk with holes) x (an interval); hexahedral meshes",
       "tetrarch product tests/data/genus4_ridges.mesh --labels 1,2 --hex 30 -o genus4.vtu", declare_product},
      {"census gluings", "all closed gluings of N tetrahedra up to isomorphism, as signatures, one a line",
       "tetrarch census gluings --tetrahedra 2 --orientable --ideal", declare_census_gluings},
      {"census enumerate", "classify the manifolds of N tetrahedra from nothing, one JSON object a line",
       "tetrarch census enumerate --tetrahedra 2", declare_census_enumerate},
      {"census validate", "rebuild a stored table from nothing and solve its manifolds again",
       "tetrarch census validate --tetrahedra 2", declare_census_validate},
      {"census list", "the manifolds of a stored table", "tetrarch census list --tetrahedra 2",
       declare_census_list},
      {"census show", "everything stored about one manifold", "tetrarch census show fmp3_17",
       declare_census_show},
      {"census identify", "the name of a manifold, in whatever triangulation",
       "tetrarch census identify eLPkbdcddhgggb", declare_census_identify},
  };
  return table;
}

} // namespace tetrarch::program
