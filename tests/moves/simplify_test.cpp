// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/simplify.hpp"

#include "support/audit.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/links.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/pachner.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

TEST_CASE("large triangulations of simple manifolds become the smallest ones", "[moves]") {
  // One tetrahedron is a ball; the 3-torus needs six (Matveev, "Algorithmic topology", table of complexity
  // 6).
  CHECK(simplified(cubical_ball(5, 6, 7)).size() == 1);
  const Triangulation torus = simplified(cubical_torus(5, 6, 7));
  CHECK(torus.size() == 6);
  CHECK(signature(torus) == zoo("3-torus").signature);
}

TEST_CASE("zoo animals come back from a random walk upwards", "[moves]") {
  // The smallest closed ones by Regina's census, by number of tetrahedra; a walk of 2-3 moves, then back.
  for (const char* name : {"S^3, Bing's house", "RP^3", "L(8,3)", "S^2 x S^1", "Poincare sphere", "S^3 / Q_8",
                           "Weeks manifold", "figure-eight complement m004", "knotted Y", "RP^2 x S^1",
                           "Whitehead link complement m129", "genus 2 handlebody", "solid Klein bottle"}) {
    const ZooEntry& animal = zoo(name);
    Complex complex(animal.triangulation());
    SplitMix64 random(5);
    for (int k = 0; k < 200; ++k) {
      const int t = random.below(complex.slot_count());
      if (complex.is_alive(t) && two_three(complex, {t, random.below(4)}))
        (void)zero_two_face(complex, {t, random.below(4)});
    }
    REQUIRE(complex.size() > 60);
    const std::string before = topology_and_homology(animal.triangulation());
    REQUIRE(topology_and_homology(complex.triangulation()) == before);
    (void)simplify(complex);
    INFO(name << " " << complex.size() << " " << signature(complex.triangulation()));
    CHECK(topology_and_homology(complex.triangulation()) == before);
    CHECK(disagreement(complex) == "");
    CHECK(complex.size() <= animal.triangulation().size());
  }
}

TEST_CASE("simplifying is deterministic, and its log replays", "[moves]") {
  const Triangulation tri = triangulation_of(exterior(named_link("trefoil").grid));
  MoveLog log;
  SimplifyOptions options;
  options.seed = 3;
  options.log = &log;
  Complex once(tri);
  const Simplification done = simplify(once, options);
  Complex twice(tri);
  options.log = nullptr;
  (void)simplify(twice, options);
  CHECK(once.triangulation() == twice.triangulation());

  Complex replayed(tri);
  CHECK_FALSE(replay(replayed, log));
  CHECK(replayed.triangulation() == once.triangulation());
  long long moves = 0;
  for (const Move& move : log) {
    moves += move.kind != MoveKind::pack ? 1 : 0;
    REQUIRE(parse_move(move.str()) == move);
  }
  CHECK(moves == done.counts.total());

  // Half a log on the wrong triangulation stops at a move that cannot be made, or names no tetrahedron.
  Complex other(cubical_torus(2, 2, 2));
  bool stopped = false;
  try {
    stopped = replay(other, log).has_value();
  } catch (const PreconditionError&) {
    stopped = true;
  }
  CHECK(stopped);
}

TEST_CASE("what is no move is refused as text", "[moves]") {
  for (const char* line :
       {"", "  ", "jump 3", "merge 1 2", "merge 1 2 2", "merge 1 2 4", "two_three x 1", "two_three 1 1 1",
        "four_four 0 0 1 2", "shell -1", "merge 99999999999 0 1", "pack 1"})
    CHECK_THROWS_AS(parse_move(line), InputError);
  CHECK(parse_move(" four_four  7 0 1 1\r") == Move{MoveKind::four_four, 7, 0, 1, 1});
  CHECK(parse_move("2-3 4 1") == Move{MoveKind::two_three, 4, 1});
  CHECK(parse_move("2-0 4 1") == Move{MoveKind::two_zero_vertex, 4, 1});
  CHECK(parse_move("2-0 4 1 0") == Move{MoveKind::two_zero_edge, 4, 1, 0});
  CHECK(parse_move("0-2 4 1") == Move{MoveKind::zero_two_face, 4, 1});
  CHECK(parse_move("0-2 4 1 0 2") == Move{MoveKind::zero_two_edge, 4, 1, 0, 2});
  CHECK(is_called({MoveKind::two_zero_edge, 4, 1, 0}, "2-0"));
  CHECK(is_called({MoveKind::two_zero_vertex, 4, 1}, "2-0"));
  CHECK(is_called({MoveKind::two_three, 4, 1}, "two_three"));
  CHECK_FALSE(is_called({MoveKind::two_three, 4, 1}, "3-2"));
  // Each name is taken by parse_move with some number of numbers, and is said once.
  const std::vector<std::string> names = move_names();
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  CHECK(names.size() == move_kind_count + 8);
  for (const std::string& name : names) {
    int taken = 0;
    for (const char* numbers : {"", " 4", " 4 1", " 4 1 0", " 4 1 0 1"}) {
      try {
        taken += is_called(parse_move(name + numbers), name) ? 1 : 0;
      } catch (const InputError&) {
      }
    }
    CHECK(taken == (name == "2-0" || name == "0-2" ? 2 : 1));
  }
}

TEST_CASE("the boundary stays as it is on request", "[moves]") {
  const Triangulation tri = cubical_ball(3, 3, 3);
  SimplifyOptions options;
  options.change_boundary = false;
  const Triangulation small = simplified(tri, options);
  CHECK(small.size() < tri.size());
  CHECK(Skeleton(small).boundary_face_count() == 6 * 9 * 2);
}

TEST_CASE("an audit is asked after every so many moves, and a stop is heard", "[moves]") {
  int audits = 0;
  SimplifyOptions options;
  options.audit_every = 100;
  options.audit = [&audits](const Complex& complex) {
    ++audits;
    REQUIRE(disagreement(complex) == "");
  };
  Complex complex(cubical_ball(6, 6, 6));
  const MoveCounts counts = reduce(complex, options);
  CHECK(audits == counts.total() / 100);

  std::stop_source stop;
  stop.request_stop();
  Complex large(cubical_ball(12, 12, 12));
  CHECK_THROWS_AS(simplify(large, {}, Progress({}, stop.get_token())), Stopped);
}

TEST_CASE("where the greedy part ends no single move makes it smaller", "[moves]") {
  // The law that lets an excursion look only at what its moves touched.
  std::vector<Triangulation> starts{cubical_ball(3, 3, 3), cubical_torus(4, 4, 4)};
  for (const char* name : {"trefoil", "5_2", "Hopf link"})
    starts.push_back(triangulation_of(exterior(named_link(name).grid)));
  for (const Triangulation& start : starts)
    for (const bool change_boundary : {false, true}) {
      SimplifyOptions options;
      options.change_boundary = change_boundary;
      Complex complex(start);
      (void)reduce(complex, options);
      const int size = complex.size();
      CHECK(reduce(complex, options).total() == 0);
      CHECK(complex.size() == size);
    }
}
