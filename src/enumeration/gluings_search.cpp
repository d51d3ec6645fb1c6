// SPDX-License-Identifier: GPL-2.0-or-later
#include "gluings_search.hpp"

#include <utility>

namespace tetrarch::enumeration {
namespace {

/// Reads a partial gluing from one flag, as far as it goes, beside a text to compare with.
class Reading {
public:
  enum class Verdict { smaller, greater, equal, waits };

  Reading(const PartialGluing& gluing, const RivalFlags::Text& text) : gluing_(gluing), text_(text) {}

  Verdict read(int tet, Perm4 order) {
    count_ = 0;
    at_ = 0;
    label_.fill(-1);
    meet(tet, order);
    for (int k = 0; k < count_; ++k) {
      const Verdict v = read_faces(k);
      if (v != Verdict::equal) return v;
    }
    return Verdict::equal;
  }
  /// The open face at which the reading stopped.
  int waits_for() const { return face_; }

private:
  void meet(int tet, Perm4 p) {
    label_[tet] = count_;
    met_[count_] = static_cast<std::uint8_t>(tet);
    perm_[count_++] = p;
  }

  Verdict read_faces(int k) {
    const Perm4 back = perm_[k].inverse();
    for (int f = 0; f < 4; ++f) {
      face_ = 4 * met_[k] + back[f];
      const std::uint8_t image = gluing_.target(face_);
      if (image == PartialGluing::open) return Verdict::waits;
      const int other = image >> 2;
      const int label = label_[other];
      RivalFlags::Letter letter = RivalFlags::fresh;
      if (label < 0) {
        meet(other, perm_[k] * gluing_.perm(face_).inverse());
      } else {
        const int there = perm_[label][image & 3];
        if (label < k || (label == k && there < f)) continue; // read from the other side
        letter = RivalFlags::letter(label, perm_[label] * gluing_.perm(face_) * back);
      }
      const RivalFlags::Letter rival = text_[at_++];
      if (letter != rival) return letter < rival ? Verdict::smaller : Verdict::greater;
    }
    return Verdict::equal;
  }

  const PartialGluing& gluing_;
  const RivalFlags::Text& text_;
  int count_ = 0;
  int at_ = 0;
  int face_ = 0;
  std::array<int, PartialGluing::max_tets> label_;
  std::array<std::uint8_t, PartialGluing::max_tets> met_;
  std::array<Perm4, PartialGluing::max_tets> perm_;
};

} // namespace

void RivalFlags::copy_from(const RivalFlags& source, int tets) {
  std::copy_n(source.first_.begin(), 4 * tets, first_.begin());
  std::copy_n(source.next_.begin(), 24 * tets, next_.begin());
}

void RivalFlags::add_tetrahedron(int tet) {
  for (int f = 0; f < 4; ++f) first_[4 * tet + f] = none;
  for (int rank = tet == 0 ? 1 : 0; rank < Perm4::count; ++rank)
    wait(24 * tet + rank, 4 * tet + Perm4::from_rank(rank).preimage(0));
}

bool RivalFlags::update(const PartialGluing& gluing, int face, const Text& text) {
  Reading reading(gluing, text);
  for (const int glued : {face, static_cast<int>(gluing.target(face))}) {
    std::uint16_t next = none;
    for (std::uint16_t flag = first_[glued]; flag != none; flag = next) {
      next = next_[flag];
      const Reading::Verdict verdict = reading.read(flag / 24, Perm4::from_rank(flag % 24));
      if (verdict == Reading::Verdict::smaller) return false;
      if (verdict == Reading::Verdict::waits) wait(flag, reading.waits_for());
    }
  }
  return true;
}

GluingSearch::GluingSearch(const GluingRules& rules, const Progress& progress)
    : rules_(rules), progress_(progress), levels_(static_cast<std::size_t>(2 * rules.tetrahedra + 1)) {
  levels_[0].gluing.add_tetrahedron(+1);
  levels_[0].rivals.add_tetrahedron(0);
}

std::vector<GluingSearch::Text> GluingSearch::beginnings(int length) {
  std::vector<Text> texts;
  goal_ = length;
  beginning_length_ = 0;
  at_goal_ = [&](const PartialGluing&) { texts.push_back(text_); };
  extend(0, 0);
  return texts;
}

void GluingSearch::complete(const Text& beginning, int length, Found found) {
  goal_ = 2 * rules_.tetrahedra;
  at_goal_ = [this, found = std::move(found)](const PartialGluing& gluing) {
    const bool wanted = (!rules_.nonorientable_only || !gluing.is_orientable()) &&
                        (!rules_.ideal || gluing.has_ideal_vertex());
    if (wanted) found(gluing);
  };
  beginning_ = beginning;
  beginning_length_ = length;
  extend(0, 0);
}

/// All ways to go on from here; every face before `from_face` is glued.
void GluingSearch::extend(int depth, int from_face) {
  constexpr unsigned steps_between_looks = 1024; // some hundred microseconds
  const PartialGluing& gluing = levels_[depth].gluing;
  if (depth == goal_) return at_goal_(gluing);
  if (++steps_ % steps_between_looks == 0 && progress_.stop_requested()) throw Stopped();
  int face = from_face;
  while (!gluing.is_open(face)) ++face;
  const bool can_add = gluing.size() < rules_.tetrahedra;
  const bool is_last_pair = 4 * gluing.size() - 2 * depth == 2;
  if (!(can_add && is_last_pair)) glue_old(depth, face);
  if (can_add) glue_new(depth, face);
}

void GluingSearch::glue_old(int depth, int face) {
  const PartialGluing& gluing = levels_[depth].gluing;
  PartialGluing& next = levels_[depth + 1].gluing;
  for (int other = 0; other < gluing.size(); ++other) {
    const int needed_sign = gluing.handedness(face >> 2) == gluing.handedness(other) ? -1 : 1;
    for (int rank = 0; rank < Perm4::count; ++rank) {
      const Perm4 p = Perm4::from_rank(rank);
      const int image = 4 * other + p[face & 3];
      if (image == face || !gluing.is_open(image)) continue;
      if (rules_.orientable_only && p.sign() != needed_sign) continue;
      const RivalFlags::Letter letter = RivalFlags::letter(other, p);
      if (!is_asked_for(depth, letter)) continue;
      next.copy_from(gluing);
      if (!next.glue(face, other, p, rules_)) continue;
      levels_[depth + 1].rivals.copy_from(levels_[depth].rivals, gluing.size());
      accept(depth, face, letter);
    }
  }
}

void GluingSearch::glue_new(int depth, int face) {
  if (!is_asked_for(depth, RivalFlags::fresh)) return;
  const PartialGluing& gluing = levels_[depth].gluing;
  Level& next = levels_[depth + 1];
  const int fresh = gluing.size();
  next.gluing.copy_from(gluing);
  next.gluing.add_tetrahedron(-gluing.handedness(face >> 2));
  if (!next.gluing.glue(face, fresh, Perm4(), rules_)) return;
  next.rivals.copy_from(levels_[depth].rivals, fresh);
  next.rivals.add_tetrahedron(fresh);
  accept(depth, face, RivalFlags::fresh);
}

/// The next level is filled in but for the rivals that waited for this face.
void GluingSearch::accept(int depth, int face, RivalFlags::Letter letter) {
  Level& next = levels_[depth + 1];
  text_[depth] = letter;
  if (next.rivals.update(next.gluing, face, text_)) extend(depth + 1, face + 1);
}

} // namespace tetrarch::enumeration
