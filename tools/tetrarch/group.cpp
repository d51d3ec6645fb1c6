// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/format/group_json.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

Json words_json(const algebra::Presentation& group) {
  Json list = Json::array();
  for (const algebra::Word& r : group.relators) list.push_back(algebra::word_str(r, group.generators));
  return list;
}

Result describe_group(const std::string& input, bool as_given, const std::string& output,
                      const Context& context) {
  require_folder(output);
  format::GroupDocument document = read_group(input, context, as_given);
  const algebra::Presentation group = presentation_of(document);
  const std::string homology = abelianized(group).str();
  Result result;
  result.json["presentation"] = group.str();
  result.json["generators"] = Json::array();
  for (int g = 0; g < group.generators; ++g)
    result.json["generators"].push_back(algebra::word_str({g + 1}, group.generators));
  result.json["relators"] = words_json(group);
  result.json["abelianized"] = homology;
  result.text = block({{"group", group.str()},
                       {"generators", std::to_string(group.generators)},
                       {"relators", std::to_string(group.relators.size())},
                       {"abelianized", homology}});
  if (!output.empty()) result.files.push_back({output, write_group_json(document)});
  result.value = std::make_shared<Value>(std::move(document));
  return result;
}

} // namespace

Run declare_group(OptionTable& table) {
  const auto input = std::make_shared<std::string>();
  const auto as_given = std::make_shared<bool>(false);
  const auto output = std::make_shared<std::string>();
  table.add("X", *input, "a triangulation or a mesh, or a presentation such as '< a, b | abAB >'").required();
  table.add("--as-given", *as_given, "print the presentation without simplification");
  table.add("-o,--output", *output, "write the presentation as JSON").value_name("FILE");
  return [input, as_given, output](const Context& context) {
    return describe_group(*input, *as_given, *output, context);
  };
}

} // namespace tetrarch::program
