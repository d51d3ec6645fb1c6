// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Classifying the manifolds from nothing, and validating the stored tables against that.
///
/// From nothing: every closed orientable gluing whose links are tori or surfaces of higher genus, no edge of
/// valence below 3; the geometric ones are solved, canonized and told apart by isometry signature; those that
/// fewer tetrahedra make are left out. Source: Frigerio-Martelli-Petronio 2004; Yin, section 4.3.4.

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/progress.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::catalogue {

/// The numbers of a classification, for the record.
struct Tally {
  int gluings = 0;   ///< closed orientable gluings that qualify
  int geometric = 0; ///< of them, those that carry a structure
  int stuck = 0;     ///< structures without a canonical decomposition within the budget
  int flat = 0;      ///< manifolds with cells other than tetrahedra
};

struct Classification {
  std::vector<Manifold>
      manifolds; ///< sorted by volume; named where `tetrahedra` <= 4; none if units are missing
  Tally tally;
  std::vector<std::string>
      stuck;             ///< signatures of gluings with a structure that has no cells within the budget
  int missing_units = 0; ///< that others have to do
};

/// Where finished units of work are kept, so that none is done twice. Empty functions: nowhere. Both may be
/// called from any thread.
struct UnitRecords {
  std::function<const std::string*(const std::string& key)> find;
  std::function<void(const std::string& key, const std::string& text)> keep;
};

/// Every `count`-th unit, beginning with number `index`, from 0.
struct Share {
  int index = 0;
  int count = 1;
};

struct WorkOptions {
  int threads = 1;
  UnitRecords records;
  std::optional<Share> share =
      Share{}; ///< what is to be done here; nothing: units come from the records alone
};

/// All manifolds of this many tetrahedra and no fewer. One second for three on two cores, a few minutes for
/// four. Deterministic for any number of threads. Throws PreconditionError unless tetrahedra >= 1.
Classification classify_manifolds(int tetrahedra, int threads = 1, const Progress& progress = {});
/// The same in units of 64 gluings, which may be kept, taken from earlier runs, and shared out. The result
/// depends on none of that. A unit that was kept counts only if it is one of the very gluings.
Classification classify_manifolds(int tetrahedra, const WorkOptions& options, const Progress& progress = {});

/// Published numbers of a table, as an outside witness.
struct Published {
  int tetrahedra = 0;
  int manifolds = 0;
  int distinct_volumes = 0;
  int single_edge = 0; ///< manifolds with one edge class
  int cusped = 0;
  const char* source = "";
};
/// Nothing if no numbers are published.
std::optional<Published> published(int tetrahedra);

/// The result of rebuilding the stored tables and solving them again.
struct Validation {
  int tetrahedra = 0;
  // Rebuilt from nothing:
  bool rebuilt = false; ///< the stored table came out again, byte for byte
  int manifolds = 0;
  std::vector<VolumeCount> volumes;
  int single_edge = 0;
  int cusped = 0;
  std::vector<std::pair<std::string, int>> by_boundary; ///< boundary text and count
  Tally tally;
  // Re-solved from length 1 and compared with the stored 30 digits:
  double max_angle_error = 0;
  double max_angle_error_flow = 0;
  double max_volume_error = 0;
  double max_volume_error_flow = 0;
  /// One line for each failure.
  std::vector<std::string> failures;
};

/// Rebuilds and re-solves. Throws InputError if no table of that many tetrahedra is stored.
Validation validate(int tetrahedra, int threads = 1, const Progress& progress = {});

} // namespace tetrarch::catalogue
