// SPDX-License-Identifier: GPL-2.0-or-later
#include "census.hpp"
#include "command.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/validate.hpp"

#include <chrono>
#include <memory>

namespace tetrarch::program {
namespace {

using catalogue::Validation;

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

Result run_validation(catalogue::TableKey key, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const Validation v = catalogue::validate(key, context.threads, context.progress);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Result result;
  result.json = validation_json(v, seconds);
  result.text = validation_text(v, seconds);
  if (!v.failures.empty()) result.status = Status::proved_no;
  return result;
}

} // namespace

fields::List fields::of_census_validate() {
  namespace type = workshop::type;
  return {{"tetrahedra", "", "of the table", type::integer},
          {"rebuilt", "", "whether it came out again, byte for byte", type::truth},
          {"manifolds", "", "number of manifolds", type::integer},
          {"distinct_volumes", "", "number of volumes", type::integer},
          {"single_edge", "", "manifolds with one edge class", type::integer},
          {"cusped", "", "manifolds with a cusp", type::integer},
          {"by_boundary", "", "manifolds by the genera of their boundary", type::table(type::integer)},
          {"volumes", "curvature -1",
           "each volume (decimal digits, as a text), and how many manifolds have it",
           type::list(type::object({{"volume", type::text}, {"manifolds", type::integer}}))},
          {"gluings", "", "number of gluings", type::integer},
          {"geometric_gluings", "", "those of them that carry a structure", type::integer},
          {"max_angle_error", "radians", "greatest difference of an angle solved again, by Newton's method",
           type::number},
          {"max_angle_error_flow", "radians", "the same by the flow", type::number},
          {"max_volume_error", "curvature -1", "greatest difference of a volume, by Newton's method",
           type::number},
          {"max_volume_error_flow", "curvature -1", "the same by the flow", type::number},
          {"failures", "", "what failed, a sentence each", type::list(type::text)},
          {"seconds", "seconds", "time taken", type::number}};
}

Run declare_census_validate(OptionTable& table) {
  const auto choice = std::make_shared<TableChoice>();
  add_table_choice(table, *choice, false);
  return [choice](const Context& context) { return run_validation(choice->key(), context); };
}

} // namespace tetrarch::program
