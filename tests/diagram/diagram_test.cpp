// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/diagram.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/write.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::diagram;

namespace {

Diagram read(const std::string& code) {
  return read_diagram(code, "test");
}

std::string refusal(const std::string& code) {
  try {
    read(code);
  } catch (const InputError& e) {
    return e.what();
  }
  return "read";
}

/// Whether one dart of a can be sent to one of b so that everything else follows; of connected diagrams.
bool are_same(const Diagram& a, const Diagram& b) {
  if (a.dart_count() != b.dart_count()) return false;
  for (int start = 0; start < b.dart_count(); ++start) {
    std::vector<int> image(static_cast<std::size_t>(a.dart_count()), -1);
    std::vector<int> queue{0};
    image[0] = start;
    bool good = true;
    const auto send = [&](int d, int e) {
      if (image[d] < 0) {
        image[d] = e;
        queue.push_back(d);
      }
      good &= image[d] == e;
    };
    for (std::size_t k = 0; good && k < queue.size(); ++k) {
      const int d = queue[k];
      const int e = image[d];
      good &= a.at_crossing(d) == b.at_crossing(e) && (!a.at_crossing(d) || a.is_over(d) == b.is_over(e));
      send(a.opposite(d), b.opposite(e));
      send(a.turned(d, 1), b.turned(e, 1));
    }
    if (good) return true;
  }
  return false;
}

} // namespace

TEST_CASE("the code of a knot is that of the same diagram", "[diagram]") {
  for (const char* code :
       {"PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]", "DT[4, 6, 8, 2]", "DT[4, 8, 10, 2, 6]",
        "embedding:4 { 0: (4, 5, 6), 1: (3, 6, 5), 2: (3, 4, 6, 6), 3: (1, 5, 4, 2), "
        "4: (0, 2, 3, 5), 5: (0, 4, 3, 1), 6: (0, 1, 2, 2) }"}) {
    const Diagram d = read(code);
    const std::string written = planar_diagram_code(d);
    INFO(written);
    CHECK(are_same(d, read(written)));
    CHECK_FALSE(are_same(mirrored(read("PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]")), d));
  }
}

TEST_CASE("the trefoil's diagram has what one counts on paper", "[diagram]") {
  const Diagram trefoil = read("PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]");
  CHECK(crossing_count(trefoil) == 3);
  CHECK(trefoil.arc_count() == 6);
  CHECK(regions(trefoil).count == 5);
  CHECK(components(trefoil).count == 1);
  CHECK(edges(trefoil).count == 1);
  CHECK(parts(trefoil).count == 1);
  CHECK(mirrored(mirrored(trefoil)) == trefoil);
  CHECK_FALSE(mirrored(trefoil) == trefoil);
}

TEST_CASE("codes of one diagram have the same counts", "[diagram]") {
  for (const char* code :
       {"braid 1 -2 1 -2", "Braid[3, {1, -2, 1, -2}]", "BR(3, [1, -2, 1, -2])", "DT[4, 6, 8, 2]",
        "DT: [(4, 6, 8, 2)]", "DT[dadbcda]", "Gauss[-1, 2, -3, 1, -4, 3, -2, 4]", "U1-O2-U3-O1-U4-O3-U2-O4",
        "[[4, 2, 5, 1], [8, 6, 1, 5], [6, 3, 7, 4], [2, 7, 3, 8]]",
        "PD: [(4, 2, 5, 1), (8, 6, 1, 5), (6, 3, 7, 4), (2, 7, 3, 8)]"}) {
    INFO(code);
    const Diagram d = read(code);
    CHECK(looks_like_diagram(code));
    CHECK(crossing_count(d) == 4);
    CHECK(components(d).count == 1);
    CHECK(regions(d).count == 6);
  }
}

TEST_CASE("diagrams of graphs, of several parts and without crossings", "[diagram]") {
  const Diagram theta = read("V[1, 2, 3] V[3, 2, 1]");
  CHECK(vertex_count(theta) == 2);
  CHECK(edges(theta).count == 3);
  CHECK(regions(theta).count == 3);
  const Diagram two_circles = read("Loop[1] Loop[2]");
  CHECK(parts(two_circles).count == 2);
  CHECK(components(two_circles).count == 2);
  CHECK(crossing_count(two_circles) == 0);
  const Diagram strands = read("Braid[4, {1, 1}]");
  CHECK(components(strands).count == 4);
  CHECK(parts(strands).count == 3);
}

