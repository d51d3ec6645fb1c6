// SPDX-License-Identifier: GPL-2.0-or-later
#include "census.hpp"
#include "command.hpp"
#include "crew.hpp"
#include "output.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/format/compressed.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/records.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

namespace tetrarch::program {
namespace {

using catalogue::Manifold;

/// "2/4": the second of four.
catalogue::Share share_in(const std::string& text) {
  constexpr int most_shares = 1'000'000;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = format::parse_integer(std::string_view(text).substr(0, slash));
    const auto count = format::parse_integer(std::string_view(text).substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count && *count <= most_shares)
      return {static_cast<int>(*index) - 1, static_cast<int>(*count)};
  }
  throw InputError("--shard " + in_quotes(text) + ": expected I/K with I from 1 to K, such as 1/4");
}

/// The records of a folder, which is made if it is to be written to; or the file of the records itself.
std::unique_ptr<format::Records> open_work(const std::string& folder, catalogue::TableKey key, bool brief,
                                           format::Records::Open how) {
  std::error_code error;
  const std::string heading = "certified classification of " + std::to_string(key.tetrahedra) +
                              " tetrahedra" + (key.orientable ? "" : ", not orientable") +
                              (brief ? ", brief" : "");
  if (how == format::Records::Open::read && std::filesystem::is_regular_file(folder, error))
    return std::make_unique<format::Records>(folder, heading, how);
  error.clear();
  if (how != format::Records::Open::read) std::filesystem::create_directories(folder, error);
  if (error) throw InputError({folder, 0}, "this folder cannot be made: " + error.message());
  return std::make_unique<format::Records>((std::filesystem::path(folder) / "records").string(), heading,
                                           how);
}

/// A few of the signatures; all are in the JSON.
std::string some_of(const std::vector<catalogue::Unsettled>& list) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, list.size()); ++k)
    text += (k == 0 ? "" : ", ") + list[k].signature;
  return text + (list.size() > most ? ", ..." : "");
}

Json unsettled_json(const std::vector<catalogue::Unsettled>& list) {
  Json json = Json::array();
  for (const catalogue::Unsettled& u : list) json.push_back({{"signature", u.signature}, {"why", u.why}});
  return json;
}

/// What keeps the list from being a census.
void tell_unsettled(const catalogue::Classification& found, Result& result) {
  const auto tell = [&](const std::vector<catalogue::Unsettled>& list, const char* noun, const char* what) {
    if (list.empty()) return;
    result.status = Status::undecided;
    result.warnings.push_back(counted(static_cast<long long>(list.size()), noun) + what + some_of(list));
  };
  tell(found.stuck, "structure", " left out for want of a canonical decomposition: ");
  tell(found.unproved, "structure", " without a proof of it or of its cells: ");
  tell(found.open, "gluing", " without a structure, and without a proof that there is none: ");
}

Json summary_json(const catalogue::Classification& found) {
  const catalogue::Tally& t = found.tally;
  Json json{{"manifolds", found.manifolds.size()},
            {"gluings", t.gluings},
            {"geometric_gluings", t.geometric},
            {"elsewhere", t.elsewhere},
            {"none", t.none},
            {"flat", t.flat},
            {"certified", t.certified},
            {"proved", t.proved},
            {"widest", t.widest}};
  json["arguments"] = Json::object();
  for (const auto& [letter, count] : t.arguments) json["arguments"][std::string(1, letter)] = count;
  json["reasons"] = Json::object();
  for (const auto& [reason, count] : found.reasons) json["reasons"][reason] = count;
  json["stuck"] = unsettled_json(found.stuck);
  json["unproved"] = unsettled_json(found.unproved);
  json["open"] = unsettled_json(found.open);
  return json;
}

