// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/signature.hpp"

#include "tetrarch/core/error.hpp"

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

/// The three streams of a signature, in the order in which they are compared.
struct Streams {
  std::string types; ///< three face types a letter: 0 boundary, 1 a new tetrahedron, 2 an old one
  std::string targets;
  std::string perms;
};

/// Tries labellings of one component and keeps the smallest.
class Labeller {
public:
  explicit Labeller(const Triangulation& tri)
      : tri_(tri), n_(tri.size()), width_(number_width(n_)), label_(static_cast<std::size_t>(n_), -1),
        perm_(static_cast<std::size_t>(n_)), orbit_(static_cast<std::size_t>(n_) * 24),
        tried_(orbit_.size(), 0) {
    std::iota(orbit_.begin(), orbit_.end(), 0);
    order_.reserve(static_cast<std::size_t>(n_));
  }

  CanonicalLabelling run() {
    for (int t = 0; t < n_; ++t) {
      for (int rank = 0; rank < Perm4::count; ++rank) {
        const int flag = root(24 * t + rank);
        if (tried_[flag]) continue;
        tried_[flag] = 1;
        attempt(t, Perm4::from_rank(rank));
      }
    }
    std::string text;
    if (n_ < 63) {
      text += letter(n_);
    } else {
      text += letter(63);
      text += letter(width_);
      append_number(text, n_, width_);
    }
    return {text + best_.types + best_.targets + best_.perms, best_labelling_};
  }

private:
  int root(int x) {
    while (orbit_[x] != x) x = orbit_[x] = orbit_[orbit_[x]];
    return x;
  }

  /// Follows the labelling that starts at t; afterwards it is the best, tied with the best, or forgotten.
  void attempt(int t, Perm4 start) {
    order_.clear();
    now_.types.clear();
    now_.targets.clear();
    now_.perms.clear();
    pending_ = pending_count_ = 0;
    better_ = best_.types.empty();
    targets_differ_ = perms_differ_ = 0;
    take(t, start);
    bool alive = true;
    for (std::size_t k = 0; k < order_.size() && alive; ++k) alive = write_faces(static_cast<int>(k));
    if (alive && pending_count_ > 0) alive = write_type_letter();
    if (alive) conclude();
    for (const int u : order_) label_[u] = -1;
  }

  void take(int t, Perm4 p) {
    label_[t] = static_cast<int>(order_.size());
    perm_[t] = p;
    order_.push_back(t);
  }

  bool write_faces(int k) {
    const int t = order_[k];
    const Perm4 back = perm_[t].inverse();
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri_.gluing({t, back[f]});
      int type = 0;
      if (g.tet >= 0) {
        if (label_[g.tet] < 0) {
          type = 1;
          take(g.tet, perm_[t] * g.perm.inverse());
        } else {
          const int there = perm_[g.tet][g.perm[back[f]]];
          if (label_[g.tet] < k || (label_[g.tet] == k && there < f)) continue; // written from the other side
          type = 2;
          write_target(label_[g.tet], perm_[g.tet] * g.perm * back);
        }
      }
      pending_ |= type << (2 * pending_count_);
      if (++pending_count_ == 3 && !write_type_letter()) return false;
    }
    return true;
  }

  void write_target(int target, Perm4 p) {
    append_number(now_.targets, target, width_);
    now_.perms += letter(p.rank());
    if (better_) return;
    if (targets_differ_ == 0) {
      const std::size_t at = now_.targets.size() - static_cast<std::size_t>(width_);
      targets_differ_ = best_.targets.compare(at, width_, now_.targets, at, width_);
    }
    if (perms_differ_ == 0) {
      const std::size_t at = now_.perms.size() - 1;
      perms_differ_ = best_.perms.compare(at, 1, now_.perms, at, 1);
    }
  }

  /// False as soon as the best labelling is known to stay ahead.
  bool write_type_letter() {
    const char c = letter(pending_);
    pending_ = pending_count_ = 0;
    now_.types += c;
    if (better_) return true;
    const char b = best_.types[now_.types.size() - 1];
    if (c < b) better_ = true;
    return c <= b;
  }

  /// The types are no worse than the best's; the later streams decide.
  void conclude() {
    const int differ = targets_differ_ != 0 ? targets_differ_ : perms_differ_;
    if (better_ || differ > 0) { // "best compares greater"
      best_ = now_;
      best_labelling_ = {label_, perm_};
      best_order_ = order_;
    } else if (differ == 0) {
      join_orbits();
    }
  }

  /// This labelling and the best one give the same text: their quotient is an automorphism, and flags in one
  /// orbit of it lead to equal texts. Each tie at least doubles the group known, so there are at most
  /// log2(24n) ties.
  void join_orbits() {
    for (int t = 0; t < n_; ++t) {
      const int image = best_order_[label_[t]];
      const Perm4 p = perm_[t].inverse() * best_labelling_.perm[image]; // vertices of image to vertices of t
      for (int rank = 0; rank < Perm4::count; ++rank) {
        const int a = root(24 * t + rank);
        const int b = root(24 * image + (Perm4::from_rank(rank) * p).rank());
        if (a == b) continue;
        orbit_[a] = b;
        tried_[b] |= tried_[a];
      }
    }
  }

  const Triangulation& tri_;
  int n_;
  int width_;
  std::vector<int> label_;
  std::vector<Perm4> perm_;
  std::vector<int> order_;
  std::vector<int> orbit_; ///< union-find over flags (tetrahedron, rank of the starting order)
  std::vector<char> tried_;
  Streams now_;
  Streams best_;
  Isomorphism best_labelling_;
  std::vector<int> best_order_;
  int pending_ = 0;
  int pending_count_ = 0;
  bool better_ = true;
  int targets_differ_ = 0; ///< sign of (best - now) at the first difference
  int perms_differ_ = 0;
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
      fail("has " + quoted(text_.substr(at_, 1)) + " at position " + std::to_string(at_ + 1) +
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
    throw InputError("signature " + quoted(text_) + " " + what);
  }
  [[noreturn]] void fail_before(const std::string& what) const {
    fail("is wrong at position " + std::to_string(at_) + ": " + what);
  }

