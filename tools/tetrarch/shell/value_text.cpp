// SPDX-License-Identifier: GPL-2.0-or-later
#include "value_text.hpp"

#include "../command.hpp"
#include "../input.hpp"
#include "../text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/format/json.hpp"

namespace tetrarch::program {
namespace {

std::string summary_of(const format::Document& document) {
  return (document.name.empty() ? "" : document.name + ", ") + "triangulation of " +
         counted(document.triangulation.size(), "tetrahedron") +
         (document.metric ? ", with its metric" : "") +
         (document.canonical ? ", with its canonical cells" : "") +
         (document.bundle ? ", with fibre coordinates" : "");
}

std::string summary_of(const format::MeshDocument& mesh) {
  const auto several = [](std::size_t n, const char* noun) {
    return counted(static_cast<long long>(n), noun);
  };
  const format::Soup& soup = mesh.soup;
  std::string text = !mesh.hexahedra.empty()    ? "mesh of " + several(mesh.hexahedra.size(), "hexahedron")
                     : !soup.tetrahedra.empty() ? "mesh of " + several(soup.tetrahedra.size(), "tetrahedron")
                                                : "surface of " + several(soup.triangles.size(), "triangle");
  text += ", " + several(soup.points.size(), "vertex");
  std::vector<std::string> fields;
  fields.reserve(mesh.fields.size());
  for (const format::MeshField& field : mesh.fields) fields.push_back(field.name);
  return text + (fields.empty() ? "" : ", with " + joined(fields, ", "));
}

std::string summary_of(const format::GroupDocument& group) {
  return (group.name.empty() ? "" : group.name + ", ") + "group on " +
         counted(group.generators, "generator") + " with " +
         counted(static_cast<long long>(group.relators.size()), "relator");
}

/// A signature names a manifold's gluings up to isomorphism only.
bool is_said_by_signature(const format::Document& document) {
  const Triangulation& tri = document.triangulation;
  return document.name.empty() && !document.metric && !document.canonical && !document.bundle &&
         document.provenance.is_null() && document.members.is_null() && tri.size() > 0 &&
         Skeleton(tri).is_connected() && from_signature(signature(tri)) == tri;
}

std::string spelled_of(const format::Document& document) {
  if (is_said_by_signature(document)) return signature(document.triangulation);
  return Json::parse(format::write_json(document)).dump();
}

std::string spelled_of(const format::GroupDocument& group) {
  if (group.name.empty() && group.provenance.is_null() && group.members.is_null())
    return presentation_of(group).str();
  return Json::parse(write_group_json(group)).dump();
}

bool is_short(const format::MeshDocument& mesh) {
  return mesh.soup.points.size() <= 1000;
}

std::string spelled_of(const format::MeshDocument& mesh) {
  if (!is_short(mesh))
    throw InputError("a mesh of " + counted(static_cast<long long>(mesh.soup.points.size()), "vertex") +
                     " is too large to paste (convert NAME --to mesh -o FILE writes it)");
  return Json::parse(write_mesh_json(mesh)).dump();
}

} // namespace

std::string summary(const Value& value) {
  return std::visit([](const auto& held) { return summary_of(held); }, value);
}

bool can_be_spelled(const Value& value) {
  const auto* const mesh = std::get_if<format::MeshDocument>(&value);
  return mesh == nullptr || is_short(*mesh);
}

std::string spelled(const Value& value) {
  return std::visit([](const auto& held) { return spelled_of(held); }, value);
}

} // namespace tetrarch::program