/// What became of the gluings.
std::string classification_summary(const catalogue::Classification& found) {
  const catalogue::Tally& t = found.tally;
  std::vector<std::pair<std::string, std::string>> rows{
      {"gluings", std::to_string(t.gluings)},
      {"  with a structure", std::to_string(t.geometric)},
      {"  with a structure on another triangulation", std::to_string(t.elsewhere)},
      {"  proved to have none", std::to_string(t.none)}};
  for (const auto& [reason, count] : found.reasons) rows.emplace_back("    " + reason, std::to_string(count));
  rows.emplace_back("  open", std::to_string(found.open.size()));
  rows.emplace_back("structures certified",
                    std::to_string(t.certified) + ", volumes within " + scientific(t.widest, 1));
  std::string arguments;
  for (const auto& [letter, count] : t.arguments)
    arguments += (arguments.empty() ? "" : ", ") + std::string(1, letter) + " " + std::to_string(count);
  rows.emplace_back("decompositions proved", std::to_string(t.proved));
  rows.emplace_back("manifolds", std::to_string(found.manifolds.size()) + ", " + std::to_string(t.flat) +
                                     " with cells other than tetrahedra; cells by argument: " + arguments);
  return block(rows);
}

/// A table for a file of this name: JSON or its lines, packed or not; nothing for another extension.
std::optional<std::string> table_text(catalogue::TableKey key, const std::vector<Manifold>& manifolds,
                                      const std::string& path) {
  const bool pack = format::has_extension(path, ".xz");
  const std::string bare = pack ? path.substr(0, path.size() - std::string_view(".xz").size()) : path;
  const bool lines = format::has_extension(bare, ".jsonl");
  if (!lines && !format::has_extension(bare, ".json")) return std::nullopt;
  std::string text = lines ? write_table_lines(key, manifolds) : write_table(key, manifolds);
  return pack ? format::packed(text) : std::move(text);
}

/// Throws InputError unless a table can be written to `path`; an empty one is none.
void require_table(const std::string& path) {
  if (path.empty()) return;
  if (!table_text(1, {}, path))
    throw InputError({path, 0}, "no census table has this extension (expected .jsonl or .json, or .jsonl.xz "
                                "or .json.xz to have it packed; census table makes an SQLite file of these)");
}

void add_table_output(OptionTable& table, std::string& path) {
  table
      .add("-o,--output", path,
           "write a census table to this file: lines of JSON (.jsonl) or one document (.json), packed if .xz "
           "follows")
      .output_file();
}

/// The manifolds, a line each or as a table in a file; and what is left open.
Result classification_result(const catalogue::Classification& found, catalogue::TableKey key,
                             const std::string& output) {
  Result result;
  if (found.missing_units > 0) {
    result.text = "done, of " + counted(found.missing_units, "unit") + " left to others nothing is known\n";
    result.json = {{"missing_units", found.missing_units}};
    if (!output.empty())
      result.warnings.push_back(output + " was not written: this is one of several shards");
    return result;
  }
  if (output.empty())
    for (const Manifold& m : found.manifolds) result.text += manifold_json(m).dump() + "\n";
  else {
    result.files.push_back({output, table_text(key, found.manifolds, output).value()});
    result.json = summary_json(found);
    result.text = classification_summary(found) +
                  counted(static_cast<long long>(found.manifolds.size()), "manifold") + " written to " +
                  output + "\n";
  }
  tell_unsettled(found, result);
  return result;
}

} // namespace

namespace {

fields::List summary_fields() {
  namespace type = workshop::type;
  const workshop::Type unsettled = type::list(type::object({{"signature", type::text}, {"why", type::text}}));
  return {
      {"manifolds", "", "with -o: number of manifolds", type::integer},
      {"gluings", "", "number of gluings", type::integer},
      {"geometric_gluings", "", "those of them that carry a structure", type::integer},
      {"elsewhere", "", "those with a structure on another triangulation", type::integer},
      {"none", "", "those that are proved to have none", type::integer},
      {"flat", "", "manifolds with cells other than tetrahedra", type::integer},
      {"certified", "", "number of structures certified", type::integer},
      {"proved", "", "number of decompositions proved", type::integer},
      {"widest", "curvature -1", "width of the widest interval around a volume", type::number},
      {"arguments", "", "cells by the argument that proves them", type::table(type::integer)},
      {"reasons", "", "gluings without a structure by the reason", type::table(type::integer)},
      {"stuck", "", "structures left out for want of a canonical decomposition: signature, why", unsettled},
      {"unproved", "", "structures without a proof of them or of their cells, likewise", unsettled},
      {"open", "", "gluings without a structure and without a proof that there is none, likewise",
       unsettled}};
}

} // namespace

