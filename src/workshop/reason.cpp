// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/reason.hpp"

#include "tetrarch/workshop/text.hpp"

namespace tetrarch::workshop {
namespace {

using algebra::Word;
using reasons::GroupEvidence;
using reasons::SurfaceEvidence;

Tree words(const std::vector<Word>& list, int generators) {
  Tree tree = Tree::array();
  for (const Word& word : list) tree.push_back(algebra::word_str(word, generators));
  return tree;
}

Tree generators_named(const std::vector<int>& list, int generators) {
  Tree tree = Tree::array();
  for (const int g : list) tree.push_back(algebra::word_str({g + 1}, generators));
  return tree;
}

Tree tree_of_quotient(const reasons::Quotient& quotient) {
  if (quotient.cover)
    return {{"degree", quotient.cover->degree}, {"permutations", Tree(quotient.cover->sheet)}};
  return {{"homology_modulo", quotient.modulus}};
}

Tree tree_of_group(const GroupEvidence& seen) {
  const int n = seen.shown.generators;
  Tree tree{{"triangulation", seen.triangulation},
            {"presentation", seen.from.str()},
            {"images", words(seen.image, n)},
            {"shown", seen.shown.str()},
            {"generators", generators_named(seen.generators, n)},
            {"elements", words(seen.elements, n)},
            {"exponents", Tree::array()}};
  tree["exponents"].push_back(seen.p);
  tree["exponents"].push_back(seen.q);
  tree["finite_group"] = seen.quotient ? tree_of_quotient(*seen.quotient) : Tree();
  return tree;
}

Tree tree_of_surface(const SurfaceEvidence& seen) {
  return {{"triangulation", seen.triangulation}, {"coordinates", seen.coordinates}, {"euler", seen.euler},
          {"orientable", seen.orientable},       {"separating", seen.separating},   {"sides", seen.sides}};
}

std::string text_of_quotient(const reasons::Quotient& quotient) {
  if (!quotient.cover) return "first homology modulo " + std::to_string(quotient.modulus);
  std::vector<std::string> generators;
  for (std::size_t g = 0; g < quotient.cover->sheet.size(); ++g) {
    std::string images;
    for (const int p : quotient.cover->sheet[g]) images += (images.empty() ? "" : " ") + std::to_string(p);
    generators.push_back(
        algebra::word_str({static_cast<int>(g) + 1}, static_cast<int>(quotient.cover->sheet.size())) + ": " +
        images);
  }
  return "permutations " + joined(generators, ", ");
}

} // namespace

Tree tree_of(const reasons::Reason& reason) {
  return {{"kind", reasons::to_string(reason.kind)},
          {"text", reason.text},
          {"theorem", reason.theorem},
          {"in_double_cover", reason.in_double_cover},
          {"group", reason.group ? tree_of_group(*reason.group) : Tree()},
          {"surface", reason.surface ? tree_of_surface(*reason.surface) : Tree()}};
}

Type reason_type() {
  const Type words = type::list(type::text);
  const Type quotient = type::either(
      type::object({{"degree", type::integer}, {"permutations", type::list(type::list(type::integer))}}),
      type::object({{"homology_modulo", type::integer}}));
  const Type group = type::object({{"triangulation", type::text},
                                   {"presentation", type::text},
                                   {"images", words},
                                   {"shown", type::text},
                                   {"generators", words},
                                   {"elements", words},
                                   {"exponents", type::list(type::integer, 2)},
                                   {"finite_group", type::or_null(quotient)}});
  const Type surface = type::object({{"triangulation", type::text},
                                     {"coordinates", type::list(type::integer)},
                                     {"euler", type::integer},
                                     {"orientable", type::truth},
                                     {"separating", type::truth},
                                     {"sides", words}});
  return type::object({{"kind", type::text},
                       {"text", type::text},
                       {"theorem", type::text},
                       {"in_double_cover", type::truth},
                       {"group", type::or_null(group)},
                       {"surface", type::or_null(surface)}});
}

Rows rows_of(const reasons::Reason& reason) {
  Rows rows{{"reason", reason.text + (reason.in_double_cover ? ", in the orientable double cover" : "")}};
  if (reason.group) {
    rows.emplace_back("group", reason.group->shown.str());
    if (reason.group->quotient) rows.emplace_back("seen in", text_of_quotient(*reason.group->quotient));
  }
  if (reason.surface) {
    rows.emplace_back("surface", "in the triangulation " + reason.surface->triangulation);
    for (const std::string& side : reason.surface->sides) rows.emplace_back("side", side);
  }
  rows.emplace_back("theorem", reason.theorem);
  return rows;
}

} // namespace tetrarch::workshop
