// SPDX-License-Identifier: GPL-2.0-or-later

/// Certificates damaged at random. What remains may still be a proof: a digit moved inside its box, an
/// interval of the volume that has grown. Those are told apart by computing the structure of what the damaged
/// file says, in doubles and by other code.

#include "../verified/certified.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/checker/check.hpp"
#include "tetrarch/core/error.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace tetrarch;
using support::Certified;
using Json = nlohmann::json;

namespace {

/// Accepted, refused, or no certificate any more.
enum class Answer { accepted, refused, unreadable };

Answer answer_to(const std::string& text) {
  try {
    return checker::check(text, "damaged").accepted ? Answer::accepted : Answer::refused;
  } catch (const InputError&) {
    return Answer::unreadable;
  }
}

Triangulation triangulation_of(const Json& certificate) {
  const Json& list = certificate["gluings"];
  Triangulation tri(static_cast<int>(list.size()));
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const auto images = list[t][f][1].get<std::string>();
      const Perm4 perm(images[0] - '0', images[1] - '0', images[2] - '0', images[3] - '0');
      if (tri.is_boundary({t, f})) tri.glue({t, f}, list[t][f][0].get<int>(), perm);
    }
  return tri;
}

/// Whether a structure that was found anew, by Newton's method in doubles, is what the certificate says.
bool is_true(const Json& certificate) {
  const Triangulation tri = triangulation_of(certificate);
  const Skeleton skeleton(tri);
  const auto found = hyperbolic::hyperbolize(tri, skeleton);
  if (found.outcome != hyperbolic::Outcome::geometric) return false;
  hyperbolic::Metric<double> lengths(skeleton.edge_count(), 0);
  for (const Json& edge : certificate["edges"])
    lengths[skeleton.edge({edge["tetrahedron"].get<int>(), edge["edge"].get<int>()})] =
        std::stod(edge["length"].get<std::string>());
  // At lengths within r of the structure's the curvature is below some 100 r.
  const double radius = std::stod(certificate["radius"].get<std::string>());
  const auto k = hyperbolic::edge_curvature(skeleton, hyperbolic::dihedral_angles(skeleton, lengths));
  const Json& volume = certificate["claims"]["volume"];
  return hyperbolic::max_curvature(k) < 100 * radius + 1e-13 &&
         std::stod(volume[0].get<std::string>()) < found.volume + 1e-11 &&
         std::stod(volume[1].get<std::string>()) > found.volume - 1e-11 &&
         certificate["claims"]["orientable"].get<bool>() == skeleton.is_orientable();
}

/// Another character of the same kind in the place of a digit or letter of the values.
std::string with_another_character(std::string text, support::Random& random) {
  const std::size_t start = text.find("\"gluings\"");
  for (;;) {
    const std::size_t at = start + random.below(static_cast<int>(text.size() - start));
    const std::string alphabet = std::isdigit(text[at]) != 0 ? "0123456789" : "abcdef";
    if (alphabet.find(text[at]) == std::string::npos) continue;
    const char other = alphabet[random.below(static_cast<int>(alphabet.size()))];
    if (other == text[at]) continue;
    text[at] = other;
    return text;
  }
}

/// Two faces change their partners, consistently.
Json with_swapped_gluings(Json certificate, support::Random& random) {
  Triangulation tri = triangulation_of(certificate);
  for (;;) {
    const TetFace a{random.below(tri.size()), random.below(4)};
    const TetFace b{random.below(tri.size()), random.below(4)};
    const Gluing ga = tri.gluing(a);
    const Gluing gb = tri.gluing(b);
    const TetFace a2{ga.tet, ga.perm[a.face]};
    const TetFace b2{gb.tet, gb.perm[b.face]};
    if (a == b || a == b2) continue;
    // a with b, and their old partners with each other.
    const auto set = [&](const TetFace& x, const TetFace& y, const Perm4& p) {
      certificate["gluings"][x.tet][x.face] = {y.tet, p.str()};
      certificate["gluings"][y.tet][y.face] = {x.tet, p.inverse().str()};
    };
    const auto onto = [&](const TetFace& x, const TetFace& y) {
      Perm4 p = random.perm();
      while (p[x.face] != y.face) p = random.perm();
      return p;
    };
    set(a, b, onto(a, b));
    set(a2, b2, onto(a2, b2));
    return certificate;
  }
}

/// A claim, a flag, a member or an order is changed.
Json with_another_claim(Json c, support::Random& random) {
  Json& edges = c["edges"];
  Json& edge = edges[random.below(static_cast<int>(edges.size()))];
  switch (random.below(8)) {
  case 0:
    c["claims"]["orientable"] = !c["claims"]["orientable"].get<bool>();
    break;
  case 1:
    c["claims"]["links"].push_back(-2);
    break;
  case 2:
    c["claims"]["volume"][random.below(2)] = "6.4519902708";
    break;
  case 3:
    edge["fixed"] = !edge["fixed"].get<bool>();
    break;
  case 4:
    edges.push_back(edge);
    break;
  case 5:
    edges.erase(0);
    break;
  case 6:
    c["radius"] = "0x1p-90";
    break;
  default:
    c["radius"] = "0x1p-1";
  }
  return c;
}

