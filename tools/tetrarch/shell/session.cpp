// SPDX-License-Identifier: GPL-2.0-or-later
#include "session.hpp"

#include "../describe.hpp"
#include "../input.hpp"
#include "../samples.hpp"
#include "../text.hpp"
#include "value_text.hpp"
#include "words.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/workshop/nearest.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

constexpr int deepest = 20; ///< files that run one another
constexpr std::size_t most_changes = 1000;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// What can be pasted although it has blanks: JSON and presentations of groups.
bool is_spelled_out(std::string_view text) {
  return text.starts_with('{') || text.starts_with('<');
}

bool is_failure(Status status) {
  return status != Status::done && status != Status::proved_no && status != Status::undecided;
}

/// The verb that shows a value of this kind.
std::string showing(const Value& value) {
  const std::string kind = kind_of(value);
  return kind == "triangulation" ? "info" : kind == "group" ? "group" : "check";
}

/// Of "move Y two_three 0 1", Y: the first word after the verb that is no option.
std::string first_argument(const std::vector<std::string>& words) {
  for (std::size_t k = 1; k < words.size(); ++k)
    if (!words[k].starts_with("-")) return words[k];
  return {};
}

} // namespace

Session::Session(const Common& defaults, bool keeps_going)
    : defaults_(defaults), keeps_going_(keeps_going), verbs_(commands()) {
  // A shell in a shell would forget its values on the way out.
  std::erase_if(verbs_, [](const Command& c) { return std::string_view(c.name) == "shell"; });
  for (Command& own : own_verbs()) verbs_.push_back(std::move(own));
}

bool Session::is_verb(const std::string& word) const {
  return std::any_of(verbs_.begin(), verbs_.end(), [&word](const Command& c) {
    const std::string_view name = c.name;
    return name.substr(0, name.find(' ')) == word;
  });
}

bool Session::changes_value(const Parts& statement) const {
  const auto changes = [&statement](const Command& c) {
    return c.changes && statement.words.front() == c.name;
  };
  return statement.name.empty() && std::any_of(verbs_.begin(), verbs_.end(), changes) &&
         values_.contains(first_argument(statement.words));
}

Session::Parts Session::statement_of(std::string_view line) const {
  line = trimmed(line);
  Parts statement;
  statement.line = line;
  const std::size_t equals = line.find('=');
  if (equals != std::string_view::npos && is_name(trimmed(line.substr(0, equals)))) {
    statement.name = trimmed(line.substr(0, equals));
    line = trimmed(line.substr(equals + 1));
    if (is_verb(statement.name)) throw InputError("'" + statement.name + "' is a verb and can name no value");
  }
  statement.words = is_spelled_out(line) ? std::vector<std::string>{std::string(line)} : words_of(line);
  // Pasted from a page about the program.
  if (statement.words.size() > 1 && statement.words.front() == "tetrarch")
    statement.words.erase(statement.words.begin());
  if (!statement.name.empty() && statement.words.empty())
    throw InputError("there is nothing after " + statement.name + " =");
  return statement;
}

Status Session::run(std::string_view line, const std::string& speaker) {
  Parts statement;
  statement.line = trimmed(line);
  try {
    statement = statement_of(line);
    if (statement.words.empty()) return Status::done;
    return execute(statement, speaker);
  } catch (const InputError& e) {
    return complain_of(statement, speaker, e.what(), Status::bad_input);
  } catch (const std::exception& e) {
    return complain_of(statement, speaker, std::string("internal error, please report it: ") + e.what(),
                       Status::fault);
  }
}

Status Session::complain_of(const Statement& statement, const std::string& speaker,
                            const std::string& message, Status status) const {
  if (defaults_.json) tell_error(statement, status, message);
  return complain(speaker, message, status);
}

