// SPDX-License-Identifier: GPL-2.0-or-later
#include "schema.hpp"

#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::program {
namespace {

using workshop::FieldNote;
namespace type = workshop::type;

Json document(const std::string& title, const std::string& description, const std::vector<FieldNote>& notes) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", title},
              {"description", description}};
  schema.update(workshop::schema_of(notes));
  return schema;
}

Json schema_of_error() {
  return document(
      "tetrarch: an error", "one line on standard error, where a command with --json fails",
      {{"error", "", "what went wrong, and where", workshop::Type(workshop::schema_of(error_notes()))}});
}

Json schema_of_statement() {
  return document("tetrarch shell --json", "one line for each line of a session that says something",
                  {{"name", "", "what was named; null: nothing", type::or_null(type::text)},
                   {"line", "", "the line as it was typed", type::text},
                   {"status", "", "as the exit status of the command", type::integer},
                   {"result", "", "what the command prints with --json, or its text", {}, false},
                   {"error", "", "in place of it: what went wrong", type::text, false}});
}

} // namespace

const std::vector<FieldNote>& common_notes() {
  static const std::vector<FieldNote> notes{
      {"passed_over", "", "where something was read: what was passed over, a list of objects what, count",
       type::list(type::object({{"what", type::text}, {"count", type::integer}})), false},
      {"input", "", "of each triangulation of a file (FILE#*): which one it is", type::text, false},
      {"name", "", "of such a triangulation: its name in the file", type::text, false}};
  return notes;
}

const std::vector<FieldNote>& error_notes() {
  static const std::vector<FieldNote> notes{
      {"code", "", "the kind of error",
       type::one_of({"bad_value", "bad_option", "unknown_name", "wrong_kind", "bad_file", "bad_content",
                     "no_memory", "bad_input", "fault", "interrupted"})},
      {"file", "", "the file, or what stands for one; null: none is to blame", type::or_null(type::text)},
      {"line", "", "counted from 1; null: not known", type::or_null(type::integer)},
      {"message", "", "without the place", type::text}};
  return notes;
}

Json schema_of(const Command& command) {
  if (command.fields == nullptr)
    throw InputError("'" + std::string(command.name) + "' prints no object of its own with --json",
                     Cause::option);
  return document("tetrarch " + std::string(command.name) + " --json", command.summary,
                  workshop::each_once(workshop::both_of(command.fields(), common_notes())));
}

Json schemas_of(const std::vector<Command>& table) {
  Json commands = Json::object();
  for (const Command& command : table)
    if (command.fields != nullptr) commands[command.name] = schema_of(command);
  return {
      {"commands", std::move(commands)}, {"error", schema_of_error()}, {"statement", schema_of_statement()}};
}

} // namespace tetrarch::program
