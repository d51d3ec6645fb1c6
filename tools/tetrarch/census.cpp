// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/format/new_files.hpp"
#include "tetrarch/format/records.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>

namespace tetrarch::program {
namespace {

using catalogue::Manifold;
using catalogue::Validation;

Json manifold_json(const Manifold& m) {
  Json j{{"name", nullptr}, {"tetrahedra", m.tetrahedra}};
  j.update(Json::parse(json_text(m)));
  return j;
}

/// A stored volume rounded to twelve decimals.
std::string shortened(const std::string& volume) {
  constexpr int decimals = 12;
  return fixed(format::parse_double(volume).value_or(0), decimals);
}

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

Result run_validation(int tetrahedra, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const Validation v = catalogue::validate(tetrahedra, context.threads, context.progress);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Result result;
  result.json = validation_json(v, seconds);
  result.text = validation_text(v, seconds);
  if (!v.failures.empty()) result.status = Status::proved_no;
  return result;
}

void add_tetrahedra(OptionTable& table, int& tetrahedra, bool required) {
  Option& option = table.add("--tetrahedra", tetrahedra, "number of tetrahedra")
                       .in_range(1, enumeration::max_gluing_tetrahedra);
  if (required)
    option.required();
  else
    option.with_default();
}

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
std::unique_ptr<format::Records> open_work(const std::string& folder, int tetrahedra, bool brief,
                                           format::Records::Open how) {
  std::error_code error;
  const std::string heading =
      "certified classification of " + std::to_string(tetrahedra) + " tetrahedra" + (brief ? ", brief" : "");
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
std::string summary_of(const catalogue::Classification& found) {
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

/// The manifolds, a line each or as a table in a file; and what is left open.
Result classification_result(const catalogue::Classification& found, int tetrahedra,
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
    result.files.push_back({output, catalogue::write_table(tetrahedra, found.manifolds)});
    result.json = summary_json(found);
    result.text = summary_of(found) + counted(static_cast<long long>(found.manifolds.size()), "manifold") +
                  " written to " + output + "\n";
  }
  tell_unsettled(found, result);
  return result;
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// "3,2": genera, decreasing. Nothing for no text.
std::optional<std::vector<int>> genera_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  constexpr int largest = 1000;
  std::vector<int> genera;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const auto genus = format::parse_integer(std::string_view(text).substr(at, comma - at));
    if (!genus || *genus < 2 || *genus > largest)
      throw InputError("--boundary " + in_quotes(text) + ": expected genera from 2 on, such as 2 or 3,2");
    genera.push_back(static_cast<int>(*genus));
    at = comma + 1;
  }
  std::sort(genera.begin(), genera.end(), std::greater<>());
  return genera;
}

/// "9..10": both ends included.
std::pair<double, double> range_in(const std::string& text) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (text.empty()) return {-infinite, infinite};
  const std::size_t dots = text.find("..");
  const auto refuse = [&text] {
    return InputError("--volume " + in_quotes(text) + ": expected a range such as 9..10");
  };
  if (dots == std::string::npos || text.size() == 2) throw refuse();
  const auto end = [&](std::size_t from, std::size_t length, double otherwise) {
    const std::string_view number = std::string_view(text).substr(from, length);
    if (number.empty()) return otherwise;
    const auto value = format::parse_double(number);
    if (!value) throw refuse();
    return *value;
  };
  return {end(0, dots, -infinite), end(dots + 2, std::string::npos, infinite)};
}

/// Which manifolds of a table are asked for.
struct Wanted {
  std::optional<std::vector<int>> boundary;
  std::pair<double, double> volume;
  std::string homology; ///< without blanks; empty: any
  std::optional<int> cusps;

  bool fits(const Manifold& m) const {
    const double v = format::parse_double(m.volume).value_or(0);
    return (!boundary || m.boundary == *boundary) && v >= volume.first && v <= volume.second &&
           (homology.empty() || without_blanks(m.homology) == homology) && (!cusps || m.cusps == *cusps);
  }
};

/// All signatures at once, for programs.
Result listed(const enumeration::GluingOptions& gluings, const Context& context) {
  Result result;
  Json signatures = Json::array();
  enumerate_signatures(
      gluings,
      [&](const std::string& signature) {
        signatures.push_back(signature);
        result.text += signature + "\n";
      },
      context.progress);
  result.json = {{"count", signatures.size()}, {"signatures", std::move(signatures)}};
  return result;
}

/// Hands out signatures in portions, so that few are kept and none waits long.
class Portions {
public:
  explicit Portions(std::function<void(const std::string&)> deliver) : deliver_(std::move(deliver)) {}

