// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"

#include "tetrarch/workshop/bundle.hpp"
#include "tetrarch/workshop/canonical.hpp"
#include "tetrarch/workshop/check.hpp"
#include "tetrarch/workshop/diagram.hpp"
#include "tetrarch/workshop/embed.hpp"
#include "tetrarch/workshop/filling.hpp"
#include "tetrarch/workshop/fingerprint.hpp"
#include "tetrarch/workshop/identify.hpp"
#include "tetrarch/workshop/info.hpp"
#include "tetrarch/workshop/pair.hpp"
#include "tetrarch/workshop/product.hpp"
#include "tetrarch/workshop/registration.hpp"
#include "tetrarch/workshop/simplify.hpp"
#include "tetrarch/workshop/structure.hpp"
#include "tetrarch/workshop/truncate.hpp"
#include "tetrarch/workshop/verify.hpp"

namespace tetrarch::program {
namespace {

constexpr const char* triangulations = "Triangulations";
constexpr const char* structures = "Hyperbolic structures";
constexpr const char* diagrams = "Knots, links and graphs in space";
constexpr const char* meshes = "Meshes of surfaces and solids";
constexpr const char* tables = "The census";
constexpr const char* session = "Sessions and help";

} // namespace

Status status_of(workshop::Verdict verdict) {
  if (verdict == workshop::Verdict::yes) return Status::done;
  return verdict == workshop::Verdict::proved_no ? Status::proved_no : Status::undecided;
}

const std::vector<Command>& commands() {
  static const std::vector<Command> table{
      {triangulations, "info",
       "sizes, validity, orientability, vertex links, boundary, homology, group, signature", "info cPcbbbihq",
       declare_info, false, workshop::notes_of<workshop::Info>},
      {triangulations, "skeleton", "the gluings, and the classes of faces, edges and vertices",
       "skeleton cPcbbbihq", declare_skeleton, false, fields::of_skeleton},
      {triangulations, "group", "a simplified presentation of the fundamental group, and the first homology",
       "group fmp3_17", declare_group, false, fields::of_group},
      {triangulations, "convert", "convert between triangulation formats, or between mesh formats",
       "convert cPcbbbiht -o figure8.tri", declare_convert, false, fields::of_convert},
      {meshes, "check",
       "every fault of a mesh or a surface, by element and line; the boundary loops of a surface",
       "check samples/knotted_y_8k.mesh", declare_check, false, workshop::notes_of<workshop::Diagnosis>},
      {triangulations, "simplify", "fewer tetrahedra, the same manifold", "simplify gvLQQedfedffrwawrhh",
       declare_simplify, false, workshop::notes_of<workshop::Simplification>},
      {triangulations, "truncate", "turn the mesh of a solid into a few truncated tetrahedra",
       "truncate samples/knotted_y_8k.mesh -o knotted_y.json", declare_truncate, false,
       workshop::notes_of<workshop::Truncation>},
      {triangulations, "move", "make one or more moves on a triangulation, or list the legal moves",
       "move cPcbbbiht 2-3 0 1", declare_move, true, fields::of_move},
      {triangulations, "subdivide",
       "more tetrahedra, the same manifold; real boundary in place of ideal vertices",
       "subdivide cPcbbbihq --finite --barycentric 1 -o knotted_y_mesh.json", declare_subdivide, false,
       fields::of_subdivide},
      {triangulations, "drill", "the exterior of a set of edges", "drill cMcabbgqs 0", declare_drill, false,
       fields::of_drill},
      {diagrams, "diagram", "read and check the diagram of a link or a graph in space",
       "diagram 4_1 -o figure8.svg", declare_diagram, false, workshop::notes_of<workshop::DiagramFacts>},
      {diagrams, "exterior", "the exterior of a link or a graph in space", "exterior 4_1 -o figure8.json",
       declare_exterior, false, workshop::notes_of<workshop::Exterior>},
      {structures, "hyperbolize",
       "find the structure with geodesic boundary and cusps, by Newton's method or Luo's flow",
       "hyperbolize cPcbbbihq", declare_hyperbolize, false, workshop::notes_of<workshop::Structure>},
      {structures, "verify", "check a certificate of a structure by other means than those that made it",
       "verify samples/knotted_y.cert.json", declare_verify, false, workshop::notes_of<checker::Report>},
      {structures, "canonize", "canonical cells, isometry signature and isometry group", "canonize fmp3_1",
       declare_canonize, false, workshop::notes_of<workshop::Cells>},
      {structures, "isometric", "decide whether two manifolds are isometric", "isometric cPcbbbihq fmp2_1",
       declare_isometric, false, workshop::notes_with_pairs},
      {structures, "embed",
       "the fundamental domain and its copies in hyperbolic space, the holonomy, boundary tilings",
       "embed cPcbbbihq --copies 60 --model ball -o knotted_y.glb", declare_embed, false,
       workshop::notes_of<workshop::Embedding>},
      {structures, "view", "write a self-contained page to look at the manifold and turn it around",
       "view cPcbbbihq -o knotted_y.html", declare_view, false, fields::of_view},
      {meshes, "bundle", "the unit tangent bundle of a surface, or the circle bundle of any Euler number",
       "bundle samples/torus.off --fiber 6 -o torus_bundle.json", declare_bundle, false,
       workshop::notes_of<workshop::SurfaceBundle>},
      {meshes, "slit",
       "map a sphere with holes conformally to a cylinder, rectangle or ring with slits, or to a disk",
       "slit samples/ring_two_holes.off -o ring_two_holes.svg", declare_slit, false,
       workshop::notes_of_maps_and_types},
      {meshes, "register",
       "resample a surface with holes by the triangles of another, through circular domains",
       "register samples/ring_two_holes.off samples/ring_two_holes.off", declare_register, false,
       workshop::notes_of<workshop::SurfaceRegistration>},
      {meshes, "product",
       "coordinates of a handlebody in (a disk with holes) x (an interval); hexahedral meshes",
       "product samples/genus4_ridges.mesh --labels 1,2 --hex 30 -o genus4.vtu", declare_product, false,
       workshop::notes_of<workshop::SolidProduct>},
      {meshes, "hex", "fill a solid with hexahedra, whatever its genus; no partition is needed",
       "hex samples/double_torus.off --cells 2000 -o double_torus.vtu", declare_hex, false,
       workshop::notes_of<workshop::FilledSolid>},
      {tables, "census gluings",
       "list all closed gluings of N tetrahedra up to isomorphism, as signatures, one per line",
       "census gluings --tetrahedra 2 --orientable --ideal", declare_census_gluings, false,
       fields::of_census_gluings},
      {tables, "census enumerate",
       "classify the manifolds of N tetrahedra from nothing, one JSON object per line",
       "census enumerate --tetrahedra 2", declare_census_enumerate, false, fields::of_census_enumerate},
      {tables, "census merge", "the table of work that several machines did, each a share",
       "census merge samples/census_work.records --tetrahedra 2 -o census.json", declare_census_merge, false,
       fields::of_census_merge},
      {tables, "census validate", "rebuild a stored table from nothing and solve its manifolds again",
       "census validate --tetrahedra 2", declare_census_validate, false, fields::of_census_validate},
      {tables, "census list",
       "list the manifolds of a stored table, that of three tetrahedra or all of a file unless options say "
       "less",
       "census list --tetrahedra 2", declare_census_list, false, fields::of_census_list},
      {tables, "census show", "show the entry of one manifold", "census show fmp3_17", declare_census_show,
       false, fields::of_census_show},
      {tables, "census table", "put tables together in one SQLite file, which other programs can ask",
       "census table samples/census.jsonl -o census.sqlite", declare_census_table, false,
       fields::of_census_table},
      {tables, "census identify", "find the name of a manifold, whatever its triangulation",
       "census identify eLPkbdcddhgggb", declare_census_identify, false,
       workshop::notes_of<identify::Identification>},
      {session, "shell", "run the same commands as verbs on named values, at a prompt or from a script",
       "shell samples/moves.txt", declare_shell},
      {session, "help", "explain a command and its options; with --json, print the table of all commands",
       "help truncate", declare_help},
  };
  return table;
}

} // namespace tetrarch::program
