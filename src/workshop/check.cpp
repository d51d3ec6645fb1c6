// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/check.hpp"

#include "tetrarch/doctor/boundary_surface.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/doctor/validate_surface.hpp"
#include "tetrarch/doctor/weld.hpp"
#include "tetrarch/surface/boundary_loops.hpp"
#include "tetrarch/workshop/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tetrarch::workshop {
namespace {

/// How many of the worst elements are told by their numbers.
constexpr int most_worst = 10;

/// The types of the parts of a surface.
std::vector<SurfaceType> types_of_parts(const surface::Surface& surface) {
  std::vector<SurfaceType> types;
  for (const surface::Part& part : surface::split(surface, surface::parts(surface)))
    types.push_back(surface::type_of(part.surface));
  return types;
}

/// Of duplicates and the like there is no type: they are mended first.
Diagnosis::Sheet sheet_of(const format::Soup& found) {
  format::Soup soup = doctor::repair(found).soup;
  const auto vertices = static_cast<int>(soup.points.size());
  const surface::TriangleMesh mesh{std::move(soup.points),
                                   surface::Surface(vertices, std::move(soup.triangles))};
  Diagnosis::Sheet sheet{types_of_parts(mesh.surface), {}};
  for (const surface::BoundaryLoop& loop : surface::boundary_loops(mesh)) {
    Diagnosis::Sheet::Loop& kept = sheet.loops.emplace_back();
    kept.length = loop.length;
    kept.area = loop.area;
    for (const surface::SideEnd e : loop.sides)
      kept.vertices.push_back(format::point_number(soup, mesh.surface.vertex(e)) - soup.first_number);
  }
  return sheet;
}

/// Nothing if the surfaces that bound the solid have fatal findings.
std::optional<Diagnosis::Hull> hull_of(const format::Soup& solid) {
  const format::Soup boundary = doctor::repair(doctor::boundary_surface(solid)).soup;
  if (doctor::validate_surface(boundary, 1).count(doctor::Severity::fatal) > 0) return std::nullopt;
  const auto vertices = static_cast<int>(boundary.points.size());
  return Diagnosis::Hull{types_of_parts(surface::Surface(vertices, boundary.triangles)),
                         doctor::component_count(solid)};
}

/// Whether nothing stops measuring: every index in range, every point finite.
bool is_measurable(const doctor::Report& report) {
  return report.count(doctor::Kind::not_finite) == 0 && report.count(doctor::Kind::index_out_of_range) == 0;
}

const char* severity_word(doctor::Severity severity) {
  switch (severity) {
  case doctor::Severity::fatal:
    return "fatal";
  case doctor::Severity::repairable:
    return "repairable";
  case doctor::Severity::remark:
    return "remark";
  }
  return "";
}

/// One line a finding, then what was left out of each kind.
std::string findings_text(const doctor::Report& report, const format::Soup& soup) {
  std::string text;
  std::array<std::int64_t, doctor::kind_count> listed{};
  for (const doctor::Finding& f : report.findings) {
    const Place place = doctor::place_of(f, soup);
    text += place.source + (place.line > 0 ? ":" + std::to_string(place.line) : "") + ": " +
            severity_word(doctor::severity_of(f.kind)) + ": " + f.text + "\n";
    ++listed[static_cast<std::size_t>(f.kind)];
  }
  for (int k = 0; k < doctor::kind_count; ++k) {
    const auto kind = static_cast<doctor::Kind>(k);
    const std::int64_t left_out = report.count(kind) - listed[static_cast<std::size_t>(k)];
    if (left_out > 0)
      text += "and " + std::to_string(left_out) + " more of the kind " + std::string(doctor::name_of(kind)) +
              "\n";
  }
  return text;
}

std::string sheet_text(const Diagnosis::Sheet& sheet) {
  std::string text = sheet.types.size() == 1
                         ? sheet.types.front().str()
                         : counted(static_cast<long long>(sheet.types.size()), "component");
  text += "\n";
  for (std::size_t k = 0; k < sheet.loops.size(); ++k) {
    const Diagnosis::Sheet::Loop& loop = sheet.loops[k];
    text += "boundary loop " + std::to_string(k) + ": " +
            counted(static_cast<long long>(loop.vertices.size()), "edge") + ", length " +
            rounded(loop.length) + ", area " + rounded(loop.area) + ", through v" +
            std::to_string(loop.vertices.front()) + "\n";
  }
  return text;
}

std::string hull_text(const Diagnosis::Hull& hull) {
  constexpr std::size_t most_named = 20;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(most_named, hull.types.size()); ++k)
    names.push_back(hull.types[k].str());
  if (hull.types.size() > names.size())
    names.push_back("and " + std::to_string(hull.types.size() - names.size()) + " more");
  return "boundary: " + (names.empty() ? "none" : joined(names, ", ")) + "\n";
}

std::string point_text(const std::array<double, 3>& p) {
  return "(" + rounded(p[0]) + ", " + rounded(p[1]) + ", " + rounded(p[2]) + ")";
}

