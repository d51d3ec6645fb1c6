// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidate.hpp"

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/numeric/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace tetrarch::catalogue {
namespace {

using detail::Candidate;
using Structure = Candidate::Structure;

/// Link surfaces of genus 1 and more, as far as that many tetrahedra can reach: chi(boundary) = 2 (E - T) >=
/// 2 (1 - T).
enumeration::LinkSet qualifying_links(int tetrahedra) {
  enumeration::LinkSet links;
  for (int genus = 1; genus <= tetrahedra; ++genus) links.genera.push_back(genus);
  return links;
}

bool has_geodesic_boundary(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).genus() > 1) return true;
  return false;
}

enumeration::GluingOptions qualifying_gluings(int tetrahedra) {
  enumeration::GluingOptions options;
  options.tetrahedra = tetrahedra;
  options.orientability = enumeration::GluingOptions::Orientability::orientable;
  options.links = qualifying_links(tetrahedra);
  options.min_valence = 3; // fewer tetrahedra around an edge never close up to 2 pi
  return options;
}

using Unit = std::vector<Candidate>;

/// Units of one number of tetrahedra: done here, or taken from the records.
class Workshop {
public:
  Workshop(int tetrahedra, const WorkOptions& options, const Progress& progress)
      : tetrahedra_(tetrahedra), options_(options), progress_(progress),
        gluings_(qualifying_gluings(tetrahedra), progress) {}

  /// All candidates; of units that are not there, and not for this share to do, none. They are counted.
  std::vector<Candidate> candidates(int& missing) {
    std::vector<std::optional<Unit>> units(static_cast<std::size_t>(gluings_.size()));
    for_all("solving and canonizing", [&](int k) { units[k] = examined(k); });
    for_all("looking again where there is no structure", [&](int k) { settle(k, units[k]); });
    std::vector<Candidate> all;
    for (auto& unit : units) {
      missing += !unit;
      if (unit) std::move(unit->begin(), unit->end(), std::back_inserter(all));
    }
    return all;
  }

private:
  template <class Job>
  void for_all(const char* stage, const Job& job) {
    const int count = gluings_.size();
    std::atomic<int> done{0};
    numeric::parallel_for(count, {options_.threads}, [&](int k) {
      job(k);
      progress_.step(stage, static_cast<double>(++done) / count);
    });
  }

  std::vector<std::string> signatures_of(int k) const {
    std::vector<std::string> signatures = gluings_.signatures(k, progress_.silent());
    std::erase_if(signatures, [](const std::string& text) {
      return !has_geodesic_boundary(Skeleton(from_signature(text)));
    });
    return signatures;
  }

  /// One candidate for each signature: kept from earlier, or made and kept. Nothing where that is for others.
  template <class Make>
  std::optional<Unit> made_once(int k, const std::string& key, const std::vector<std::string>& signatures,
                                const Make& make) const {
    if (signatures.empty()) return Unit();
    if (options_.records.find)
      if (const std::string* text = options_.records.find(key))
        if (auto kept = detail::read_unit(*text, signatures)) return kept;
    if (!options_.share || k % options_.share->count != options_.share->index) return std::nullopt;
    Unit made;
    for (const std::string& signature : signatures) {
      made.push_back(make(signature, options_.angles, progress_.silent()));
      progress_.silent().step({});
    }
    if (options_.records.keep) options_.records.keep(key, detail::unit_text(made));
    return made;
  }

  std::string key(int k) const { return std::to_string(tetrahedra_) + "." + std::to_string(k); }

  std::optional<Unit> examined(int k) const {
    return made_once(k, key(k), signatures_of(k), detail::examine);
  }

  /// Puts what comes of a second look in the place of gluings without a structure.
  void settle(int k, std::optional<Unit>& unit) const {
    if (!unit) return;
    std::vector<std::string> signatures;
    for (const Candidate& c : *unit)
      if (c.structure == Structure::unknown) signatures.push_back(c.signature);
    auto settled = made_once(k, key(k) + ".no", signatures, detail::settle);
    if (!settled) return unit.reset();
    auto next = settled->begin();
    for (Candidate& c : *unit)
      if (c.structure == Structure::unknown) c = std::move(*next++);
  }

