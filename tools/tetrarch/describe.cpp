// SPDX-License-Identifier: GPL-2.0-or-later
#include "describe.hpp"

#include "parse.hpp"
#include "schema.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/workshop/nearest.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

constexpr const char* summary = "Tetrarch: a combinatorial topology engine for triangulated 3-manifolds.";
constexpr const char* common_group = "Common options";

/// The words that may follow `before` ("" or "census "), each once.
std::vector<std::string> words_after(const std::vector<Command>& table, const std::string& before) {
  std::vector<std::string> words;
  for (const Command& command : table) {
    const std::string name = command.name;
    if (!name.starts_with(before)) continue;
    const std::string rest = name.substr(before.size());
    const std::string word = rest.substr(0, rest.find(' '));
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

Json texts(const std::vector<std::string>& list) {
  Json json = Json::array();
  for (const std::string& text : list) json.push_back(text);
  return json;
}

Json option_json(const Option& option) {
  const std::string fallback = option.default_text();
  Json json;
  json["names"] = texts(option.names);
  json["value"] = option.is_flag() ? Json() : Json(option.type());
  json["help"] = option.help;
  json["default"] = fallback.empty() ? Json() : Json(fallback);
  json["choices"] = texts(option.choices);
  json["required"] = option.is_required;
  json["repeats"] = option.repeats();
  json["words"] = option.words;
  json["optional_value"] = !option.implied.empty();
  return json;
}

Json argument_json(const Option& option) {
  return {{"name", option.names.front()},
          {"help", option.help},
          {"required", option.is_required},
          {"repeats", option.repeats()}};
}

Json field_json(const workshop::FieldNote& field) {
  return {{"name", field.name},
          {"unit", field.unit},
          {"meaning", field.meaning},
          {"always", field.always},
          {"schema", field.type.schema()}};
}

Json fields_json(const std::vector<workshop::FieldNote>& fields) {
  Json list = Json::array();
  for (const workshop::FieldNote& field : fields) list.push_back(field_json(field));
  return list;
}

Json command_json(const Declared& declared, const std::string& program) {
  const Command& command = *declared.command;
  Json json{{"name", command.name},       {"group", command.group},
            {"summary", command.summary}, {"example", program + command.example},
            {"arguments", Json::array()}, {"options", Json::array()}};
  for (const Option& option : declared.options.options()) {
    if (option.is_argument())
      json["arguments"].push_back(argument_json(option));
    else if (option.group != common_group)
      json["options"].push_back(option_json(option));
  }
  if (command.fields != nullptr) json["result"] = fields_json(command.fields());
  return json;
}

Json common_json() {
  Json list = Json::array();
  Common common;
  OptionTable table;
  declare_common(table, common);
  for (const Option& option : table.options()) list.push_back(option_json(option));
  return list;
}

Json exit_statuses() {
  constexpr std::array<std::pair<Status, const char*>, 6> meanings{
      {{Status::done, "done"},
       {Status::proved_no, "the mathematical answer is a proved no"},
       {Status::bad_input, "bad usage or bad input"},
       {Status::fault, "a fault of the program"},
       {Status::undecided, "undecided within the budget"},
       {Status::interrupted, "interrupted"}}};
  Json list = Json::array();
  for (const auto& [status, meaning] : meanings)
    list.push_back({{"status", static_cast<int>(status)}, {"meaning", meaning}});
  return list;
}

Result schema(const std::vector<Command>& table, const Named& found) {
  if (found.command == nullptr && !found.name.empty())
    throw InputError("'" + found.name + "' is a group of commands (expected one of them)", Cause::option);
  Result result;
  result.json = found.command == nullptr ? schemas_of(table) : schema_of(*found.command);
  result.text = result.json.dump(2) + "\n";
  result.is_file = true;
  return result;
}

struct HelpArguments {
  std::vector<std::string> words;
  bool schema = false;
};

Result help(const Context& context, const HelpArguments& options) {
  const std::vector<Command>& table = *context.commands;
  const std::vector<std::string>& words = options.words;
  const Named found = named_command(table, words);
  if (found.words < words.size())
    throw InputError("unknown command '" + found.name + " " + words[found.words] + "'", Cause::option);
  if (options.schema) return schema(table, found);
  Result result;
  result.text = found.command == nullptr ? overview(table, found.name, context.program)
                                         : help_page(*found.command, context.program);
  result.json = describe(table, context.program);
  return result;
}

} // namespace

Named named_command(const std::vector<Command>& table, const std::vector<std::string>& words) {
  Named at;
  for (; at.words < words.size() && at.command == nullptr; ++at.words) {
    const std::string& word = words[at.words];
    if (word.starts_with("-")) break;
    std::string name = at.name.empty() ? "" : at.name + " ";
    const std::vector<std::string> expected = words_after(table, name);
    name += word;
    if (std::find(expected.begin(), expected.end(), word) == expected.end())
      throw InputError("unknown command '" + name + "'" + workshop::did_you_mean(word, expected),
                       Cause::option);
    at.name = std::move(name);
    const auto found =
        std::find_if(table.begin(), table.end(), [&at](const Command& c) { return c.name == at.name; });
    if (found != table.end()) at.command = &*found;
  }
  return at;
}

void declare_common(OptionTable& table, Common& common) {
  constexpr int most_threads = 256;
  table.add("--json", common.json, "print one JSON object on standard output and nothing else").group =
      common_group;
  table.add("--quiet", common.quiet, "print no warnings and no progress").group = common_group;
  table.add("--seed", common.seed, "seed of every random choice").with_default().group = common_group;
  table
      .add("--threads", common.threads,
           "number of threads (default: all cores); the results do not depend on it")
      .in_range(1, most_threads)
      .group = common_group;
  table
      .add("--memory", common.memory,
           "greatest memory to use, in gigabytes (default: nine tenths of the machine's; 4 for what is "
           "estimated beforehand)")
      .positive()
      .value_name("GB")
      .group = common_group;
}

std::vector<Declared> declared(const std::vector<Command>& table) {
  std::vector<Declared> list;
  for (const Command& command : table) {
    Declared& made = list.emplace_back(Declared{&command, {}, {}});
    const auto common = std::make_shared<Common>();
    made.run = [common, run = command.declare(made.options)](const Context& context) { return run(context); };
    declare_common(made.options, *common);
  }
  return list;
}

std::string overview(const std::vector<Command>& table, const std::string& name, const std::string& program) {
  const std::string start = program.empty() ? "" : program + " ";
  const std::string kind = program.empty() ? "VERB" : "COMMAND";
  const std::string before = name.empty() ? "" : name + " ";
  std::string text = std::string(summary) + "\n\nUsage: " + start + before + kind + " [OPTIONS]\n";
  std::vector<std::string> groups;
  for (const Command& command : table)
    if (std::string(command.name).starts_with(before) &&
        std::find(groups.begin(), groups.end(), command.group) == groups.end())
      groups.emplace_back(command.group);
  for (const std::string& group : groups) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Command& command : table)
      if (command.group == group && std::string(command.name).starts_with(before))
        rows.emplace_back("  " + std::string(command.name), command.summary);
    text += "\n" + group + "\n" + block(rows);
  }
  text += "\n'" + start + "help " + before + kind + "' explains one" +
          (program.empty() ? ".\n" : "; '" + start + "--version' tells the version.\n");
  if (name.empty())
    text +=
        "A triangulation is a file, - for standard input, an isomorphism signature, or a census name.\n"
        "Exit status: 0 done, 1 proved no, 2 bad usage or input, 3 fault of the program, 4 undecided, 130 "
        "interrupted.\n";
  return text;
}

Json describe(const std::vector<Command>& table, const std::string& program) {
  const std::string start = program.empty() ? "" : program + " ";
  Json json{{"program", "tetrarch"},
            {"version", TETRARCH_VERSION},
            {"summary", summary},
            {"commands", Json::array()},
            {"common", common_json()},
            {"common_result", fields_json(common_notes())},
            {"exit_status", exit_statuses()}};
  for (const Declared& command : declared(table)) json["commands"].push_back(command_json(command, start));
  return json;
}

std::vector<std::string> first_words(const std::vector<Command>& table) {
  return words_after(table, "");
}

Run declare_help(OptionTable& table) {
  const auto options = std::make_shared<HelpArguments>();
  table.add("COMMAND", options->words, "the command to explain (default: list all commands)");
  table.add("--schema", options->schema,
            "print the JSON Schema of what the command prints with --json (default: those of all commands, "
            "and of errors)");
  return [options](const Context& context) { return help(context, *options); };
}

} // namespace tetrarch::program
