// SPDX-License-Identifier: GPL-2.0-or-later
#include "census.hpp"
#include "command.hpp"
#include "text.hpp"

#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/format/new_files.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

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

fields::List fields::of_census_gluings() {
  namespace type = workshop::type;
  return {{"count", "", "number of gluings", type::integer},
          {"signatures", "", "all of them; without -o", type::list(type::text), false}};
}

Run declare_census_gluings(OptionTable& table) {
  struct Options {
    enumeration::GluingOptions gluings;
    bool orientable = false;
    bool nonorientable = false;
    std::string links;
    std::string output;
  };
  const auto options = std::make_shared<Options>();
  add_tetrahedra(table, &options->gluings.tetrahedra).required();
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
  table.add("-o,--output", options->output, "write the signatures to this file").output_file();
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

} // namespace tetrarch::program