TEST_CASE("writing a code and reading it gives the diagram", "[diagram]") {
  for (const char* code : {"braid 1 -2 1 -2", "braid 1 1", "braid 1", "V[1, 2, 3] V[3, 2, 1]",
                           "Loop[1] Loop[7]", "V[1, 1]", "V[1, 1, 2] V[2, 3, 3]", "V[1]V[1]",
                           "embedding:2 { 0: (3, 4, 5), 1: (2, 5, 4), 2: (1, 3, 5, 5), 3: (0, 2, 4, 4), "
                           "4: (0, 3, 3, 1), 5: (0, 1, 2, 2) }"}) {
    const Diagram d = read(code);
    const std::string written = planar_diagram_code(d);
    INFO(code << " is " << written);
    const Diagram again = read(written);
    CHECK(crossing_count(again) == crossing_count(d));
    CHECK(vertex_count(again) == vertex_count(d));
    CHECK(edges(again).count == edges(d).count);
    CHECK(components(again).count == components(d).count);
    CHECK(parts(again).count == parts(d).count);
    CHECK(regions(again).count == regions(d).count);
  }
}

TEST_CASE("bad codes are refused with their place", "[diagram]") {
  CHECK(refusal("") == "test:1: the file is empty (expected the code of a diagram)");
  CHECK(refusal("PD[X[1, 2, 3, 4]]") == "test:1: arc 1 has 1 end (expected 2)");
  CHECK(refusal("X[1, 1, 1, 2] V[2]") == "test:1: arc 1 has 3 ends (expected 2)");
  CHECK(refusal("X[1, 1, 2]") == "test:1: a crossing has 3 arcs (expected 4)");
  CHECK(refusal("[[1, 2, 3, 4], [1, 2, 3, 4]]") == "test: no diagram: the order of the arcs round the nodes "
                                                   "is that of a surface of genus 1 (expected the plane)");
  CHECK(refusal("PD[X[1, 2, 2, 1]") == "test:1: the code ends (expected ']')");
  CHECK(refusal("PD[X[1, b, 2, 1]]") == "test:1: found 'b' (expected the number of an arc)");
  CHECK(refusal("braid 1 0") ==
        "test:1: a generator of the braid group is 0 (expected 1, 2, ... or -1, -2, ...)");
  CHECK(refusal("braid 1\n2 x") ==
        "test:2: found 'x' (expected a generator of the braid group, a number other than 0)");
  CHECK(refusal("Braid[2, {3}]") == "test:1: the braid has 2 strands, and a generator needs 4");
  CHECK(refusal("DT[4, 6, 3]") == "test:1: found 3 (expected even numbers from 2 to 6)");
  CHECK(refusal("DT[4, 4, 2]") == "test:1: the DT code lists 4 twice");
  CHECK(refusal("Gauss[1, 2, -1, -2]") == "test:1: no plane diagram has this code");
  CHECK(refusal("Gauss[1, 1]") == "test:1: crossing 1 is passed twice over");
  CHECK(refusal("Gauss[1]") == "test:1: crossing 1 is passed once (expected twice)");
  CHECK(refusal("embedding:0 { 0: (1, 1, 1), 1: (0, 0) }") ==
        "test:1: vertex 0 lists 1 3 times, and is listed by it 2 times");
  CHECK(refusal("embedding:0 { 0: (1, 1, 1), 0: (0, 0, 0) }") == "test:1: vertex 0 is listed twice");
  CHECK(refusal("embedding:0 { 0: (1, 2), 1: (0, 2) }") == "test:1: vertex 0 lists 2, which is no vertex");
  CHECK(refusal("embedding:0 { 0: (0, 1, 1), 1: (0, 0, 2), 2: (1) }") ==
        "test:1: vertex 0 lists itself 1 times: a loop has two ends");
  CHECK(refusal("embedding:8 { 0: (1, 1, 1), 1: (0, 0, 0) }") ==
        "test:1: the choice has more bits than there are crossings");
  CHECK(refusal("V[1, 2, 3] V[1, 2, 3]").find("genus 1") != std::string::npos);
}

TEST_CASE("a code is told from other texts", "[diagram]") {
  for (const char* text : {"cPcbbbiht", "m004", "4_1", "< a | >", "{ \"format\": 1 }", "x", "vertex", "braid",
                           "[1, 2]", "DT", "OFF", "o 3"})
    CHECK(looks_like_diagram(text) == (std::string(text) == "o 3"));
}

TEST_CASE("a diagram keeps its laws", "[diagram]") {
  CHECK_THROWS_AS(Diagram({Node{{0, 1}, false, 0}}, {0, 1}), PreconditionError);
  CHECK_THROWS_AS(Diagram({Node{{0, 0}, false, 0}}, {1, 0}), PreconditionError);
  CHECK_THROWS_AS(Diagram({Node{{0, 1}, true, 0}}, {1, 0}), PreconditionError);
  CHECK_THROWS_AS(Diagram({Node{{}, false, 0}}, {}), PreconditionError);
  CHECK(regions(circle()).count == 2);
}
