// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/validate.hpp"

#include <CLI/CLI.hpp>
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

Result check(const Options& options, const Context&) {
  format::Soup soup = format::read_soup_file(options.input);
  if (soup.tetrahedra.empty() && !soup.triangles.empty())
    throw InputError({options.input, 0}, "a surface: there are no tetrahedra to check");
  Result result;
  result.warnings = soup.warnings;
  Json repairs = Json::array();
  if (options.repair) {
    mesh::Repaired repaired = mesh::repair(std::move(soup));
    soup = std::move(repaired.soup);
    for (const std::string& done : repaired.done) {
      repairs.push_back(done);
      result.text += "repaired: " + done + "\n";
    }
  }
  const mesh::Report report = mesh::validate(soup, options.listed);
  const bool good = report.count(mesh::Severity::fatal) == 0;
  result.status = good ? Status::done : Status::proved_no;
  Json counts = Json::object();
  for (int k = 0; k < mesh::kind_count; ++k) {
    const auto kind = static_cast<mesh::Kind>(k);
    if (report.count(kind) > 0) counts[std::string(mesh::name_of(kind))] = report.count(kind);
  }
  result.json = {{"tetrahedra", soup.tetrahedra.size()},
                 {"vertices", soup.points.size()},
                 {"fatal", report.count(mesh::Severity::fatal)},
                 {"counts", std::move(counts)},
                 {"findings", findings_json(report)},
                 {"repairs", std::move(repairs)}};
  result.text += findings_text(report, soup) +
                 counted(static_cast<long long>(soup.tetrahedra.size()), "tetrahedron") + " on " +
                 counted(static_cast<long long>(soup.points.size()), "vertex") +
                 (good ? ": a manifold\n" : ": no manifold\n");
  if (!options.output.empty()) {
    const auto format = format::mesh_format_for_extension(options.output);
    if (!format) throw InputError({options.output, 0}, "no mesh format has this extension");
    result.files.push_back({options.output, format::write_soup(soup, *format)});
  }
  return result;
}

} // namespace

Run declare_check(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  app.add_option("MESH", options->input, "a mesh of tetrahedra")->required();
  app.add_option("--listed", options->listed, "so many findings of each kind are told in full")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  app.add_flag("--repair", options->repair, "mend orientation, unused vertices and duplicates first");
  app.add_option("-o,--output", options->output,
                 "write the mesh, repaired or not, in the format of the extension");
  return [options](const Context& context) { return check(*options, context); };
}

} // namespace tetrarch::program
