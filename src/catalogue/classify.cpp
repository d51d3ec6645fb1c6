// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidate.hpp"

#include "tetrarch/catalogue/units.hpp"
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

/// Link surfaces without positive Euler characteristic, as far as that many tetrahedra can reach:
/// chi(boundary) = 2 (E - T) >= 2 (1 - T).
enumeration::LinkSet qualifying_links(TableKey table) {
  enumeration::LinkSet links;
  for (int genus = 1; genus <= table.tetrahedra; ++genus) links.genera.push_back(genus);
  if (!table.orientable)
    for (int crosscaps = 2; crosscaps <= 2 * table.tetrahedra; ++crosscaps)
      links.crosscaps.push_back(crosscaps);
  return links;
}

bool has_geodesic_boundary(const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (skeleton.link(v).euler < 0) return true;
  return false;
}

enumeration::GluingOptions qualifying_gluings(TableKey table) {
  using Orientability = enumeration::GluingOptions::Orientability;
  enumeration::GluingOptions options;
  options.tetrahedra = table.tetrahedra;
  options.orientability = table.orientable ? Orientability::orientable : Orientability::nonorientable;
  options.links = qualifying_links(table);
  options.min_valence = 3; // fewer tetrahedra around an edge never close up to 2 pi
  return options;
}

using Unit = std::vector<Candidate>;

bool has(const Share& share, int k) {
  return k % share.count == share.index;
}

/// Units of one number of tetrahedra: done here, or taken from the records.
class Workshop {
public:
  Workshop(TableKey table, const Progress& progress)
      : table_(table), gluings_(qualifying_gluings(table), progress) {}

  int size() const { return gluings_.size(); }
  std::string key(int k) const {
    return (table_.orientable ? "" : "n") + std::to_string(table_.tetrahedra) + "." + std::to_string(k);
  }
  static std::string second_key(const std::string& key) { return key + ".no"; }

  /// All candidates; of units that are not there, and not for this share to do, none. They are counted.
  std::vector<Candidate> candidates(const WorkOptions& options, int& missing,
                                    const Progress& progress) const {
    std::vector<std::optional<Unit>> units(static_cast<std::size_t>(size()));
    const auto for_all = [&](const char* stage, const auto& job) {
      std::atomic<int> done{0};
      numeric::parallel_for(size(), {options.threads}, [&](int k) {
        job(k);
        progress.step(stage, static_cast<double>(++done) / size());
      });
    };
    for_all("solving and canonizing", [&](int k) { units[k] = examined(k, options, progress.silent()); });
    for_all("looking again where there is no structure",
            [&](int k) { settle(k, units[k], options, progress.silent()); });
    std::vector<Candidate> all;
    for (auto& unit : units) {
      missing += !unit;
      if (unit) std::move(unit->begin(), unit->end(), std::back_inserter(all));
    }
    return all;
  }

  std::optional<Unit> examined(int k, const WorkOptions& options, const Progress& progress) const {
    // To find the gluings of what others do would cost each of a thousand shares as much as all the gluings.
    const bool is_kept = options.records.find && options.records.find(key(k)) != nullptr;
    if (options.share && !has(*options.share, k) && !is_kept) return std::nullopt;
    return made_once(k, key(k), signatures_of(k, progress), detail::examine, options, progress);
  }

  /// Puts what comes of a second look in the place of gluings without a structure.
  void settle(int k, std::optional<Unit>& unit, const WorkOptions& options, const Progress& progress) const {
    if (!unit) return;
    std::vector<std::string> signatures;
    for (const Candidate& c : *unit)
      if (c.structure == Structure::unknown) signatures.push_back(c.signature);
    auto settled = made_once(k, second_key(key(k)), signatures, detail::settle, options, progress);
    if (!settled) return unit.reset();
    auto next = settled->begin();
    for (Candidate& c : *unit)
      if (c.structure == Structure::unknown) c = std::move(*next++);
  }

private:
  std::vector<std::string> signatures_of(int k, const Progress& progress) const {
    std::vector<std::string> signatures = gluings_.signatures(k, progress);
    std::erase_if(signatures, [](const std::string& text) {
      return !has_geodesic_boundary(Skeleton(from_signature(text)));
    });
    return signatures;
  }