private:
  std::string_view text_;
  std::size_t at_ = 0;
};

void read_component(Reader& in, Triangulation& tri) {
  std::int64_t n = in.value();
  int width = 1;
  if (n == 63) {
    width = in.value();
    if (width < 1 || width > 5) in.fail_before("a number of " + std::to_string(width) + " letters");
    n = in.number(width);
  }
  // n tetrahedra have 4n faces, so at least 2n gluings or boundary faces, three a letter.
  if (static_cast<std::int64_t>(in.rest()) < (2 * n + 2) / 3)
    in.fail("ends too early for its " + std::to_string(n) + " tetrahedra");
  std::vector<int> types;
  std::int64_t joined = 0;
  std::int64_t fresh = 0;
  for (std::int64_t faces = 4 * n; faces > 0;) {
    int packed = in.value();
    for (int k = 0; k < 3; ++k, packed /= 4) {
      const int type = packed % 4;
      if (faces <= 0 && type != 0) in.fail_before("more faces than there are");
      if (faces <= 0) continue;
      if (type == 3) in.fail_before("3 is no face type");
      types.push_back(type);
      faces -= type == 0 ? 1 : 2;
      joined += type == 2;
      fresh += type == 1;
      if (faces < 0) in.fail_before("more faces than there are");
    }
  }
  if (n > 0 && fresh != n - 1) in.fail_before("the tetrahedra are not connected");
  std::vector<int> target;
  std::vector<Perm4> perm;
  for (std::int64_t k = 0; k < joined; ++k) {
    const std::int64_t u = in.number(width);
    if (u >= n) in.fail_before("tetrahedron " + std::to_string(u) + " of " + std::to_string(n));
    target.push_back(static_cast<int>(u));
  }
  for (std::int64_t k = 0; k < joined; ++k) {
    const int rank = in.value();
    if (rank >= Perm4::count) in.fail_before(std::to_string(rank) + " is no permutation");
    perm.push_back(Perm4::from_rank(rank));
  }
  const int base = tri.add_tetrahedra(static_cast<int>(n));
  std::size_t next_type = 0;
  std::size_t next_join = 0;
  int last = base;
  for (int t = base; t < base + static_cast<int>(n); ++t) {
    for (int f = 0; f < 4; ++f) {
      if (!tri.is_boundary({t, f})) continue;
      if (next_type == types.size()) in.fail_before("too few face types");
      const int type = types[next_type++];
      if (type == 1) {
        ++last;
        if (!tri.is_boundary({last, f})) in.fail_before("a face glued twice");
        tri.glue({t, f}, last, Perm4());
      } else if (type == 2) {
        const int u = base + target[next_join];
        const Perm4 p = perm[next_join++];
        if (u > last || !tri.is_boundary({u, p[f]}) || (u == t && p[f] == f))
          in.fail_before("face " + std::to_string(f) + " of tetrahedron " + std::to_string(t - base) +
                         " is glued to a face that is not free");
        tri.glue({t, f}, u, p);
      }
    }
    if (t == last && t + 1 < base + static_cast<int>(n)) in.fail_before("the tetrahedra are not connected");
  }
  if (next_type != types.size()) in.fail_before("more face types than faces");
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
    throw PreconditionError("a canonical labelling is that of a connected triangulation");
  return Labeller(tri).run();
}

std::string signature(const Triangulation& tri) {
  if (tri.size() == 0) return std::string(1, letter(0));
  const Components parts = components(tri);
  if (parts.count == 1) return Labeller(tri).run().text;
  std::vector<std::string> texts;
  for (int c = 0; c < parts.count; ++c) texts.push_back(Labeller(component(tri, parts, c)).run().text);
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

} // namespace tetrarch
