// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluings_signature.hpp"

namespace tetrarch::enumeration {
namespace {

enum FaceType : int { new_tet = 1, old_tet = 2 };

/// The letter of a number below 52: a..z, then A..Z.
constexpr char letter(int value) {
  return static_cast<char>(value < 26 ? 'a' + value : 'A' + (value - 26));
}

/// Which orders of the faces of a first tetrahedron begin with the smallest letter. That depends only on
/// which of its four neighbours are the same and which are the tetrahedron itself, its *pattern*.
struct Front {
  char letter = 127;
  std::uint32_t orders = 0; ///< bit r: Perm4::from_rank(r), from t-vertices to labels
};

constexpr int pattern_count = 625; ///< four digits 0..4; 0 is the tetrahedron itself

char first_letter(const std::array<int, 4>& neighbour, Perm4 order) {
  const Perm4 back = order.inverse();
  int packed = 0;
  int count = 0;
  unsigned seen = 0;
  for (int f = 0; f < 4 && count < 3; ++f) {
    const unsigned who = 1U << neighbour[back[f]];
    const bool is_itself = neighbour[back[f]] == 0;
    const bool is_second_half = is_itself && (seen & who) != 0;
    if (!is_second_half) packed |= (is_itself || (seen & who) != 0 ? old_tet : new_tet) << (2 * count++);
    seen |= who;
  }
  return letter(packed);
}

std::array<Front, pattern_count> all_fronts() {
  std::array<Front, pattern_count> fronts{};
  for (int pattern = 0; pattern < pattern_count; ++pattern) {
    const std::array<int, 4> neighbour{pattern / 125, pattern / 25 % 5, pattern / 5 % 5, pattern % 5};
    Front& front = fronts[pattern];
    for (int rank = 0; rank < Perm4::count; ++rank) {
      const char c = first_letter(neighbour, Perm4::from_rank(rank));
      if (c > front.letter) continue;
      if (c < front.letter) front = {c, 0};
      front.orders |= 1U << rank;
    }
  }
  return fronts;
}

const Front& front_of(const PartialGluing& gluing, int tet) {
  static const std::array<Front, pattern_count> fronts = all_fronts();
  constexpr std::uint32_t every_order = (1U << Perm4::count) - 1;
  // Glued only to itself, it has too few pairs for the letter to be told by the pattern.
  static const Front alone{0, every_order};
  if (gluing.size() == 1) return alone;
  std::array<int, 4> met{};
  int count = 0;
  int pattern = 0;
  for (int f = 0; f < 4; ++f) {
    const int other = gluing.target(4 * tet + f) >> 2;
    int who = 0;
    if (other != tet) {
      while (who < count && met[who] != other) ++who;
      if (who == count) met[count++] = other;
      ++who;
    }
    pattern = 5 * pattern + who;
  }
  return fronts[pattern];
}

} // namespace

std::string SignatureWriter::write(const PartialGluing& gluing) {
  gluing_ = &gluing;
  have_best_ = false;
  start_from_best_fronts();
  const int n = gluing.size();
  std::string text(1, letter(n));
  text.append(best_types_.data(), static_cast<std::size_t>((2 * n + 2) / 3));
  for (int j = 0; j < best_joins_; ++j) text += letter(best_target_[j]);
  for (int j = 0; j < best_joins_; ++j) text += letter(best_perm_[j]);
  return text;
}

void SignatureWriter::start_from_best_fronts() {
  const int n = gluing_->size();
  std::array<const Front*, PartialGluing::max_tets> front{};
  char smallest = 127;
  for (int t = 0; t < n; ++t) {
    front[t] = &front_of(*gluing_, t);
    smallest = std::min(smallest, front[t]->letter);
  }
  for (int t = 0; t < n; ++t) {
    if (front[t]->letter != smallest) continue;
    for (int rank = 0; rank < Perm4::count; ++rank)
      if ((front[t]->orders >> rank & 1U) != 0) attempt(t, Perm4::from_rank(rank));
  }
}

/// Most labellings lose by their face types, so the joins are looked at only after these.
void SignatureWriter::attempt(int tet, Perm4 order) {
  met_ = letters_ = joins_ = 0;
  better_ = !have_best_;
  label_.fill(-1);
  meet(tet, order);
  if (read_types() && (better_ || is_better_behind_types())) keep();
}

void SignatureWriter::meet(int tet, Perm4 p) {
  label_[tet] = met_;
  tet_[met_] = static_cast<std::uint8_t>(tet);
  perm_[met_++] = p;
}

/// False as soon as the types are worse than the best ones.
bool SignatureWriter::read_types() {
  int packed = 0;
  int count = 0;
  for (int k = 0; k < met_; ++k) {
    const Perm4 back = perm_[k].inverse();
    for (int f = 0; f < 4; ++f) {
      const int face = 4 * tet_[k] + back[f];
      const int image = gluing_->target(face);
      const int label = label_[image >> 2];
      if (label < 0) {
        meet(image >> 2, perm_[k] * gluing_->perm(face).inverse());
        packed |= new_tet << (2 * count);
      } else {
        if (label < k || (label == k && perm_[k][image & 3] < f)) continue; // read from the other side
        join_face_[joins_] = static_cast<std::uint8_t>(face);
        target_[joins_++] = static_cast<std::uint8_t>(label);
        packed |= old_tet << (2 * count);
      }
      if (++count < 3) continue;
      count = 0;
      if (!end_type_letter(packed)) return false;
    }
  }
  return count == 0 || end_type_letter(packed);
}

bool SignatureWriter::end_type_letter(int& packed) {
  const char c = letter(packed);
  const char best = best_types_[letters_];
  types_[letters_++] = c;
  packed = 0;
  if (better_) return true;
  better_ = c < best;
  return c <= best;
}

/// The types are those of the best labelling, so there are as many joins.
bool SignatureWriter::is_better_behind_types() const {
  for (int j = 0; j < joins_; ++j)
    if (target_[j] != best_target_[j]) return target_[j] < best_target_[j];
  for (int j = 0; j < joins_; ++j) {
    const int rank = perm_of_join(j).rank();
    if (rank != best_perm_[j]) return rank < best_perm_[j];
  }
  return false;
}

Perm4 SignatureWriter::perm_of_join(int j) const {
  const int face = join_face_[j];
  return perm_[target_[j]] * gluing_->perm(face) * perm_[label_[face >> 2]].inverse();
}

void SignatureWriter::keep() {
  have_best_ = true;
  best_types_ = types_;
  best_target_ = target_;
  best_joins_ = joins_;
  for (int j = 0; j < joins_; ++j) best_perm_[j] = static_cast<std::uint8_t>(perm_of_join(j).rank());
}

} // namespace tetrarch::enumeration
