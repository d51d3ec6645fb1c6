// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/catalogue/prove.hpp"

#include "tetrarch/canonical/certify.hpp"
#include "tetrarch/verified/structure.hpp"

namespace tetrarch::catalogue {

void prove_cells(canonical::Canonical& c, const Progress& progress) {
  const Skeleton skeleton(c.triangulation);
  const auto structure = hyperbolic::hyperbolize(c.triangulation, skeleton, {}, progress);
  if (structure.outcome != hyperbolic::Outcome::geometric) {
    c.proof.why_not = "the structure was not found again";
    return;
  }
  constexpr int most_bits = 212;
  for (const int bits : {53, most_bits}) {
    const auto certified =
        verified::certify(c.triangulation, skeleton, structure, {bits, bits, false}, progress);
    c.proof = {};
    c.proof.why_not = "the structure is not certified: " + certified.why_not;
    if (!certified.proof) continue;
    const numeric::WorkingPrecision precision(bits);
    canonical::Solvers solvers;
    solvers.merged = [&](const Table<EdgeId, int>& block, double reach) {
      return verified::solve_merged(skeleton, block, structure.lengths, reach, progress);
    };
    solvers.still_wanted = [&] { progress.step("proving"); };
    if (bits == most_bits) // after all that is cheaper
      solvers.precise = [&](int enough) -> std::optional<hyperbolic::Metric<numeric::Ball>> {
        auto precise =
            verified::certify(c.triangulation, skeleton, structure, {enough, enough, false}, progress);
        if (!precise.proof) return std::nullopt;
        return std::move(precise.proof->lengths);
      };
    c.proof = canonical::certify_cells(c.triangulation, skeleton, certified.proof->lengths, c.flat, solvers);
    c.proof.bits = bits;
    if (c.proof.certified) return;
  }
}

} // namespace tetrarch::catalogue
