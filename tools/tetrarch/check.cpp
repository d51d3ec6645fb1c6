// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/mesh/boundary_loops.hpp"
#include "tetrarch/mesh/boundary_surface.hpp"
#include "tetrarch/mesh/quality.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/validate_surface.hpp"
#include "tetrarch/mesh/weld.hpp"

#include <array>
#include <memory>

namespace tetrarch::program {
namespace {

struct CheckArguments {
  std::string input;
  std::string output;
  int listed = 10;
  Doctor doctor;
};

/// How many of the worst elements are told by their numbers.
constexpr int most_worst = 10;

const char* severity_word(mesh::Severity severity) {
  switch (severity) {
  case mesh::Severity::fatal:
    return "fatal";
  case mesh::Severity::repairable:
    return "repairable";
  case mesh::Severity::remark:
    return "remark";
  }
  return "";
}

Json findings_json(const mesh::Report& report) {
  Json list = Json::array();
  for (const mesh::Finding& f : report.findings)
    list.push_back({{"kind", mesh::name_of(f.kind)},
                    {"severity", severity_word(mesh::severity_of(f.kind))},
                    {"number", f.number},
                    {"line", f.line},
                    {"text", f.text}});
  return list;
}

/// One line a finding, then what was left out of each kind.
std::string findings_text(const mesh::Report& report, const format::Soup& soup) {
  std::string text;
  std::array<std::int64_t, mesh::kind_count> listed{};
  for (const mesh::Finding& f : report.findings) {
    const Place place = mesh::place_of(f, soup);
    text += place.source + (place.line > 0 ? ":" + std::to_string(place.line) : "") + ": " +
            severity_word(mesh::severity_of(f.kind)) + ": " + f.text + "\n";
    ++listed[static_cast<std::size_t>(f.kind)];
  }
  for (int k = 0; k < mesh::kind_count; ++k) {
    const auto kind = static_cast<mesh::Kind>(k);
    const std::int64_t left_out = report.count(kind) - listed[static_cast<std::size_t>(k)];
    if (left_out > 0)
      text +=
          "and " + std::to_string(left_out) + " more of the kind " + std::string(mesh::name_of(kind)) + "\n";
  }
  return text;
}

/// The types of the parts of a surface.
std::vector<SurfaceType> types_of(const mesh::Surface& surface) {
  std::vector<SurfaceType> types;
  for (const mesh::Part& part : mesh::split(surface, mesh::parts(surface)))
    types.push_back(mesh::type_of(part.surface));
  return types;
}

/// Adds what a surface without fatal findings is; returns whether it is closed and orientable, so that it
/// encloses a volume. What can be mended is taken as mended: of duplicates and the like there is no type.
/// Vertices are counted from 0, so that v17 asks for the same loop elsewhere.
bool describe_surface(Result& result, const format::Soup& found) {
  format::Soup soup = mesh::repair(found).soup;
  const auto vertices = static_cast<int>(soup.points.size());
  const mesh::TriangleMesh mesh{std::move(soup.points), mesh::Surface(vertices, std::move(soup.triangles))};
  const std::vector<SurfaceType> types = types_of(mesh.surface);
  const auto components = static_cast<int>(types.size());
  result.json["components"] = components;
  bool encloses = true;
  Json genera = Json::array();
  for (const SurfaceType& type : types) {
    encloses = encloses && type.is_closed() && type.orientable;
    genera.push_back(type.genus());
  }
  result.json["genus"] = components == 1 ? genera.front() : Json();
  result.json["component_genera"] = std::move(genera);
  result.json["type"] = components == 1 ? Json(types.front().str()) : Json();
  result.text += components == 1 ? types.front().str() + "\n" : counted(components, "component") + "\n";
  Json list = Json::array();
  for (const mesh::BoundaryLoop& loop : mesh::boundary_loops(mesh)) {
    Json names = Json::array();
    for (const mesh::SideEnd e : loop.sides)
      names.push_back(format::point_number(soup, mesh.surface.vertex(e)) - soup.first_number);
    const std::size_t index = list.size();
    result.text += "boundary loop " + std::to_string(index) + ": " +
                   counted(static_cast<long long>(names.size()), "edge") + ", length " +
                   rounded(loop.length) + ", area " + rounded(loop.area) + ", through v" +
                   names.front().dump() + "\n";
    list.push_back({{"index", index}, {"length", loop.length}, {"area", loop.area}, {"vertices", names}});
  }
  result.json["boundary_loops"] = std::move(list);
  return encloses;
}

Json counts_json(const mesh::Report& report) {
  Json counts = Json::object();
  for (int k = 0; k < mesh::kind_count; ++k) {
    const auto kind = static_cast<mesh::Kind>(k);
    if (report.count(kind) > 0) counts[std::string(mesh::name_of(kind))] = report.count(kind);
  }
  return counts;
}

Json point_json(const std::array<double, 3>& p) {
  Json list = Json::array();
  for (const double x : p) list.push_back(x);
  return list;
}

std::string point_text(const std::array<double, 3>& p) {
  return "(" + rounded(p[0]) + ", " + rounded(p[1]) + ", " + rounded(p[2]) + ")";
}

/// Adds box, volume, area and quality. Indices are in range and points finite.
void describe_size(Result& result, const format::Soup& soup, bool encloses, int listed) {
  const bool is_surface = soup.tetrahedra.empty();
  const mesh::Extent extent = mesh::extent(soup);
  const mesh::Quality quality = mesh::quality(soup, listed);
  result.json["box"] = {{"least", point_json(extent.least)}, {"greatest", point_json(extent.greatest)}};
  result.json["volume"] = is_surface && !encloses ? Json() : Json(extent.volume);
  if (is_surface) result.json["area"] = extent.area;
  const std::string angles = is_surface ? "angles" : "dihedral angles";
  result.text += "box " + point_text(extent.least) + " to " + point_text(extent.greatest) + ", " +
                 (is_surface ? "area " + rounded(extent.area) : "volume " + rounded(extent.volume)) +
                 (is_surface && encloses ? ", volume " + rounded(extent.volume) : "") + "\n" + angles + " " +
                 rounded(quality.least_angle) + " to " + rounded(quality.greatest_angle) +
                 " degrees, least scaled Jacobian " + rounded(quality.least_scaled_jacobian) + "\n";
  Json worst = Json::array();
  const format::Labels& labels = is_surface ? soup.triangle_labels : soup.tetrahedron_labels;
  for (const mesh::ElementQuality& one : quality.worst) {
    const long long number = labels.number(one.element, soup.first_number);
    worst.push_back({{"number", number},
                     {"least_angle", one.least_angle},
                     {"greatest_angle", one.greatest_angle},
                     {"scaled_jacobian", one.scaled_jacobian}});
  }
  result.json["quality"] = {{"least_angle", quality.least_angle},
                            {"greatest_angle", quality.greatest_angle},
                            {"least_scaled_jacobian", quality.least_scaled_jacobian},
                            {"worst", std::move(worst)}};
  constexpr double poor = 0.1; // a sliver, or nearly; fewer than all are worth a line
  std::string bad;
  for (const mesh::ElementQuality& one : quality.worst)
    if (one.scaled_jacobian < poor)
      bad += (bad.empty() ? "" : ", ") + std::to_string(labels.number(one.element, soup.first_number)) +
             " (" + rounded(one.least_angle) + ")";
  if (!bad.empty())
    result.text += "worst " + std::string(is_surface ? "triangles" : "tetrahedra") +
                   " (least angle in degrees): " + bad + "\n";
}

/// Whether nothing stops measuring: every index in range, every point finite.
bool is_measurable(const mesh::Report& report) {
  return report.count(mesh::Kind::not_finite) == 0 && report.count(mesh::Kind::index_out_of_range) == 0;
}

/// Adds what surfaces bound a solid without fatal findings.
void describe_boundary(Result& result, const format::Soup& solid) {
  const format::Soup boundary = mesh::repair(mesh::boundary_surface(solid)).soup;
  const mesh::Report report = mesh::validate_surface(boundary, 1);
  if (report.count(mesh::Severity::fatal) > 0) return;
  const auto vertices = static_cast<int>(boundary.points.size());
  Json types = Json::array();
  std::vector<std::string> names;
  constexpr std::size_t most_named = 20;
  for (const SurfaceType& type : types_of(mesh::Surface(vertices, boundary.triangles))) {
    types.push_back({{"type", type.str()}, {"genus", type.genus()}});
    if (names.size() < most_named) names.push_back(type.str());
  }
  if (types.size() > names.size())
    names.push_back("and " + std::to_string(types.size() - names.size()) + " more");
  result.json["boundary"] = std::move(types);
  result.json["components"] = mesh::component_count(solid);
  result.text += "boundary: " + (names.empty() ? "none" : joined(names, ", ")) + "\n";
}

Result check(const CheckArguments& options, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  const bool is_surface = soup.tetrahedra.empty() && !soup.triangles.empty();
  Result result;
  Json repairs = Json::array();
  for (const std::string& done : mend(soup, options.doctor)) {
    repairs.push_back(done);
    result.text += "repaired: " + done + "\n";
  }
  const mesh::Report report =
      is_surface ? mesh::validate_surface(soup, options.listed) : mesh::validate(soup, options.listed);
  const bool good = report.count(mesh::Severity::fatal) == 0;
  result.status = good ? Status::done : Status::proved_no;
  const std::size_t elements = is_surface ? soup.triangles.size() : soup.tetrahedra.size();
  result.json = {{is_surface ? "triangles" : "tetrahedra", elements},
                 {"vertices", soup.points.size()},
                 {"fatal", report.count(mesh::Severity::fatal)},
                 {"counts", counts_json(report)},
                 {"findings", findings_json(report)},
                 {"repairs", std::move(repairs)}};
  result.text += findings_text(report, soup) +
                 counted(static_cast<long long>(elements), is_surface ? "triangle" : "tetrahedron") + " on " +
                 counted(static_cast<long long>(soup.points.size()), "vertex") +
                 (good ? ": a manifold\n" : ": no manifold\n");
  bool encloses = false;
  if (is_surface && good) encloses = describe_surface(result, soup);
  if (!is_surface && good && elements > 0) describe_boundary(result, soup);
  if (elements > 0 && is_measurable(report)) describe_size(result, soup, encloses, most_worst);
  if (!options.output.empty()) {
    const auto format = format::mesh_format_for_extension(options.output);
    if (!format) throw InputError({options.output, 0}, "no mesh format has this extension");
    result.files.push_back({options.output, format::write_soup(soup, *format)});
  }
  result.value = std::make_shared<Value>(format::mesh_document_of(std::move(soup)));
  return result;
}

} // namespace

Run declare_check(OptionTable& table) {
  const auto options = std::make_shared<CheckArguments>();
  table.add("MESH", options->input, "a mesh of tetrahedra or a surface").required();
  table.add("--listed", options->listed, "number of findings of each kind to print in full")
      .in_range(0, 1'000'000)
      .with_default();
  declare_doctor(table, options->doctor);
  table.add("-o,--output", options->output, "write the mesh, repaired or not, in the format of the extension")
      .value_name("FILE");
  return [options](const Context& context) { return check(*options, context); };
}

} // namespace tetrarch::program
