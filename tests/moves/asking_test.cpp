// SPDX-License-Identifier: GPL-2.0-or-later
// Quick ways of asking agree with asking move by move, and with making the move.
#include "support/zoo.hpp"
#include "tetrarch/moves/boundary_moves.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/pachner.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

TEST_CASE("all turns of a 0-2 move at once are those that are legal one by one", "[moves]") {
  long long legal = 0;
  long long illegal = 0;
  for (const ZooEntry& animal : zoo()) {
    const Complex complex(animal.triangulation());
    for (int t = 0; t < complex.slot_count(); ++t)
      for (int from = 0; from < 4; ++from)
        for (int to = 0; to < 4; ++to) {
          if (from == to) continue;
          const DirectedTetEdge e{t, from, to};
          const std::vector<int> turns = zero_two_turns(complex, e);
          std::vector<int> one_by_one;
          for (int turn = 0; turn <= complex.valence(complex.edge(e)); ++turn)
            if (why_not_zero_two_edge(complex, e, turn))
              ++illegal;
            else
              one_by_one.push_back(turn);
          CHECK(turns == one_by_one);
          legal += static_cast<long long>(turns.size());
        }
  }
  CHECK(legal > 1000);
  CHECK(illegal > 1000);
}

TEST_CASE("a cone is refused exactly where it cannot be made", "[moves]") {
  int made = 0;
  for (const ZooEntry& animal : zoo()) {
    const Complex complex(animal.triangulation());
    for (const auto& component : boundary_faces(complex)) {
      Complex trial = complex;
      const MaybeObstacle asked = why_not_cone(complex, component);
      CHECK(asked == cone(trial, component));
      CHECK(asked == why_not_apply(complex, {MoveKind::cone, component[0].tet, component[0].face}));
      made += asked ? 0 : 1;
    }
  }
  CHECK(made > 0);
}
