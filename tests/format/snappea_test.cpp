// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/snappea.hpp"

#include "expect.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/signature.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::format;
using namespace tetrarch::format::test;

namespace {

/// What Regina said about a file: the signature, then the kernel's answer.
struct Answer {
  std::string signature;
  std::string kernel;
};

std::map<std::string, Answer> recorded() {
  std::map<std::string, Answer> answers;
  std::istringstream lines(read_file(data("tri/regina.txt")));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    TextCursor in(line, "regina.txt");
    const std::string name(in.token("a name"));
    const std::string signature(in.token("a signature"));
    answers[name] = {signature, std::string(in.rest_of_line())};
  }
  return answers;
}

std::string snappea_complaint(const std::string& text) {
  return error_of([&] { read_snappea(text, "f"); });
}

const std::string snappea_figure_eight = read_file(data("tri/ours_figure_eight.tri"));

} // namespace

TEST_CASE("SnapPea files are read as Regina reads them", "[snappea]") {
  // Signatures: Regina 7.3's own reader of the same files (tests/data/format/tri/regina.txt).
  const auto answers = recorded();
  CHECK(answers.size() >= 10);
  for (const auto& [name, answer] : answers) {
    INFO(name);
    CHECK(signature(read_snappea(read_file(data("tri/" + name)), name).triangulation) == answer.signature);
  }
}

TEST_CASE("SnapPea files that we write are those that Regina and the SnapPea kernel were shown",
          "[snappea]") {
  const std::vector<std::pair<std::string, std::string>> shown{
      {"ours_figure_eight.tri", "figure-eight complement m004"},
      {"ours_whitehead.tri", "Whitehead link complement m129"},
      {"ours_gieseking.tri", "Gieseking manifold m000"},
      {"ours_trefoil.tri", "trefoil complement"},
      {"ours_knotted_y.tri", "knotted Y"},
      {"ours_weeks.tri", "Weeks manifold"}};
  for (const auto& [file, name] : shown) {
    INFO(name);
    CHECK(write_snappea(document_of(support::zoo(name).triangulation())).text ==
          read_file(data("tri/" + file)));
  }
  // Volumes as everyone knows them: 2.0298832128 and half of it, 3.6638623767 (Thurston's notes, chapter 6).
  auto answers = recorded();
  CHECK(answers["ours_figure_eight.tri"].kernel == "2.0298832128 1");
  CHECK(answers["ours_gieseking.tri"].kernel == "1.0149416064 1");
  CHECK(answers["ours_whitehead.tri"].kernel == "3.6638623767 2");
}

TEST_CASE("what SnapPea cannot swallow gets a warning", "[snappea]") {
  const auto warnings = [](const std::string& signature) {
    return write_snappea(document_of(from_signature(signature))).warnings;
  };
  auto answers = recorded();
  // The kernel's refusal and its crash are recorded in regina.txt.
  CHECK(answers["ours_knotted_y.tri"].kernel == "refuses");
  CHECK(warnings("cPcbbbihq") ==
        std::vector<std::string>{"the link of vertex 0 is a surface (genus 2) that is neither "
                                 "sphere, torus nor Klein bottle: SnapPy will refuse this file"});
  CHECK(answers["ours_weeks.tri"].kernel == "fails");
  CHECK(warnings("jLvAMPQadfgghhiiijaqgjqxims") ==
        std::vector<std::string>{"there is no cusp: SnapPea's kernel fails on such a file"});
  CHECK(warnings("cPcbbbiht").empty());
  CHECK(warnings("bkaaid").empty());
  CHECK(warnings("cPcbbbihtcPcbbbiht") ==
        std::vector<std::string>{"there are 2 components: SnapPy expects one"});
}

TEST_CASE("edges glued to themselves backwards get a warning", "[snappea]") {
  // Face 012 goes onto face 013 with 0 and 1 exchanged, so edge 01 meets itself reversed.
  Triangulation tri(1);
  tri.glue({0, 3}, 0, Perm4(1, 0, 3, 2));
  tri.glue({0, 0}, 0, Perm4(1, 0, 2, 3));
  const std::vector<std::string> warnings = write_snappea(document_of(tri)).warnings;
  CHECK(std::any_of(warnings.begin(), warnings.end(),
                    [](const std::string& w) { return w.find("backwards") != std::string::npos; }));
}

