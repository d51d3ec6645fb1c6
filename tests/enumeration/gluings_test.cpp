// SPDX-License-Identifier: GPL-2.0-or-later
/// Laws of the enumeration. Its witnesses: every labelled gluing of one and two tetrahedra, one by one; the
/// number of labelled gluings of more by formula, met again as a sum of orbits; and the lists that another
/// program, Regina's tricensus, prints (tests/oracle/record_gluings.py).

#include "tetrarch/enumeration/gluings.hpp"

#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/core/skeleton.hpp"

#include "support/enumeration.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::enumeration;
using Orientability = GluingOptions::Orientability;
using Signatures = std::vector<std::string>;

namespace {

GluingOptions everything(int tetrahedra) {
  GluingOptions options;
  options.tetrahedra = tetrahedra;
  options.allow_invalid = true;
  return options;
}

/// The options, judged on a finished gluing through its skeleton.
bool fits(const Skeleton& s, const GluingOptions& options) {
  if (options.orientability == Orientability::orientable && !s.is_orientable()) return false;
  if (options.orientability == Orientability::nonorientable && s.is_orientable()) return false;
  bool ideal = false;
  for (const VertexId v : all<VertexId>(s.vertex_count())) {
    ideal |= s.is_ideal(v);
    if (options.links && !options.links->contains(s.link(v))) return false;
  }
  if (options.ideal && !ideal) return false;
  for (const EdgeId e : all<EdgeId>(s.edge_count()))
    if (s.valence(e) < options.min_valence || (s.is_reversed(e) && !options.allow_invalid)) return false;
  return true;
}

/// The options of `tricensus` by its letters.
GluingOptions by_letters(int tetrahedra, const std::string& letters) {
  GluingOptions options;
  options.tetrahedra = tetrahedra;
  for (const char c : letters) {
    if (c == 'o') options.orientability = Orientability::orientable;
    if (c == 'n') options.orientability = Orientability::nonorientable;
    if (c == 'd') options.ideal = true;
    if (c == 'f') options.links = parse_link_set("0");
  }
  return options;
}

/// Calls `visit` with every combination of some values of all options.
template <class Visit>
void for_each_option(int tetrahedra, const std::vector<int>& valences, Visit visit) {
  GluingOptions options;
  options.tetrahedra = tetrahedra;
  for (const char* links : {"", "0", "1", "2", "0,1", "1,2,3", "n1", "n2", "0,n1", "0,1,2,n1,n2", "3,n4"}) {
    options.links.reset();
    if (*links != 0) options.links = parse_link_set(links);
    for (const Orientability o :
         {Orientability::any, Orientability::orientable, Orientability::nonorientable}) {
      options.orientability = o;
      for (const bool ideal : {false, true}) {
        options.ideal = ideal;
        for (const bool invalid : {false, true}) {
          options.allow_invalid = invalid;
          for (const int valence : valences) {
            options.min_valence = valence;
            visit(options);
          }
        }
      }
    }
  }
}

/// Gluings to choose from: the unpruned route.
struct Catalogue {
  explicit Catalogue(Signatures texts) : signatures(std::move(texts)) {
    for (const std::string& text : signatures) skeletons.emplace_back(from_signature(text));
  }
  Signatures choose(const GluingOptions& options) const {
    Signatures chosen;
    for (std::size_t k = 0; k < signatures.size(); ++k)
      if (fits(skeletons[k], options)) chosen.push_back(signatures[k]);
    return chosen;
  }
  Signatures signatures;
  std::vector<Skeleton> skeletons;
};

/// Connected closed labelled gluings of n tetrahedra, by class.
const std::map<std::string, long>& labelled_gluings(int n) {
  static std::array<std::map<std::string, long>, 3> counts; // it takes a moment, and two tests ask
  std::map<std::string, long>& count = counts.at(static_cast<std::size_t>(n));
  if (!count.empty()) return count;
  support::for_each_gluing(n, [&](const Triangulation& tri) {
    for (int f = 0; f < 4 * n; ++f)
      if (tri.is_boundary({f / 4, f % 4})) return;
    if (components(tri).count == 1) ++count[signature(tri)];
  });
  return count;
}

/// A vertex order of each tetrahedron and an order of the tetrahedra: 24^n n!.
std::int64_t labellings(int n) {
  std::int64_t count = 1;
  for (int k = 1; k <= n; ++k) count *= 24 * k;
  return count;
}

/// How many labelled gluings are connected, where all[k] counts those of k tetrahedra: tetrahedron 0 lies in
/// a component of k tetrahedra, and the others are anything.
std::vector<std::int64_t> connected(const std::vector<std::int64_t>& all) {
  std::vector<std::int64_t> result(all.size(), 0);
  for (std::size_t n = 1; n < all.size(); ++n) {
    result[n] = all[n];
    std::int64_t choose = 1; // n-1 over k-1
    for (std::size_t k = 1; k < n; ++k) {
      result[n] -= choose * result[k] * all[n - k];
      choose = choose * static_cast<std::int64_t>(n - k) / static_cast<std::int64_t>(k);
    }
  }
  return result;
}

/// Pair the 4n faces, (4n-1)(4n-3)...1 ways, then choose a map for each of the 2n pairs; `hands` ways to hand
/// each tetrahedron.
std::vector<std::int64_t> all_labelled(int n, int maps, int hands) {
  std::vector<std::int64_t> result{1};
  for (int k = 1; k <= n; ++k)
    result.push_back(result.back() * (4 * k - 1) * (4 * k - 3) * maps * maps * hands);
  return result;
}

std::int64_t sum_of_orbits(const GluingOptions& options) {
  std::int64_t sum = 0;
  enumerate_gluings(options, [&](const Triangulation& tri) {
    sum += labellings(tri.size()) / static_cast<std::int64_t>(automorphisms(tri).size());
  });
  return sum;
}

std::string fnv1a(const Signatures& signatures) {
  std::uint64_t value = 0xcbf29ce484222325;
  const auto take = [&](char c) { value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3; };
  for (const std::string& text : signatures) {
    for (const char c : text) take(c);
    take('\n');
  }
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[value >> shift & 15];
  return digits;
}

/// Compares the lists of so many tetrahedra whose options have the letter o, or do not have it.
void compare_with_counts(int tetrahedra, bool orientable) {
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/oracle/gluings_counts.txt");
  REQUIRE(file);
  int tets = 0;
  int compared = 0;
  std::string letters;
  std::size_t count = 0;
  std::string hash;
  while (file >> tets >> letters >> count >> hash) {
    if (tets != tetrahedra || (letters.find('o') != std::string::npos) != orientable) continue;
    INFO(tets << " tetrahedra, options " << letters);
    const Signatures found = gluing_signatures(by_letters(tets, letters));
    CHECK(found.size() == count);
    CHECK(fnv1a(found) == hash);
    ++compared;
  }
  CHECK(compared > 0);
}

std::vector<Triangulation> in_order(GluingOptions options, int threads) {
  options.threads = threads;
  std::vector<Triangulation> found;
  enumerate_gluings(options, [&](const Triangulation& tri) { found.push_back(tri); });
  return found;
}

} // namespace

