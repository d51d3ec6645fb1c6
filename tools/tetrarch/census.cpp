// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/format/text.hpp"

#include <chrono>
#include <memory>

namespace tetrarch::program {
namespace {

using catalogue::Manifold;
using catalogue::Validation;

Json manifold_json(const Manifold& m) {
  Json j{{"name", nullptr}, {"tetrahedra", m.tetrahedra}};
  j.update(Json::parse(json_text(m)));
  return j;
}

/// A stored volume rounded to twelve decimals.
std::string shortened(const std::string& volume) {
  constexpr int decimals = 12;
  return fixed(format::parse_double(volume).value_or(0), decimals);
}

Json validation_json(const Validation& v, double seconds) {
  Json j;
  j["tetrahedra"] = v.tetrahedra;
  j["rebuilt"] = v.rebuilt;
  j["manifolds"] = v.manifolds;
  j["distinct_volumes"] = v.volumes.size();
  j["single_edge"] = v.single_edge;
  j["cusped"] = v.cusped;
  j["by_boundary"] = Json::object();
  for (const auto& [boundary, n] : v.by_boundary) j["by_boundary"][boundary] = n;
  j["volumes"] = Json::array();
  for (const auto& volume : v.volumes)
    j["volumes"].push_back({{"volume", volume.volume}, {"manifolds", volume.manifolds}});
  j["gluings"] = v.tally.gluings;
  j["geometric_gluings"] = v.tally.geometric;
  j["max_angle_error"] = v.max_angle_error;
  j["max_angle_error_flow"] = v.max_angle_error_flow;
  j["max_volume_error"] = v.max_volume_error;
  j["max_volume_error_flow"] = v.max_volume_error_flow;
  j["failures"] = v.failures;
  j["seconds"] = seconds;
  return j;
}

std::string validation_text(const Validation& v, double seconds) {
  std::string text =
      "Census of " + std::to_string(v.tetrahedra) + (v.tetrahedra == 1 ? " tetrahedron\n" : " tetrahedra\n");
  text += "\nRebuilt from nothing: " + counted(v.tally.gluings, "gluing") + ", " +
          std::to_string(v.tally.geometric) + " geometric, " + counted(v.manifolds, "manifold") + "\n";
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [boundary, n] : v.by_boundary)
    rows.emplace_back("  boundary " + boundary, counted(n, "manifold"));
  rows.emplace_back("  one edge class", counted(v.single_edge, "manifold"));
  rows.emplace_back("  with a cusp", counted(v.cusped, "manifold"));
  rows.emplace_back("  the stored table",
                    v.rebuilt ? "came out again, byte for byte" : "DID NOT come out again");
  text += block(rows) + "\n" + counted(static_cast<long long>(v.volumes.size()), "volume") + ":\n";
  rows.clear();
  for (const auto& volume : v.volumes)
    rows.emplace_back("  " + shortened(volume.volume), counted(volume.manifolds, "manifold"));
  text += block(rows) + "\nSolved again from length 1, against the stored 30 digits:\n";
  text += block({{"  Newton", "worst angle error " + scientific(v.max_angle_error, 1) +
                                  ", worst volume error " + scientific(v.max_volume_error, 1)},
                 {"  flow", "worst angle error " + scientific(v.max_angle_error_flow, 1) +
                                ", worst volume error " + scientific(v.max_volume_error_flow, 1)}});
  text += "\n";
  for (const std::string& failure : v.failures) text += "FAILED  " + failure + "\n";
  return text + (v.failures.empty() ? "Nothing failed. " : "") + fixed(seconds, 2) + " seconds\n";
}

Result run_validation(int tetrahedra, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const Validation v = catalogue::validate(tetrahedra, context.threads, context.progress);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Result result;
  result.json = validation_json(v, seconds);
  result.text = validation_text(v, seconds);
  if (!v.failures.empty()) result.status = Status::proved_no;
  return result;
}

void add_tetrahedra(OptionTable& table, int& tetrahedra, bool required) {
  Option& option = table.add("--tetrahedra", tetrahedra, "number of tetrahedra")
                       .in_range(1, enumeration::max_gluing_tetrahedra);
  if (required)
    option.required();
  else
    option.with_default();
}

} // namespace