TEST_CASE("names survive as far as a line allows", "[snappea]") {
  Document document = document_of(from_signature("cPcbbbiht"), "4_1, the figure eight");
  CHECK(read_snappea(write_snappea(document).text, "f").name == document.name);
  document.name = "two\nlines";
  const Written written = write_snappea(document);
  CHECK(written.warnings == std::vector<std::string>{"the name was changed to fit on a line: 'two lines'"});
  CHECK(read_snappea(written.text, "f").name == "two lines");
  document.name.clear();
  CHECK(read_snappea(write_snappea(document).text, "f").name.empty());
}

TEST_CASE("a Dehn filling is not lost in silence", "[snappea]") {
  // kernel_filled.tri: the Whitehead link, its first cusp filled along (1,2).
  const Document document = read_snappea(read_file(data("tri/kernel_filled.tri")), "f");
  CHECK(document.passed_over.sentence() ==
        "passed over: Dehn filling (1,2) of cusp 0, which is open here, peripheral curve (4)");
  const DehnFillings fillings = read_dehn_fillings(read_file(data("tri/kernel_filled.tri")), "f");
  CHECK(fillings.named == std::vector<std::string>{"Dehn filling (1,2) of cusp 0"});
  CHECK(fillings.left.empty());
  REQUIRE(fillings.curves.size() == 4);
  // Meridian and twice the longitude, in the first tetrahedron at its first cusp: 0 1 -1 0 and 0 0 -1 1.
  CHECK(fillings.curves[0][0] == std::array<std::int64_t, 4>{0, 1, -3, 2});
  CHECK(fillings.curves[0][2] == std::array<std::int64_t, 4>{0, 0, 0, 0}); // the other cusp
  for (const char* slope : {"2.5", "3e9"}) { // a cone manifold; what nobody means
    const DehnFillings none =
        read_dehn_fillings(with(read_file(data("tri/kernel_filled.tri")), "2.000000000000", slope), "f");
    CHECK(none.curves.empty());
    CHECK(none.named.empty());
    CHECK(none.left.size() == 1);
  }
  // A meridian and a longitude for each of two cusps; our own files leave them to SnapPea.
  CHECK(read_snappea(read_file(data("tri/kernel_whitehead.tri")), "f").passed_over.sentence() ==
        "passed over: peripheral curve (4)");
  CHECK(read_snappea(snappea_figure_eight, "f").passed_over.empty());
}

TEST_CASE("blank lines and line ends from elsewhere do not matter", "[snappea]") {
  const Triangulation tri = read_snappea(snappea_figure_eight, "f").triangulation;
  const auto same = [&tri](const std::string& text, const std::string& name) {
    const Document document = read_snappea(text, "f");
    CHECK(document.triangulation == tri);
    CHECK(document.name == name);
  };
  const std::string named = with(snappea_figure_eight, "unnamed", "4_1 here");
  same(named, "4_1 here");
  same(with(named, "4_1 here", "\n  \n4_1 here"), "4_1 here");
  same(with(named, "4_1 here", "4_1 here\n\n"), "4_1 here");
  same(with(named, "4_1 here", ""), "");
  same(with(named, "4_1 here\n", ""), "");
  same(with(snappea_figure_eight, "unnamed", "\nunnamed"), "");
  same("\n\n" + named, "4_1 here");
  for (const std::string end : {"\r", "\r\n"}) {
    std::string text;
    for (const char c : named) text += c == '\n' ? end : std::string(1, c);
    same(text, "4_1 here");
    same(with(text, "4_1 here", end + "4_1 here"), "4_1 here");
    // Lines are counted the same.
    CHECK(snappea_complaint(with(text, "1203", "1202")) ==
          "f:9: found '1202', expected a permutation of tetrahedron 0, like 0132");
  }
}

TEST_CASE("what a SnapPea file cannot hold is refused", "[bad][snappea]") {
  const auto writing = [](const Triangulation& tri) {
    return error_of([&] { write_snappea(document_of(tri)); });
  };
  CHECK(writing(from_signature("bGaj")).find("a SnapPea file cannot hold boundary faces") == 0);
  CHECK(writing(Triangulation()) == "a SnapPea file has at least one tetrahedron, this triangulation none");
}