  void add(const std::string& line) {
    text_ += line + "\n";
    ++count_;
    if (text_.size() >= most_bytes || (count_ % 64 == 0 && Clock::now() > next_)) flush();
  }
  void flush() {
    if (!text_.empty()) deliver_(text_);
    text_.clear();
    next_ = Clock::now() + std::chrono::milliseconds(500);
  }
  long long count() const { return count_; }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t most_bytes = 1U << 16U;

  std::function<void(const std::string&)> deliver_;
  std::string text_;
  long long count_ = 0;
  Clock::time_point next_ = Clock::now();
};

/// The same as they are found, printed or into the file.
Result streamed(const enumeration::GluingOptions& gluings, const std::string& output,
                const Context& context) {
  std::optional<format::GrowingFile> file;
  if (!output.empty()) file.emplace(output);
  Portions portions(file ? [&file](const std::string& text) { file->add(text); } : context.print);
  enumerate_signatures(
      gluings, [&](const std::string& signature) { portions.add(signature); }, context.progress);
  portions.flush();
  Result result;
  result.json = {{"count", portions.count()}};
  if (!file) return result;
  file->keep();
  result.text = counted(portions.count(), "gluing") + " written to " + output + "\n";
  return result;
}

} // namespace

Run declare_census_gluings(OptionTable& table) {
  struct Options {
    enumeration::GluingOptions gluings;
    bool orientable = false;
    bool nonorientable = false;
    std::string links;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  add_tetrahedra(table, options->gluings.tetrahedra, true);
  table.add("--orientable", options->orientable, "only orientable gluings");
  table.add("--nonorientable", options->nonorientable, "only non-orientable gluings")
      .excludes("--orientable");
  table.add("--ideal", options->gluings.ideal, "only gluings with a vertex link other than a sphere");
  table
      .add("--links", options->links,
           "only gluings whose vertex links are in this list: genera (0 for the sphere), nK for K crosscaps")
      .value_name("LIST");
  table
      .add("--min-valence", options->gluings.min_valence,
           "only gluings whose edges have at least this valence")
      .in_range(1, 72);
  table.add("--allow-invalid", options->gluings.allow_invalid,
            "allow edges that are identified with themselves reversed");
  table.add("-o,--output", options->output, "write the signatures to this file").value_name("FILE");
  return [options](const Context& context) {
    using Orientability = enumeration::GluingOptions::Orientability;
    enumeration::GluingOptions gluings = options->gluings;
    gluings.threads = context.threads;
    if (options->orientable) gluings.orientability = Orientability::orientable;
    if (options->nonorientable) gluings.orientability = Orientability::nonorientable;
    if (!options->links.empty()) gluings.links = enumeration::parse_link_set(options->links);
    return options->output.empty() && !context.print ? listed(gluings, context)
                                                     : streamed(gluings, options->output, context);
  };
}

Run declare_census_enumerate(OptionTable& table) {
  struct Options {
    int tetrahedra = 3;
    std::string output;
    bool brief = false;
    std::string work;
    bool resume = false;
    std::string share;
  };
  const auto options = std::make_shared<Options>();
  add_tetrahedra(table, options->tetrahedra, true);
  table.add("-o,--output", options->output, "write a census table to this file (the format of census/*.json)")
      .value_name("FILE");
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
    catalogue::WorkOptions how;
    how.threads = context.threads;
    how.angles = !options->brief;
    if (!options->share.empty()) how.share = share_in(options->share);
    if (options->work.empty() && (options->resume || !options->share.empty()))
      throw InputError(std::string(options->resume ? "--resume" : "--shard") + " needs --work");
    std::unique_ptr<format::Records> records;
    if (!options->work.empty()) {
      records = open_work(options->work, options->tetrahedra, options->brief,
                          options->resume ? format::Records::Open::resume : format::Records::Open::fresh);
      how.records.find = [&](const std::string& key) { return records->find(key); };
      how.records.keep = [&](const std::string& key, const std::string& text) { records->add(key, text); };
    }
    const auto found = catalogue::classify_manifolds(options->tetrahedra, how, context.progress);
    Result result = classification_result(found, options->tetrahedra, options->output);
    if (records && records->damaged() > 0)
      result.warnings.push_back(counted(records->damaged(), "damaged record") + " in " + options->work +
                                " done again");
    return result;
  };
}

