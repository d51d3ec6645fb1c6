// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Other processes that do a part of a job. The program has none; tetrarch-mpi has those that mpirun started.

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/progress.hpp"

#include <functional>

namespace tetrarch::program {

/// Makes all units of a classification that the records do not hold yet (catalogue/units.hpp), and keeps them
/// there.
using Crew = std::function<void(catalogue::TableKey table, bool angles, const catalogue::UnitRecords& records,
                                const Progress& progress)>;

/// To be called before the first job, if at all.
void set_crew(Crew crew);
/// Empty: there is none.
const Crew& crew();

} // namespace tetrarch::program