const format::Labels& labels_of(const Diagnosis& d) {
  return d.is_surface ? d.soup.triangle_labels : d.soup.tetrahedron_labels;
}

/// The slivers among the worst elements; empty: none.
std::string slivers_text(const Diagnosis& d) {
  constexpr double poor = 0.1; // a sliver, or nearly; fewer than all are worth a line
  std::vector<std::string> bad;
  for (const doctor::ElementQuality& one : d.measures->quality.worst)
    if (one.scaled_jacobian < poor)
      bad.push_back(std::to_string(labels_of(d).number(one.element, d.soup.first_number)) + " (" +
                    rounded(one.least_angle) + ")");
  if (bad.empty()) return "";
  return "worst " + std::string(d.is_surface ? "triangles" : "tetrahedra") +
         " (least angle in degrees): " + joined(bad, ", ") + "\n";
}

std::string measures_text(const Diagnosis& d) {
  const auto& [extent, quality] = *d.measures;
  return "box " + point_text(extent.least) + " to " + point_text(extent.greatest) + ", " +
         (d.is_surface ? "area " + rounded(extent.area) : "volume " + rounded(extent.volume)) +
         (d.encloses() ? ", volume " + rounded(extent.volume) : "") + "\n" +
         (d.is_surface ? "angles " : "dihedral angles ") + rounded(quality.least_angle) + " to " +
         rounded(quality.greatest_angle) + " degrees, least scaled Jacobian " +
         rounded(quality.least_scaled_jacobian) + "\n" + slivers_text(d);
}

Tree findings_tree(const Diagnosis& d) {
  Tree list = Tree::array();
  for (const doctor::Finding& f : d.report.findings)
    list.push_back({{"kind", doctor::name_of(f.kind)},
                    {"severity", severity_word(doctor::severity_of(f.kind))},
                    {"number", f.number},
                    {"line", f.line},
                    {"text", f.text}});
  return list;
}

Tree counts_tree(const Diagnosis& d) {
  Tree counts = Tree::object();
  for (int k = 0; k < doctor::kind_count; ++k) {
    const auto kind = static_cast<doctor::Kind>(k);
    if (d.report.count(kind) > 0) counts[doctor::name_of(kind)] = d.report.count(kind);
  }
  return counts;
}

Tree hull_tree(const Diagnosis& d) {
  Tree list = Tree::array();
  for (const SurfaceType& type : d.hull->types)
    list.push_back({{"type", type.str()}, {"genus", type.genus()}});
  return list;
}

Tree genera_tree(const Diagnosis& d) {
  Tree list = Tree::array();
  for (const SurfaceType& type : d.sheet->types) list.push_back(type.genus());
  return list;
}

Tree loops_tree(const Diagnosis& d) {
  Tree list = Tree::array();
  for (const Diagnosis::Sheet::Loop& loop : d.sheet->loops)
    list.push_back(
        {{"index", list.size()}, {"length", loop.length}, {"area", loop.area}, {"vertices", loop.vertices}});
  return list;
}

Tree quality_tree(const Diagnosis& d) {
  const doctor::Quality& quality = d.measures->quality;
  Tree worst = Tree::array();
  for (const doctor::ElementQuality& one : quality.worst)
    worst.push_back({{"number", labels_of(d).number(one.element, d.soup.first_number)},
                     {"least_angle", one.least_angle},
                     {"greatest_angle", one.greatest_angle},
                     {"scaled_jacobian", one.scaled_jacobian}});
  return {{"least_angle", quality.least_angle},
          {"greatest_angle", quality.greatest_angle},
          {"least_scaled_jacobian", quality.least_scaled_jacobian},
          {"worst", std::move(worst)}};
}

Type quality_type() {
  const Type one = type::object({{"number", type::integer},
                                 {"least_angle", type::number},
                                 {"greatest_angle", type::number},
                                 {"scaled_jacobian", type::number}});
  return type::object({{"least_angle", type::number},
                       {"greatest_angle", type::number},
                       {"least_scaled_jacobian", type::number},
                       {"worst", type::list(one)}});
}

bool is_sheet(const Diagnosis& d) {
  return d.sheet.has_value();
}
bool is_measured(const Diagnosis& d) {
  return d.measures.has_value();
}

} // namespace

std::size_t Diagnosis::elements() const {
  return is_surface ? soup.triangles.size() : soup.tetrahedra.size();
}

bool Diagnosis::encloses() const {
  return sheet && std::all_of(sheet->types.begin(), sheet->types.end(),
                              [](const SurfaceType& type) { return type.is_closed() && type.orientable; });
}

Verdict Diagnosis::verdict() const {
  return report.count(doctor::Severity::fatal) == 0 ? Verdict::yes : Verdict::proved_no;
}

