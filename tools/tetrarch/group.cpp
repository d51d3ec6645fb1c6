// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/group_json.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace tetrarch::program {
namespace {

Json words_json(const algebra::Presentation& group) {
  Json list = Json::array();
  for (const algebra::Word& r : group.relators) list.push_back(algebra::word_str(r, group.generators));
  return list;
}

/// The group, and which generator crosses which face.
Json group_json(const LocatedGroup& located) {
  const algebra::Presentation group = presentation_of(located.group);
  Json json{{"presentation", group.str()}, {"generators", Json::array()}};
  for (int g = 0; g < group.generators; ++g)
    json["generators"].push_back(algebra::word_str({g + 1}, group.generators));
  json["relators"] = words_json(group);
  json["abelianized"] = abelianized(group).str();
  json["generator_faces"] = Json::array();
  for (std::size_t g = 0; g < located.faces.size(); ++g)
    json["generator_faces"].push_back({{"generator", json["generators"][g]},
                                       {"tetrahedron", located.faces[g].tet},
                                       {"face", located.faces[g].face}});
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const Json& group) {
  return {{"group", group["presentation"]},
          {"generators", std::to_string(group["generators"].size())},
          {"relators", std::to_string(group["relators"].size())},
          {"abelianized", group["abelianized"]}};
}

Result describe_groups(const std::string& input, bool as_given, const std::string& output,
                       const Context& context) {
  require_folder(output);
  std::vector<LocatedGroup> groups = read_groups(input, context, as_given);
  if (groups.size() > 1 && !output.empty())
    throw InputError({input, 0}, "there are " + std::to_string(groups.size()) +
                                     " components, and a file holds one group");
  Result result;
  if (groups.size() == 1) {
    result.json = group_json(groups.front());
    result.text = block(rows_of(result.json));
    if (!output.empty()) result.files.push_back({output, write_group_json(groups.front().group)});
    result.value = std::make_shared<Value>(std::move(groups.front().group));
    return result;
  }
  result.json["components"] = Json::array();
  for (const LocatedGroup& group : groups) {
    result.json["components"].push_back(group_json(group));
    result.text += "component " + std::to_string(result.json["components"].size()) + "\n" +
                   block(rows_of(result.json["components"].back()));
  }
  return result;
}

} // namespace

Run declare_group(CLI::App& app) {
  const auto input = std::make_shared<std::string>();
  const auto as_given = std::make_shared<bool>(false);
  const auto output = std::make_shared<std::string>();
  app.add_option("X", *input, "a triangulation or mesh, or a presentation: '< a, b | abAB >'")->required();
  app.add_flag("--as-given", *as_given, "leave the presentation as it is read off, or as it stands");
  app.add_option("-o,--output", *output, "the presentation, as JSON")->type_name("FILE");
  return [input, as_given, output](const Context& context) {
    return describe_groups(*input, *as_given, *output, context);
  };
}

} // namespace tetrarch::program
