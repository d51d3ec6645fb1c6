// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/fmp.hpp"

#include "expect.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/format/json.hpp"
#include "tetrarch/format/read.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

// The gluings are the knotted Y's as the dissertation prints them (support/zoo.hpp), the angle is pi/6 and
// the volume 6.45199027 (Frigerio, Martelli, Petronio 2004); group and homology are only there to be carried
// along.
const std::string knotted_y = R"(2
   1    1    1    1
 1230 3012 0321 0213
   0    0    0    0
 1230 3012 0321 0213
Dihedral angles:
N. 0  0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756
N. 1  0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756
Volume: 6.451990270835
Volumes of tetrahedra: 3.2259951354175 3.2259951354175
Boundary: T^(2)
Fundamental group: < a,b | >
Homology: Z^2
-------------------
)";

std::string record_complaint(const std::string& text) {
  return error_of([&] { read_fmp(text, "f"); });
}

} // namespace

TEST_CASE("a census record is read", "[fmp]") {
  const std::vector<FmpRecord> records = read_fmp(knotted_y, "f");
  REQUIRE(records.size() == 1);
  const FmpRecord& record = records[0];
  CHECK(record.triangulation == support::knotted_y());
  REQUIRE(record.dihedral_angles.size() == 2);
  CHECK(record.dihedral_angles[1][5] == 0.5235987756);
  CHECK(record.volume == 6.451990270835);
  CHECK(record.tetrahedron_volumes == std::vector<double>(2, 3.2259951354175));
  CHECK(record.boundary_genera == std::vector<int>{2});
  CHECK(record.fundamental_group == "< a,b | >");
  CHECK(record.homology == "Z^2");
  CHECK(record.other.empty());
  CHECK(write_fmp(records) == knotted_y);
}

TEST_CASE("the excerpt that is known of the original files is read", "[fmp]") {
  // The gluings, volume and boundary lines of the last manifold of the four-tetrahedra list, as quoted by
  // others from the authors' file: a compact boundary component of genus 2 and two cusps (the paper counts
  // one such).
  const std::string excerpt = R"(4
   1    1    1    2
 0213 2103 1023 1230
   0    0    0    3
 0213 2103 1023 3120
   0    3    3    3
 3012 0132 0321 0213
   1    2    2    2
 3120 0132 0321 0213
Volume: 9.1344754117
Boundary: T^(1) T^(2) T^(1)
-------------------
)";
  const FmpRecord record = read_fmp(excerpt, "f").at(0);
  CHECK(record.volume == 9.1344754117);
  CHECK(record.boundary_genera == std::vector<int>{1, 2, 1});
  CHECK(record.other.empty());
  // The skeleton agrees with what the file says of the boundary: an independent route.
  const Skeleton skeleton(record.triangulation);
  std::vector<int> genera;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) genera.push_back(skeleton.link(v).genus());
  std::sort(genera.begin(), genera.end());
  CHECK(genera == std::vector<int>{1, 1, 2});
}

TEST_CASE("other spellings of a census record are understood", "[fmp]") {
  const std::string text = R"(

  2   1 1 1 1   1230 3012 0321 0213
  0 0 0 0
  1230 3012 0321 0213
Angles
N.0: 1 2 3 4 5 6
N. 1:  1 2 3 4 5 6.5

VOLUME : 6.5
Volumes:
3 3.5
T^(2)
Boundary:
T^(2) T^(1)
pi_1: <a | a^2>
H_1: Z/2
Remark: found by hand
another remark 5
----
)";
  const FmpRecord record = read_fmp(text, "f").at(0);
  CHECK(record.dihedral_angles[1][5] == 6.5);
  CHECK(record.volume == 6.5);
  CHECK(record.tetrahedron_volumes == std::vector<double>{3, 3.5});
  CHECK(record.boundary_genera == std::vector<int>{2});
  CHECK(record.fundamental_group == "<a | a^2>");
  CHECK(record.homology == "Z/2");
  CHECK(record.other ==
        std::vector<std::string>{"Angles", "T^(2) T^(1)", "Remark: found by hand", "another remark 5"});
  CHECK(read_fmp(write_fmp({record}), "f").at(0) == record);
}

