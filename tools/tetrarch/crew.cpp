// SPDX-License-Identifier: GPL-2.0-or-later
#include "crew.hpp"

#include <utility>

namespace tetrarch::program {
namespace {

Crew& the_crew() {
  static Crew crew;
  return crew;
}

} // namespace

void set_crew(Crew crew) {
  the_crew() = std::move(crew);
}

const Crew& crew() {
  return the_crew();
}

} // namespace tetrarch::program