  /// One candidate for each signature: kept from earlier, or made and kept. Nothing where that is for others.
  template <class Make>
  std::optional<Unit> made_once(int k, const std::string& key, const std::vector<std::string>& signatures,
                                const Make& make, const WorkOptions& options,
                                const Progress& progress) const {
    if (signatures.empty()) return Unit();
    if (options.records.find)
      if (const std::string* text = options.records.find(key))
        if (auto kept = detail::read_unit(*text, signatures)) return kept;
    if (!options.share || !has(*options.share, k)) return std::nullopt;
    Unit made;
    for (const std::string& signature : signatures) {
      made.push_back(make(signature, options.angles, progress));
      progress.step({});
    }
    if (options.records.keep) options.records.keep(key, detail::unit_text(made));
    return made;
  }

  TableKey table_;
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

void count_candidate(const Candidate& c, Classification& out, std::map<std::string, int>& reasons) {
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

Classification classify_manifolds(TableKey table, const WorkOptions& options, const Progress& progress) {
  if (table.tetrahedra < 1) throw PreconditionError("a classification needs at least one tetrahedron");
  Classification out;
  std::set<std::string> known;
  for (int fewer = 1; fewer < table.tetrahedra; ++fewer)
    for (const Candidate& c :
         Workshop({fewer, table.orientable}, progress).candidates(options, out.missing_units, progress))
      if (c.has_cells) known.insert(c.manifold.canonical_signature);
  const std::vector<Candidate> candidates =
      Workshop(table, progress).candidates(options, out.missing_units, progress);
  std::map<std::string, int> reasons;
  for (const Candidate& c : candidates) count_candidate(c, out, reasons);
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
    out.manifolds[k].name = name_prefix(table) + std::to_string(k + 1);
  return out;
}

/// The long units come first, so that the short ones fill the end.
struct ClassificationUnits::State {
  State(TableKey table, bool with_angles, const Progress& progress) : angles(with_angles) {
    for (int n = table.tetrahedra; n >= 1; --n) {
      workshops.emplace_back(TableKey(n, table.orientable), progress);
      for (int k = 0; k < workshops.back().size(); ++k) units.emplace_back(table.tetrahedra - n, k);
    }
  }
  bool angles;
  std::vector<Workshop> workshops;
  std::vector<std::pair<int, int>> units; ///< the workshop's number, and the unit's in it
};

ClassificationUnits::ClassificationUnits(TableKey table, bool angles, const Progress& progress) {
  if (table.tetrahedra < 1) throw PreconditionError("a classification needs at least one tetrahedron");
  state_ = std::make_unique<State>(table, angles, progress);
}

ClassificationUnits::ClassificationUnits(ClassificationUnits&&) noexcept = default;
ClassificationUnits& ClassificationUnits::operator=(ClassificationUnits&&) noexcept = default;
ClassificationUnits::~ClassificationUnits() = default;

int ClassificationUnits::size() const {
  return static_cast<int>(state_->units.size());
}

UnitRecords RecordsInMemory::both() {
  return {[this](const std::string& key) -> const std::string* {
            const std::lock_guard lock(mutex);
            const auto found = texts.find(key);
            return found == texts.end() ? nullptr : &found->second;
          },
          [this](const std::string& key, const std::string& text) {
            const std::lock_guard lock(mutex);
            texts.emplace(key, text);
          }};
}

bool ClassificationUnits::is_kept(int k, const UnitRecords& records) const {
  const auto [n, unit] = state_->units.at(k);
  const std::string key = state_->workshops[n].key(unit);
  const std::string* first = records.find(key);
  return first != nullptr && (!detail::leaves_unknown(*first) || records.find(Workshop::second_key(key)));
}

std::vector<std::pair<std::string, std::string>> ClassificationUnits::make(int k,
                                                                           const Progress& progress) const {
  const auto [n, unit] = state_->units.at(k);
  std::vector<std::pair<std::string, std::string>> made;
  WorkOptions options;
  options.angles = state_->angles;
  options.records.keep = [&made](const std::string& key, const std::string& text) {
    made.emplace_back(key, text);
  };
  std::optional<Unit> candidates = state_->workshops[n].examined(unit, options, progress);
  state_->workshops[n].settle(unit, candidates, options, progress);
  return made;
}

Classification classify_manifolds(TableKey table, int threads, const Progress& progress) {
  WorkOptions options;
  options.threads = threads;
  return classify_manifolds(table, options, progress);
}

} // namespace tetrarch::catalogue