TEST_CASE("the classes of one and two tetrahedra are those of all labelled gluings, for all options") {
  for (const int n : {1, 2}) {
    Signatures classes;
    for (const auto& [text, count] : labelled_gluings(n)) classes.push_back(text);
    const Catalogue catalogue(classes);
    for_each_option(n, {1, 2, 3, 4, 7, 12}, [&](const GluingOptions& options) {
      const Signatures found = gluing_signatures(options);
      if (found != catalogue.choose(options)) {
        CAPTURE(n, options.ideal, options.min_valence, options.allow_invalid);
        CAPTURE(static_cast<int>(options.orientability), options.links.has_value());
        CHECK(found == catalogue.choose(options));
      }
    });
  }
}

TEST_CASE("a class has as many labelled gluings as labellings modulo automorphisms") {
  // By hand: of one tetrahedron 3 pairings with 6 * 6 maps each; of two 7*5*3 pairings with 6^4 maps, less
  // the 108 * 108 that fall apart.
  const std::array<std::int64_t, 3> labelled{0, 108, 105 * 1296 - 108 * 108};
  for (const int n : {1, 2}) {
    std::int64_t sum = 0;
    for (const auto& [text, count] : labelled_gluings(n)) {
      const auto symmetries = static_cast<std::int64_t>(automorphisms(from_signature(text)).size());
      CHECK(count == labellings(n) / symmetries);
      sum += count;
    }
    CHECK(sum == labelled[n]);
    CHECK(sum_of_orbits(everything(n)) == labelled[n]);
  }
}

