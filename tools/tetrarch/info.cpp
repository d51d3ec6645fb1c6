// SPDX-License-Identifier: GPL-2.0-or-later
#include "info.hpp"

#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/signature.hpp"

#include <CLI/CLI.hpp>
#include <memory>

namespace tetrarch::program {
namespace {

Json boundary_json(const std::vector<BoundaryComponent>& components) {
  Json list = Json::array();
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

Json defects_json(const std::vector<Defect>& defects, const Skeleton& skeleton) {
  Json list = Json::array();
  for (const Defect& d : defects) list.push_back({{"name", d.name()}, {"where", describe(d, skeleton)}});
  return list;
}

Json group_json(const algebra::Presentation& group) {
  Json json{{"generators", Json::array()}, {"relators", Json::array()}};
  for (int g = 0; g < group.generators; ++g)
    json["generators"].push_back(algebra::word_str({g + 1}, group.generators));
  for (const algebra::Word& r : group.relators)
    json["relators"].push_back(algebra::word_str(r, group.generators));
  return json;
}

/// A presentation that a person can read, else its size.
std::string group_text(const algebra::Presentation& group) {
  constexpr std::size_t longest = 400;
  std::string text = group.str();
  if (text.size() <= longest) return text;
  return counted(group.generators, "generator") + ", " +
         counted(static_cast<long long>(group.relators.size()), "relator") + "; 'group' prints them";
}

} // namespace

Info info_of(const Triangulation& tri, const std::string& name, const Progress& progress, bool brief) {
  const Skeleton skeleton(tri);
  const std::vector<Defect> defects = check(skeleton);
  const auto boundary = boundary_components(tri, skeleton);
  const bool valid = defects.empty();
  const bool has_groups = !brief && valid && tri.size() > 0;
  const std::string homology = valid ? algebra::homology(tri, skeleton, 1).str() : "";
  std::vector<algebra::Presentation> groups; // of the components
  if (has_groups)
    for (const LocatedGroup& located : fundamental_groups(tri, false, progress))
      groups.push_back(presentation_of(located.group));
  const std::string sig = brief ? "" : signature(tri);

  Info out;
  Json& j = out.json;
  if (!name.empty()) j["name"] = name;
  j["tetrahedra"] = tri.size();
  j["faces"] = skeleton.face_count();
  j["edges"] = skeleton.edge_count();
  j["vertices"] = skeleton.vertex_count();
  j["valid"] = valid;
  j["defects"] = defects_json(defects, skeleton);
  j["orientable"] = skeleton.is_orientable();
  j["connected"] = skeleton.is_connected();
  j["signature"] = brief ? Json() : Json(sig);
  j["homology"] = valid ? Json(homology) : Json();
  j["boundary"] = boundary_json(boundary);
  j["group"] = groups.size() == 1 ? group_json(groups.front()) : Json();
  if (groups.size() > 1)
    for (const algebra::Presentation& group : groups) j["groups"].push_back(group_json(group));

  auto& rows = out.rows;
  if (!name.empty()) rows.emplace_back("name", name);
  rows.insert(rows.end(), {{"tetrahedra", std::to_string(tri.size())},
                           {"faces", std::to_string(skeleton.face_count())},
                           {"edges", std::to_string(skeleton.edge_count())},
                           {"vertices", std::to_string(skeleton.vertex_count())},
                           {"valid", valid ? "yes" : "no"}});
  for (const Defect& d : defects) rows.emplace_back("", describe(d, skeleton));
  rows.emplace_back("orientable", skeleton.is_orientable() ? "yes" : "no");
  if (!skeleton.is_connected()) rows.emplace_back("components", std::to_string(skeleton.component_count()));
  rows.emplace_back("boundary", boundary_text(boundary));
  if (valid) rows.emplace_back("homology", homology);
  for (std::size_t k = 0; k < groups.size(); ++k)
    rows.emplace_back(groups.size() == 1 ? "group" : "group " + std::to_string(k + 1), group_text(groups[k]));
  if (!brief) rows.emplace_back("signature", sig);
  return out;
}

Run declare_info(CLI::App& app) {
  const auto input = std::make_shared<std::string>();
  app.add_option("X", *input, "a triangulation")->required();
  return [input](const Context& context) {
    const format::Document document = read_triangulation(*input, context);
    Info info = info_of(document.triangulation, document.name, context.progress);
    Result result;
    result.warnings = document.warnings;
    result.json = std::move(info.json);
    result.text = block(info.rows);
    return result;
  };
}

} // namespace tetrarch::program
