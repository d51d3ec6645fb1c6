// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/signature.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace tetrarch {
namespace {

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-";

/// Letter for a value below 64; letters sort as ASCII, so value order and letter order differ.
char letter(int value) {
  return letters[static_cast<std::size_t>(value)];
}

/// How many letters a tetrahedron number takes when there are n tetrahedra.
int number_width(int n) {
  int width = 1;
  for (std::int64_t bound = 64; bound <= n; bound *= 64) ++width;
  return n < 63 ? 1 : width;
}

void append_number(std::string& text, int value, int width) {
  for (; width > 0; --width, value /= 64) text += letter(value % 64);
}

/// Tries labellings of one component and keeps the smallest.
///
/// A text has three streams: the face types (three a letter: 0 boundary, 1 a new tetrahedron, 2 an old one),
/// the targets of the faces of type 2, their maps. All texts of a component are equally long, so an attempt
/// follows the types alone, letter by letter against the best, and most end after a few. The other two
/// streams are written only of those that reach the end.
class Labeller {
public:
  explicit Labeller(const Triangulation& tri)
      : tri_(tri), n_(tri.size()), width_(number_width(n_)), mark_(static_cast<std::size_t>(n_)),
        order_(mark_.size() + 1), orbit_(static_cast<std::size_t>(n_) * Perm4::count),
        tried_(orbit_.size(), 0) {
    std::iota(orbit_.begin(), orbit_.end(), 0);
  }

  CanonicalLabelling run() {
    for (int t = 0; t < n_; ++t) {
      for (int rank = 0; rank < Perm4::count; ++rank) {
        const int flag = root(Perm4::count * t + rank);
        if (tried_[flag]) continue;
        tried_[flag] = 1;
        attempt(t, Perm4::from_rank(rank));
      }
    }
    return {size_text() + best_types_ + best_rest_, labelling()};
  }

private:
  struct Mark {
    int label = -1;
    Perm4 perm;
  };

  std::string size_text() const {
    std::string text;
    if (n_ < 63) {
      text += letter(n_);
    } else {
      text += letter(63);
      text += letter(width_);
      append_number(text, n_, width_);
    }
    return text;
  }

  Isomorphism labelling() const {
    Isomorphism iso{std::vector<int>(mark_.size()), std::vector<Perm4>(mark_.size())};
    for (std::size_t t = 0; t < mark_.size(); ++t) {
      iso.tet[t] = best_mark_[t].label;
      iso.perm[t] = best_mark_[t].perm;
    }
    return iso;
  }

  int root(int x) { return numeric::find_root(orbit_, x); }

  /// Follows the labelling that starts at t; afterwards it is the best, tied with the best, or forgotten.
  void attempt(int t, Perm4 start) {
    types_.clear();
    better_ = best_types_.empty();
    order_[0] = t;
    mark_[t] = {0, start};
    size_ = 1;
    if (write_types()) conclude();
    for (int k = 0; k < size_; ++k) mark_[order_[k]].label = -1;
  }

  /// False as soon as the best labelling is known to stay ahead. What a face turns out to be is as good as
  /// random, so the loop over faces computes where it could branch; a mispredicted branch costs more than all
  /// of it.
  bool write_types() {
    unsigned packed = 0;
    int shift = 0;
    for (int k = 0; k < size_; ++k) {
      const int t = order_[k];
      const Perm4 here = mark_[t].perm;
      const Perm4 back = here.inverse();
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri_.gluing({t, back[f]});
        if (g.tet < 0) {
          shift += 2;
          continue;
        }
        Mark& there = mark_[g.tet];
        const bool fresh = there.label < 0;
        const bool written = !fresh & was_written(k, f, there, g.perm[back[f]]);
        order_[size_] = g.tet;
        there.label = fresh ? size_ : there.label;
        there.perm = fresh ? here * g.perm.inverse() : there.perm;
        size_ += fresh ? 1 : 0;
        packed |= (written ? 0U : fresh ? 1U : 2U) << shift;
        shift += written ? 0 : 2;
      }
      for (; shift >= 6; shift -= 6, packed >>= 6)
        if (!write_letter(letter(static_cast<int>(packed % 64)))) return false;
    }
    return shift == 0 || write_letter(letter(static_cast<int>(packed)));
  }

