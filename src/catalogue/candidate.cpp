// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidate.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/catalogue/prove.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/numeric/real50.hpp"
#include "tetrarch/reasons/reason.hpp"
#include "tetrarch/verified/structure.hpp"

#include <algorithm>
#include <functional>

namespace tetrarch::catalogue::detail {
namespace {

using numeric::Real50;

std::string digits(const Real50& x) {
  constexpr int places = 30;
  return x.str(places, std::ios_base::showpoint);
}

void describe_boundary(Manifold& m, const Skeleton& skeleton) {
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    const SurfaceType& link = skeleton.link(v);
    if (link.euler == 0) {
      ++m.cusps;
      m.klein_cusps += link.orientable ? 0 : 1;
    } else {
      m.boundary.push_back(link.orientable ? link.genus() : link.euler - 2);
    }
  }
  std::sort(m.boundary.begin(), m.boundary.end(), std::greater<>());
}

/// Volume and angles from the structure in 60 digits. False if these are not those of the structure in
/// doubles.
bool describe_structure(Manifold& m, const Skeleton& skeleton,
                        const hyperbolic::Hyperbolization<double>& solved) {
  constexpr double same = 1e-9;
  const auto structure = hyperbolic::refine<Real50>(skeleton, solved);
  if (structure.outcome != hyperbolic::Outcome::geometric ||
      !(abs(structure.volume - Real50(solved.volume)) < same))
    return false;
  m.volume = digits(structure.volume);
  for (const auto& angles : structure.dihedral_angles) {
    m.dihedral_angles.emplace_back();
    for (int e = 0; e < 6; ++e) m.dihedral_angles.back()[e] = digits(angles[e]);
  }
  return true;
}

/// Certifies the structure. Where the interval decides the digits of the volume, they are its digits.
void certify(Candidate& candidate, const Triangulation& tri, const Skeleton& skeleton,
             const hyperbolic::Hyperbolization<double>& structure, const Progress& progress) {
  constexpr int bits = 128; // 38 digits: 30 are asked for
  const auto certified = verified::certify(tri, skeleton, structure, {bits, 4 * bits}, progress);
  if (!certified.proof) {
    candidate.proofs.why_not = "the structure is not certified: " + certified.why_not;
    return;
  }
  const auto interval = verified::volume_interval(*certified.proof);
  const Real50 low(interval.low);
  const Real50 high(interval.high);
  candidate.proofs.bits = certified.proof->bits;
  candidate.proofs.width = (high - low).convert_to<double>();
  if (digits(low) == digits(high)) candidate.manifold.volume = digits(low);
}

std::string letters_of(const canonical::CellsProof& proof) {
  std::string letters;
  for (const canonical::Criterion criterion : proof.criteria)
    letters += criterion == canonical::Criterion::tetrahedron ? 'T' : *to_string(criterion);
  return letters;
}

/// Certifies a structure, finds and proves its cells.
void complete(Candidate& candidate, const Triangulation& tri,
              const hyperbolic::Hyperbolization<double>& structure, bool angles, const Progress& progress) {
  const Skeleton skeleton(tri);
  Manifold& m = candidate.manifold;
  certify(candidate, tri, skeleton, structure, progress);
  canonical::Canonical cells = canonical::canonize(tri, structure, {}, progress);
  candidate.has_cells = cells.outcome == canonical::Canonical::Outcome::canonical;
  if (!candidate.has_cells) {
    candidate.proofs.why_not = "no canonical decomposition was found";
    return;
  }
  candidate.flat = cells.has_flat_faces;
  prove_cells(cells, progress);
  if (cells.proof.certified)
    candidate.proofs.cells = letters_of(cells.proof);
  else if (candidate.proofs.why_not.empty())
    candidate.proofs.why_not = "the cells are not proved: " + cells.proof.why_not;
  m.tetrahedra = tri.size();
  m.orientable = skeleton.is_orientable();
  m.signature = signature(tri);
  if ((angles || m.volume.empty()) && !describe_structure(m, skeleton, structure)) {
    candidate.has_cells = false;
    candidate.proofs.why_not = "the structure in 60 digits is not the one in doubles";
    return;
  }
  if (!angles) m.dihedral_angles.clear();
  describe_boundary(m, skeleton);
  m.edges = skeleton.edge_count();
  m.homology = algebra::homology(tri, skeleton, 1).str();
  m.cells = cells.cells;
  m.canonical_signature = cells.isometry_signature;
  m.symmetries = static_cast<int>(canonical::isometry_group(cells).size());
}

} // namespace

Candidate examine(const std::string& gluing, bool angles, const Progress& progress) {
  Candidate candidate;
  candidate.signature = gluing;
  const Triangulation tri = from_signature(gluing);
  const auto structure = hyperbolic::hyperbolize(tri, Skeleton(tri));
  if (structure.outcome != hyperbolic::Outcome::geometric) {
    candidate.reason = to_string(structure.outcome);
    return candidate;
  }
  candidate.structure = Candidate::Structure::here;
  complete(candidate, tri, structure, angles, progress);
  return candidate;
}

namespace {

/// Whether there is a reason that bears being checked.
bool is_proved_none(Candidate& candidate, const Triangulation& tri, const reasons::ReasonOptions& options,
                    const Progress& progress) {
  const auto reason = reasons::why_not_hyperbolic(tri, options, progress);
  if (!reason || !reasons::what_is_wrong(*reason).empty()) return false;
  candidate.structure = Candidate::Structure::none;
  candidate.reason = to_string(reason->kind);
  candidate.evidence = reason->text;
  return true;
}

} // namespace

Candidate settle(const std::string& gluing, bool angles, const Progress& progress) {
  Candidate candidate;
  candidate.signature = gluing;
  const Triangulation tri = from_signature(gluing);
  // Most that carry no structure have none, and the reason takes a tenth of a millisecond.
  if (is_proved_none(candidate, tri, {}, progress)) return candidate;
  hyperbolic::SearchOptions options;
  options.attempts = 200; // of four tetrahedra, nearly all that are hyperbolic elsewhere need less than ten
  const hyperbolic::Search found = find_structure(tri, options, progress);
  if (found.structure.outcome != hyperbolic::Outcome::geometric) {
    reasons::ReasonOptions further;
    further.seed = 2;
    further.changes = 100; // of five tetrahedra, 50 of 6,428 need more than the ten of before
    if (!is_proved_none(candidate, tri, further, progress)) candidate.reason = describe(found);
    return candidate;
  }
  candidate.structure = Candidate::Structure::elsewhere;
  complete(candidate, found.triangulation, found.structure, angles, progress);
  return candidate;
}

} // namespace tetrarch::catalogue::detail
