// SPDX-License-Identifier: GPL-2.0-or-later
// Reasons why a manifold is not hyperbolic: given where there is no structure, never where there is one, and
// checked.
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/identify/names.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using reasons::Kind;
using reasons::Reason;
using reasons::why_not_hyperbolic;

namespace {

/// A reason that holds what it says.
Reason checked(const Triangulation& tri) {
  const auto reason = why_not_hyperbolic(tri);
  REQUIRE(reason);
  CHECK(reasons::what_is_wrong(*reason).empty());
  CHECK_FALSE(reason->text.empty());
  CHECK_FALSE(reason->theorem.empty());
  return *reason;
}

} // namespace

TEST_CASE("No manifold of the census has a reason") {
  // 8 + 151 manifolds with a certified structure: a reason for one of them would be a false proof.
  for (const int n : {2, 3})
    for (const auto& m : catalogue::stored_table(n)) {
      reasons::ReasonOptions few;
      few.changes = 2;
      CHECK_FALSE(why_not_hyperbolic(from_signature(m.signature), few));
    }
}

TEST_CASE("Simple manifolds have their reasons") {
  const auto named = [](const char* name) { return identify::find_named(name)->triangulation; };
  CHECK(checked(named("S^3")).kind == Kind::cyclic_group);
  CHECK(checked(named("L(7,2)")).kind == Kind::cyclic_group);
  CHECK(checked(named("solid torus")).kind == Kind::cyclic_group);
  CHECK(checked(named("T^3")).kind == Kind::abelian_group);
  CHECK(checked(named("genus 3 handlebody")).kind == Kind::root);
}

TEST_CASE("Manifolds of many kinds have reasons that hold") {
  // Built by Regina 7.3's Example3, connected sums of these, prisms over surfaces, and its census of closed
  // manifolds with its names.
  struct Entry {
    const char* signature;
    const char* name;
  };
  for (const Entry& entry :
       std::vector<Entry>{{"dLQacccbjkg", "T^2 x I"},
                          {"hLLLQkbdfegffgafttevvv", "genus 2 surface x I"},
                          {"dLQacccbihj", "Klein bottle x I"},
                          {"dLQabccbdgp", "Klein bottle x I, otherwise"},
                          {"eLMkbcddddlihu", "granny knot"},
                          {"bGab", "B^3"},
                          {"bkaagj", "S^3"},
                          {"bGaj", "solid torus"},
                          {"eHuGabdes", "handlebody 2"},
                          {"hHbLbqiabegeti", "handlebody 3"},
                          {"cHcbban", "solid Klein bottle"},
                          {"cMcabbjaj", "S2xS1"},
                          {"dLQbcccajqs", "S2x~S1"},
                          {"eLMkabcddbrrag", "RP3#RP3"},
                          {"cMcabbjak", "L(3,1)"},
                          {"bkaajn", "L(5,2)"},
                          {"cMcabbjqw", "L(7,2)"},
                          {"cMcabbjqs", "L(8,3)"},
                          {"dLQbcbchxwn", "L(13,5)"},
                          {"hLLPAkaceedfggnkxknnqw", "SFS(3,3,4)"},
                          {"iLAwLQccbbdfgghhhhkhjlqss", "SFS(2,3,6) flat"},
                          {"lLALLAMMcbcbefhgijikkhhjsqjjhqrqw", "SFS(5,5,5)"},
                          {"cPcbbbadu", "trefoil"},
                          {"gLAzQbbcdeffhtoggak", "fig8#L(3,1)"},
                          {"nLLAvLLQQkceeegmkklkjmlmapppjtlaqtibjf", "weeks#L(3,1)"},
                          {"fLAPcacceeenjjjjn", "L31#L52"},
                          {"iLAzAMcbbcdefghhhtoggapaj", "S2xS1#fig8"},
                          {"mHuLeLkKwQbfhhgjjllltaaawaaphe", "H2#fig8"},
                          {"iLAwwQcbcbdfghhhhhwhrxarg", "SFS [S2: (2,1) (2,1) (16,-9)] #2"},
                          {"kLALALMkbcceffhiijjemkbematjan", "SFS [S2: (2,1) (2,1) (2,1) (2,1) (2,1)] #1"},
                          {"iLALLQcbcbegfghhhxjnarkkr", "SFS [S2: (3,2) (3,2) (4,3)] #1"},
                          {"jLALAMPbcceffghiiemkbemsxhw", "SFS [S2: (2,1) (2,1) (2,1) (8,-3)] #1"},
                          {"jLAMLLQbcbdeghhiixhjqqwihrj", "SFS [S2: (2,1) (3,2) (15,-11)] #1"},
                          {"kLAwwMAkbcbdfhhgijjxxjqwarrrhj", "SFS [S2: (3,1) (4,1) (4,7)] #3"},
                          {"kLLALPAkbcedghghijjtsajohjhfhr", "SFS [RP2/n2: (2,1) (2,9)] #26"},
                          {"kLLLMPPkcdgffhijijjhshaonphaxk", "SFS [KB/n2: (1,5)] #5"},
                          {"kLLzLPQkacehijghjijjkxamtmkoks", "SFS [KB/n2: (3,2)] #17"},
                          {"kLLzLPQkaceghijihjjjkxpeqxrwgv", "SFS [A: (3,1)] / [ 0,1 | 1,-1 ] #9"},
                          {"jLLLLQQccfgihghiilnagssjnjv", "SFS [KB/n2: (2,1)] #15"},
                          {"kLLzLPQkacegjhiihjjjkxpudprwow", "SFS [A: (3,1)] / [ 1,-2 | 0,-1 ] #1"},
                          {"kLAvMPMkbcceggihjjjlpksmwxsqwg", "SFS [KB/n2: (1,5)] #6"},
                          {"hvLPQkcedfgfggnnkldeiw", "SFS [KB/n2: (1,2)] #3"},
                          {"kLLLLPQkcddfjijihjipkrkaxdpoad", "SFS [T: (2,5)] #2"},
                          {"kLLLAPPkcdgfehijijjhshaqpiqkbb", "T x I / [ 5,4 | 1,1 ] #5"},
                          {"jLLLAPQcdgfehiihihsxaqpilmk", "T x I / [ 5,2 | 2,1 ] #2"},
                          {"jLLLMPQcdgffhihiihshanopndt", "T x I / [ 4,3 | 1,1 ] #8"},
                          {"kLLvPMQkcdeifghjjijqsqssfjxhfa", "T x I / [ -8,-5 | -3,-2 ] #8"}}) {
    CAPTURE(entry.name);
    checked(from_signature(entry.signature));
  }
}

TEST_CASE("A damaged reason is refused") {
  // Of eLMkbbdddduadu all tetrahedra degenerate: its group splits, b conjugating one letter.
  const Reason reason = checked(from_signature("eLMkbbdddduadu"));
  REQUIRE(reason.group);
  Reason damaged = reason;
  damaged.group->shown.relators.front().push_back(1);
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.group->image.front().push_back(damaged.group->image.front().back());
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.kind = Kind::free_product;
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
  damaged = reason;
  damaged.group->triangulation = "cPcbbbihq";
  CHECK_FALSE(reasons::what_is_wrong(damaged).empty());
}
