// SPDX-License-Identifier: GPL-2.0-or-later
#include "report.hpp"

namespace tetrarch::program {

void Report::add(Report other) {
  json.update(other.json);
  rows.insert(rows.end(), other.rows.begin(), other.rows.end());
  warnings.insert(warnings.end(), other.warnings.begin(), other.warnings.end());
}

} // namespace tetrarch::program
