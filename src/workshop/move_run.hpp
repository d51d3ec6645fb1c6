// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What conversions by moves share: their options and their clock.

#include "tetrarch/workshop/simplify.hpp"

#include <array>
#include <chrono>

namespace tetrarch::workshop {

/// What the room `moves` is asked for; the log is that of `result`.
moves::SimplifyOptions moves_for(const Triangulation& tri, const MoveOptions& options,
                                 Simplification& result);

/// Runs `work` and takes its time into `result`.
template <class Work>
auto timed(Simplification& result, Work work) {
  const auto start = std::chrono::steady_clock::now();
  auto made = work();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return made;
}

/// What each of them says besides what came out.
template <class Result>
std::array<Field<Result>, 2> fields_of_run() {
  return {{{{"input_tetrahedra", "", "number of tetrahedra of the input", type::integer},
            [](const Result& r) -> Tree { return r.input_tetrahedra; }},
           {{"seconds", "seconds", "time that the moves took", type::number},
            [](const Result& r) -> Tree { return r.seconds; }}}};
}

} // namespace tetrarch::workshop