TEST_CASE("a SnapPea file cut anywhere names its last line and what was expected", "[bad][snappea]") {
  // Lines counted by hand in ours_figure_eight.tri: 7 the number of tetrahedra, 8 and 9 the first gluings.
  const auto cut = [&](const std::string& before) {
    return snappea_complaint(snappea_figure_eight.substr(0, snappea_figure_eight.find(before)));
  };
  CHECK(snappea_complaint("% Triang") == "f:1: found '% Triang', expected \"% Triangulation\"");
  CHECK(cut("not_attempted") == "f:2: the text ends, expected a solution type such as not_attempted");
  CHECK(cut("0 0\n2\n") == "f:5: the text ends, expected the number of torus cusps");
  CHECK(cut(" 0123 1203") == "f:8: the text ends, expected a permutation of tetrahedron 0, like 0132");
  CHECK(cut(" 1032 3021") == "f:9: the text ends, expected a permutation of tetrahedron 0, like 0132");
  CHECK(cut("  -1   -1   -1") == "f:9: the text ends, expected a cusp index of tetrahedron 0");
  CHECK(cut("0.0 0.0\n   0") == "f:14: the text ends, expected the shape of tetrahedron 0, two numbers");
  CHECK(cut("   0    0    0    0\n") == "f:15: the text ends, expected a neighbor of tetrahedron 1, 0 to 1");
  for (std::size_t length = 0; length + 2 < snappea_figure_eight.size(); ++length) {
    const std::string message = snappea_complaint(snappea_figure_eight.substr(0, length));
    INFO(length << ": " << message);
    // Of "0.0", "0." and "0" are numbers as well: only the last figure's own digits may be missing unnoticed.
    if (length + 4 < snappea_figure_eight.size()) REQUIRE_FALSE(message.empty());
    REQUIRE(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("wrong entries of a SnapPea file", "[bad][snappea]") {
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    return snappea_complaint(with(snappea_figure_eight, from, to));
  };
  CHECK(snappea_complaint("") == "f:1: the text ends, expected \"% Triangulation\"");
  CHECK(snappea_complaint("% orb\n") == "f:1: found '% orb', expected \"% Triangulation\"");
  CHECK(spoilt("not_attempted", "attempted") ==
        "f:3: found 'attempted', expected a solution type such as not_attempted");
  CHECK(spoilt("unknown_orient", "un_orient") == "f:4: found 'un_orientability', expected oriented_manifold, "
                                                 "nonorientable_manifold or unknown_orientability");
  CHECK(spoilt("CS_unknown", "CS") == "f:5: found 'CS', expected CS_known or CS_unknown");
  CHECK(spoilt("CS_unknown", "CS_known 0,5") == "f:5: found '0,5', expected the Chern-Simons invariant");
  CHECK(spoilt("0 0\n2\n", "1 0\nsphere 0 0\n2\n") ==
        "f:7: found 'sphere', expected torus or Klein, the kind of cusp 0");
  CHECK(spoilt("0 0\n2\n", "-1 0\n2\n") == "f:6: found '-1', expected the number of torus cusps");
  CHECK(spoilt("0 0\n2\n", "0 0\n0\n") == "f:7: found '0', expected the number of tetrahedra, at least 1");
  CHECK(spoilt("0 0\n2\n", "0 0\n3\n") ==
        "f:23: the text ends, expected a neighbor of tetrahedron 2, 0 to 2");
  CHECK(spoilt("0 0\n2\n", "0 0\n2000000000\n") ==
        "f:23: the text ends, expected a neighbor of tetrahedron 2, 0 to 1999999999");
  CHECK(spoilt("0 0\n2\n", "0 0\n1\n") == "f:8: found '1', expected a neighbor of tetrahedron 0, 0 to 0");
  CHECK(spoilt("1203", "1202") == "f:9: found '1202', expected a permutation of tetrahedron 0, like 0132");
  CHECK(spoilt("1203", "0132") == "f:9: face 1 of tetrahedron 1 is glued twice: to face 1 of "
                                  "tetrahedron 0 and to face 3 of tetrahedron 0");
  CHECK(snappea_complaint(snappea_figure_eight + "x") ==
        "f:24: found 'x', expected the end after 2 tetrahedra");
}
