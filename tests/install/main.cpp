// SPDX-License-Identifier: GPL-2.0-or-later
/// The volume of a manifold with geodesic boundary, from the signature of a triangulation.
#include <cstdio>
#include <exception>
#include <tetrarch/core/signature.hpp>
#include <tetrarch/hyperbolic/search.hpp>

int main(int argc, char** argv) try {
  const tetrarch::Triangulation tri = tetrarch::from_signature(argc > 1 ? argv[1] : "cPcbbbihq");
  const tetrarch::hyperbolic::Search found = tetrarch::hyperbolic::find_structure(tri);
  if (found.structure.outcome != tetrarch::hyperbolic::Outcome::geometric) {
    std::printf("%s\n", describe(found).c_str());
    return 1;
  }
  std::printf("%.12f\n", found.structure.volume);
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
