// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/info.hpp"

#include "with_info.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/workshop/text.hpp"

namespace tetrarch::workshop {
namespace {

Tree boundary_tree(const std::vector<BoundaryComponent>& components) {
  Tree list = Tree::array();
  for (const BoundaryComponent& b : components)
    list.push_back({{"kind", b.kind == BoundaryComponent::Kind::ideal ? "ideal" : "real"},
                    {"genus", b.type.genus()},
                    {"orientable", b.type.orientable},
                    {"euler", b.type.euler}});
  return list;
}

std::string boundary_text(const std::vector<BoundaryComponent>& components) {
  std::vector<std::string> items;
  items.reserve(components.size());
  for (const BoundaryComponent& b : components)
    items.push_back(b.type.str() + (b.kind == BoundaryComponent::Kind::ideal ? " (ideal)" : " (real)"));
  return items.empty() ? "none" : joined(items, ", ");
}

Tree group_tree(const algebra::Presentation& group) {
  Tree json{{"generators", Tree::array()}, {"relators", Tree::array()}};
  for (int g = 0; g < group.generators; ++g)
    json["generators"].push_back(algebra::word_str({g + 1}, group.generators));
  for (const algebra::Word& r : group.relators)
    json["relators"].push_back(algebra::word_str(r, group.generators));
  return json;
}

/// A presentation that a person can read, else its size.
std::string presentation_text(const algebra::Presentation& group) {
  constexpr std::size_t longest = 400;
  std::string text = group.str();
  if (text.size() <= longest) return text;
  return counted(group.generators, "generator") + ", " +
         counted(static_cast<long long>(group.relators.size()), "relator") + "; 'group' prints them";
}

std::vector<std::vector<int>> tetrahedra_of(const Components& parts, int count) {
  std::vector<std::vector<int>> numbers(static_cast<std::size_t>(parts.count));
  for (int t = 0; t < count; ++t) numbers[parts.of[t]].push_back(t);
  return numbers;
}

Tree null_unless(bool known, const std::string& text) {
  return known ? Tree(text) : Tree();
}

Tree groups_tree(const Info& i) {
  Tree list = Tree::array();
  for (const algebra::Presentation& group : i.groups) list.push_back(group_tree(group));
  return list;
}

Tree defects_tree(const Info& i) {
  Tree list = Tree::array();
  for (const Info::Defect& d : i.defects) list.push_back({{"name", d.name}, {"where", d.where}});
  return list;
}

} // namespace

std::vector<ComponentGroup> fundamental_groups(const Triangulation& tri, bool as_read,
                                               const Progress& progress) {
  const Components parts = components(tri);
  const auto numbers = tetrahedra_of(parts, tri.size());
  std::vector<ComponentGroup> groups;
  for (const Triangulation& part : split(tri, parts)) {
    const algebra::DualPresentation dual = algebra::dual_presentation(part, Skeleton(part));
    const std::vector<int>& number = numbers[groups.size()];
    ComponentGroup found;
    const auto add_face = [&](std::size_t g) {
      found.faces.push_back({number[dual.generator_face[g].tet], dual.generator_face[g].face});
    };
    if (as_read) {
      for (std::size_t g = 0; g < dual.generator_face.size(); ++g) add_face(g);
      found.group = dual.presentation;
    } else {
      algebra::Kept kept = simplified_keeping(dual.presentation, {}, progress);
      for (const int g : kept.generator) add_face(static_cast<std::size_t>(g));
      found.group = std::move(kept.presentation);
    }
    groups.push_back(std::move(found));
  }
  return groups;
}

Info info(const Triangulation& tri, const std::string& name, bool brief, const Progress& progress) {
  const Skeleton skeleton(tri);
  Info found;
  found.name = name;
  found.tetrahedra = tri.size();
  found.faces = skeleton.face_count();
  found.edges = skeleton.edge_count();
  found.vertices = skeleton.vertex_count();
  found.components = skeleton.component_count();
  found.orientable = skeleton.is_orientable();
  for (const tetrarch::Defect& d : check(skeleton))
    found.defects.push_back({d.name(), describe(d, skeleton)});
  found.boundary = boundary_components(tri, skeleton);
  if (found.valid()) found.homology = algebra::homology(tri, skeleton, 1).str();
  if (!brief && found.valid() && tri.size() > 0)
    for (ComponentGroup& component : fundamental_groups(tri, false, progress))
      found.groups.push_back(std::move(component.group));
  if (!brief) found.signature = signature(tri);
  return found;
}

Rows rows_of(const Info& i, const std::string& signature) {
  Rows rows;
  if (!i.name.empty()) rows.emplace_back("name", i.name);
  rows.insert(rows.end(), {{"tetrahedra", std::to_string(i.tetrahedra)},
                           {"faces", std::to_string(i.faces)},
                           {"edges", std::to_string(i.edges)},
                           {"vertices", std::to_string(i.vertices)},
                           {"valid", i.valid() ? "yes" : "no"}});
  for (const Info::Defect& d : i.defects) rows.emplace_back("", d.where);
  rows.emplace_back("orientable", i.orientable ? "yes" : "no");
  if (i.components > 1) rows.emplace_back("components", std::to_string(i.components));
  rows.emplace_back("boundary", boundary_text(i.boundary));
  if (i.valid()) rows.emplace_back("homology", i.homology);
  for (std::size_t k = 0; k < i.groups.size(); ++k)
    rows.emplace_back(i.groups.size() == 1 ? "group" : "group " + std::to_string(k + 1),
                      presentation_text(i.groups[k]));
  if (!signature.empty()) rows.emplace_back("signature", signature);
  return rows;
}

template <>
const FieldList<Info>& fields_of<Info>() {
  using I = const Info&;
  static const FieldList<Info> fields{
      {{"name", "", "the name that it was given", type::text},
       [](I i) -> Tree { return i.name; },
       [](I i) { return !i.name.empty(); }},
      {{"tetrahedra", "", "number of tetrahedra", type::integer}, [](I i) -> Tree { return i.tetrahedra; }},
      {{"faces", "", "number of face classes", type::integer}, [](I i) -> Tree { return i.faces; }},
      {{"edges", "", "number of edge classes", type::integer}, [](I i) -> Tree { return i.edges; }},
      {{"vertices", "", "number of vertex classes", type::integer}, [](I i) -> Tree { return i.vertices; }},
      {{"valid", "", "whether it is a manifold with ideal vertices", type::truth},
       [](I i) -> Tree { return i.valid(); }},
      {{"defects", "", "what keeps it from that: name, and where",
        type::list(type::object({{"name", type::text}, {"where", type::text}}))},
       defects_tree},
      {{"orientable", "", "whether it is orientable", type::truth}, [](I i) -> Tree { return i.orientable; }},
      {{"connected", "", "whether it is connected", type::truth},
       [](I i) -> Tree { return i.components <= 1; }},
      {{"signature", "", "isomorphism signature; null where it is left out", type::or_null(type::text)},
       [](I i) { return null_unless(!i.signature.empty(), i.signature); }},
      {{"homology", "", "first homology; null of one that is not valid", type::or_null(type::text)},
       [](I i) { return null_unless(i.valid(), i.homology); }},
      {{"boundary", "",
        "of each boundary component: ideal or real, genus, orientability, Euler characteristic",
        type::list(type::object({{"kind", type::one_of({"ideal", "real"})},
                                 {"genus", type::integer},
                                 {"orientable", type::truth},
                                 {"euler", type::integer}}))},
       [](I i) { return boundary_tree(i.boundary); }},
      {{"group", "", "a presentation of the fundamental group of a connected one; null where it is left out",
        type::or_null(group_type())},
       [](I i) { return i.groups.size() == 1 ? group_tree(i.groups.front()) : Tree(); }},
      {{"groups", "", "presentations of the components' fundamental groups", type::list(group_type())},
       groups_tree,
       [](I i) { return i.groups.size() > 1; }}};
  return fields;
}

} // namespace tetrarch::workshop
