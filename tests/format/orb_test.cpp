// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/orb.hpp"

#include "expect.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/read.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

// The lines of edges are those of the example files 8knot.orb and Graphs2_0.orb that come with Orb.
const std::string orb_figure_eight = R"(% orb
8knot
SolutionType geometric_solution
vertices_known

  1  0 1.000  1  1  2xv  1ux  2vw  1xv  2ux  1vw
  2  0 1.000  1  1  2xw  1wx  2wu  1vu  2uv  1uw

  1  -23.0940107675851110    0.0000000000000523    0.0000000000000523    1.0471975511965972

9
0	129	66
)";
std::string graph() {
  return read_file(data("graphs2_0.orb"));
}

} // namespace

TEST_CASE("an Orb file is read", "[orb]") {
  const Document document = read_any(orb_figure_eight, "f");
  CHECK(document.name == "8knot");
  CHECK(document.passed_over.empty());
  // Orb's file is of the figure-eight knot's complement, and so is this signature (Regina's census, m004).
  CHECK(find_isomorphism(document.triangulation, from_signature("cPcbbbiht")));
}

TEST_CASE("an Orb file of a graph's complement is read", "[orb]") {
  const Document document = read_any(graph(), "f");
  CHECK(document.passed_over.empty());
  // The three singular edges of the file, all of order 0; by hand: 1wu is the edge vx of tetrahedron 0, 1xw
  // and 2vu the edges uv of tetrahedron 0 and wx of tetrahedron 1.
  CHECK(document.marks ==
        Marks{{{0, edge_number[1][3]}, 0}, {{0, edge_number[0][1]}, 0}, {{1, edge_number[2][3]}, 0}});
  // The second route: the degrees of the file's edges are those of the skeleton.
  const Skeleton skeleton(document.triangulation);
  CHECK(skeleton.is_orientable());
  std::vector<int> degrees;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) degrees.push_back(skeleton.valence(e));
  std::sort(degrees.begin(), degrees.end());
  CHECK(degrees == std::vector<int>{1, 1, 4, 6});
  // Signature by Regina of the same gluings.
  CHECK(find_isomorphism(document.triangulation, from_signature("cMcabbgig")));
}

TEST_CASE("wrong Orb files", "[bad][orb]") {
  const auto spoilt = [](const std::string& from, const std::string& to) {
    return complaint(with(orb_figure_eight, from, to));
  };
  CHECK(complaint("% orb") == "f:1: the text ends, expected the first edge");
  CHECK(spoilt("1wx", "1wy") == "f:7: found '1wy', expected a tetrahedron and two of its faces, like 2xv");
  CHECK(spoilt("1wx", "0wx") == "f:7: found '0wx', expected a tetrahedron and two of its faces, like 2xv");
  CHECK(spoilt("1wx", "3wx") ==
        "f:7: found '3wx', expected six edges of each tetrahedron; the edges have 12 in all");
  CHECK(spoilt("  1uw", "").substr(0, 16) == "f:6: found '2xv'");
  CHECK(spoilt("1wx", "1xw") == "f:7: found '2xw', expected the gluing that another edge says");
  CHECK(spoilt("  2  0 1.000", "  2  1 0.500") ==
        "f:7: found '0.500', expected a singular order: 0, 1 or a number above 1");
  CHECK(spoilt("  2  0 1.000", "  3  0 1.000") == "f:7: found '3', expected the number of an edge, 2");
  CHECK(spoilt("  2  0 1.000  1  1  2xw  1wx  2wu  1vu  2uv  1uw", "  2  0") ==
        "f:7: the line ends, expected a singular order");
  for (std::size_t size = 0; size < orb_figure_eight.find("\n\n  1  -23"); ++size) {
    const std::string message = complaint(orb_figure_eight.substr(0, size));
    INFO(size << ": " << message);
    CHECK((size < 2 || !message.empty()));
    CHECK(message.find('\n') == std::string::npos);
  }
}
