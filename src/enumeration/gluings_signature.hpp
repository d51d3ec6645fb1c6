// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The isomorphism signature of a complete gluing, straight from the search.
///
/// The text is that of `tetrarch::signature` (core/signature.hpp says what it means); a law in the tests
/// holds the two together. This route knows that the gluing is closed, connected and small, needs no memory
/// and is several times as fast: with the general one the search would spend nine tenths of its time on
/// names.

#include "gluings_partial.hpp"

#include <string>

namespace tetrarch::enumeration {

/// Writes signatures of complete gluings, one after the other.
class SignatureWriter {
public:
  std::string write(const PartialGluing& gluing);

private:
  static constexpr int max_pairs = 2 * PartialGluing::max_tets;
  static constexpr int max_type_letters = (max_pairs + 2) / 3;

  void start_from_best_fronts();
  void attempt(int tet, Perm4 order);
  void meet(int tet, Perm4 p);
  bool read_types();
  bool end_type_letter(int& packed);
  bool is_better_behind_types() const;
  Perm4 perm_of_join(int j) const;
  void keep();

  const PartialGluing* gluing_ = nullptr;
  bool have_best_ = false;
  bool better_ = false; ///< by its types

  // The labelling that is tried: tetrahedra as they are met, letters of face types, and the pairs that join
  // old tetrahedra: the face that is read, and the label of the tetrahedron that it meets.
  int met_ = 0;
  int letters_ = 0;
  int joins_ = 0;
  std::array<int, PartialGluing::max_tets> label_{};
  std::array<std::uint8_t, PartialGluing::max_tets> tet_{};
  std::array<Perm4, PartialGluing::max_tets> perm_{};
  std::array<char, static_cast<std::size_t>(max_type_letters)> types_{};
  std::array<std::uint8_t, static_cast<std::size_t>(max_pairs)> join_face_{};
  std::array<std::uint8_t, static_cast<std::size_t>(max_pairs)> target_{};

  // The best so far.
  int best_joins_ = 0;
  std::array<char, static_cast<std::size_t>(max_type_letters)> best_types_{};
  std::array<std::uint8_t, static_cast<std::size_t>(max_pairs)> best_target_{};
  std::array<std::uint8_t, static_cast<std::size_t>(max_pairs)> best_perm_{};
};

} // namespace tetrarch::enumeration
