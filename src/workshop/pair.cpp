// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/pair.hpp"

#include "tetrarch/canonical/isometries.hpp"
#include "tetrarch/canonical/pair.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/identify/finite_images.hpp"
#include "tetrarch/workshop/diagram.hpp"
#include "tetrarch/workshop/text.hpp"

#include <array>
#include <optional>
#include <utility>

namespace tetrarch::workshop {
namespace {

using Proof = PairComparison::Proof;
using canonical::IsometryAnswer;
using canonical::MarkedCells;
using canonical::PairIsometries;

constexpr long long most_images = 3'000'000; // homomorphisms to a finite group that are looked at
constexpr std::uint64_t seeds = 8;           // of ways to simplify an exterior

/// Throws if a neighborhood of the graph has a component that is a ball.
void require_no_trees(const diagram::Diagram& diagram, const std::string& name) {
  if (tree_count(diagram) > 0)
    throw InputError(in_quotes(name) + " has a component without cycles: a neighborhood of it is a ball");
}

std::optional<diagram::PairExterior> exterior_of(const diagram::Diagram& diagram, std::uint64_t first_seed,
                                                 const Progress& progress) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed)
    if (auto found = diagram::pair_exterior(diagram, {seed}, progress)) return found;
  return std::nullopt;
}

/// Symmetries of one side.
void add_groups(PairSide& side, const MarkedCells& cells) {
  const PairIsometries own = pair_isometries(cells, cells);
  const Triangulation& tri = cells.canonical.canonical_triangulation;
  side.found = true;
  side.isometry_signature = cells.canonical.isometry_signature;
  side.exterior_group_order = own.all.size();
  side.exterior_group = canonical::name_of_group(canonical::multiplication_table(own.all));
  side.exterior_amphichiral = canonical::is_amphichiral(tri, own.all).value_or(false);
  side.group_order = own.extending.size();
  side.group = canonical::name_of_group(canonical::multiplication_table(own.extending));
  side.amphichiral = std::count(own.hands.begin(), own.hands.end(), -1) > 0;
}

Proof proof_of(IsometryAnswer::Proof proof) {
  switch (proof) {
  case IsometryAnswer::Proof::boundary:
    return Proof::boundary;
  case IsometryAnswer::Proof::homology:
    return Proof::homology;
  case IsometryAnswer::Proof::volume:
    return Proof::volume;
  case IsometryAnswer::Proof::cells:
    return Proof::cells;
  default:
    return Proof::none;
  }
}

void count_hands(PairComparison& out, const std::vector<int>& hands) {
  out.extending = hands.size();
  out.keeps_orientation = std::count(hands.begin(), hands.end(), 1) > 0;
  out.reverses_orientation = std::count(hands.begin(), hands.end(), -1) > 0;
}

std::string isometries_text(std::size_t count) {
  return count == 1 ? "1 isometry" : std::to_string(count) + " isometries";
}

/// The exteriors differ.
void refuse_exteriors(PairComparison& out, const IsometryAnswer& no) {
  out.verdict = Verdict::proved_no;
  out.exteriors = false;
  out.proof = proof_of(no.proof);
  out.reason = "the exteriors are not homeomorphic: " + no.reason;
}

/// The cells of one side with its meridians, and what they tell.
MarkedCells marked_cells_of(PairSide& side, const diagram::PairExterior& exterior,
                            const CanonicalOptions& how, const Progress& progress) {
  const Cells found = workshop::cells(exterior.tri, how, progress);
  MarkedCells marked;
  marked.why_not = found.why_not;
  if (found.verdict() != Verdict::yes) return marked;
  canonical::MarkedOptions search;
  search.seed = how.seed;
  marked = marked_cells(exterior.tri, exterior.monodromy, search, progress);
  if (!marked.why_not.empty()) return marked;
  marked.canonical.proof = found.canonical->proof;
  side.volume = found.volume;
  add_groups(side, marked);
  return marked;
}

/// Both have cells with meridians.
void decide(PairComparison& out, const MarkedCells& a, const MarkedCells& b) {
  const bool proved = a.canonical.proof.certified && b.canonical.proof.certified;
  const PairIsometries between = pair_isometries(a, b);
  out.isometries = between.all.size();
  if (!between.all.empty()) out.exteriors = true;
  count_hands(out, between.hands);
  if (out.extending > 0) {
    out.verdict = Verdict::yes;
    out.proof = Proof::isometry;
    out.reason = std::to_string(out.extending) + " of the " + isometries_text(out.isometries) +
                 " between the exteriors take meridians to meridians";
    return;
  }
  out.reason = "none of the " + isometries_text(out.isometries) +
               " between the exteriors takes meridians to meridians";
  if (proved) {
    out.verdict = Verdict::proved_no;
    out.proof = Proof::meridians;
  } else {
    out.reason += "; but the cells are not proved, so that there may be more isometries";
  }
}

