// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Isomorphism signatures: a short text that two triangulations share exactly if they are isomorphic.
///
/// The text is that of Regina (Burton, "The Pachner graph and the simplification of 3-sphere triangulations",
/// 2011), so both programs give every triangulation the same name. A component is written from a labeling
/// that starts at some tetrahedron with some order of its vertices and numbers the others as they are met; of
/// the 24n texts the smallest (as ASCII) is the signature. Components are written one after the other, in
/// ASCII order.

#include "tetrarch/core/isomorphism.hpp"

#include <string>
#include <string_view>

namespace tetrarch {

/// The signature. The search drops a candidate labeling at its first greater letter, and each automorphism
/// found on the way spares an orbit of candidates. Typical cost O(n), for symmetric triangulations about O(n
/// log n); memory O(n). At worst O(n^2), if nearly all labelings agree for a long way without symmetry: the
/// worst known case is a ring in which two faces glue each tetrahedron to the next (half a second for 1,000).
std::string signature(const Triangulation& tri);

/// The signature of a connected triangulation and the labeling that gives it: `relabelled(tri, labelling)`
/// is `from_signature(text)`.
struct CanonicalLabelling {
  std::string text;
  Isomorphism labelling;
};
CanonicalLabelling canonical_labelling(const Triangulation& tri);

/// The triangulation that a signature names, in canonical labeling. Surrounding white space is ignored.
/// Throws InputError with the position of the letter if the text is no signature. O(length).
Triangulation from_signature(std::string_view text);

/// Whether the text is not empty and every letter is one that signatures use: a cheap test before reading.
bool looks_like_signature(std::string_view text);

/// Whether `from_signature` would read it. O(length).
bool is_signature(std::string_view text);

} // namespace tetrarch