TEST_CASE("the orbits of all classes add up to the number of labelled gluings") {
  CHECK(sum_of_orbits(everything(3)) == connected(all_labelled(3, 6, 1))[3]);
  // Orientable: hand the tetrahedra in one of 2^n ways and choose among 3 maps a pair; every connected gluing
  // is met twice, once with all hands changed.
  GluingOptions orientable;
  orientable.orientability = Orientability::orientable;
  for (const int n : {1, 2, 3, 4}) {
    orientable.tetrahedra = n;
    CHECK(2 * sum_of_orbits(orientable) == connected(all_labelled(n, 3, 2))[n]);
  }
}

TEST_CASE("the orbits add up, four and five tetrahedra", "[slow]") {
  CHECK(sum_of_orbits(everything(4)) == connected(all_labelled(4, 6, 1))[4]);
  GluingOptions orientable;
  orientable.tetrahedra = 5;
  orientable.orientability = Orientability::orientable;
  CHECK(2 * sum_of_orbits(orientable) == connected(all_labelled(5, 3, 2))[5]);
}

TEST_CASE("the signatures of up to three tetrahedra are those that tricensus lists") {
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/oracle/gluings_lists.txt");
  REQUIRE(file);
  int tets = 0;
  std::string letters;
  std::size_t count = 0;
  int lists = 0;
  for (; file >> tets >> letters >> count; ++lists) {
    Signatures listed(count);
    for (std::string& text : listed) file >> text;
    INFO(tets << " tetrahedra, options " << letters);
    CHECK(gluing_signatures(by_letters(tets, letters)) == listed);
  }
  CHECK(lists == 24); // three numbers of tetrahedra, eight sets of options
}

TEST_CASE("four tetrahedra, orientable: the lists of tricensus") {
  compare_with_counts(4, true);
}

TEST_CASE("four tetrahedra, not only orientable, and five: the lists of tricensus", "[slow]") {
  compare_with_counts(4, false);
  compare_with_counts(5, true);
}

TEST_CASE("pruning drops what a filter would drop, and nothing else") {
  const Catalogue catalogue(gluing_signatures(everything(3)));
  for_each_option(3, {1, 3}, [&](const GluingOptions& options) {
    CHECK(gluing_signatures(options) == catalogue.choose(options));
  });
}

TEST_CASE("pruning drops what a filter would drop, all valences of three tetrahedra", "[slow]") {
  const Catalogue catalogue(gluing_signatures(everything(3)));
  for_each_option(3, {1, 2, 3, 4, 5, 6, 9, 18}, [&](const GluingOptions& options) {
    CHECK(gluing_signatures(options) == catalogue.choose(options));
  });
}

TEST_CASE("pruning drops what a filter would drop, four tetrahedra", "[slow]") {
  const Catalogue catalogue(gluing_signatures(everything(4)));
  for_each_option(4, {3}, [&](const GluingOptions& options) {
    CHECK(gluing_signatures(options) == catalogue.choose(options));
  });
}