  /// Whether the face that the f-th face of the k-th tetrahedron is glued to came earlier.
  static bool was_written(int k, int f, const Mark& there, int face_there) {
    return there.label < k || (there.label == k && there.perm[face_there] < f);
  }

  bool write_letter(char c) {
    if (!better_) {
      const char best = best_types_[types_.size()];
      if (c > best) return false;
      better_ = c < best;
    }
    types_ += c;
    return true;
  }

  /// The types are no worse than the best's; the later streams decide.
  void conclude() {
    write_rest();
    if (better_ || rest_ < best_rest_) {
      best_types_ = types_;
      best_rest_ = rest_;
      best_mark_ = mark_;
      best_order_ = order_;
    } else if (rest_ == best_rest_) {
      join_orbits();
    }
  }

  /// The targets and then the maps of the faces of type 2, all tetrahedra being labelled now.
  void write_rest() {
    rest_.clear();
    perms_.clear();
    int labelled = 1;
    for (int k = 0; k < n_; ++k) {
      const int t = order_[k];
      const Perm4 back = mark_[t].perm.inverse();
      for (int f = 0; f < 4; ++f) {
        const Gluing g = tri_.gluing({t, back[f]});
        if (g.tet < 0) continue;
        const Mark& there = mark_[g.tet];
        if (there.label == labelled) { // this is where it was met first
          ++labelled;
        } else if (!was_written(k, f, there, g.perm[back[f]])) {
          append_number(rest_, there.label, width_);
          perms_ += letter((there.perm * g.perm * back).rank());
        }
      }
    }
    rest_ += perms_;
  }

  /// This labelling and the best one give the same text: their quotient is an automorphism, and flags in one
  /// orbit of it lead to equal texts. Each tie at least doubles the group known, so there are at most
  /// log2(24n) ties.
  void join_orbits() {
    for (int t = 0; t < n_; ++t) {
      const int image = best_order_[mark_[t].label];
      const Perm4 p = mark_[t].perm.inverse() * best_mark_[image].perm; // vertices of image to vertices of t
      for (int rank = 0; rank < Perm4::count; ++rank) {
        const int a = root(Perm4::count * t + rank);
        const int b = root(Perm4::count * image + (Perm4::from_rank(rank) * p).rank());
        if (a == b) continue;
        orbit_[a] = b;
        tried_[b] |= tried_[a];
      }
    }
  }

  const Triangulation& tri_;
  int n_;
  int width_;
  std::vector<Mark> mark_;
  std::vector<int> order_; ///< one place longer than there are tetrahedra: see write_types
  int size_ = 0;           ///< so many tetrahedra are labelled
  std::vector<int> orbit_; ///< union-find over flags (tetrahedron, rank of the starting order)
  std::vector<char> tried_;
  std::string types_;
  std::string rest_; ///< targets and maps
  std::string perms_;
  std::string best_types_;
  std::string best_rest_;
  std::vector<Mark> best_mark_;
  std::vector<int> best_order_;
  bool better_ = true; ///< than the best, by the types written so far
};

/// Reads a signature letter by letter.
class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }
  int value() {
    if (at_end()) fail("ends too early");
    const std::size_t v = letters.find(text_[at_]);
    if (v == std::string_view::npos)
      fail("has " + in_quotes(text_.substr(at_, 1)) + " at position " + std::to_string(at_ + 1) +
           ", which is no signature letter");
    ++at_;
    return static_cast<int>(v);
  }
  std::int64_t number(int width) {
    std::int64_t n = 0;
    for (int k = 0; k < width; ++k) n |= static_cast<std::int64_t>(value()) << (6 * k);
    return n;
  }
  std::size_t rest() const { return text_.size() - at_; }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("signature " + in_quotes(text_) + " " + what);
  }
  [[noreturn]] void fail_before(const std::string& what) const {
    fail("is wrong at position " + std::to_string(at_) + ": " + what);
  }

private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// The streams of one component as they stand in the text.
struct ComponentText {
  std::int64_t tets = 0;
  int width = 1;
  std::vector<int> types;
  std::vector<int> targets;
  std::vector<Perm4> perms;
};

void read_size(Reader& in, ComponentText& part) {
  part.tets = in.value();
  if (part.tets == 63) {
    part.width = in.value();
    if (part.width < 1 || part.width > 5)
      in.fail_before("a number of " + std::to_string(part.width) + " letters");
    part.tets = in.number(part.width);
  }
  // n tetrahedra have 4n faces, so at least 2n gluings or boundary faces, three a letter. Checked before
  // memory is asked for.
  if (static_cast<std::int64_t>(in.rest()) < (2 * part.tets + 2) / 3)
    in.fail("ends too early for its " + std::to_string(part.tets) + " tetrahedra");
}