fields::List fields::of_census_enumerate() {
  const List shard{{"missing_units", "", "of one of several shards: units of work left to others",
                    workshop::type::integer}};
  return workshop::either_of(of_census_merge(), shard);
}

fields::List fields::of_census_merge() {
  return workshop::either_of(fields_of_manifold(), summary_fields());
}

Run declare_census_enumerate(OptionTable& table) {
  struct Options {
    TableChoice table;
    std::string output;
    bool brief = false;
    std::string work;
    bool resume = false;
    std::string share;
  };
  const auto options = std::make_shared<Options>();
  add_table_choice(table, options->table, true);
  add_table_output(table, options->output);
  table.add("--brief", options->brief, "leave the dihedral angles out");
  table
      .add("--work", options->work,
           "keep finished units of work in this folder, so that a run that was stopped, in whatever way, can "
           "be resumed")
      .value_name("DIR");
  table.add("--resume", options->resume, "go on with what the folder of --work holds");
  table
      .add("--shard", options->share,
           "do the units of one of several machines alone, such as 1/4; census merge puts the folders "
           "together")
      .value_name("I/K");
  return [options](const Context& context) {
    require_table(options->output);
    catalogue::WorkOptions how;
    how.threads = context.threads;
    how.angles = !options->brief;
    if (!options->share.empty()) how.share = share_in(options->share);
    if (options->work.empty() && (options->resume || !options->share.empty()))
      throw InputError(std::string(options->resume ? "--resume" : "--shard") + " needs --work");
    if (crew() && !options->share.empty())
      throw InputError("--shard is for machines that do not know of each other, and mpirun's do");
    std::unique_ptr<format::Records> records;
    catalogue::RecordsInMemory in_memory; // nobody needs them later
    if (crew()) how.records = in_memory.both();
    if (!options->work.empty()) {
      records = open_work(options->work, options->table.key(), options->brief,
                          options->resume ? format::Records::Open::resume : format::Records::Open::fresh);
      how.records.find = [&](const std::string& key) { return records->find(key); };
      how.records.keep = [&](const std::string& key, const std::string& text) { records->add(key, text); };
    }
    if (crew()) crew()(options->table.key(), how.angles, how.records, context.progress);
    const auto found = catalogue::classify_manifolds(options->table.key(), how, context.progress);
    Result result = classification_result(found, options->table.key(), options->output);
    if (records && records->damaged() > 0)
      result.warnings.push_back(counted(records->damaged(), "damaged record") + " in " + options->work +
                                " done again");
    return result;
  };
}

Run declare_census_merge(OptionTable& table) {
  struct Options {
    std::vector<std::string> folders;
    TableChoice table;
    bool brief = false;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  table
      .add("DIR", options->folders,
           "the folders that census enumerate --work wrote, or the files of records in them")
      .required();
  add_table_choice(table, options->table, true);
  table.add("--brief", options->brief, "the folders were written with --brief");
  add_table_output(table, options->output);
  return [options](const Context& context) {
    require_table(options->output);
    std::vector<std::unique_ptr<format::Records>> all;
    for (const std::string& folder : options->folders)
      all.push_back(
          open_work(located(folder), options->table.key(), options->brief, format::Records::Open::read));
    catalogue::WorkOptions how;
    how.threads = context.threads;
    how.share.reset();
    how.records.find = [&](const std::string& key) -> const std::string* {
      for (const auto& records : all)
        if (const std::string* text = records->find(key)) return text;
      return nullptr;
    };
    const auto found = catalogue::classify_manifolds(options->table.key(), how, context.progress);
    if (found.missing_units > 0)
      throw InputError(counted(found.missing_units, "unit") +
                       " of work missing from these folders (census enumerate --resume does them)");
    return classification_result(found, options->table.key(), options->output);
  };
}

} // namespace tetrarch::program
