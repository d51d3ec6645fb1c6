// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Isomorphism signatures: a short text that two triangulations share exactly if they are isomorphic.
///
/// The text is that of Regina (Burton, "The Pachner graph and the simplification of 3-sphere triangulations",
/// 2011), so both programs name every triangulation alike. A component is written from a labelling that
/// starts at some tetrahedron with some order of its vertices and numbers the others as they are met; of the
/// 24n texts the smallest (as ASCII) is the signature. Components are written one after the other, in ASCII
/// order.

#include "tetrarch/core/isomorphism.hpp"

#include <string>
#include <string_view>

namespace tetrarch {

/// The signature. A candidate labelling is given up at its first difference for the worse, and automorphisms
/// found on the way spare their orbits. Typical cost O(n), for symmetric triangulations about O(n log n);
/// memory O(n). At worst O(n^2), where nearly all labellings agree for long without being symmetric: the
/// worst known are rings of tetrahedra in which each is glued to the next by two faces (half a second for
/// 1,000).
std::string signature(const Triangulation& tri);

/// The signature of a connected triangulation and the labelling that gives it: `relabelled(tri, labelling)`
/// is `from_signature(text)`.
struct CanonicalLabelling {
  std::string text;
  Isomorphism labelling;
};
CanonicalLabelling canonical_labelling(const Triangulation& tri);

/// The triangulation that a signature names, in canonical labelling. Surrounding white space is ignored.
/// Throws InputError that names the letter's position where the text is no signature. O(length).
Triangulation from_signature(std::string_view text);

/// Whether every letter is one that signatures use and the text is not empty: the cheap test for "this might
/// be one".
bool looks_like_signature(std::string_view text);

/// Whether `from_signature` would read it. O(length).
bool is_signature(std::string_view text);

} // namespace tetrarch