Status Session::execute(const Parts& statement, const std::string& speaker) {
  std::vector<std::string> words = statement.words;
  if (std::optional<Mapping> mapping = mapping_in(words))
    return execute(std::move(*mapping), statement, speaker);
  if (words.size() == 1 && !is_verb(words[0]) && shielded(words[0]).front() != '-') {
    if (!statement.name.empty()) {
      name_what_is_given(statement, speaker);
      return Status::done;
    }
    Context context;
    context.values = &values_;
    if (is_name(words[0]) && !values_.contains(words[0]) &&
        !workshop::nearest(words[0], first_words(verbs_)).empty())
      throw InputError("unknown command or value '" + words[0] + "'" +
                       workshop::did_you_mean(words[0], first_words(verbs_)));
    words.insert(words.begin(), showing(*read_value(words[0], context)));
  }
  const Parsed parsed = parse(words, verbs_, "", defaults_);
  if (!parsed.job) {
    say(parsed.text);
    return Status::done;
  }
  const JobOutcome done = run_job(*parsed.job, &values_, speaker, defaults_.json ? &statement : nullptr);
  const std::string name = changes_value(statement) ? first_argument(words) : statement.name;
  if (name.empty() || is_failure(done.status)) return done.status;
  if (done.value != nullptr)
    assign(name, done.value, statement);
  else if (!statement.name.empty())
    return complain(speaker, "this verb makes no value that " + name + " could name", Status::bad_input);
  return done.status;
}

/// The verb that shows a triangulation, if there is none, for each of them.
Status Session::execute(Mapping mapping, const Parts& statement, const std::string& speaker) {
  if (!statement.name.empty())
    throw InputError("a name is for one value, and " + in_quotes(mapping.words[mapping.at]) +
                     " stands for all in a file");
  if (mapping.words.size() == 1) {
    mapping.words.insert(mapping.words.begin(), "info");
    mapping.at = 1;
  }
  return run_mapping(std::move(mapping), verbs_, "", defaults_, &values_, speaker);
}

void Session::name_what_is_given(const Parts& statement, const std::string& speaker) {
  Context context;
  context.values = &values_;
  assign(statement.name, read_value(statement.words.front(), context), statement);
  if (!defaults_.quiet && !context.reads->passed_over.empty())
    warn(speaker, context.reads->passed_over.sentence());
  if (defaults_.json)
    tell(statement, Status::done, "result", summary(*values_.at(statement.name)));
  else if (!defaults_.quiet)
    say(printable(statement.name + ": " + summary(*values_.at(statement.name))) + "\n");
}

/// What made a value is what made the values that it was made from, and the line itself.
void Session::assign(const std::string& name, ValuePointer value, const Parts& statement) {
  Lines lines;
  std::vector<std::string> seen;
  for (const std::string& word : statement.words) {
    const auto used = lines_.find(word);
    if (used == lines_.end() || std::find(seen.begin(), seen.end(), word) != seen.end()) continue;
    seen.push_back(word);
    lines.insert(lines.end(), used->second.begin(), used->second.end());
  }
  lines.push_back(statement.line);
  ValuePointer& named = values_[name];
  changes_.push_back({name, std::exchange(named, std::move(value)),
                      std::exchange(lines_[name], std::move(lines)), statement.line});
  if (changes_.size() > most_changes) changes_.erase(changes_.begin());
}

Status Session::run_file(const std::string& path) {
  if (depth_ >= deepest)
    throw InputError({path, 0}, "files run each other to a depth of " + std::to_string(deepest + 1) +
                                    "; does this file run itself?");
  const std::string source = path == "-" ? "standard input" : path;
  std::ifstream file;
  if (path != "-") {
    file.open(located(path));
    if (!file) throw InputError({path, 0}, "cannot be opened");
  }
  std::istream& in = path == "-" ? std::cin : file;
  ++depth_;
  Status first = Status::done;
  int number = 0;
  const auto next = [&in, &number](std::string& line) {
    ++number;
    return static_cast<bool>(std::getline(in, line));
  };
  for (std::string line; !ended_ && (keeps_going_ || !is_failure(first)) && next(line);) {
    const std::string speaker = source + ":" + std::to_string(number);
    for (std::string more; is_open(line) && next(more);) line += "\n" + more;
    const Status status = run(line, speaker);
    if (!is_failure(first) && is_failure(status)) first = status;
  }
  --depth_;
  if (in.bad()) throw InputError({path, 0}, "cannot be read");
  return is_failure(first) ? first : Status::done;
}

bool Session::is_open(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string_view::npos && is_name(trimmed(text.substr(0, equals))))
    text.remove_prefix(equals + 1);
  text = trimmed(text);
  if (!text.starts_with('{')) return false;
  int depth = 0;
  bool is_quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (is_quoted && c == '\\')
      ++k;
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted)
      depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
  }
  return depth > 0;
}

