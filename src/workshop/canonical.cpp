// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/canonical.hpp"

#include "marked_isometry.hpp"
#include "orbifold_rows.hpp"

#include "tetrarch/algebra/covers.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/canonical/isometries.hpp"
#include "tetrarch/catalogue/prove.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/document.hpp"
#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/verified/certificate.hpp"
#include "tetrarch/verified/structure.hpp"
#include "tetrarch/workshop/reason.hpp"
#include "tetrarch/workshop/structure.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string_view>

namespace tetrarch::workshop {
namespace {

using canonical::Canonical;
using canonical::IsometryAnswer;
using hyperbolic::Outcome;

/// The boundary of what was given, with the boundary spheres that `find_structure` fills.
struct Boundary {
  std::vector<std::string> types; ///< of its components, sorted
  int spheres = 0;
};

Boundary boundary_of(const Triangulation& tri) {
  Boundary found;
  for (const BoundaryComponent& component : boundary_components(tri, Skeleton(tri))) {
    found.types.push_back(component.type.str());
    found.spheres += component.type.is_sphere();
  }
  std::sort(found.types.begin(), found.types.end());
  return found;
}

Searched search_for(const Triangulation& tri, const CanonicalOptions& options, const Progress& progress) {
  hyperbolic::SearchOptions search;
  search.seed = options.seed;
  search.attempts = options.attempts;
  return searched(tri, search, progress);
}

Cells cells_in(const hyperbolic::Search& found, const CanonicalOptions& how, const Progress& progress) {
  const auto& structure = found.structure;
  Cells solved;
  solved.outcome = structure.outcome;
  solved.volume = structure.volume;
  if (structure.outcome != Outcome::geometric) {
    solved.why_not = describe(found);
    return solved;
  }
  canonical::CanonizeOptions options;
  options.seed = how.seed;
  options.restarts = how.attempts;
  solved.canonical = canonical::canonize(found.triangulation, structure, options, progress);
  if (solved.canonical->outcome != Canonical::Outcome::canonical)
    solved.why_not = "a face stays concave and no move mends it, after " +
                     std::to_string(solved.canonical->restarts) + " changes of the triangulation";
  else
    catalogue::prove_cells(*solved.canonical, progress);
  return solved;
}

std::string filled_text(int spheres) {
  return std::to_string(spheres) + ": the structure is that of the filled manifold";
}

std::string cell_summary(const std::vector<std::string>& cells) {
  std::map<std::string, int> count;
  for (const std::string& cell : cells) ++count[cell];
  std::vector<std::string> items;
  items.reserve(count.size());
  for (const auto& [cell, n] : count) items.push_back(counted(n, cell));
  return joined(items, ", ");
}

/// Tetrahedra with a flat face between them are parts of one cell; cells are numbered by their first one.
format::CanonicalCells cells_of(const Canonical& c) {
  std::vector<int> root(static_cast<std::size_t>(c.triangulation.size()));
  std::iota(root.begin(), root.end(), 0);
  for (int t = 0; t < c.triangulation.size(); ++t)
    for (int f = 0; f < 4; ++f)
      if (c.flat[t][f]) {
        const int a = numeric::find_root(root, t);
        const int b = numeric::find_root(root, c.triangulation.gluing({t, f}).tet);
        root[std::max(a, b)] = std::min(a, b);
      }
  format::CanonicalCells result{c.cells, std::vector<int>(root.size()), c.flat, c.isometry_signature, {}};
  int cells = 0;
  for (int t = 0; t < c.triangulation.size(); ++t) {
    const int first = numeric::find_root(root, t);
    result.cell_of[t] = first == t ? cells++ : result.cell_of[first];
  }
  return result;
}

/// As short as the definition in decorated.hpp.
constexpr const char* cusp_area = "0.05";

/// Certifies the structure once more, now with its volume, and says which faces are flat and why. Empty where
/// something is not proved.
std::string certificate_of(const Canonical& c, const Progress& progress) {
  if (!c.proof.certified) return {};
  const Skeleton skeleton(c.triangulation);
  const auto structure = hyperbolic::hyperbolize(c.triangulation, skeleton, {}, progress);
  if (structure.outcome != Outcome::geometric) return {};
  const auto certified =
      verified::certify(c.triangulation, skeleton, structure, {c.proof.bits, c.proof.bits}, progress);
  if (!certified.proof) return {};
  verified::CellClaims claims{cusp_area, {}};
  const std::vector<int> cell_of = cells_of(c).cell_of;
  for (int t = 0; t < c.triangulation.size(); ++t) {
    claims.flat.emplace_back();
    for (int f = 0; f < 4; ++f)
      if (c.flat[t][f]) claims.flat.back()[f] = to_string(c.proof.criteria[cell_of[t]]);
  }
  return verified::certificate(c.triangulation, skeleton, *certified.proof, claims);
}

bool is_found(const Cells& c) {
  return c.why_not.empty();
}
bool is_not_found(const Cells& c) {
  return !is_found(c);
}

Tree tree_of(const Isomorphism& isometry) {
  Tree perms = Tree::array();
  for (const Perm4 p : isometry.perm) perms.push_back(p.str());
  return {{"tetrahedra", isometry.tet}, {"vertices", perms}};
}

Type isomorphism_type() {
  return type::object({{"tetrahedra", type::list(type::integer)}, {"vertices", type::list(type::text)}});
}

void name_isometries(Cells& found, bool keep) {
  std::vector<Isomorphism> group = isometry_group(*found.canonical);
  found.isometry_group_order = group.size();
  constexpr std::size_t most_named = 500;
  if (group.size() <= most_named)
    found.isometry_group = canonical::name_of_group(canonical::multiplication_table(group));
  found.amphichiral = canonical::is_amphichiral(found.canonical->canonical_triangulation, group);
  if (keep) found.isometries = std::move(group);
}

bool has_isometries(const Cells& c) {
  return !c.isometries.empty();
}
bool is_proved(const Cells& c) {
  return is_found(c) && c.canonical->proof.certified;
}
bool is_not_proved(const Cells& c) {
  return is_found(c) && !is_proved(c);
}

/// "yes", "yes, 2 cells by R", or why not.
std::string proof_text(const canonical::CellsProof& proof) {
  if (!proof.certified) return "no: " + proof.why_not;
  std::map<std::string, int> count;
  for (const canonical::Criterion criterion : proof.criteria)
    if (criterion != canonical::Criterion::tetrahedron) ++count[to_string(criterion)];
  std::string text = "yes";
  for (const auto& [criterion, n] : count) text += ", " + counted(n, "flat cell") + " by " + criterion;
  return text;
}

Tree criteria_of(const canonical::CellsProof& proof) {
  Tree list = Tree::array();
  for (const canonical::Criterion criterion : proof.criteria) list.push_back(to_string(criterion));
  return list;
}

IsometryAnswer told(IsometryAnswer::Verdict verdict, IsometryAnswer::Proof proof, std::string reason) {
  IsometryAnswer answer;
  answer.verdict = verdict;
  answer.proof = proof;
  answer.reason = std::move(reason);
  return answer;
}

/// A proved no of volumes, where both structures are certified.
std::optional<IsometryAnswer> differ_in_volume(const hyperbolic::Search& x, const hyperbolic::Search& y,
                                               const Progress& progress) {
  std::array<verified::VolumeInterval, 2> interval;
  std::array<numeric::Ball, 2> volume;
  for (int k = 0; k < 2; ++k) {
    const hyperbolic::Search& search = k == 0 ? x : y;
    if (search.structure.outcome != Outcome::geometric) return std::nullopt;
    const auto certified = verified::certify(search.triangulation, Skeleton(search.triangulation),
                                             search.structure, {}, progress);
    if (!certified.proof) return std::nullopt;
    volume[k] = certified.proof->volume;
    interval[k] = verified::volume_interval(*certified.proof);
  }
  if (overlap(volume[0], volume[1])) return std::nullopt;
  return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::volume,
              "the volumes differ: one lies in [" + interval[0].low + ", " + interval[0].high +
                  "], the other in [" + interval[1].low + ", " + interval[1].high + "]");
}

constexpr const char* given_triangulations = "triangulations given";
constexpr const char* simplified_triangulations = "simplified triangulations";

/// A proved no of invariants that need no structure.
std::optional<IsometryAnswer> differ(const Triangulation& x, const Boundary& boundary_x,
                                     const Triangulation& y, const Boundary& boundary_y) {
  if (boundary_x.types != boundary_y.types) {
    const auto named = [](const Boundary& b) {
      return b.types.empty() ? std::string("none") : joined(b.types, ", ");
    };
    return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::boundary,
                "the boundaries differ: " + named(boundary_x) + " against " + named(boundary_y));
  }
  const auto h_x = algebra::homology(x, Skeleton(x), 1);
  const auto h_y = algebra::homology(y, Skeleton(y), 1);
  if (h_x == h_y) return std::nullopt;
  return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::homology,
              "the first homology differs: " + h_x.str() + " against " + h_y.str());
}

