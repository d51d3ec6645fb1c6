// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/census/gluings.hpp"

#include "gluings_search.hpp"
#include "gluings_signature.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

namespace tetrarch::census {
namespace {

constexpr std::string_view stage = "gluings";

void require_sensible(const GluingOptions& options) {
  if (options.tetrahedra < 1 || options.tetrahedra > max_gluing_tetrahedra)
    throw PreconditionError("gluings of " + std::to_string(options.tetrahedra) +
                            " tetrahedra: their number must be from 1 to " +
                            std::to_string(max_gluing_tetrahedra));
  if (options.threads < 1) throw PreconditionError("gluings: at least one thread is needed");
}

/// The search cut into pieces that do not depend on the number of threads.
struct Plan {
  Plan(const GluingOptions& options, const Progress& progress)
      : rules(options), length(options.tetrahedra),
        beginnings(GluingSearch(rules, progress).beginnings(length)) {}

  GluingRules rules;
  int length; ///< n letters: thousands of pieces of five tetrahedra, and none has more than a small part of
              ///< all
  std::vector<GluingSearch::Text> beginnings;
};

/// Workers take one piece after the other; the results leave in the order of the pieces.
template <class Item>
class Workshop {
public:
  using Make = std::function<Item(const PartialGluing&)>;
  using Deliver = std::function<void(Item&&)>;

  Workshop(const Plan& plan, Make make, const Progress& progress)
      : plan_(plan), make_(std::move(make)), progress_(progress) {}

  void run(int threads, const Deliver& deliver) {
    std::vector<std::jthread> workers;
    workers.reserve(static_cast<std::size_t>(threads));
    const Finally stop{*this};
    for (int k = 0; k < threads; ++k) workers.emplace_back([this] { work(); });
    const std::size_t pieces = plan_.beginnings.size();
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      progress_.step(stage, static_cast<double>(piece) / static_cast<double>(pieces));
      for (Item& item : wait_for(piece)) deliver(std::move(item));
    }
  }

private:
  /// Sends the workers home, however `run` is left; it is destroyed before they are joined.
  struct Finally {
    Workshop& shop;
    explicit Finally(Workshop& s) : shop(s) {}
    Finally(const Finally&) = delete;
    Finally& operator=(const Finally&) = delete;
    ~Finally() {
      const std::lock_guard lock(shop.mutex_);
      shop.closed_ = true;
      shop.changed_.notify_all();
    }
  };

  void work() {
    try {
      GluingSearch search(plan_.rules, progress_);
      for (std::size_t piece = 0; take(piece);) {
        std::vector<Item> items;
        search.complete(plan_.beginnings[piece], plan_.length,
                        [&](const PartialGluing& gluing) { items.push_back(make_(gluing)); });
        const std::lock_guard lock(mutex_);
        done_.emplace(piece, std::move(items));
        changed_.notify_all();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      changed_.notify_all();
    }
  }

  /// The next piece, unless the workers are too far ahead of the deliveries: then waits. False: go home.
  bool take(std::size_t& piece) {
    constexpr std::size_t max_lead = 256; // bounds the memory where a visitor is slow
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || failure_ || taken_ < delivered_ + max_lead; });
    if (closed_ || failure_ || taken_ == plan_.beginnings.size()) return false;
    piece = taken_++;
    return true;
  }

  std::vector<Item> wait_for(std::size_t piece) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || done_.contains(piece); });
    if (failure_) std::rethrow_exception(failure_);
    std::vector<Item> items = std::move(done_.extract(piece).mapped());
    delivered_ = piece + 1;
    changed_.notify_all();
    return items;
  }

  const Plan& plan_;
  Make make_;
  const Progress& progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t taken_ = 0;
  std::size_t delivered_ = 0;
  std::map<std::size_t, std::vector<Item>> done_;
  std::exception_ptr failure_;
  bool closed_ = false;
};

template <class Item>
void run(const GluingOptions& options, typename Workshop<Item>::Make make,
         const typename Workshop<Item>::Deliver& deliver, const Progress& progress) {
  require_sensible(options);
  const Plan plan(options, progress);
  if (options.threads > 1) {
    Workshop<Item>(plan, std::move(make), progress).run(options.threads, deliver);
    return;
  }
  GluingSearch search(plan.rules, progress);
  const auto pieces = static_cast<double>(plan.beginnings.size());
  double piece = 0;
  for (const GluingSearch::Text& beginning : plan.beginnings) {
    progress.step(stage, piece++ / pieces);
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

} // namespace tetrarch::census
