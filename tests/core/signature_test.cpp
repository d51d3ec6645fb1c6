// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/signature.hpp"

#include "support/enumeration.hpp"
#include "support/laws.hpp"
#include "support/random.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <set>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

Isomorphism composed(const Isomorphism& second, const Isomorphism& first) {
  Isomorphism out = first;
  for (std::size_t t = 0; t < first.tet.size(); ++t) {
    out.tet[t] = second.tet[first.tet[t]];
    out.perm[t] = second.perm[first.tet[t]] * first.perm[t];
  }
  return out;
}

struct ByPosition {
  bool operator()(const Isomorphism& a, const Isomorphism& b) const {
    return std::tie(a.tet, a.perm) < std::tie(b.tet, b.perm);
  }
};

struct Class {
  Triangulation canonical;
  long labellings = 0;
};

/// The classes of all gluings of `tets` tetrahedra by signature. Every gluing must map to what its signature
/// names.
std::map<std::string, Class> classes(int tets) {
  std::map<std::string, Class> found;
  for_each_gluing(tets, [&](const Triangulation& tri) {
    const std::string text = signature(tri);
    const auto [entry, fresh] = found.try_emplace(text);
    if (fresh) entry->second.canonical = from_signature(text);
    ++entry->second.labellings;
    const auto iso = find_isomorphism(tri, entry->second.canonical);
    if (!iso || !(relabelled(tri, *iso) == entry->second.canonical)) FAIL("no isomorphism to " << text);
  });
  return found;
}

/// The automorphisms form a group that acts freely on the 24n flags.
void check_group(const Triangulation& tri) {
  const auto group = automorphisms(tri);
  const std::set<Isomorphism, ByPosition> elements(group.begin(), group.end());
  REQUIRE(elements.size() == group.size());
  CHECK(24 * tri.size() % static_cast<int>(group.size()) == 0);
  for (const Isomorphism& g : group) {
    CHECK(relabelled(tri, g) == tri);
    for (const Isomorphism& h : group) CHECK(elements.count(composed(g, h)) == 1);
  }
}