/// Yes if two triangulations of the manifolds are isomorphic. Where they carry no structure, it is a
/// homeomorphism.
bool compare_triangulations(const Triangulation& x, const Triangulation& y, const char* which,
                            Isometry& found) {
  auto isometry = find_isomorphism(x, y);
  if (!isometry) return false;
  found.answer = told(IsometryAnswer::Verdict::isometric, IsometryAnswer::Proof::isomorphism,
                      std::string("the ") + which + " are isomorphic");
  found.answer.isometry = *std::move(isometry);
  found.between = which;
  found.from = signature(x);
  return true;
}

algebra::Presentation group_of(const Triangulation& tri, const Progress& progress) {
  return algebra::simplified(algebra::dual_presentation(tri, Skeleton(tri)).presentation, {}, progress);
}

/// A proved no of covers. Degrees grow until a budget ends the search.
std::optional<IsometryAnswer> differ_in_covers(const Triangulation& x, const Triangulation& y, int& compared,
                                               const Progress& progress) {
  constexpr int most_sheets = 7;
  constexpr long long most_steps = 300'000;
  algebra::CoverDifference found = algebra::difference_of_covers(group_of(x, progress), group_of(y, progress),
                                                                 most_sheets, most_steps, progress);
  compared = found.compared;
  if (found.what.empty()) return std::nullopt;
  return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::covers, std::move(found.what));
}

