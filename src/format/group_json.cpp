// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/group_json.hpp"

#include "json_members.hpp"
#include "json_text.hpp"
#include "json_tree.hpp"

#include <cstdlib>
#include <string>

namespace tetrarch::format {
namespace {

/// A name is made for each, so that a short file must not ask for more than fit into memory.
constexpr int most_generators = 4'000'000;

GroupDocument to_group(JsonTree tree) {
  GroupDocument group;
  group.generators =
      read_integer(required(tree.root, "generators"), {JsonStep("generators")}, 0, most_generators,
                   "the number of generators, 0 to " + std::to_string(most_generators));
  const std::string letter = "a letter, 1 to " + std::to_string(group.generators) + " or minus that";
  const auto read_letter = [&group, &letter](const Json& value, const JsonPath& path) {
    const int read = read_integer(value, path, -group.generators, group.generators, letter);
    if (read == 0) fail_found(path, value, letter);
    return read;
  };
  group.relators = take_list(required(tree.root, "relators"), {JsonStep("relators")}, std::nullopt, "words",
                             [&read_letter](Json& word, const JsonPath& path) {
                               return take_list(word, path, std::nullopt, "letters", read_letter);
                             });
  group.name = read_text(tree.root, "name");
  group.provenance = take_object(tree.root, "provenance");
  group.members = std::move(tree.root);
  return group;
}

} // namespace

GroupDocument read_group_json(std::string_view text, const std::string& source) {
  return read_tree(text, source, {group_json_format_tag, group_json_format_version}, to_group);
}

std::string write_group_json(const GroupDocument& group) {
  for (const std::vector<int>& word : group.relators)
    for (const int letter : word)
      if (letter == 0 || std::abs(static_cast<long long>(letter)) > group.generators)
        throw PreconditionError("the letter " + std::to_string(letter) + " names none of the " +
                                std::to_string(group.generators) + " generators");
  std::vector<JsonMember> members =
      first_members(group_json_format_tag, group_json_format_version, group.name);
  members.push_back({"generators", std::to_string(group.generators)});
  members.push_back({"relators", integer_rows_text(group.relators, 1).value_or("[]")});
  members.push_back(provenance_member(group.provenance));
  return object_text(group.members, std::move(members), 0) + "\n";
}

bool looks_like_group_json(std::string_view text) {
  return json_format_of(text) == group_json_format_tag;
}

} // namespace tetrarch::format
