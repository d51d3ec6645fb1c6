// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/numeric/parallel.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

namespace tetrarch::catalogue {
namespace {

using numeric::Real50;

/// What a gluing turned out to be.
struct Candidate {
  std::string signature;
  bool geometric = false;
  bool stuck = false;
  bool flat = false;
  Manifold manifold; ///< without its name; where it is geometric and not stuck
};

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

std::string digits(const Real50& x) {
  constexpr int places = 30;
  return x.str(places, std::ios_base::showpoint);
}

/// The full record of a gluing: everything but the name.
Manifold describe(const Triangulation& tri, const Skeleton& skeleton,
                  const hyperbolic::Hyperbolization<double>& solved, const canonical::Canonical& canonical) {
  Manifold m;
  const auto structure = hyperbolic::refine<Real50>(skeleton, solved);
  m.tetrahedra = tri.size();
  m.volume = digits(structure.volume);
  for (const auto& angles : structure.dihedral_angles) {
    m.dihedral_angles.emplace_back();
    for (int e = 0; e < 6; ++e) m.dihedral_angles.back()[e] = digits(angles[e]);
  }
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    if (skeleton.link(v).genus() == 1)
      ++m.cusps;
    else
      m.boundary.push_back(skeleton.link(v).genus());
  }
  std::sort(m.boundary.begin(), m.boundary.end(), std::greater<>());
  m.edges = skeleton.edge_count();
  m.homology = algebra::homology(tri, skeleton, 1).str();
  m.cells = canonical.cells;
  m.canonical_signature = canonical.isometry_signature;
  m.symmetries = static_cast<int>(canonical::isometry_group(canonical).size());
  return m;
}

Candidate examine(const std::string& signature, const Progress& progress) {
  Candidate candidate;
  candidate.signature = signature;
  const Triangulation tri = from_signature(signature);
  const Skeleton skeleton(tri);
  const auto structure = hyperbolic::hyperbolize(tri, skeleton);
  candidate.geometric = structure.outcome == hyperbolic::Outcome::geometric;
  if (!candidate.geometric) return candidate;
  const canonical::Canonical canonical = canonical::canonize(tri, structure, {}, progress);
  candidate.stuck = canonical.outcome != canonical::Canonical::Outcome::canonical;
  if (candidate.stuck) return candidate;
  candidate.flat = canonical.has_flat_faces;
  candidate.manifold = describe(tri, skeleton, structure, canonical);
  candidate.manifold.signature = signature;
  return candidate;
}

/// The qualifying gluings, in ASCII order of their signatures.
std::vector<std::string> qualifying_gluings(int tetrahedra, int threads, const Progress& progress) {
  enumeration::GluingOptions options;
  options.tetrahedra = tetrahedra;
  options.orientability = enumeration::GluingOptions::Orientability::orientable;
  options.links = qualifying_links(tetrahedra);
  options.min_valence = 3; // fewer tetrahedra around an edge never close up to 2 pi
  options.threads = threads;
  std::vector<std::string> signatures = enumeration::gluing_signatures(options, progress);
  std::erase_if(signatures, [](const std::string& text) {
    return !has_geodesic_boundary(Skeleton(from_signature(text)));
  });
  return signatures;
}

/// Some of the gluings, one after the other: what is done, kept and shared out as a whole.
constexpr int unit_size = 64;

std::string unit_text(const std::vector<Candidate>& unit) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Candidate& c : unit) {
    nlohmann::ordered_json item{{"signature", c.signature}};
    if (!c.geometric)
      item["outcome"] = "none";
    else if (c.stuck)
      item["outcome"] = "stuck";
    else
      item["manifold"] = nlohmann::ordered_json::parse(json_text(c.manifold));
    if (c.flat) item["flat"] = true;
    list.push_back(std::move(item));
  }
  return list.dump();
}