/// A certified structure on the one, a proof that there is none on the other.
std::optional<IsometryAnswer> differ_in_structure(const Compared& with, const hyperbolic::Search& search,
                                                  const Compared& without, const hyperbolic::Search& other,
                                                  std::uint64_t seed, const Progress& progress) {
  const auto certified =
      verified::certify(search.triangulation, Skeleton(search.triangulation), search.structure, {}, progress);
  if (!certified.proof) return std::nullopt;
  const auto why = proved_no(other.triangulation, seed, progress);
  if (!why) return std::nullopt;
  return told(IsometryAnswer::Verdict::not_isometric, IsometryAnswer::Proof::structure,
              with.name + " has a certified hyperbolic structure, and " + without.name +
                  " has none: " + why->text);
}

bool is_yes(const Isometry& i) {
  return i.verdict() == Verdict::yes;
}
bool is_undecided(const Isometry& i) {
  return i.verdict() == Verdict::undecided;
}

} // namespace

Verdict Cells::verdict() const {
  if (why_not.empty()) return Verdict::yes;
  return outcome == Outcome::projective_plane || why ? Verdict::proved_no : Verdict::undecided;
}

Verdict Isometry::verdict() const {
  if (answer.verdict == IsometryAnswer::Verdict::isometric) return Verdict::yes;
  return answer.verdict == IsometryAnswer::Verdict::undecided ? Verdict::undecided : Verdict::proved_no;
}