std::vector<std::string> certificates() {
  std::vector<std::string> list;
  for (const char* signature : {"cPcbbbiht", "cPcbbbdxm", "dLQbcccdero"}) {
    const Certified c(signature);
    if (c.result.proof) list.push_back(c.text());
  }
  const auto& table = catalogue::stored_table(3);
  for (std::size_t k = 0; k < table.size(); k += 5) list.push_back(Certified(table[k].signature).text());
  return list;
}

} // namespace

TEST_CASE("certificates damaged at random are refused unless they remain true", "[checker]") {
  support::Random random(25);
  const std::vector<std::string> list = certificates();
  REQUIRE(list.size() > 30);
  std::array<int, 3> seen{};
  for (int k = 0; k < 1000; ++k) {
    const std::string& whole = list[k % list.size()];
    const std::string text = k % 4 == 0   ? with_swapped_gluings(Json::parse(whole), random).dump()
                             : k % 4 == 1 ? with_another_claim(Json::parse(whole), random).dump()
                                          : with_another_character(whole, random);
    const Answer answer = answer_to(text);
    ++seen[static_cast<std::size_t>(answer)];
    CAPTURE(k, whole, text);
    if (answer == Answer::accepted) REQUIRE(is_true(Json::parse(text)));
  }
  WARN("accepted " << seen[0] << ", refused " << seen[1] << ", unreadable " << seen[2]);
  CHECK(seen[1] > 500);
  CHECK(seen[0] > 0); // some digits do not matter
}

TEST_CASE("near misses are refused", "[checker]") {
  for (const catalogue::Manifold& m : catalogue::stored_table(3)) {
    CAPTURE(m.name);
    const Json good = Json::parse(Certified(m.signature).text());
    // A midpoint moved out of its box.
    Json moved = good;
    moved["edges"][0]["length"] =
        numeric::hexadecimal(numeric::Ball(std::stod(good["edges"][0]["length"].get<std::string>()) + 1e-12));
    if (!good["edges"][0]["fixed"].get<bool>()) CHECK(answer_to(moved.dump()) == Answer::refused);
    // A box smaller than what the midpoint is off.
    Json shrunk = good;
    shrunk["radius"] = "0x1p-70";
    CHECK(answer_to(shrunk.dump()) == Answer::refused);
    // A box that is mapped out of itself, or on which a tetrahedron need not exist.
    Json wide = good;
    wide["radius"] = "0x1p0";
    CHECK(answer_to(wide.dump()) == Answer::refused);
    // An interval beside the volume.
    Json beside = good;
    beside["claims"]["volume"][0] = good["claims"]["volume"][1];
    CHECK(answer_to(beside.dump()) == Answer::refused);
  }
}

TEST_CASE("what is no certificate is refused with what is wrong", "[checker]") {
  const std::string good = Certified("cPcbbbihq").text();
  REQUIRE(answer_to(good) == Answer::accepted);
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[1,2]"), std::string("null"),
        good.substr(0, good.size() / 2), "{\"format\":1," + good.substr(1), std::string(1000, '['),
        std::string("\xff\xfe{}"), std::string(R"({"format": "tetrarch-triangulation"})")})
    CHECK(answer_to(text) == Answer::unreadable);
  const Json json = Json::parse(good);
  for (const auto& [pointer, value] :
       std::vector<std::pair<std::string, Json>>{{"/version", 2},
                                                 {"/version", "1"},
                                                 {"/bits", 1},
                                                 {"/bits", 1e300},
                                                 {"/bits", 9000},
                                                 {"/radius", "0.5"},
                                                 {"/radius", "0x1p"},
                                                 {"/radius", "0x1p99999999999"},
                                                 {"/radius", nullptr},
                                                 {"/radius", "nan"},
                                                 {"/gluings", Json::array()},
                                                 {"/gluings/0/0/0", 2},
                                                 {"/gluings/0/0/0", -1},
                                                 {"/gluings/0/0/1", "0012"},
                                                 {"/gluings/0/0/1", "01234"},
                                                 {"/gluings/0/0", nullptr},
                                                 {"/edges/0/edge", 6},
                                                 {"/edges/0/tetrahedron", 2},
                                                 {"/edges/0/length", "inf"},
                                                 {"/edges/0/fixed", 1},
                                                 {"/claims/volume/0", "6,45"},
                                                 {"/claims/volume/0", 6.45},
                                                 {"/claims/volume/0", "-"},
                                                 {"/claims/links", 2},
                                                 {"/claims/links/0", 3},
                                                 {"/claims/more", true},
                                                 {"/more", true}}) {
    Json bad = json;
    bad[Json::json_pointer(pointer)] = value;
    CAPTURE(pointer, value.dump());
    CHECK(answer_to(bad.dump()) == Answer::unreadable);
  }
}