Diagnosis check(format::Soup soup, const CheckOptions& options) {
  Diagnosis d;
  d.is_surface = soup.tetrahedra.empty() && !soup.triangles.empty();
  d.repairs = mend(soup, options.doctor);
  d.soup = std::move(soup);
  d.report = d.is_surface ? doctor::validate_surface(d.soup, options.listed)
                          : doctor::validate(d.soup, options.listed);
  const bool good = d.verdict() == Verdict::yes;
  if (good && d.is_surface) d.sheet = sheet_of(d.soup);
  if (good && !d.is_surface) d.hull = hull_of(d.soup);
  if (d.elements() > 0 && is_measurable(d.report))
    d.measures = {doctor::extent(d.soup), doctor::quality(d.soup, most_worst)};
  return d;
}

std::string text_of(const Diagnosis& d) {
  std::string text;
  for (const std::string& done : d.repairs) text += "repaired: " + done + "\n";
  text += findings_text(d.report, d.soup) +
          counted(static_cast<long long>(d.elements()), d.is_surface ? "triangle" : "tetrahedron") + " on " +
          counted(static_cast<long long>(d.soup.points.size()), "vertex") +
          (d.verdict() == Verdict::yes ? ": a manifold\n" : ": no manifold\n");
  if (d.sheet) text += sheet_text(*d.sheet);
  if (d.hull) text += hull_text(*d.hull);
  if (d.measures) text += measures_text(d);
  return text;
}

template <>
const FieldList<Diagnosis>& fields_of<Diagnosis>() {
  using D = const Diagnosis&;
  static const FieldList<Diagnosis> fields{
      {{"triangles", "", "of a surface: number of triangles", type::integer},
       [](D d) -> Tree { return d.elements(); },
       [](D d) { return d.is_surface; }},
      {{"tetrahedra", "", "of a solid: number of tetrahedra", type::integer},
       [](D d) -> Tree { return d.elements(); },
       [](D d) { return !d.is_surface; }},
      {{"vertices", "", "number of vertices", type::integer},
       [](D d) -> Tree { return d.soup.points.size(); }},
      {{"fatal", "", "number of findings by which it is no manifold; 0: it is one", type::integer},
       [](D d) -> Tree { return d.report.count(doctor::Severity::fatal); }},
      {{"counts", "", "by kind, the number of findings", type::table(type::integer)}, counts_tree},
      {{"findings", "", "the first of each kind: kind, severity, number, line, text",
        type::list(type::object({{"kind", type::text},
                                 {"severity", type::one_of({"fatal", "repairable", "remark"})},
                                 {"number", type::integer},
                                 {"line", type::integer},
                                 {"text", type::text}}))},
       findings_tree},
      {{"repairs", "", "what was mended first, a sentence each", type::list(type::text)},
       [](D d) -> Tree { return d.repairs; }},
      {{"boundary", "", "of a solid: type and genus of each surface that bounds it",
        type::list(type::object({{"type", type::text}, {"genus", type::integer}}))},
       hull_tree,
       [](D d) { return d.hull.has_value(); }},
      {{"components", "", "number of components of a manifold", type::integer},
       [](D d) { return d.hull ? Tree(d.hull->components) : Tree(d.sheet->types.size()); },
       [](D d) { return d.hull || d.sheet; }},
      {{"genus", "", "of a surface; null: it has several components", type::or_null(type::integer)},
       [](D d) { return d.sheet->types.size() == 1 ? Tree(d.sheet->types.front().genus()) : Tree(); },
       is_sheet},
      {{"component_genera", "", "of a surface: the genus of each component", type::list(type::integer)},
       genera_tree,
       is_sheet},
      {{"type", "", "of a surface, such as \"torus\"; null: it has several components",
        type::or_null(type::text)},
       [](D d) { return d.sheet->types.size() == 1 ? Tree(d.sheet->types.front().str()) : Tree(); },
       is_sheet},
      {{"boundary_loops", "",
        "of a surface, by decreasing length: index, length, area, vertices (counted from 0)",
        type::list(type::object({{"index", type::integer},
                                 {"length", type::number},
                                 {"area", type::number},
                                 {"vertices", type::list(type::integer)}}))},
       loops_tree,
       is_sheet},
      {{"box", "", "least and greatest coordinates of the vertices in use",
        type::object({{"least", type::list(type::number, 3)}, {"greatest", type::list(type::number, 3)}})},
       [](D d) -> Tree {
         return {{"least", d.measures->extent.least}, {"greatest", d.measures->extent.greatest}};
       },
       is_measured},
      {{"volume", "", "signed; of a surface, what it encloses; null: it encloses nothing",
        type::or_null(type::number)},
       [](D d) { return d.is_surface && !d.encloses() ? Tree() : Tree(d.measures->extent.volume); },
       is_measured},
      {{"area", "", "of a surface", type::number},
       [](D d) -> Tree { return d.measures->extent.area; },
       [](D d) { return d.is_surface && d.measures; }},
      {{"quality", "degrees",
        "least_angle, greatest_angle, least_scaled_jacobian (a pure number, at most 1), and of the worst ten "
        "elements number, both angles and scaled_jacobian",
        quality_type()},
       quality_tree,
       is_measured}};
  return fields;
}

} // namespace tetrarch::workshop