Cells cells(const Triangulation& tri, const CanonicalOptions& options, const Progress& progress) {
  if (!options.marks.empty()) {
    Cells found = cells_with_marks(tri, options, progress);
    if (is_found(found)) name_isometries(found, options.list_isometries);
    return found;
  }
  const Boundary boundary = boundary_of(tri);
  const Searched way = search_for(tri, options, progress);
  Cells found = cells_in(way.search, options, progress);
  if (found.outcome != Outcome::geometric)
    found.why = way.why ? way.why : proved_no(way.search.triangulation, options.seed, progress);
  found.filled_spheres = boundary.spheres;
  if (is_found(found)) {
    name_isometries(found, options.list_isometries);
    if (options.certify) found.certificate = certificate_of(*found.canonical, progress);
  }
  return found;
}

namespace {

std::string group_text(const Cells& found) {
  std::string text = "order " + std::to_string(found.isometry_group_order);
  if (!found.isometry_group.empty()) text += ": " + found.isometry_group;
  if (found.amphichiral) text += *found.amphichiral ? ", amphichiral" : ", chiral";
  return text;
}

} // namespace

Rows rows_of(const Cells& found) {
  if (found.why) {
    Rows rows{{"outcome", "not hyperbolic"}};
    const Rows proof = rows_of(*found.why);
    rows.insert(rows.end(), proof.begin(), proof.end());
    return rows;
  }
  if (is_not_found(found)) return {{"outcome", "not found"}, {"reason", found.why_not}};
  const Canonical& c = *found.canonical;
  Rows rows{{"cells", cell_summary(c.cells)},
            {"isometry signature", c.isometry_signature},
            {"certified", proof_text(c.proof)},
            {"isometry group", group_text(found)},
            {"tetrahedra", std::to_string(c.triangulation.size())},
            {"smallest tilt", scientific(c.smallest_tilt, 3)},
            {"volume", fixed(found.volume, 12)}};
  if (!found.certificate.empty())
    rows.insert(rows.begin() + 3, {"certificate", "sha256 " + verified::digest(found.certificate)});
  if (!c.marks.empty())
    rows.emplace_back("marks", orders_text(c.marks) + "; cells and volume are those of parabolic meridians");
  if (found.filled_spheres > 0) rows.emplace_back("filled spheres", filled_text(found.filled_spheres));
  return rows;
}

format::Document document_of(const Cells& found) {
  if (!found.canonical) throw PreconditionError("document_of: there are no cells");
  format::Document document = format::document_of(found.canonical->triangulation);
  document.canonical = cells_of(*found.canonical);
  document.marks = found.canonical->marks;
  return document;
}