/// A no of images in finite groups.
bool differ_in_images(PairComparison& out, const diagram::PairExterior& a, const diagram::PairExterior& b,
                      const Progress& progress) {
  for (const std::string& group : identify::finite_groups()) {
    const auto counts_a = identify::image_counts(a.tri, a.monodromy, group, most_images, progress);
    const auto counts_b = identify::image_counts(b.tri, b.monodromy, group, most_images, progress);
    if (!counts_a || !counts_b) return false;
    if (*counts_a == *counts_b) continue;
    out.verdict = Verdict::proved_no;
    out.proof = Proof::images;
    out.reason = "homomorphisms to " + group +
                 " have other orders of images of the exterior, of its boundary and of the meridians";
    return true;
  }
  return false;
}

/// Without a structure: a yes if a triangulation is found that both exteriors share with their meridians, a
/// no of finite groups.
void decide_without_cells(PairComparison& out, const diagram::PairExterior& a, const diagram::PairExterior& b,
                          std::uint64_t seed, const Progress& progress) {
  canonical::CommonOptions how;
  how.seed = seed;
  const auto common = common_triangulation(a.tri, a.monodromy, b.tri, b.monodromy, how, progress);
  if (!common.signature.empty()) out.exteriors = true;
  if (!common.hands.empty()) {
    out.verdict = Verdict::yes;
    out.proof = Proof::isomorphism;
    count_hands(out, common.hands);
    out.isometries = common.isomorphisms;
    out.reason = "both exteriors have the triangulation " + common.signature +
                 ", and an isomorphism takes meridians to meridians";
    return;
  }
  const std::string why_not = out.reason;
  const bool no = differ_in_images(out, a, b, progress);
  if (!no) out.reason = why_not;
  if (!common.signature.empty())
    out.reason += std::string(no ? "; the exteriors are homeomorphic: both have the triangulation "
                                 : "; both exteriors have the triangulation ") +
                  common.signature +
                  (no ? "" : ", but no isomorphism that was met takes meridians to meridians");
}

const char* yes_no(bool yes) {
  return yes ? "yes" : "no";
}

std::string order_text(std::size_t order, const std::string& group) {
  return "order " + std::to_string(order) + (group.empty() ? "" : ": " + group);
}

void add_rows(Rows& rows, const PairSide& side) {
  if (!side.found) return;
  rows.emplace_back(side.name, "volume " + fixed(side.volume, 12));
  rows.emplace_back("",
                    "exterior: isometries of " + order_text(side.exterior_group_order, side.exterior_group));
  rows.emplace_back("", "pair: symmetries of " + order_text(side.group_order, side.group) +
                            (side.amphichiral ? ", amphichiral" : ", chiral"));
}

} // namespace

const char* to_string(PairComparison::Proof proof) {
  constexpr std::array<const char*, 9> names{"none",  "isometry",  "boundary",    "homology", "volume",
                                             "cells", "meridians", "isomorphism", "images"};
  return names[static_cast<std::size_t>(proof)];
}

PairComparison compare_pairs(const diagram::Diagram& x, const std::string& name_x, const diagram::Diagram& y,
                             const std::string& name_y, const PairOptions& options,
                             const Progress& progress) {
  require_no_trees(x, name_x);
  require_no_trees(y, name_y);
  PairComparison out;
  out.x.name = name_x;
  out.y.name = name_y;
  const auto a = exterior_of(x, options.seed, progress);
  const auto b = exterior_of(y, options.seed, progress);
  if (!a || !b) {
    out.reason = "the meridians of " + in_quotes(a ? name_y : name_x) +
                 " could not be followed to a small triangulation of its exterior";
    return out;
  }
  const CanonicalOptions how{options.attempts, options.seed, false};
  if (const auto no = differ_without_structure(a->tri, b->tri)) refuse_exteriors(out, *no);
  const MarkedCells cells_x = marked_cells_of(out.x, *a, how, progress);
  const MarkedCells cells_y = marked_cells_of(out.y, *b, how, progress);
  if (out.verdict != Verdict::undecided) return out;
  if (!cells_x.why_not.empty() || !cells_y.why_not.empty()) {
    out.reason = cells_x.why_not.empty() ? name_y + ": " + cells_y.why_not : name_x + ": " + cells_x.why_not;
    decide_without_cells(out, *a, *b, options.seed, progress);
    return out;
  }
  const Isometry exteriors = isometry({a->tri, name_x}, {b->tri, name_y}, how, progress);
  if (exteriors.verdict() == Verdict::proved_no)
    refuse_exteriors(out, exteriors.answer);
  else
    decide(out, cells_x, cells_y);
  return out;
}