void Session::require_value(const std::string& name) const {
  if (values_.contains(name)) return;
  std::vector<std::string> names;
  names.reserve(values_.size());
  for (const auto& [known, value] : values_) names.push_back(known);
  throw InputError("no value is called " + in_quotes(name) + workshop::did_you_mean(name, names));
}

Result Session::list() const {
  Result result;
  result.json = Json::object();
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [name, value] : values_) {
    result.json[name] = {{"kind", kind_of(*value)}, {"summary", summary(*value)}};
    rows.emplace_back(name, summary(*value));
  }
  result.text = rows.empty() ? "no values yet\n" : block(rows);
  return result;
}

Result Session::print(const std::vector<std::string>& names) const {
  Result result;
  result.json = Json::object();
  const auto add = [&](const std::string& name) {
    require_value(name);
    const std::string text = spelled(*values_.at(name));
    result.json[name] = text;
    result.text += name + " = " + text + "\n";
  };
  for (const std::string& name : names) add(name);
  if (!names.empty()) return result;
  for (const auto& [name, value] : values_) {
    if (can_be_spelled(*value))
      add(name);
    else // a comment, so that the rest can still be pasted
      result.text += "# " + name + ": " + summary(*value) + ", too long for a line\n";
  }
  return result;
}

Result Session::log(const std::string& name) const {
  require_value(name);
  Result result;
  result.json = {{"lines", lines_.at(name)}};
  for (const std::string& line : lines_.at(name)) result.text += line + "\n";
  return result;
}

Result Session::forget(const std::vector<std::string>& names) {
  for (const std::string& name : names) require_value(name);
  Result result;
  result.json = {{"forgotten", names}};
  for (const std::string& name : names) {
    if (!values_.contains(name)) continue; // named twice
    changes_.push_back({name, std::move(values_.at(name)), std::move(lines_.at(name)), "forget " + name});
    values_.erase(name);
    lines_.erase(name);
  }
  return result;
}

Result Session::undo() {
  if (changes_.empty()) throw InputError("there is nothing to undo");
  Change last = std::move(changes_.back());
  changes_.pop_back();
  Result result;
  result.text =
      last.name + (last.value ? " is what it was before: " : " is gone, as before: ") + last.line + "\n";
  result.json = {{"name", last.name}, {"undone", last.line}};
  if (last.value) {
    values_[last.name] = std::move(last.value);
    lines_[last.name] = std::move(last.lines);
  } else {
    values_.erase(last.name);
    lines_.erase(last.name);
  }
  return result;
}

std::vector<Command> Session::own_verbs() {
  const auto no_options = [](auto act) {
    return [act](OptionTable&) -> Run { return [act](const Context&) { return act(); }; };
  };
  const auto end = [this] {
    ended_ = true;
    return Result();
  };
  const auto with_names = [](const char* what, bool required, auto act) {
    return [=](OptionTable& table) -> Run {
      const auto names = std::make_shared<std::vector<std::string>>();
      table.add("NAME", *names, what).required(required);
      return [names, act](const Context&) { return act(*names); };
    };
  };
  const auto with_word = [](const char* word, const char* what, auto act) {
    return [=](OptionTable& table) -> Run {
      const auto argument = std::make_shared<std::string>();
      table.add(word, *argument, what).required();
      return [argument, act](const Context&) { return act(*argument); };
    };
  };
  constexpr const char* session = "Values and session";
  return {
      {session, "values", "list the named values", "values", no_options([this] { return list(); })},
      {session, "print", "print values in a form that can be pasted back in", "print Y",
       with_names("names of values (default: all)", false,
                  [this](const std::vector<std::string>& names) { return print(names); })},
      {session, "log", "print the lines and moves that made a value", "log Y",
       with_word("NAME", "name of a value", [this](const std::string& name) { return log(name); })},
      {session, "undo", "take back the last change of a value", "undo",
       no_options([this] { return undo(); })},
      {session, "forget", "forget named values", "forget Y",
       with_names("names of values", true,
                  [this](const std::vector<std::string>& names) { return forget(names); })},
      {session, "run", "run the lines of a file", "run moves.txt",
       with_word("FILE", "a script with one command per line; # begins a comment",
                 [this](const std::string& path) {
                   Result result;
                   result.status = run_file(path);
                   return result;
                 })},
      {session, "quit", "end the session; so does Ctrl-D", "quit", no_options(end)},
  };
}

} // namespace tetrarch::program