Run declare_census_merge(OptionTable& table) {
  struct Options {
    std::vector<std::string> folders;
    int tetrahedra = 3;
    bool brief = false;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  table
      .add("DIR", options->folders,
           "the folders that census enumerate --work wrote, or the files of records in them")
      .required();
  add_tetrahedra(table, options->tetrahedra, true);
  table.add("--brief", options->brief, "the folders were written with --brief");
  table.add("-o,--output", options->output, "write a census table to this file (the format of census/*.json)")
      .value_name("FILE");
  return [options](const Context& context) {
    std::vector<std::unique_ptr<format::Records>> all;
    for (const std::string& folder : options->folders)
      all.push_back(
          open_work(located(folder), options->tetrahedra, options->brief, format::Records::Open::read));
    catalogue::WorkOptions how;
    how.threads = context.threads;
    how.share.reset();
    how.records.find = [&](const std::string& key) -> const std::string* {
      for (const auto& records : all)
        if (const std::string* text = records->find(key)) return text;
      return nullptr;
    };
    const auto found = catalogue::classify_manifolds(options->tetrahedra, how, context.progress);
    if (found.missing_units > 0)
      throw InputError(counted(found.missing_units, "unit") +
                       " of work missing from these folders (census enumerate --resume does them)");
    return classification_result(found, options->tetrahedra, options->output);
  };
}

Run declare_census_validate(OptionTable& table) {
  const auto tetrahedra = std::make_shared<int>(3);
  add_tetrahedra(table, *tetrahedra, false);
  return [tetrahedra](const Context& context) { return run_validation(*tetrahedra, context); };
}

Run declare_census_list(OptionTable& table) {
  struct Options {
    int tetrahedra = 3;
    std::string boundary;
    std::string volume;
    std::string homology;
    std::optional<int> cusps;
    bool count = false;
  };
  const auto o = std::make_shared<Options>();
  add_tetrahedra(table, o->tetrahedra, false);
  table.add("--boundary", o->boundary, "only with geodesic boundary of just these genera, such as 2 or 3,2")
      .value_name("LIST");
  table.add("--volume", o->volume, "only with a volume in this range; either end may be left out")
      .value_name("A..B");
  table.add("--homology", o->homology, "only with this first homology, such as 'Z^2 + Z/3'")
      .value_name("GROUP");
  table.add("--cusps", o->cusps, "only with this number of cusps").in_range(0, 1000);
  table.add("--count", o->count, "print no more than their number");
  return [o](const Context&) {
    const Wanted wanted{genera_in(o->boundary), range_in(o->volume), without_blanks(o->homology), o->cusps};
    Result result;
    result.json = {{"tetrahedra", o->tetrahedra}, {"count", 0}};
    if (!o->count) result.json["manifolds"] = Json::array();
    long long count = 0;
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Manifold& m : catalogue::require_table(o->tetrahedra)) {
      if (!wanted.fits(m)) continue;
      ++count;
      if (o->count) continue;
      result.json["manifolds"].push_back(manifold_json(m));
      rows.emplace_back(m.name, shortened(m.volume) + "  " + m.boundary_text() + "  " + m.homology + "  " +
                                    m.signature);
    }
    result.json["count"] = count;
    result.text = o->count ? std::to_string(count) + "\n" : block(rows);
    return result;
  };
}

Run declare_census_show(OptionTable& table) {
  const auto name = std::make_shared<std::string>();
  table.add("NAME", *name, "a census name, such as fmp3_17").required();
  return [name](const Context&) {
    const auto found = catalogue::find_by_name(*name);
    if (!found) throw InputError("no census manifold is called " + in_quotes(*name));
    const Manifold& m = *found;
    Result result;
    result.json = manifold_json(m);
    std::vector<std::pair<std::string, std::string>> rows{
        {"name", m.name},
        {"tetrahedra", std::to_string(m.tetrahedra)},
        {"signature", m.signature},
        {"volume", m.volume},
        {"boundary", m.boundary_text()},
        {"edge classes", std::to_string(m.edges)},
        {"homology", m.homology},
        {"canonical cells", joined(m.cells, ", ")},
        {"isometry signature", m.canonical_signature},
        {"isometry group", "order " + std::to_string(m.symmetries)}};
    for (std::size_t t = 0; t < m.dihedral_angles.size(); ++t)
      for (int e = 0; e < 6; ++e)
        rows.emplace_back(e == 0 ? "angles " + std::to_string(t) : "", m.dihedral_angles[t][e]);
    result.text = block(rows);
    result.value = std::make_shared<Value>(format::document_of(from_signature(m.signature), m.name));
    return result;
  };
}

} // namespace tetrarch::program