std::string text_of(const PairComparison& found) {
  const char* const word = found.verdict == Verdict::yes         ? "equivalent"
                           : found.verdict == Verdict::proved_no ? "not equivalent"
                                                                 : "undecided";
  std::string text = std::string(word) + ": " + found.reason + "\n";
  Rows rows;
  if (found.verdict == Verdict::yes) {
    rows.emplace_back("as they are", yes_no(found.keeps_orientation));
    rows.emplace_back("as mirror images", yes_no(found.reverses_orientation));
  }
  add_rows(rows, found.x);
  if (found.y.name != found.x.name) add_rows(rows, found.y);
  return text + block(rows);
}

namespace {

Tree name_or_null(const std::string& name) {
  return name.empty() ? Tree() : Tree(name);
}

bool is_side_found(const PairSide& s) {
  return s.found;
}

} // namespace

template <>
const FieldList<PairSide>& fields_of<PairSide>() {
  using S = const PairSide&;
  static const FieldList<PairSide> fields{
      {{"name", "", "what was given", type::text}, [](S s) -> Tree { return s.name; }},
      {{"volume", "curvature -1", "of the exterior", type::number},
       [](S s) -> Tree { return s.volume; },
       is_side_found},
      {{"isometry_signature", "", "of the exterior", type::text},
       [](S s) -> Tree { return s.isometry_signature; },
       is_side_found},
      {{"exterior_group_order", "", "number of isometries of the exterior", type::integer},
       [](S s) -> Tree { return s.exterior_group_order; },
       is_side_found},
      {{"exterior_group", "", "their group; null: none of those known by name", type::or_null(type::text)},
       [](S s) { return name_or_null(s.exterior_group); },
       is_side_found},
      {{"exterior_amphichiral", "", "whether one of them reverses orientation", type::truth},
       [](S s) -> Tree { return s.exterior_amphichiral; },
       is_side_found},
      {{"group_order", "", "number of those that extend over what was drilled: the symmetry group",
        type::integer},
       [](S s) -> Tree { return s.group_order; },
       is_side_found},
      {{"group", "", "its name; null: none of those known", type::or_null(type::text)},
       [](S s) { return name_or_null(s.group); },
       is_side_found},
      {{"amphichiral", "", "whether a symmetry reverses the orientation of space", type::truth},
       [](S s) -> Tree { return s.amphichiral; },
       is_side_found}};
  return fields;
}

template <>
const FieldList<PairComparison>& fields_of<PairComparison>() {
  using P = const PairComparison&;
  static const FieldList<PairComparison> fields{
      {{"equivalent", "", "with --pair: true or false, both proved; null: undecided",
        type::or_null(type::truth)},
       [](P p) { return p.verdict == Verdict::undecided ? Tree() : Tree(p.verdict == Verdict::yes); }},
      {{"reason", "", "what decides, or what is missing", type::text}, [](P p) -> Tree { return p.reason; }},
      {{"proof", "", "which kind of proof; null: undecided", type::or_null(type::text)},
       [](P p) { return p.verdict == Verdict::undecided ? Tree() : Tree(to_string(p.proof)); }},
      {{"exteriors_homeomorphic", "", "with --pair: true or false; null: undecided",
        type::or_null(type::truth)},
       [](P p) { return p.exteriors ? Tree(*p.exteriors) : Tree(); }},
      {{"isometries", "", "with --pair: number of isometries between the exteriors", type::integer},
       [](P p) -> Tree { return p.isometries; }},
      {{"extending", "", "with --pair: how many of them extend over what was drilled", type::integer},
       [](P p) -> Tree { return p.extending; }},
      {{"keeps_orientation", "", "with --pair: whether one that extends keeps the orientation of space",
        type::truth},
       [](P p) -> Tree { return p.keeps_orientation; }},
      {{"reverses_orientation", "", "with --pair: whether one that extends reverses it", type::truth},
       [](P p) -> Tree { return p.reverses_orientation; }},
      {{"x", "",
        "with --pair, of the first: volume, isometry_signature, exterior_group and group (name and order), "
        "exterior_amphichiral and amphichiral, where its cells were found",
        Type(schema_of(notes_of<PairSide>()))},
       [](P p) { return tree_of(p.x); }},
      {{"y", "", "with --pair: the same of the second", Type(schema_of(notes_of<PairSide>()))},
       [](P p) { return tree_of(p.y); }}};
  return fields;
}

std::vector<FieldNote> notes_with_pairs() {
  return either_of(notes_of<Isometry>(), notes_of<PairComparison>());
}

} // namespace tetrarch::workshop