TEST_CASE("the three ways to ask agree, and name gluings as core does") {
  GluingOptions orientable = by_letters(4, "o");
  for (const GluingOptions& options : {everything(1), everything(2), everything(3), orientable}) {
    Signatures texts;
    enumerate_gluings(options, [&](const Triangulation& tri) { texts.push_back(signature(tri)); });
    std::sort(texts.begin(), texts.end());
    CHECK(gluing_signatures(options) == texts);
    CHECK(count_gluings(options) == static_cast<std::int64_t>(texts.size()));
  }
}

TEST_CASE("any number of threads gives the same gluings in the same order") {
  for (const GluingOptions& options : {everything(1), everything(3), by_letters(4, "od")}) {
    const std::vector<Triangulation> one = in_order(options, 1);
    CHECK(in_order(options, 2) == one);
    CHECK(in_order(options, 3) == one);
    GluingOptions two = options;
    two.threads = 2;
    CHECK(gluing_signatures(two) == gluing_signatures(options));
  }
}

TEST_CASE("a stop is heeded, and what the visitor throws comes through") {
  GluingOptions options = by_letters(6, "o"); // more than anybody would wait for
  for (const int threads : {1, 2}) {
    options.threads = threads;
    std::stop_source stop;
    long visited = 0;
    const auto stop_soon = [&](const Triangulation&) {
      if (++visited == 1000) stop.request_stop();
    };
    CHECK_THROWS_AS(enumerate_gluings(options, stop_soon, Progress({}, stop.get_token())), Stopped);
    CHECK(visited >= 1000);
    const auto refuse = [](const Triangulation&) { throw std::out_of_range("enough"); };
    CHECK_THROWS_AS(enumerate_gluings(options, refuse), std::out_of_range);
  }
}

TEST_CASE("progress goes from 0 towards 1") {
  std::vector<double> fractions;
  const Progress progress([&](std::string_view, double fraction) { fractions.push_back(fraction); }, {});
  count_gluings(by_letters(3, "o"), progress);
  REQUIRE(fractions.size() > 10);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() == 0);
  CHECK(fractions.back() < 1);
}

TEST_CASE("vertex links are read as they are typed") {
  const LinkSet set = parse_link_set("2,3,n1,N12");
  CHECK(set.genera == std::vector<int>{2, 3});
  CHECK(set.crosscaps == std::vector<int>{1, 12});
  CHECK(set.contains({-2, 0, true}));  // genus 2
  CHECK(set.contains({1, 0, false}));  // the projective plane
  CHECK(!set.contains({2, 0, true}));  // the sphere was not asked for
  CHECK(!set.contains({-3, 1, true})); // a surface of genus 2 with a hole
  for (const char* text : {"", "2,", ",2", "x", "-1", "n0", "n", "2 3", "1.5", "99999999999"})
    CHECK_THROWS_AS(parse_link_set(text), InputError);
}

TEST_CASE("senseless requests are refused") {
  for (const int n : {-1, 0, max_gluing_tetrahedra + 1})
    CHECK_THROWS_AS(count_gluings(everything(n)), PreconditionError);
  GluingOptions options = everything(1);
  options.threads = 0;
  CHECK_THROWS_AS(count_gluings(options), PreconditionError);
}

TEST_CASE("units and streams hold the same gluings as the list", "[enumeration]") {
  for (const int tets : {1, 2, 3}) {
    GluingOptions options = everything(tets);
    const Signatures listed = gluing_signatures(options);
    Signatures streamed;
    for (const int threads : {1, 3}) {
      options.threads = threads;
      Signatures now;
      enumerate_signatures(options, [&](const std::string& text) { now.push_back(text); });
      if (threads > 1) CHECK(now == streamed); // the order, too
      streamed = now;
      std::sort(now.begin(), now.end());
      CHECK(now == listed);
    }
    const GluingUnits units(options);
    Signatures together;
    for (int k = units.size(); k-- > 0;) {
      const Signatures unit = units.signatures(k);
      CHECK(std::is_sorted(unit.begin(), unit.end()));
      together.insert(together.end(), unit.begin(), unit.end());
    }
    std::sort(together.begin(), together.end());
    CHECK(together == listed);
  }
}
