// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The units of a classification one by one, for processes that share them out as they come free:
///
///     const ClassificationUnits units(5, false);
///     for (int k = 0; k < units.size(); ++k)
///       if (!units.is_kept(k, records))
///         for (const auto& [key, text] : units.make(k)) records.keep(key, text);
///
/// Then `classify_manifolds` finds in the records what it would have done itself, whoever made them. Units
/// depend on the table's key alone, so that every process has the same.

#include "tetrarch/catalogue/validate.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tetrarch::catalogue {

class ClassificationUnits {
public:
  /// Of that many tetrahedra and of all fewer; `angles` as in WorkOptions. It finds how the gluings begin: a
  /// small part of the work. Throws PreconditionError unless tetrahedra >= 1.
  ClassificationUnits(TableKey table, bool angles, const Progress& progress = {});
  ClassificationUnits(ClassificationUnits&&) noexcept;
  ClassificationUnits& operator=(ClassificationUnits&&) noexcept;
  ~ClassificationUnits();

  int size() const;
  /// Whether the records hold unit k. Their text is not read, which `classify_manifolds` does.
  bool is_kept(int k, const UnitRecords& records) const;
  /// What is to be kept of unit k, with its keys: one record, two where gluings were looked at again, none of
  /// a unit without gluings. Any thread. Some seconds at most for a few dozen gluings.
  std::vector<std::pair<std::string, std::string>> make(int k, const Progress& progress = {}) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace tetrarch::catalogue
