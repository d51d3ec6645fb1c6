// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Tables of manifolds in one SQLite file, for tables too long to be compiled in.
///
///     manifold: name | tetrahedra | signature | volume | volume_value | boundary | cusps | edges | homology
///               | cells | canonical_signature | symmetries | orientable | klein_cusps | symmetry_group
///               | amphichiral
///
/// A row for each manifold, in the order of names. `volume` is the text of 30 digits, `volume_value` its
/// nearest double; `boundary` and `cells` are JSON arrays; `symmetry_group` is the name of the isometry
/// group, null where it has none; `amphichiral` is 1 if an isometry reverses orientation, null where there is
/// no orientation; the others are as in census/README.md. Indexes lie on the name, the canonical signature,
/// and volume, boundary and homology, each with the number of tetrahedra first. The file is made from
/// census/*.json and census/*.jsonl.xz when the program is built, and anyone may read it: sqlite3
/// census.sqlite "select name from manifold where ...".

#include "tetrarch/catalogue/manifold.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::catalogue {

/// Which manifolds of a table are asked for. What is left out is any.
struct Wanted {
  std::optional<int> tetrahedra;
  std::optional<std::vector<int>> boundary;                       ///< genera, decreasing
  double least_volume = -std::numeric_limits<double>::infinity(); ///< both ends included
  double greatest_volume = std::numeric_limits<double>::infinity();
  std::string homology; ///< "Z^2 + Z/3"; empty: any
  std::optional<int> cusps;
  std::optional<bool> orientable;

  bool fits(const Manifold& m) const;
};

/// A file of tables, open for reading. Any thread.
class Database {
public:
  /// Throws InputError if there is no such file, or it is no file of tables.
  explicit Database(const std::string& path);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  /// Tens of microseconds, whatever the number of manifolds.
  std::optional<Manifold> by_name(std::string_view name) const;
  std::optional<Manifold> by_isometry_signature(std::string_view signature) const;
  long long count(const Wanted& wanted) const;
  /// In the order of names.
  void visit(const Wanted& wanted, const std::function<void(const Manifold&)>& visitor) const;
  /// The tables of which there are manifolds, the orientable ones first, by increasing numbers of tetrahedra.
  std::vector<TableKey> tables() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The bytes of such a file, in the order given. Names and canonical signatures must not repeat. Throws
/// InputError. 20 microseconds and half a kilobyte for each manifold.
std::string database_of(const std::vector<Manifold>& manifolds);

/// Whether there is a file that begins as SQLite's do.
bool is_database(const std::string& path);

/// The file of tables beside the program, share/tetrarch/census.sqlite, or the one that the environment
/// variable TETRARCH_CENSUS names; null if there is none. `find_by_name` and `find_by_isometry_signature`
/// look there, too. Opened at the first call.
const Database* installed_database();

} // namespace tetrarch::catalogue