std::string error_of(const std::string& text) {
  try {
    (void)from_signature(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST_CASE("two small gluings share a signature exactly if an isomorphism maps one to the other",
          "[signature]") {
  // 16 and 431 classes: Regina 7.3 (tests/oracle/record_core.py counts the different isoSigs).
  const std::size_t class_count[] = {0, 16, 431};
  for (int tets = 1; tets <= 2; ++tets) {
    const auto found = classes(tets);
    CHECK(found.size() == class_count[tets]);
    for (auto a = found.begin(); a != found.end(); ++a) {
      const Triangulation& tri = a->second.canonical;
      CHECK(signature(tri) == a->first);
      for (auto b = found.begin(); b != a; ++b)
        if (find_isomorphism(tri, b->second.canonical))
          FAIL(a->first << " and " << b->first << " are isomorphic");
      if (components(tri).count > 1) continue;
      // Orbit and stabiliser: labellings of the class times symmetries are all relabellings.
      const long relabellings = tets == 1 ? 24 : 2 * 24 * 24;
      CHECK(a->second.labellings * static_cast<long>(automorphisms(tri).size()) == relabellings);
      check_group(tri);
    }
  }
}

TEST_CASE("relabelling changes no signature", "[signature]") {
  Random random(3);
  for_each_gluing(2, [&](const Triangulation& tri) {
    if (random.below(20) > 0) return;
    const Triangulation other = relabelled(tri, random_relabelling(2, random));
    if (signature(other) != signature(tri)) FAIL("the signature changed: " << gluing_text(tri));
  });
  for (int k = 0; k < 300; ++k) {
    RandomGluing wanted;
    wanted.tets = 1 + random.below(100);
    wanted.boundary_faces = random.below(wanted.tets);
    wanted.orientable = random.below(2) == 0;
    wanted.connected = random.below(4) > 0;
    const Triangulation tri = random_gluing(wanted, random);
    const Triangulation other = relabelled(tri, random_relabelling(tri.size(), random));
    const std::string text = signature(tri);
    CHECK(signature(other) == text);
    const auto iso = find_isomorphism(other, from_signature(text));
    REQUIRE(iso.has_value());
    CHECK(relabelled(other, *iso) == from_signature(text));
  }
}

TEST_CASE("the canonical labelling leads to the triangulation that the signature names", "[signature]") {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    RandomGluing wanted;
    wanted.tets = 1 + random.below(70);
    wanted.boundary_faces = random.below(3);
    const Triangulation tri = random_gluing(wanted, random);
    const auto [text, labelling] = canonical_labelling(tri);
    CHECK(text == signature(tri));
    CHECK(relabelled(tri, labelling) == from_signature(text));
  }
  for (const ZooEntry& animal : zoo()) {
    const auto [text, labelling] = canonical_labelling(animal.triangulation());
    CHECK(text == animal.signature);
    CHECK(relabelled(animal.triangulation(), labelling) == from_signature(text));
  }
  CHECK_THROWS_AS(canonical_labelling(Triangulation()), PreconditionError);
  CHECK_THROWS_AS(canonical_labelling(Triangulation(2)), PreconditionError);
}

TEST_CASE("symmetric triangulations have the symmetries of their making", "[signature]") {
  // 64 translations times 48 (the 3-torus of one cube has 48 in the zoo); Regina 7.3 finds 3,072 isomorphisms
  // too.
  const Triangulation torus = cubical_torus(4, 4, 4);
  CHECK(automorphisms(torus).size() == 3072);
  const std::string text = signature(torus);
  Random random(5);
  CHECK(signature(relabelled(torus, random_relabelling(torus.size(), random))) == text);
  check_group(cubical_torus(1, 1, 1));
  check_group(cubical_torus(1, 1, 2));
  CHECK_THROWS_AS(automorphisms(Triangulation(2)), PreconditionError);
  CHECK_THROWS_AS(automorphisms(Triangulation()), PreconditionError);
  CHECK(isomorphisms(Triangulation(1), cubical_torus(1, 1, 1)).empty());
}

TEST_CASE("components are named one by one and found in any order", "[signature]") {
  Triangulation both(3); // a ball, then the figure-eight complement
  const Triangulation knot = zoo("figure-eight complement m004").triangulation();
  for (int t = 0; t < 2; ++t)
    for (int f = 0; f < 4; ++f)
      if (both.is_boundary({t + 1, f}))
        both.glue({t + 1, f}, knot.gluing({t, f}).tet + 1, knot.gluing({t, f}).perm);
  CHECK(signature(both) == "baacPcbbbiht");
  CHECK(components(from_signature("cPcbbbihtbaa")).count == 2);
  CHECK(signature(from_signature("cPcbbbihtbaa")) == "baacPcbbbiht");
  CHECK(from_signature("abaa") == Triangulation(1)); // an empty component adds nothing
  CHECK(signature(Triangulation(3)) == "baabaabaa");
  CHECK(signature(Triangulation()) == "a");
  CHECK(from_signature("a").size() == 0);
  CHECK(find_isomorphism(Triangulation(), Triangulation()).has_value());
  CHECK(find_isomorphism(both, from_signature("cPcbbbihtbaa")).has_value());
  CHECK_FALSE(find_isomorphism(both, Triangulation(3)).has_value());
  CHECK_FALSE(find_isomorphism(both, Triangulation(2)).has_value());
}

TEST_CASE("what is no signature is an InputError that names the place", "[signature]") {
  CHECK(error_of("").find("empty") != std::string::npos);
  CHECK(error_of(" \n\t").find("empty") != std::string::npos);
  CHECK(error_of("cPcb!bihq").find("'!' at position 5") != std::string::npos);
  CHECK(error_of("cPcb bihq").find("' ' at position 5") != std::string::npos);
  CHECK(error_of("cPcbbbihq ") == "accepted");
  CHECK(error_of("cPcbbbih").find("too early") != std::string::npos); // the last letter cut off
  CHECK(error_of("c").find("too early") != std::string::npos);
  CHECK(error_of("cPcbbbihqb").find("too early") != std::string::npos); // a second component begins
  CHECK(error_of("cPcbbbyhq") != "accepted");                           // y = 24 is no permutation
  CHECK(error_of("cPcdbbihq") != "accepted");                           // tetrahedron 3 of 2
  CHECK(error_of("cPcaaaaaa") != "accepted");                           // a face glued twice
  CHECK(error_of("bkaaaa") != "accepted");                              // a face glued to itself
  CHECK(error_of("d-aaaaaa") != "accepted");                            // 3 is no face type
  // n = 2^30 - 1 and such: refused before memory is asked for.
  CHECK(error_of("-f-----").find("too early") != std::string::npos);
  CHECK(error_of("-f-----" + std::string(1000, 'a')).find("too early") != std::string::npos);
  CHECK(error_of("-z-----") != "accepted");
  CHECK(error_of("-") != "accepted");
  CHECK(error_of("-a") != "accepted");
  CHECK(error_of(std::string(100000, '\0')).size() < 300);
  CHECK(error_of(std::string(100000, '-')).size() < 300);
  CHECK_FALSE(looks_like_signature(""));
  CHECK_FALSE(looks_like_signature("a.tri"));
  CHECK(looks_like_signature(" cPcbbbihq\n"));
}

TEST_CASE("whole words are signatures or none", "[signature]") {
  CHECK(is_signature("cPcbbbihq"));
  CHECK_FALSE(is_signature(""));
  CHECK_FALSE(is_signature("cPcbbbih"));
  // Signatures of 63 and more tetrahedra begin with a dash (Burton 2011, section 3); options do so, too.
  Random random(8);
  for (const int tets : {63, 64, 200}) {
    const std::string text = signature(random_gluing({tets, 3, false, true}, random));
    CHECK(text.front() == '-');
    CHECK(is_signature(text));
  }
  for (const char* option : {"-", "-o", "-h", "-a", "-b", "-bb", "--json", "--", "-oout", "--seed", "-1"})
    CHECK_FALSE(is_signature(option));
}

TEST_CASE("every prefix of a signature is refused", "[signature]") {
  for (const ZooEntry& animal : zoo())
    for (std::size_t k = 0; k < animal.signature.size(); ++k) {
      INFO(animal.signature.substr(0, k));
      CHECK_THROWS_AS(from_signature(animal.signature.substr(0, k)), InputError);
    }
}

TEST_CASE("mutated signatures are refused or are triangulations", "[signature]") {
  const std::string alphabet = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-*";
  Random random(6);
  int accepted = 0;
  std::vector<std::string> originals;
  for (const ZooEntry& animal : zoo()) originals.push_back(animal.signature);
  for (const int tets : {62, 63, 64, 130})
    originals.push_back(signature(random_gluing({tets, 3, false, true}, random)));
  for (int k = 0; k < 40000; ++k) {
    std::string text = originals[random.below(static_cast<int>(originals.size()))];
    for (int edits = 1 + random.below(3); edits > 0; --edits) {
      const std::size_t at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      const char c = alphabet[random.below(static_cast<int>(alphabet.size()))];
      if (const int kind = random.below(5); kind == 0)
        text.insert(at, 1, c);
      else if (kind == 1 && text.size() > 1)
        text.erase(at, 1);
      else
        text[at] = c;
    }
    try {
      const Triangulation tri = from_signature(text);
      ++accepted;
      // What the text says is one labelling of what it names; the signature is that of the smallest
      // labelling.
      const std::string canonical = signature(tri);
      CHECK(signature(from_signature(canonical)) == canonical);
      CHECK(laws::gluings_are_mutual(tri) == "");
      if (components(tri).count == 1 && text[0] != 'a') CHECK(canonical <= text);
    } catch (const InputError&) {
      // refused: what most deserve
    }
  }
  CHECK(accepted > 100);
}