void read_types(Reader& in, ComponentText& part) {
  std::int64_t fresh = 0;
  for (std::int64_t faces = 4 * part.tets; faces > 0;) {
    int packed = in.value();
    for (int k = 0; k < 3; ++k, packed /= 4) {
      const int type = packed % 4;
      if (faces == 0 && type == 0) continue; // the last letter is filled up
      if (type == 3) in.fail_before("3 is no face type");
      part.types.push_back(type);
      faces -= type == 0 ? 1 : 2;
      fresh += type == 1;
      if (faces < 0) in.fail_before("more faces than there are");
    }
  }
  if (part.tets > 0 && fresh != part.tets - 1) in.fail_before("the tetrahedra are not connected");
}

void read_joins(Reader& in, ComponentText& part) {
  const auto joined = std::count(part.types.begin(), part.types.end(), 2);
  for (std::int64_t k = 0; k < joined; ++k) {
    const std::int64_t u = in.number(part.width);
    if (u >= part.tets)
      in.fail_before("tetrahedron " + std::to_string(u) + " of " + std::to_string(part.tets));
    part.targets.push_back(static_cast<int>(u));
  }
  for (std::int64_t k = 0; k < joined; ++k) {
    const int rank = in.value();
    if (rank >= Perm4::count) in.fail_before(std::to_string(rank) + " is no permutation");
    part.perms.push_back(Perm4::from_rank(rank));
  }
}

/// Adds the component to `tri`. Every tetrahedron but the first is met from an earlier one, by the identity.
void glue_component(const Reader& in, const ComponentText& part, Triangulation& tri) {
  const int base = tri.add_tetrahedra(static_cast<int>(part.tets));
  std::size_t next_type = 0;
  std::size_t next_join = 0;
  int last = base;
  for (int t = base; t < tri.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      if (!tri.is_boundary({t, f})) continue;
      if (next_type == part.types.size()) in.fail_before("too few face types");
      const int type = part.types[next_type++];
      if (type == 1) {
        tri.glue({t, f}, ++last, Perm4());
      } else if (type == 2) {
        const int u = base + part.targets[next_join];
        const Perm4 p = part.perms[next_join++];
        if (u > last || !tri.is_boundary({u, p[f]}) || (u == t && p[f] == f))
          in.fail_before("face " + std::to_string(f) + " of tetrahedron " + std::to_string(t - base) +
                         " is glued to a face that is not free");
        tri.glue({t, f}, u, p);
      }
    }
    if (t == last && t + 1 < tri.size()) in.fail_before("the tetrahedra are not connected");
  }
  if (next_type != part.types.size()) in.fail_before("more face types than faces");
}

void read_component(Reader& in, Triangulation& tri) {
  ComponentText part;
  read_size(in, part);
  read_types(in, part);
  read_joins(in, part);
  glue_component(in, part, tri);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(space) - first + 1);
}

} // namespace

CanonicalLabelling canonical_labelling(const Triangulation& tri) {
  if (tri.size() == 0 || components(tri).count != 1)
    throw PreconditionError("a canonical labeling needs a connected triangulation");
  return Labeller(tri).run();
}

std::string signature(const Triangulation& tri) {
  if (tri.size() == 0) return std::string(1, letter(0));
  const Components parts = components(tri);
  if (parts.count == 1) return Labeller(tri).run().text;
  std::vector<std::string> texts;
  for (const Triangulation& part : split(tri, parts)) texts.push_back(Labeller(part).run().text);
  std::sort(texts.begin(), texts.end());
  return std::accumulate(texts.begin(), texts.end(), std::string());
}

Triangulation from_signature(std::string_view text) {
  Reader in(trimmed(text));
  if (in.at_end()) in.fail("is empty");
  Triangulation tri;
  while (!in.at_end()) read_component(in, tri);
  return tri;
}

bool looks_like_signature(std::string_view text) {
  text = trimmed(text);
  return !text.empty() && text.find_first_not_of(letters) == std::string_view::npos;
}

bool is_signature(std::string_view text) {
  try {
    from_signature(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

} // namespace tetrarch
