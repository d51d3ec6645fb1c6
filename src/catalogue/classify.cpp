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
#include <set>

namespace tetrarch::catalogue {
namespace {

using numeric::Real50;

/// What a gluing turned out to be.
struct Candidate {
  std::string signature;
  bool geometric = false;
  bool stuck = false;
  canonical::Canonical canonical;
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

void examine(Candidate& candidate, const Progress& progress) {
  const Triangulation tri = from_signature(candidate.signature);
  const Skeleton skeleton(tri);
  const auto structure = hyperbolic::hyperbolize(tri, skeleton);
  candidate.geometric = structure.outcome == hyperbolic::Outcome::geometric;
  if (!candidate.geometric) return;
  candidate.canonical = canonical::canonize(tri, structure, {}, progress);
  candidate.stuck = candidate.canonical.outcome != canonical::Canonical::Outcome::canonical;
}

std::vector<Candidate> examine_gluings(int tetrahedra, int threads, const Progress& progress) {
  enumeration::GluingOptions options;
  options.tetrahedra = tetrahedra;
  options.orientability = enumeration::GluingOptions::Orientability::orientable;
  options.links = qualifying_links(tetrahedra);
  options.min_valence = 3; // fewer tetrahedra around an edge never close up to 2 pi
  options.threads = threads;
  std::vector<Candidate> candidates;
  for (const std::string& text : enumeration::gluing_signatures(options, progress))
    if (has_geodesic_boundary(Skeleton(from_signature(text)))) candidates.emplace_back().signature = text;
  std::atomic<int> done{0};
  const int count = static_cast<int>(candidates.size());
  numeric::parallel_for(count, {threads}, [&](int k) {
    examine(candidates[k], progress.silent());
    progress.step("solving and canonising", static_cast<double>(++done) / count);
  });
  return candidates;
}

std::string digits(const Real50& x) {
  constexpr int places = 30;
  return x.str(places, std::ios_base::showpoint);
}

/// The full record of a gluing: everything but the name.
Manifold describe(const Candidate& candidate) {
  Manifold m;
  const Triangulation tri = from_signature(candidate.signature);
  const Skeleton skeleton(tri);
  const auto structure = hyperbolic::refine<Real50>(skeleton, hyperbolic::hyperbolize(tri, skeleton));
  m.tetrahedra = tri.size();
  m.signature = candidate.signature;
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
  m.cells = candidate.canonical.cells;
  m.canonical_signature = candidate.canonical.isometry_signature;
  m.symmetries = static_cast<int>(canonical::isometry_group(candidate.canonical).size());
  return m;
}

/// The first candidate (by signature) of each isometry class that is not among `known`.
std::vector<const Candidate*> representatives(const std::vector<Candidate>& candidates,
                                              const std::set<std::string>& known) {
  std::map<std::string, const Candidate*> first;
  for (const Candidate& c : candidates)
    if (c.geometric && !c.stuck && !known.contains(c.canonical.isometry_signature))
      first.emplace(c.canonical.isometry_signature, &c);
  std::vector<const Candidate*> out;
  out.reserve(first.size());
  for (const auto& entry : first) out.push_back(entry.second);
  return out;
}

} // namespace

Classification classify_manifolds(int tetrahedra, int threads, const Progress& progress) {
  if (tetrahedra < 1) throw PreconditionError("a classification needs at least one tetrahedron");
  std::set<std::string> known;
  for (int fewer = 1; fewer < tetrahedra; ++fewer)
    for (const Candidate& c : examine_gluings(fewer, threads, progress))
      if (c.geometric) known.insert(c.canonical.isometry_signature);
  const std::vector<Candidate> candidates = examine_gluings(tetrahedra, threads, progress);
  const auto chosen = representatives(candidates, known);
  Classification out;
  for (const Candidate& c : candidates) {
    ++out.tally.gluings;
    out.tally.geometric += c.geometric;
    out.tally.stuck += c.stuck;
  }
  out.manifolds.resize(chosen.size());
  numeric::parallel_for(static_cast<int>(chosen.size()), {threads}, [&](int k) {
    progress.step("thirty digits");
    out.manifolds[k] = describe(*chosen[k]);
  });
  for (const Candidate* c : chosen) out.tally.flat += c->canonical.has_flat_faces;
  sort_by_volume(out.manifolds);
  constexpr int largest_named = 3;
  for (std::size_t k = 0; k < out.manifolds.size() && tetrahedra <= largest_named; ++k)
    out.manifolds[k].name = "fmp" + std::to_string(tetrahedra) + "_" + std::to_string(k + 1);
  return out;
}

} // namespace tetrarch::catalogue