  int tetrahedra_;
  const WorkOptions& options_;
  const Progress& progress_;
  enumeration::GluingUnits gluings_;
};

/// The first candidate of each isometry class that is not among `known`: rather one of the gluings, rather
/// the smaller, the first by signature.
std::vector<const Candidate*> representatives(const std::vector<Candidate>& candidates,
                                              const std::set<std::string>& known) {
  const auto rank = [](const Candidate* c) {
    return std::tuple(c->structure, c->manifold.tetrahedra, c->manifold.signature);
  };
  std::map<std::string, const Candidate*> first;
  for (const Candidate& c : candidates) {
    if (!c.has_cells || known.contains(c.manifold.canonical_signature)) continue;
    const auto [place, is_new] = first.emplace(c.manifold.canonical_signature, &c);
    if (!is_new && rank(&c) < rank(place->second)) place->second = &c;
  }
  std::vector<const Candidate*> out;
  out.reserve(first.size());
  for (const auto& entry : first) out.push_back(entry.second);
  return out;
}

void count(const Candidate& c, Classification& out, std::map<std::string, int>& reasons) {
  Tally& tally = out.tally;
  ++tally.gluings;
  tally.geometric += c.structure == Structure::here;
  tally.elsewhere += c.structure == Structure::elsewhere;
  if (c.structure == Structure::unknown) out.open.push_back({c.signature, c.reason});
  if (c.structure == Structure::none) {
    ++tally.none;
    ++reasons[c.reason];
  }
  if (c.structure > Structure::elsewhere) return;
  tally.certified += c.proofs.bits > 0;
  tally.proved += !c.proofs.cells.empty();
  tally.widest = std::max(tally.widest, c.proofs.width);
  if (!c.has_cells)
    out.stuck.push_back({c.signature, c.proofs.why_not});
  else if (!c.proofs.why_not.empty())
    out.unproved.push_back({c.signature, c.proofs.why_not});
}

void sort_by_signature(std::vector<Unsettled>& list) {
  std::sort(list.begin(), list.end(),
            [](const Unsettled& a, const Unsettled& b) { return a.signature < b.signature; });
}

} // namespace

Classification classify_manifolds(int tetrahedra, const WorkOptions& options, const Progress& progress) {
  if (tetrahedra < 1) throw PreconditionError("a classification needs at least one tetrahedron");
  Classification out;
  std::set<std::string> known;
  for (int fewer = 1; fewer < tetrahedra; ++fewer)
    for (const Candidate& c : Workshop(fewer, options, progress).candidates(out.missing_units))
      if (c.has_cells) known.insert(c.manifold.canonical_signature);
  const std::vector<Candidate> candidates =
      Workshop(tetrahedra, options, progress).candidates(out.missing_units);
  std::map<std::string, int> reasons;
  for (const Candidate& c : candidates) count(c, out, reasons);
  out.tally.stuck = static_cast<int>(out.stuck.size());
  for (auto* list : {&out.stuck, &out.unproved, &out.open}) sort_by_signature(*list);
  out.reasons.assign(reasons.begin(), reasons.end());
  std::stable_sort(out.reasons.begin(), out.reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (out.missing_units > 0) return out;
  for (const Candidate* c : representatives(candidates, known)) {
    out.tally.flat += c->flat;
    for (const char argument : c->proofs.cells) ++out.tally.arguments[argument];
    out.manifolds.push_back(c->manifold);
  }
  sort_by_volume(out.manifolds);
  for (std::size_t k = 0; k < out.manifolds.size(); ++k)
    out.manifolds[k].name = name_prefix(tetrahedra) + std::to_string(k + 1);
  return out;
}

Classification classify_manifolds(int tetrahedra, int threads, const Progress& progress) {
  WorkOptions options;
  options.threads = threads;
  return classify_manifolds(tetrahedra, options, progress);
}

} // namespace tetrarch::catalogue
