// SPDX-License-Identifier: GPL-2.0-or-later
#include "describe.hpp"

#include "nearest.hpp"

#include "tetrarch/core/error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

constexpr std::array common_names{"json", "quiet", "seed", "threads"};

bool is_common(const CLI::Option& option) {
  return std::any_of(common_names.begin(), common_names.end(),
                     [&option](const char* name) { return option.check_lname(name); });
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& apps) {
  std::vector<std::string> names;
  names.reserve(apps.size());
  for (const CLI::App* app : apps) names.push_back(app->get_name());
  return names;
}

std::vector<const CLI::App*> children(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* sub) { return !sub->get_name().empty(); });
}

/// "{newton,flow}" at the end of a type's name lists what is allowed.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', std::min(open, type.size()));
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

Json option_json(const CLI::Option& option) {
  Json json;
  Json names = Json::array();
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  const std::string type = option.get_type_name();
  const bool flag = option.get_expected_max() == 0;
  const std::string fallback = option.get_default_str();
  json["names"] = std::move(names);
  json["value"] = flag ? Json() : Json(type.substr(0, type.find(':')));
  json["help"] = option.get_description();
  json["default"] = fallback.empty() ? Json() : Json(fallback);
  json["choices"] = choices_of(option);
  json["required"] = option.get_required();
  json["repeats"] = option.get_expected_max() > 1;
  return json;
}

Json argument_json(const CLI::Option& option) {
  return {{"name", option.get_name(true)},
          {"help", option.get_description()},
          {"required", option.get_required()},
          {"repeats", option.get_expected_max() > 1}};
}

Json command_json(const std::string& name, const CLI::App& app) {
  const std::string footer = app.get_footer();
  const std::string heading = example_heading;
  Json json{{"name", name},
            {"summary", app.get_description()},
            {"example", footer.starts_with(heading) ? footer.substr(heading.size()) : ""},
            {"arguments", Json::array()},
            {"options", Json::array()}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional())
      json["arguments"].push_back(argument_json(*option));
    else if (!option->check_lname("help") && !is_common(*option))
      json["options"].push_back(option_json(*option));
  }
  return json;
}

void add_commands(Json& list, const CLI::App& app, const std::string& before) {
  for (const CLI::App* sub : children(app)) {
    const std::string name = before + sub->get_name();
    if (children(*sub).empty())
      list.push_back(command_json(name, *sub));
    else
      add_commands(list, *sub, name + " ");
  }
}

Json common_json(const CLI::App& app) {
  Json list = Json::array();
  for (const CLI::Option* option : app.get_options())
    if (is_common(*option)) list.push_back(option_json(*option));
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

Result help(const CLI::App& app, const std::vector<std::string>& words) {
  const Named found = named_command(app, words);
  if (found.words < words.size())
    throw InputError("unknown command '" + found.name + " " + words[found.words] + "'");
  std::string group = found.name.substr(0, found.name.rfind(' '));
  if (group == found.name) group.clear();
  const std::string program = app.get_name();
  Result result;
  result.text = found.app->help(found.app == &app ? "" : program + (group.empty() ? "" : " " + group));
  result.json = describe(app);
  return result;
}

} // namespace

CLI::App* child(const CLI::App& app, const std::string& name) {
  for (CLI::App* sub : const_cast<CLI::App&>(app).get_subcommands({}))
    if (sub->get_name() == name) return sub;
  return nullptr;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

Named named_command(const CLI::App& app, const std::vector<std::string>& words) {
  Named at{&app, "", 0};
  for (; at.words < words.size() && !children(*at.app).empty(); ++at.words) {
    const std::string& word = words[at.words];
    if (word.starts_with("-")) break;
    const CLI::App* next = child(*at.app, word);
    const std::string name = at.name.empty() ? word : at.name + " " + word;
    if (next == nullptr)
      throw InputError("unknown command '" + name + "'" + did_you_mean(word, names_of(children(*at.app))));
    at.name = name;
    at.app = next;
  }
  return at;
}

Json describe(const CLI::App& app) {
  Json json{{"program", "tetrarch"},
            {"version", TETRARCH_VERSION},
            {"summary", app.get_description()},
            {"commands", Json::array()},
            {"common", common_json(*children(app).front())},
            {"exit_status", exit_statuses()}};
  add_commands(json["commands"], app, "");
  return json;
}

std::vector<std::string> first_words(const std::vector<Command>& table) {
  std::vector<std::string> words;
  for (const Command& command : table) {
    const std::string name = command.name;
    const std::string word = name.substr(0, name.find(' '));
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return words;
}

Run declare_help(CLI::App& app) {
  const auto words = std::make_shared<std::vector<std::string>>();
  app.add_option("COMMAND", *words, "what to explain; nothing: the list of commands");
  // The command line outlives the run.
  return [words, &line = *app.get_parent()](const Context&) { return help(line, *words); };
}

} // namespace tetrarch::program
