// SPDX-License-Identifier: GPL-2.0-or-later
#include "input.hpp"

#include "samples.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/workshop/info.hpp"

#include <optional>
#include <utility>

namespace tetrarch::program {
namespace {

template <class Named>
ValuePointer value_in(const Named* values, const std::string& name) {
  if (values == nullptr) return nullptr;
  const auto found = values->find(name);
  return found == values->end() ? nullptr : found->second;
}

/// Null: there is none of that name.
ValuePointer value_named(const std::string& name, const Context& context) {
  const ValuePointer value = value_in(context.values, name);
  return value ? value : value_in(context.passing, name);
}

/// The mesh of that name, if nobody else needs it.
std::optional<format::Soup> passing_soup(const std::string& name, const Context& context) {
  const ValuePointer value = value_in(context.passing, name);
  if (!value || !std::holds_alternative<format::MeshDocument>(*value)) return std::nullopt;
  return std::move(std::get<format::MeshDocument>(*context.passing->extract(name).mapped()).soup);
}

/// The argument as it was typed: `shielded` put a blank before it.
std::string bared(const std::string& argument) {
  return argument.starts_with(" -") ? argument.substr(1) : argument;
}

workshop::OpenOptions opened_with(const Doctor& doctor) {
  return {doctor, samples_folder()};
}

} // namespace

format::Document triangulation_of(const std::string& name, const Value& value, const Context& context,
                                  const Doctor& doctor) {
  return workshop::triangulation_of(name, value, doctor, context.progress);
}

namespace {

format::Document read_with_marks(const std::string& argument, const Context& context, const Doctor& doctor) {
  const std::string given = bared(argument);
  context.reads->any = true;
  if (const ValuePointer value = value_named(given, context))
    return triangulation_of(given, *value, context, doctor);
  format::Document document = workshop::open_triangulation(given, opened_with(doctor), context.progress);
  context.reads->passed_over.add(document.passed_over);
  return document;
}

} // namespace

format::Document read_triangulation(const std::string& argument, const Context& context,
                                    const Doctor& doctor) {
  format::Document document = read_with_marks(argument, context, doctor);
  context.reads->passed_over.note("order of an edge, of which the underlying manifold has none",
                                  static_cast<std::int64_t>(document.marks.size()));
  document.marks.clear();
  return document;
}

format::Document read_marked_triangulation(const std::string& argument, const Context& context) {
  return read_with_marks(argument, context, {});
}

format::Soup read_soup(const std::string& argument, const Context& context) {
  context.reads->any = true;
  if (auto soup = passing_soup(argument, context)) return *std::move(soup);
  if (const ValuePointer value = value_named(argument, context)) {
    if (const auto* mesh = std::get_if<format::MeshDocument>(value.get())) return mesh->soup;
    throw InputError(argument + " is a " + kind_of(*value) + " (expected a mesh: it has no coordinates)",
                     Cause::kind);
  }
  format::Soup soup = workshop::open_mesh(argument, opened_with({}));
  context.reads->passed_over.add(soup.passed_over);
  return soup;
}

std::vector<LocatedGroup> read_groups(const std::string& argument, const Context& context, bool as_given) {
  const ValuePointer value = read_value(argument, context);
  if (const auto* held = std::get_if<format::GroupDocument>(value.get())) {
    if (as_given) return {{*held, {}}};
    return {
        {workshop::document_of(simplified(presentation_of(*held), {}, context.progress), held->name), {}}};
  }
  const format::Document document = triangulation_of(argument, *value, context);
  require_manifolds(document.triangulation, argument);
  return fundamental_groups(document.triangulation, as_given, context.progress);
}

std::vector<LocatedGroup> fundamental_groups(const Triangulation& tri, bool as_read,
                                             const Progress& progress) {
  std::vector<LocatedGroup> groups;
  for (workshop::ComponentGroup& found : workshop::fundamental_groups(tri, as_read, progress))
    groups.push_back({workshop::document_of(std::move(found.group)), std::move(found.faces)});
  return groups;
}

algebra::Presentation presentation_of(const format::GroupDocument& group) {
  return {group.generators, group.relators};
}

ValuePointer read_value(const std::string& argument, const Context& context) {
  const std::string given = bared(argument);
  context.reads->any = true;
  if (ValuePointer named = value_named(given, context)) return named;
  Value value = workshop::open(given, opened_with({}));
  if (const auto* document = std::get_if<format::Document>(&value))
    context.reads->passed_over.add(document->passed_over);
  else if (const auto* mesh = std::get_if<format::MeshDocument>(&value))
    context.reads->passed_over.add(mesh->soup.passed_over);
  return std::make_shared<Value>(std::move(value));
}

std::string shielded(const std::string& word) {
  return is_signature_with_dash(word) || word.starts_with("-#") ? " " + word : word;
}

} // namespace tetrarch::program
