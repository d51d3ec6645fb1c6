// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/enumeration/gluings.hpp"

#include "gluings_search.hpp"
#include "gluings_signature.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/parallel.hpp"

#include <algorithm>
#include <charconv>

namespace tetrarch::enumeration {
namespace {

constexpr std::string_view stage = "gluings";

void require_sensible(const GluingOptions& options) {
  if (options.tetrahedra < 1 || options.tetrahedra > max_gluing_tetrahedra)
    throw PreconditionError("gluings of " + std::to_string(options.tetrahedra) +
                            " tetrahedra: their number must be from 1 to " +
                            std::to_string(max_gluing_tetrahedra));
  if (options.threads < 1) throw PreconditionError("gluings: at least one thread is needed");
}

/// By how many letters the search is cut into pieces: of up to six tetrahedra no piece has more than some
/// thousand gluings, and beyond there are not too many pieces.
int letters_of_pieces(int tetrahedra) {
  constexpr int most = 8;
  return std::min(std::max(tetrahedra, std::min(tetrahedra + 2, most)), 2 * tetrahedra);
}

/// The search cut into pieces by so many letters. Their results in a row do not depend on the cut.
struct SearchPlan {
  SearchPlan(const GluingOptions& options, int letters, const Progress& progress)
      : rules(options), length(letters), beginnings(GluingSearch(rules, progress).beginnings(length)) {}

  GluingRules rules;
  int length;
  std::vector<GluingSearch::Text> beginnings;
};

/// Delivers what `make` makes of each gluing, in the order of the search, whatever the number of threads.
template <class Item, class Make, class Deliver>
void run(const GluingOptions& options, const Make& make, const Deliver& deliver, const Progress& progress) {
  require_sensible(options);
  // Each piece is begun anew: for one thread few are enough, which tell how far it is.
  const SearchPlan plan(
      options, options.threads > 1 ? letters_of_pieces(options.tetrahedra) : options.tetrahedra, progress);
  const auto report = [&](double part) { progress.step(stage, part); };
  if (options.threads > 1) {
    const auto worker = [&] {
      return [&, search = GluingSearch(plan.rules, progress)](std::size_t piece) mutable {
        std::vector<Item> items;
        search.complete(plan.beginnings[piece], plan.length,
                        [&](const PartialGluing& gluing) { items.push_back(make(gluing)); });
        return items;
      };
    };
    const auto deliver_all = [&](std::vector<Item>&& items) {
      for (Item& item : items) deliver(std::move(item));
    };
    numeric::gather_in_order<std::vector<Item>>(plan.beginnings.size(), options.threads, worker, deliver_all,
                                                report);
    return;
  }
  GluingSearch search(plan.rules, progress);
  const auto pieces = static_cast<double>(plan.beginnings.size());
  double piece = 0;
  for (const GluingSearch::Text& beginning : plan.beginnings) {
    report(piece++ / pieces);
    search.complete(beginning, plan.length, [&](const PartialGluing& gluing) { deliver(make(gluing)); });
  }
}

} // namespace

bool LinkSet::contains(const SurfaceType& type) const {
  const std::vector<int>& allowed = type.orientable ? genera : crosscaps;
  return type.is_closed() && std::find(allowed.begin(), allowed.end(), type.genus()) != allowed.end();
}

LinkSet parse_link_set(std::string_view text) {
  LinkSet set;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view item = text.substr(at, end - at);
    at = end + 1;
    const bool crosscaps = !item.empty() && (item.front() == 'n' || item.front() == 'N');
    const std::string_view digits = crosscaps ? item.substr(1) : item;
    int number = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || stop != digits.data() + digits.size() || number < (crosscaps ? 1 : 0))
      throw InputError(
          in_quotes(item) +
          " is no vertex link: expected a genus (0, 1, 2, ...), or nk for k crosscaps (n1, n2, ...)");
    (crosscaps ? set.crosscaps : set.genera).push_back(number);
  }
  return set;
}

void enumerate_gluings(const GluingOptions& options, const std::function<void(const Triangulation&)>& visit,
                       const Progress& progress) {
  run<Triangulation>(
      options, [](const PartialGluing& gluing) { return gluing.triangulation(); },
      [&](Triangulation&& tri) { visit(tri); }, progress);
}

void enumerate_signatures(const GluingOptions& options, const std::function<void(const std::string&)>& visit,
                          const Progress& progress) {
  run<std::string>(
      options, [](const PartialGluing& gluing) { return SignatureWriter().write(gluing); },
      [&](std::string&& text) { visit(text); }, progress);
}

std::vector<std::string> gluing_signatures(const GluingOptions& options, const Progress& progress) {
  std::vector<std::string> signatures;
  run<std::string>(
      options, [](const PartialGluing& gluing) { return SignatureWriter().write(gluing); },
      [&](std::string&& text) { signatures.push_back(std::move(text)); }, progress);
  std::sort(signatures.begin(), signatures.end());
  return signatures;
}

std::int64_t count_gluings(const GluingOptions& options, const Progress& progress) {
  struct Nothing {};
  std::int64_t count = 0;
  run<Nothing>(
      options, [](const PartialGluing&) { return Nothing(); }, [&](Nothing&&) { ++count; }, progress);
  return count;
}

/// Whatever the number of threads, which may be another one when work is resumed.
struct GluingUnits::Plan : SearchPlan {
  Plan(const GluingOptions& options, const Progress& progress)
      : SearchPlan(options, letters_of_pieces(options.tetrahedra), progress) {}
};

GluingUnits::GluingUnits(const GluingOptions& options, const Progress& progress) {
  require_sensible(options);
  plan_ = std::make_unique<Plan>(options, progress);
}
GluingUnits::GluingUnits(GluingUnits&&) noexcept = default;
GluingUnits::~GluingUnits() = default;

int GluingUnits::size() const {
  return static_cast<int>(plan_->beginnings.size());
}

std::vector<std::string> GluingUnits::signatures(int k, const Progress& progress) const {
  std::vector<std::string> found;
  GluingSearch(plan_->rules, progress)
      .complete(plan_->beginnings[static_cast<std::size_t>(k)], plan_->length,
                [&](const PartialGluing& gluing) { found.push_back(SignatureWriter().write(gluing)); });
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace tetrarch::enumeration
