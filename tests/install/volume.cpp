// SPDX-License-Identifier: GPL-2.0-or-later
/// A shared object for programs in any language: the volume of a manifold, from the signature of a
/// triangulation; 0 where no structure was found, -1 where there is no such triangulation.
#include <tetrarch/tetrarch.hpp>

extern "C" double volume_of(const char* signature) try {
  const tetrarch::Triangulation tri = tetrarch::from_signature(signature);
  const tetrarch::hyperbolic::Search found = tetrarch::hyperbolic::find_structure(tri);
  if (found.structure.outcome != tetrarch::hyperbolic::Outcome::geometric) return 0;
  return found.structure.volume;
} catch (const tetrarch::InputError&) {
  return -1;
}
