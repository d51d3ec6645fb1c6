// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Classifying the manifolds from nothing, and validating the stored tables against that.
///
/// From nothing: every closed gluing whose links are no spheres and no projective planes, no edge of valence
/// below 3; the geometric ones are solved, canonized and told apart by isometry signature; those that
/// fewer tetrahedra make are left out. Source: Frigerio-Martelli-Petronio 2004; Yin, section 4.3.4.

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/progress.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::catalogue {

/// The numbers of a classification, for the record.
struct Tally {
  int gluings = 0;   ///< closed gluings that qualify
  int geometric = 0; ///< of them, those that carry a structure
  int elsewhere = 0; ///< of the others, those whose manifold has a structure on another triangulation
  int none = 0;      ///< of the others, those that are proved not to be hyperbolic
  int stuck = 0;     ///< structures without a canonical decomposition within the budget
  int flat = 0;      ///< manifolds with cells other than tetrahedra
  int certified = 0; ///< structures that are proved to exist, of those here and elsewhere
  int proved = 0;    ///< canonical decompositions that are proved, of the same
  double widest = 0; ///< of the intervals that hold the volumes
  /// Of the manifolds, how many cells each argument proved: T (a tetrahedron), R, F, B
  /// (canonical/certify.hpp).
  std::map<char, int> arguments;
};

/// A gluing that is not settled, and what is known of it.
struct Unsettled {
  std::string signature;
  std::string why;
};

struct Classification {
  std::vector<Manifold> manifolds; ///< sorted by volume; named; none if units are missing
  Tally tally;
  std::vector<Unsettled> stuck;    ///< structures that have no cells within the budget
  std::vector<Unsettled> unproved; ///< structures or cells that are computed and not proved
  std::vector<Unsettled> open;     ///< no structure was found, and no proof that there is none
  std::vector<std::pair<std::string, int>>
      reasons;           ///< of the noes, with their numbers; the frequent ones first
  int missing_units = 0; ///< that others have to do
};

/// Where finished units of work are kept, so that none is done twice. Empty functions: nowhere. Both may be
/// called from any thread.
struct UnitRecords {
  std::function<const std::string*(const std::string& key)> find;
  std::function<void(const std::string& key, const std::string& text)> keep;
};

/// Records that last as long as this object, which must outlive what `both` gives. Of a key that comes twice
/// the first text stays, so that what `find` pointed to never changes.
struct RecordsInMemory {
  std::map<std::string, std::string> texts;
  std::mutex mutex;
  UnitRecords both();
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
      Share{};        ///< what is to be done here; nothing: units come from the records alone
  bool angles = true; ///< keep dihedral angles, which are nine tenths of all
};

/// All manifolds of this many tetrahedra and no fewer. One second for three on two cores, half a minute for
/// four. Every structure is certified and its cells are proved; gluings without one are looked at again, on
/// other triangulations. What is not settled is listed. Deterministic for any number of threads. Throws
/// PreconditionError unless tetrahedra >= 1.
Classification classify_manifolds(TableKey table, int threads = 1, const Progress& progress = {});
/// The same in units (enumeration::GluingUnits), which may be kept, taken from earlier runs, and shared out.
/// The result depends on none of that. A unit that was kept counts only if it is one of the very gluings.
Classification classify_manifolds(TableKey table, const WorkOptions& options, const Progress& progress = {});

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
std::optional<Published> published(TableKey table);

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

/// Rebuilds and re-solves. Throws InputError if no such table is stored.
Validation validate(TableKey table, int threads = 1, const Progress& progress = {});

} // namespace tetrarch::catalogue
