// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The search itself: gluings as texts, and only the smallest text of each goes on.
///
/// A *flag* is a tetrahedron with an order of its vertices. From a flag a gluing is read as a text: always
/// take the first open face (of the tetrahedra in the order in which they were met), and write down what it
/// meets, either *new* (a tetrahedron met for the first time; it is named so that the gluing is the identity)
/// or *old* (the tetrahedron and the permutation). The search writes such texts letter by letter, from flag
/// (0, 0123), old ones first. A gluing is kept if no other of its 24n flags reads a smaller text, so that
/// each class is found once; and since a text is read from the front, most others are seen to be worse long
/// before they are complete.
/// Why *old* comes before *new*: a text that begins with *new* then promises that no tetrahedron is glued to
/// itself anywhere, and whatever breaks such a promise is dropped on the spot.

#include "gluings_partial.hpp"

#include "tetrarch/core/progress.hpp"

#include <functional>
#include <vector>

namespace tetrarch::enumeration {

/// Which flags may still read a smaller text than (0, 0123), and which open face each of them waits for.
class RivalFlags {
public:
  using Letter = std::uint16_t;
  static constexpr Letter fresh = 0xffff; ///< the letter *new*
  static constexpr int max_letters = 2 * PartialGluing::max_tets;
  using Text = std::array<Letter, static_cast<std::size_t>(max_letters)>;

  static Letter letter(int tet, Perm4 p) { return static_cast<Letter>(24 * tet + p.rank()); }

  void copy_from(const RivalFlags& source, int tets);
  /// All flags of a new tetrahedron become rivals (except (0, 0123) itself).
  void add_tetrahedron(int tet);
  /// Goes on with the flags that waited for a face, or its partner, which have just been glued. False: one of
  /// them reads a smaller text than `text`. Ties at the end of the text are automorphisms, and no harm.
  bool update(const PartialGluing& gluing, int face, const Text& text);

private:
  static constexpr std::uint16_t none = 0xffff;
  static constexpr int max_flags = 24 * PartialGluing::max_tets;

  void wait(int flag, int face) {
    next_[flag] = first_[face];
    first_[face] = static_cast<std::uint16_t>(flag);
  }

  /// Lists, one for each face: the flags whose text goes on with what that face will meet.
  std::array<std::uint16_t, static_cast<std::size_t>(4) * PartialGluing::max_tets> first_;
  std::array<std::uint16_t, static_cast<std::size_t>(max_flags)> next_;
};

class GluingSearch {
public:
  using Text = RivalFlags::Text;
  using Found = std::function<void(const PartialGluing&)>;

  GluingSearch(const GluingRules& rules, const Progress& progress);

  /// The smallest texts of `length` letters that obey the rules so far, in increasing order.
  std::vector<Text> beginnings(int length);
  /// All complete gluings whose text begins so, in the order of their texts.
  void complete(const Text& beginning, int length, Found found);

private:
  struct Level {
    PartialGluing gluing;
    RivalFlags rivals;
  };

  void extend(int depth, int from_face);
  void glue_old(int depth, int face);
  void glue_new(int depth, int face);
  void accept(int depth, int face, RivalFlags::Letter letter);
  bool is_asked_for(int depth, RivalFlags::Letter letter) const {
    return depth >= beginning_length_ || letter == beginning_[depth];
  }

  const GluingRules& rules_; // both outlive the search
  const Progress& progress_;
  std::vector<Level> levels_;
  Text text_{};
  Text beginning_{};
  int beginning_length_ = 0;
  int goal_ = 0;
  Found at_goal_;
  unsigned steps_ = 0;
};

} // namespace tetrarch::enumeration