Run declare_census_gluings(OptionTable& table) {
  struct Options {
    enumeration::GluingOptions gluings;
    bool orientable = false;
    bool nonorientable = false;
    std::string links;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  add_tetrahedra(table, options->gluings.tetrahedra, true);
  table.add("--orientable", options->orientable, "only orientable gluings");
  table.add("--nonorientable", options->nonorientable, "only non-orientable gluings")
      .excludes("--orientable");
  table.add("--ideal", options->gluings.ideal, "only gluings with a vertex link other than a sphere");
  table
      .add("--links", options->links,
           "only gluings whose vertex links are in this list: genera (0 for the sphere), nK for K crosscaps")
      .value_name("LIST");
  table
      .add("--min-valence", options->gluings.min_valence,
           "only gluings whose edges have at least this valence")
      .in_range(1, 72);
  table.add("--allow-invalid", options->gluings.allow_invalid,
            "allow edges that are identified with themselves reversed");
  table.add("-o,--output", options->output, "write the signatures to this file").value_name("FILE");
  return [options](const Context& context) {
    using Orientability = enumeration::GluingOptions::Orientability;
    enumeration::GluingOptions gluings = options->gluings;
    gluings.threads = context.threads;
    if (options->orientable) gluings.orientability = Orientability::orientable;
    if (options->nonorientable) gluings.orientability = Orientability::nonorientable;
    if (!options->links.empty()) gluings.links = enumeration::parse_link_set(options->links);
    const std::vector<std::string> signatures = enumeration::gluing_signatures(gluings, context.progress);
    std::string lines;
    for (const std::string& s : signatures) lines += s + "\n";
    Result result;
    result.json = {{"count", signatures.size()}, {"signatures", signatures}};
    result.text = lines;
    if (!options->output.empty()) {
      result.text = counted(static_cast<long long>(signatures.size()), "gluing") + " written to " +
                    options->output + "\n";
      result.json.erase("signatures");
      result.files.push_back({options->output, lines});
    }
    return result;
  };
}

Run declare_census_enumerate(OptionTable& table) {
  const auto tetrahedra = std::make_shared<int>(3);
  const auto output = std::make_shared<std::string>();
  add_tetrahedra(table, *tetrahedra, true);
  table.add("-o,--output", *output, "write a census table to this file (the format of census/*.json)")
      .value_name("FILE");
  return [tetrahedra, output](const Context& context) {
    const auto found = catalogue::classify_manifolds(*tetrahedra, context.threads, context.progress);
    Result result;
    if (output->empty())
      for (const Manifold& m : found.manifolds) result.text += manifold_json(m).dump() + "\n";
    else {
      result.files.push_back({*output, catalogue::write_table(*tetrahedra, found.manifolds)});
      result.text = counted(static_cast<long long>(found.manifolds.size()), "manifold") + " written to " +
                    *output + "\n";
    }
    if (found.tally.stuck > 0)
      result.warnings.push_back(counted(found.tally.stuck, "structure") +
                                " left out for want of a canonical decomposition");
    if (found.tally.flat > 0)
      result.warnings.push_back(counted(found.tally.flat, "manifold") +
                                " with flat faces, distinguished by 60 digits and not by proof");
    return result;
  };
}

Run declare_census_validate(OptionTable& table) {
  const auto tetrahedra = std::make_shared<int>(3);
  add_tetrahedra(table, *tetrahedra, false);
  return [tetrahedra](const Context& context) { return run_validation(*tetrahedra, context); };
}

Run declare_census_list(OptionTable& table) {
  const auto tetrahedra = std::make_shared<int>(3);
  add_tetrahedra(table, *tetrahedra, false);
  return [tetrahedra](const Context&) {
    Result result;
    result.json = {{"tetrahedra", *tetrahedra}, {"manifolds", Json::array()}};
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Manifold& m : catalogue::require_table(*tetrahedra)) {
      result.json["manifolds"].push_back(manifold_json(m));
      rows.emplace_back(m.name, shortened(m.volume) + "  " + m.boundary_text() + "  " + m.homology + "  " +
                                    m.signature);
    }
    result.text = block(rows);
    return result;
  };
}

Run declare_census_show(OptionTable& table) {
  const auto name = std::make_shared<std::string>();
  table.add("NAME", *name, "a census name, such as fmp3_17").required();
  return [name](const Context&) {
    const auto found = catalogue::find_by_name(*name);
    if (!found) throw InputError("no census manifold is called " + in_quotes(*name));
    const Manifold& m = *found;
    Result result;
    result.json = manifold_json(m);
    std::vector<std::pair<std::string, std::string>> rows{
        {"name", m.name},
        {"tetrahedra", std::to_string(m.tetrahedra)},
        {"signature", m.signature},
        {"volume", m.volume},
        {"boundary", m.boundary_text()},
        {"edge classes", std::to_string(m.edges)},
        {"homology", m.homology},
        {"canonical cells", joined(m.cells, ", ")},
        {"isometry signature", m.canonical_signature},
        {"isometry group", "order " + std::to_string(m.symmetries)}};
    for (std::size_t t = 0; t < m.dihedral_angles.size(); ++t)
      for (int e = 0; e < 6; ++e)
        rows.emplace_back(e == 0 ? "angles " + std::to_string(t) : "", m.dihedral_angles[t][e]);
    result.text = block(rows);
    result.value = std::make_shared<Value>(format::document_of(from_signature(m.signature), m.name));
    return result;
  };
}

} // namespace tetrarch::program