TEST_CASE("a line of control characters is no line", "[fmp]") {
  // Found by the fuzzer: it was kept as an empty line, which the next reading passed over.
  const FmpRecord record = read_fmp(with(knotted_y, "Homology: Z^2\n", "\x01\n"), "f").at(0);
  CHECK(record.other.empty());
}

TEST_CASE("several records, and gluings alone", "[fmp]") {
  CHECK(read_fmp(knotted_y + "\n" + knotted_y, "f").size() == 2);
  const std::string gluings = knotted_y.substr(0, knotted_y.find("Dihedral"));
  CHECK(read_fmp(gluings, "f").at(0).triangulation == support::knotted_y());
  CHECK(
      error_of([&] { read_any(knotted_y + knotted_y, "f"); }) ==
      "f: found 2 triangulations of 3-manifolds, expected one: say which by FILE#1 or FILE#NAME, or FILE#*");
}

TEST_CASE("a census record survives as a document", "[fmp]") {
  FmpRecord record = read_fmp(knotted_y, "f").at(0);
  record.other = {"a remark"};
  const Document document = document_of(record);
  CHECK(fmp_record_of(document) == record);
  CHECK(fmp_record_of(read_json(write_json(document), "f")) == record);
  // A member "fmp" of anybody else's is no reason to stumble.
  Document foreign = document_of(support::knotted_y());
  foreign.members = Json::parse(R"({"fmp": {"homology": 3, "boundary_genera": "none"}})");
  CHECK(fmp_record_of(foreign).homology.empty());
  foreign.members = Json::parse(R"({"fmp": 1})");
  CHECK(fmp_record_of(foreign).boundary_genera.empty());
}

TEST_CASE("wrong census records", "[bad][fmp]") {
  const auto spoilt = [](const std::string& from, const std::string& to) {
    return record_complaint(with(knotted_y, from, to));
  };
  CHECK(record_complaint("") == "f:1: the text ends, expected the number of tetrahedra, at least 1");
  CHECK(record_complaint("0\n") == "f:1: found '0', expected the number of tetrahedra, at least 1");
  CHECK(record_complaint("2\n1 1 1") == "f:2: the text ends, expected a neighbor of tetrahedron 0, 0 to 1");
  CHECK(record_complaint("1\n1 0 0 0") == "f:2: found '1', expected a neighbor of tetrahedron 0, 0 to 0");
  CHECK(record_complaint("1\n0 0 0 0\n0123 0123 0123 0122") ==
        "f:3: found '0122', expected a permutation of tetrahedron 0, like 0132");
  CHECK(record_complaint("1\n0 0 0 0\n0123 0123 0123 0123") ==
        "f:3: face 0 of tetrahedron 0 is glued to itself");
  CHECK(spoilt("N. 1 ", "N. 2 ") == "f:8: found '2', expected the angles of tetrahedron 1 next");
  CHECK(spoilt("N. 0 ", "N. 0 1") ==
        "f:7: found '0.5235987756', expected the end of the line after six angles");
  CHECK(spoilt("N. 0  0.5", "N. 0  x") ==
        "f:7: found 'x235987756', expected the angles of tetrahedron 0, six numbers");
  CHECK(spoilt("N. 1  0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756 0.5235987756\n", "") ==
        "f:13: found the angles of 1 tetrahedra, expected those of 2");
  CHECK(spoilt("Volume: ", "N. 2  1 1 1 1 1 1\nVolume: ") ==
        "f:9: found '2', expected the angles of 2 tetrahedra only");
  CHECK(spoilt("-------------------\n", "") ==
        "f:13: the text ends, expected a line of dashes, the end of the record");
  CHECK(error_of([] { write_fmp({FmpRecord{}}); }) ==
        "a census record has at least one tetrahedron, this triangulation none");
  FmpRecord open;
  open.triangulation = Triangulation(1);
  CHECK(error_of([&] { write_fmp({open}); }) ==
        "a census record cannot hold boundary faces, such as face 0 of tetrahedron 0");
  open.dihedral_angles.resize(2);
  open.triangulation = support::zoo("Gieseking manifold m000").triangulation();
  CHECK_THROWS_AS(write_fmp({open}), PreconditionError);
}
