// SPDX-License-Identifier: GPL-2.0-or-later
// Some thousand triangulations against Regina's recorded answers; tests/oracle/record_core.py describes the
// file.
#include "support/laws.hpp"
#include "tetrarch/core/signature.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  if (!text.empty() && text.back() == separator) parts.emplace_back();
  return parts;
}

Triangulation read_gluings(const std::string& text) {
  const std::size_t colon = text.find(':');
  Triangulation tri(std::stoi(text.substr(0, colon)));
  std::istringstream in(text.substr(colon + 1));
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      std::string token;
      if (!tri.is_boundary({t, f}) || !(in >> token) || token == "-") continue;
      tri.glue({t, f}, std::stoi(token), Perm4::from_rank(token.back() - 'a'));
    }
  std::string rest;
  REQUIRE_FALSE(in >> rest);
  return tri;
}

std::string flags(const Skeleton& s) {
  return std::string(is_valid(s) ? "v" : "") + (s.is_orientable() ? "o" : "") + (s.is_connected() ? "c" : "");
}

std::string counts(const Skeleton& s) {
  int reversed = 0;
  for (const EdgeId e : all<EdgeId>(s.edge_count())) reversed += s.is_reversed(e);
  return std::to_string(s.vertex_count()) + " " + std::to_string(s.edge_count()) + " " +
         std::to_string(s.face_count()) + " " + std::to_string(reversed);
}

std::string boundary(const Triangulation& tri, const Skeleton& s) {
  int real = 0;
  int ideal = 0;
  for (const BoundaryComponent& b : boundary_components(tri, s))
    ++(b.kind == BoundaryComponent::Kind::real ? real : ideal);
  return std::to_string(real) + " " + std::to_string(ideal) + " 0";
}

std::string links(const Skeleton& s) {
  std::map<std::tuple<int, int, std::string>, int> kinds;
  for (const VertexId v : all<VertexId>(s.vertex_count()))
    ++kinds[{s.link(v).euler, s.link(v).boundary_curves, s.link(v).orientable ? "o" : "n"}];
  std::string text;
  for (const auto& [kind, count] : kinds)
    text += (text.empty() ? "" : " ") + std::to_string(count) + ":" + std::to_string(std::get<0>(kind)) +
            "," + std::to_string(std::get<1>(kind)) + "," + std::get<2>(kind);
  return text;
}

} // namespace

TEST_CASE("signatures and invariants are Regina's", "[oracle]") {
  std::ifstream in(TETRARCH_SOURCE_DIR "/tests/oracle/regina_core.txt");
  REQUIRE(in);
  int lines = 0;
  int invalid = 0;
  for (std::string line; std::getline(in, line);) {
    if (line[0] == '#') continue;
    ++lines;
    const auto field = split(line, '|');
    REQUIRE(field.size() == 7);
    const Triangulation tri = read_gluings(field[0]);
    const Skeleton s(tri);
    INFO(field[1].substr(0, 200));
    CHECK(signature(tri) == field[1]);
    CHECK(signature(from_signature(field[1])) == field[1]);
    CHECK(flags(s) == field[2]);
    CHECK(counts(s) == field[3]);
    CHECK(boundary(tri, s) == field[4]);
    CHECK(links(s) == field[5]);
    if (field[6] != "-") CHECK(std::to_string(automorphisms(tri).size()) == field[6]);
    invalid += !is_valid(s);
  }
  CHECK(lines > 2500);
  CHECK(invalid > 500);
}