Isometry isometry(const Compared& x, const Compared& y, const CanonicalOptions& options,
                  const Progress& progress) {
  if (!x.marks.empty() || !y.marks.empty()) return isometry_with_marks(x, y, options, progress);
  const Boundary boundary_x = boundary_of(x.tri);
  const Boundary boundary_y = boundary_of(y.tri);
  Isometry found{
      {}, "canonical triangulations", {}, std::max(boundary_x.spheres, boundary_y.spheres), x.name, y.name};
  if (auto no = differ(x.tri, boundary_x, y.tri, boundary_y)) {
    found.answer = *std::move(no);
    return found;
  }
  const hyperbolic::Search search = search_for(x.tri, options, progress).search;
  if (compare_triangulations(x.tri, y.tri, given_triangulations, found)) return found;
  const hyperbolic::Search other = search_for(y.tri, options, progress).search;
  const bool in_x = search.structure.outcome == Outcome::geometric;
  const bool in_y = other.structure.outcome == Outcome::geometric;
  std::optional<IsometryAnswer> no;
  if (in_x && in_y)
    no = differ_in_volume(search, other, progress);
  else if (in_x)
    no = differ_in_structure(x, search, y, other, options.seed, progress);
  else if (in_y)
    no = differ_in_structure(y, other, x, search, options.seed, progress);
  else if (compare_triangulations(search.triangulation, other.triangulation, simplified_triangulations,
                                  found))
    return found;
  if (no) {
    found.answer = *std::move(no);
    return found;
  }
  const Cells a = cells_in(search, options, progress);
  const Cells b = cells_in(other, options, progress);
  if (!a.why_not.empty())
    found.answer.reason = x.name + ": " + a.why_not;
  else if (!b.why_not.empty())
    found.answer.reason = y.name + ": " + b.why_not;
  else {
    found.answer = compare(*a.canonical, *b.canonical);
    found.from = signature(a.canonical->canonical_triangulation);
  }
  if (!is_undecided(found)) return found;
  int compared = 1;
  if (auto other_covers = differ_in_covers(search.triangulation, other.triangulation, compared, progress))
    found.answer = *std::move(other_covers);
  else if (compared > 1)
    found.answer.reason += "; homology of covers to " + std::to_string(compared) + " sheets agrees";
  return found;
}

std::optional<IsometryAnswer> differ_without_structure(const Triangulation& x, const Triangulation& y) {
  return differ(x, boundary_of(x), y, boundary_of(y));
}

std::string text_of(const Isometry& found) {
  const bool yes = is_yes(found);
  const char* const word = yes ? "isometric" : is_undecided(found) ? "undecided" : "not isometric";
  std::string text = std::string(word) + ": " + found.answer.reason + "\n";
  if (!yes) return text;
  if (found.filled_spheres > 0)
    text += "filled spheres: " + std::to_string(found.filled_spheres) +
            " in each; the isometry is one of the filled manifolds\n";
  const bool cells = std::string_view(found.between) == "canonical triangulations";
  text += std::string(cells ? "canonical tetrahedra of " : "tetrahedra of ") + found.x + " go to those of " +
          found.y + ":\n";
  const Isomorphism& isometry = found.answer.isometry;
  for (std::size_t t = 0; t < isometry.tet.size(); ++t)
    text += "  " + std::to_string(t) + " -> " + std::to_string(isometry.tet[t]) + ", vertices 0123 -> " +
            isometry.perm[t].str() + "\n";
  return text;
}

