// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/mesh/boundary_loops.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/validate_surface.hpp"

#include <array>
#include <memory>

namespace tetrarch::program {
namespace {

struct Options {
  std::string input;
  std::string output;
  int listed = 10;
  bool repair = false;
};

const char* word(mesh::Severity severity) {
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
                    {"severity", word(mesh::severity_of(f.kind))},
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
            word(mesh::severity_of(f.kind)) + ": " + f.text + "\n";
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

/// Adds what a surface without fatal findings is. What can be mended is taken as mended: of duplicates and
/// the like there is no type. Vertices are counted from 0, so that v17 asks for the same loop elsewhere.
void describe_surface(Result& result, const format::Soup& found) {
  format::Soup soup = mesh::repair(found).soup;
  const auto vertices = static_cast<int>(soup.points.size());
  const mesh::TriangleMesh mesh{std::move(soup.points), mesh::Surface(vertices, std::move(soup.triangles))};
  const int components = mesh::parts(mesh.surface).count;
  result.json["components"] = components;
  result.json["type"] = components == 1 ? Json(mesh::type_of(mesh.surface).str()) : Json();
  result.text +=
      components == 1 ? mesh::type_of(mesh.surface).str() + "\n" : counted(components, "component") + "\n";
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
}

Json counts_json(const mesh::Report& report) {
  Json counts = Json::object();
  for (int k = 0; k < mesh::kind_count; ++k) {
    const auto kind = static_cast<mesh::Kind>(k);
    if (report.count(kind) > 0) counts[std::string(mesh::name_of(kind))] = report.count(kind);
  }
  return counts;
}

Result check(const Options& options, const Context& context) {
  format::Soup soup = read_soup(options.input, context);
  const bool is_surface = soup.tetrahedra.empty() && !soup.triangles.empty();
  Result result;
  Json repairs = Json::array();
  if (options.repair) {
    mesh::Repaired repaired = mesh::repair(std::move(soup));
    soup = std::move(repaired.soup);
    for (const std::string& done : repaired.done) {
      repairs.push_back(done);
      result.text += "repaired: " + done + "\n";
    }
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
  if (is_surface && good) describe_surface(result, soup);
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
  const auto options = std::make_shared<Options>();
  table.add("MESH", options->input, "a mesh of tetrahedra or a surface").required();
  table.add("--listed", options->listed, "number of findings of each kind to print in full")
      .in_range(0, 1'000'000)
      .with_default();
  table.add("--repair", options->repair,
            "first repair the mesh: orientation, duplicates, unused vertices, degenerate triangles");
  table.add("-o,--output", options->output, "write the mesh, repaired or not, in the format of the extension")
      .value_name("FILE");
  return [options](const Context& context) { return check(*options, context); };
}

} // namespace tetrarch::program
