// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/group_json.hpp"

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
    json["generator_faces"].push_back(
        {{"generator", algebra::word_str({static_cast<int>(g) + 1}, group.generators)},
         {"tetrahedron", located.faces[g].tet},
         {"face", located.faces[g].face}});
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const Json& group) {
  return {{"group", group["presentation"].text()},
          {"generators", std::to_string(group["generators"].size())},
          {"relators", std::to_string(group["relators"].size())},
          {"abelianized", group["abelianized"].text()}};
}

Result describe_groups(const std::string& input, bool as_given, const std::string& output,
                       const Context& context) {
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

fields::List fields::of_group() {
  namespace type = workshop::type;
  List one{{"presentation", "", "the group, as it is read", type::text},
           {"generators", "", "their letters", type::list(type::text)},
           {"relators", "", "words in them", type::list(type::text)},
           {"abelianized", "", "first homology", type::text},
           {"generator_faces", "",
            "of each generator of a triangulation's group: generator, and the tetrahedron and face that it "
            "crosses",
            type::list(type::object(
                {{"generator", type::text}, {"tetrahedron", type::integer}, {"face", type::integer}}))}};
  const workshop::FieldNote components{"components", "",
                                       "in place of all that, where there are several: the same of each",
                                       type::list(workshop::Type(workshop::schema_of(one))), false};
  return workshop::both_of(workshop::sometimes(std::move(one)), {components});
}

Run declare_group(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  const auto as_given = std::make_shared<bool>(false);
  const auto output = std::make_shared<std::string>();
  table.add("X", *input, "a triangulation or a mesh, or a presentation such as '< a, b | abAB >'").required();
  table.add("--as-given", *as_given, "print the presentation without simplification");
  table.add("-o,--output", *output, "write the presentation as JSON").output_file(with_extension(".json"));
  return [input, as_given, output](const Context& context) {
    return describe_groups(*input, *as_given, *output, context);
  };
}

} // namespace tetrarch::program