template <>
const FieldList<Cells>& fields_of<Cells>() {
  using C = const Cells&;
  static const FieldList<Cells> fields{
      {{"outcome", "", "canonical, not hyperbolic (proved), or not found",
        type::one_of({"canonical", "not hyperbolic", "not found"})},
       [](C c) -> Tree { return is_found(c) ? "canonical"
                                : c.why     ? "not hyperbolic"
                                            : "not found"; }},
      {{"reason", "", "why there are no cells", type::text},
       [](C c) -> Tree { return c.why ? c.why->text : c.why_not; },
       is_not_found},
      {{"why", "", "the proof that the manifold is not hyperbolic, as for hyperbolize", reason_type()},
       [](C c) -> Tree { return tree_of(*c.why); },
       [](C c) { return c.why.has_value(); }},
      {{"cells", "", "the polyhedra, by their names", type::list(type::text)},
       [](C c) -> Tree { return c.canonical->cells; },
       is_found},
      {{"isometry_signature", "", "a text that two manifolds share if and only if they are isometric",
        type::text},
       [](C c) -> Tree { return c.canonical->isometry_signature; },
       is_found},
      {{"isometry_group_order", "", "number of isometries of the manifold to itself", type::integer},
       [](C c) -> Tree { return c.isometry_group_order; },
       is_found},
      {{"isometry_group", "", "its name, such as Z/2 + Z/2, D4 (of order 8), S4; null: none of those known",
        type::or_null(type::text)},
       [](C c) { return c.isometry_group.empty() ? Tree() : Tree(c.isometry_group); },
       is_found},
      {{"amphichiral", "", "whether an isometry reverses orientation; null: there is no orientation",
        type::or_null(type::truth)},
       [](C c) { return c.amphichiral ? Tree(*c.amphichiral) : Tree(); },
       is_found},
      {{"isometries", "",
        "of each isometry the images of the canonical triangulation's tetrahedra and vertices",
        type::list(isomorphism_type())},
       [](C c) {
         Tree list = Tree::array();
         for (const Isomorphism& isometry : c.isometries) list.push_back(tree_of(isometry));
         return list;
       },
       has_isometries},
      {{"certified", "", "whether the cells are proved to be the canonical ones", type::truth},
       [](C c) -> Tree { return is_proved(c); },
       is_found},
      {{"why_not_certified", "", "what is in doubt", type::text},
       [](C c) -> Tree { return c.canonical->proof.why_not; },
       is_not_proved},
      {{"criteria", "",
        "what proves each cell: tetrahedron, or how it is proved flat (R: orbits, F: one line, B: blocks, L: "
        "linear relations, E: exact algebra)",
        type::list(type::text)},
       [](C c) { return criteria_of(c.canonical->proof); },
       is_proved},
      {{"certificate", "", "SHA-256 of the file that proves structure and cells", type::text},
       [](C c) -> Tree { return verified::digest(c.certificate); },
       [](C c) { return !c.certificate.empty(); }},
      {{"tetrahedra", "", "number of tetrahedra of the subdivided cells", type::integer},
       [](C c) -> Tree { return c.canonical->triangulation.size(); },
       is_found},
      {{"flat_faces", "",
        "whether cells other than tetrahedra occur, so that some faces inside them are flat", type::truth},
       [](C c) -> Tree { return c.canonical->has_flat_faces; },
       is_found},
      {{"smallest_tilt", "", "of the faces between cells: how far the cells are from other ones",
        type::number},
       [](C c) -> Tree { return c.canonical->smallest_tilt; },
       is_found},
      {{"volume", "curvature -1", "the volume; with marks that of the structure with parabolic meridians",
        type::number},
       [](C c) -> Tree { return c.volume; },
       is_found},
      {{"marks", "",
        "of each marked edge of the canonical triangulation a tetrahedron, its edge, and the order",
        marks_type()},
       [](C c) -> Tree { return marks_tree(c.canonical->canonical_marks); },
       [](C c) { return is_found(c) && !c.canonical->marks.empty(); }},
      {{"filled_spheres", "", "number of boundary spheres that were filled with balls", type::integer},
       [](C c) -> Tree { return c.filled_spheres; }}};
  return fields;
}

template <>
const FieldList<Isometry>& fields_of<Isometry>() {
  using I = const Isometry&;
  static const FieldList<Isometry> fields{
      {{"isometric", "", "true or false, both proved; null: undecided", type::or_null(type::truth)},
       [](I i) { return is_undecided(i) ? Tree() : Tree(is_yes(i)); }},
      {{"reason", "", "what decides, or what is missing", type::text},
       [](I i) -> Tree { return i.answer.reason; }},
      {{"proof", "", "which kind of proof; null: undecided", type::or_null(type::text)},
       [](I i) { return is_undecided(i) ? Tree() : Tree(to_string(i.answer.proof)); }},
      {{"filled_spheres", "", "number of boundary spheres filled with balls in each", type::integer},
       [](I i) -> Tree { return i.filled_spheres; }},
      {{"isometry", "", "for each tetrahedron its image, and where its vertices go", isomorphism_type()},
       [](I i) { return tree_of(i.answer.isometry); },
       is_yes},
      {{"between", "", "which triangulations the isometry goes between", type::text},
       [](I i) -> Tree { return i.between; },
       is_yes},
      {{"from", "", "signature of the first of them", type::text},
       [](I i) -> Tree { return i.from; },
       is_yes}};
  return fields;
}

} // namespace tetrarch::workshop