/// Reads a unit back; nothing unless it is one of just these gluings.
std::optional<std::vector<Candidate>> read_unit(const std::string& text,
                                                std::span<const std::string> signatures, int tetrahedra) {
  std::vector<Candidate> unit;
  try {
    for (const auto& item : nlohmann::ordered_json::parse(text)) {
      Candidate& c = unit.emplace_back();
      c.signature = item.at("signature");
      const std::string outcome = item.value("outcome", "");
      c.geometric = outcome != "none";
      c.stuck = outcome == "stuck";
      c.flat = item.value("flat", false);
      if (outcome.empty()) c.manifold = read_manifold(item.at("manifold").dump(), tetrahedra);
    }
  } catch (const nlohmann::ordered_json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
  const bool same =
      std::equal(unit.begin(), unit.end(), signatures.begin(), signatures.end(),
                 [](const Candidate& c, const std::string& signature) { return c.signature == signature; });
  return same ? std::optional(std::move(unit)) : std::nullopt;
}

/// Units of one number of tetrahedra: done here, or taken from the records.
class Workshop {
public:
  Workshop(int tetrahedra, const WorkOptions& options, const Progress& progress)
      : tetrahedra_(tetrahedra), options_(options), progress_(progress),
        signatures_(qualifying_gluings(tetrahedra, options.threads, progress)) {}

  /// All candidates; of units that are not there, and not for this share to do, none. They are counted.
  std::vector<Candidate> candidates(int& missing) {
    const int count = (static_cast<int>(signatures_.size()) + unit_size - 1) / unit_size;
    std::vector<std::optional<std::vector<Candidate>>> units(count);
    std::atomic<int> done{0};
    numeric::parallel_for(count, {options_.threads}, [&](int k) {
      units[k] = unit(k);
      progress_.step("solving and canonizing", static_cast<double>(++done) / count);
    });
    std::vector<Candidate> all;
    for (auto& unit : units) {
      missing += !unit;
      if (unit) std::move(unit->begin(), unit->end(), std::back_inserter(all));
    }
    return all;
  }

private:
  std::span<const std::string> signatures_of(int k) const {
    const std::size_t from = static_cast<std::size_t>(k) * unit_size;
    return std::span(signatures_).subspan(from, std::min<std::size_t>(unit_size, signatures_.size() - from));
  }

  std::optional<std::vector<Candidate>> unit(int k) const {
    const std::string key = std::to_string(tetrahedra_) + "." + std::to_string(k);
    if (options_.records.find)
      if (const std::string* text = options_.records.find(key))
        if (auto kept = read_unit(*text, signatures_of(k), tetrahedra_)) return kept;
    if (!options_.share || k % options_.share->count != options_.share->index) return std::nullopt;
    std::vector<Candidate> made;
    for (const std::string& signature : signatures_of(k)) {
      made.push_back(examine(signature, progress_.silent()));
      progress_.silent().step({});
    }
    if (options_.records.keep) options_.records.keep(key, unit_text(made));
    return made;
  }

  int tetrahedra_;
  const WorkOptions& options_;
  const Progress& progress_;
  std::vector<std::string> signatures_;
};

/// The first candidate (by signature) of each isometry class that is not among `known`.
std::vector<const Candidate*> representatives(const std::vector<Candidate>& candidates,
                                              const std::set<std::string>& known) {
  std::map<std::string, const Candidate*> first;
  for (const Candidate& c : candidates)
    if (c.geometric && !c.stuck && !known.contains(c.manifold.canonical_signature))
      first.emplace(c.manifold.canonical_signature, &c);
  std::vector<const Candidate*> out;
  out.reserve(first.size());
  for (const auto& entry : first) out.push_back(entry.second);
  return out;
}

} // namespace

Classification classify_manifolds(int tetrahedra, const WorkOptions& options, const Progress& progress) {
  if (tetrahedra < 1) throw PreconditionError("a classification needs at least one tetrahedron");
  Classification out;
  std::set<std::string> known;
  for (int fewer = 1; fewer < tetrahedra; ++fewer)
    for (const Candidate& c : Workshop(fewer, options, progress).candidates(out.missing_units))
      if (c.geometric && !c.stuck) known.insert(c.manifold.canonical_signature);
  const std::vector<Candidate> candidates =
      Workshop(tetrahedra, options, progress).candidates(out.missing_units);
  for (const Candidate& c : candidates) {
    ++out.tally.gluings;
    out.tally.geometric += c.geometric;
    if (c.stuck) out.stuck.push_back(c.signature);
  }
  out.tally.stuck = static_cast<int>(out.stuck.size());
  if (out.missing_units > 0) return out;
  for (const Candidate* c : representatives(candidates, known)) {
    out.tally.flat += c->flat;
    out.manifolds.push_back(c->manifold);
  }
  sort_by_volume(out.manifolds);
  constexpr int largest_named = 4;
  for (std::size_t k = 0; k < out.manifolds.size() && tetrahedra <= largest_named; ++k)
    out.manifolds[k].name = "fmp" + std::to_string(tetrahedra) + "_" + std::to_string(k + 1);
  return out;
}

Classification classify_manifolds(int tetrahedra, int threads, const Progress& progress) {
  WorkOptions options;
  options.threads = threads;
  return classify_manifolds(tetrahedra, options, progress);
}

} // namespace tetrarch::catalogue
