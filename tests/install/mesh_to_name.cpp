// SPDX-License-Identifier: GPL-2.0-or-later
/// From a mesh to a named manifold with its structure, one step a line.
#include <cstdio>
#include <exception>
#include <tetrarch/identify/identify.hpp>
#include <tetrarch/workshop/open.hpp>
#include <tetrarch/workshop/structure.hpp>

int main(int argc, char** argv) try {
  using namespace tetrarch;
  const char* const what = argc > 1 ? argv[1] : "cPcbbbihq";
  const format::Document body = workshop::open_triangulation(what);
  workshop::require_manifold(body.triangulation, what);
  const workshop::Structure found = workshop::structure(body.triangulation);
  for (const auto& [name, value] : rows_of(found)) std::printf("%s: %s\n", name.c_str(), value.c_str());
  if (found.verdict() != workshop::Verdict::yes) return 1;
  const identify::Identification named = identify::identify(found.search.triangulation);
  std::printf("name: %s\n", named ? named.name.c_str() : "none found");
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
