// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/identify/names.hpp"

#include "famous.hpp"
#include "tetrarch/catalogue/cusped.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <set>

namespace tetrarch::identify {
namespace {

/// Closed manifolds and handlebodies without parameters: Regina's ready-made examples, by their signatures.
/// (`recognise` calls each by its name again, which is tested.)
constexpr std::array<std::array<std::string_view, 2>, 8> simple{{
    {"S^3", "bkaagj"},
    {"RP^3", "cMcabbgqw"},
    {"S^2 x S^1", "cMcabbjaj"},
    {"S^2 x~ S^1", "cPcbbbajs"},
    {"T^3", "gvLQQedfedffrwawrhh"},
    {"B^3", "baa"},
    {"solid torus", "bGaj"},
    {"solid Klein bottle", "cHabj"},
}};

/// L(3,1), the one lens space that would need a solid torus whose meridian meets two edges equally often.
constexpr std::string_view three_one = "cMcabbjak";

/// "2" out of "genus 2 handlebody", by what stands around it.
std::optional<std::string_view> between(std::string_view text, std::string_view before,
                                        std::string_view after) {
  if (!text.starts_with(before) || !text.ends_with(after) || text.size() < before.size() + after.size())
    return std::nullopt;
  return text.substr(before.size(), text.size() - before.size() - after.size());
}

std::optional<long long> whole_number(std::string_view text) {
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

/// A ball with pairs of triangles on its boundary glued to each other, one pair for each handle. The ball is
/// a stack of tetrahedra, of which number i has the corners i, i+1, i+2, i+3; the triangle of the first,
/// second and fourth corner is free, and those of every fourth tetrahedron have no corner in common.
Triangulation handlebody(int genus, bool orientable) {
  constexpr int apart = 4;
  constexpr int free_face = 2;
  Triangulation tri(2 * apart * genus);
  for (int t = 0; t + 1 < tri.size(); ++t) tri.glue({t, 0}, t + 1, Perm4(3, 0, 1, 2));
  // The stack is oriented by its gluings, which are odd; an even one turns a handle over.
  for (int handle = 0; handle < genus; ++handle) {
    const int first = 2 * apart * handle;
    const bool turned = !orientable && handle == 0;
    tri.glue({first, free_face}, first + apart, turned ? Perm4() : Perm4(1, 0, 2, 3));
  }
  return moves::simplified(tri);
}

std::optional<Named> handlebody_called(std::string_view name) {
  constexpr std::string_view turned = "non-orientable ";
  const bool orientable = !name.starts_with(turned);
  const auto number = between(name.substr(orientable ? 0 : turned.size()), "genus ", " handlebody");
  const auto genus = number ? whole_number(*number) : std::nullopt;
  if (!genus || *genus < 1) return std::nullopt;
  if (*genus > most_handles)
    throw InputError(in_quotes(name) + " has more than " + std::to_string(most_handles) + " handles");
  return Named{std::string(name), handlebody(static_cast<int>(*genus), orientable)};
}

/// A layered solid torus. Its boundary is a torus of two triangles, spread in the plane as the parallelogram
/// that A and B span, cut along A - B; corners 0, 1, 2, 3 of the last tetrahedron lie at 0, A, A+B, B, and
/// its faces 2 and 0 are the triangles. The meridian meets the edges A, B, A - B of the boundary a, b, a+b
/// times.
class LayeredTorus {
public:
  /// One tetrahedron with the lower two faces folded onto each other so that A stays: A + 2B is the meridian.
  LayeredTorus() : tri_(1) { tri_.glue({0, 3}, 0, Perm4(3, 2, 0, 1)); }

  long long a() const { return a_; }
  long long b() const { return b_; }
  int size() const { return tri_.size(); }

  /// A tetrahedron over the edge A, of which A - B and B are left, or over B, of which A and B - A are.
  void cover_a() { cover(Perm4(0, 3, 1, 2), Perm4(3, 0, 2, 1), b_); }
  void cover_b() { cover(Perm4(0, 1, 3, 2), Perm4(1, 0, 2, 3), a_); }

  /// Folds the boundary so that A, or B, stays. The meridian of what closes it is 2B - A, or 2A - B.
  Triangulation closed(bool along_a) const {
    Triangulation tri = tri_;
    tri.glue({tri.size() - 1, 2}, tri.size() - 1, along_a ? Perm4(3, 2, 0, 1) : Perm4(1, 3, 0, 2));
    return tri;
  }

private:
  /// `left` and `right` take the new tetrahedron's lower faces, 3 and 1, to the last one's upper ones.
  void cover(Perm4 left, Perm4 right, long long kept) {
    const int last = tri_.size() - 1;
    const int next = tri_.add_tetrahedra(1);
    tri_.glue({next, 3}, last, left);
    tri_.glue({next, 1}, last, right);
    b_ = a_ + b_;
    a_ = kept;
  }

  Triangulation tri_;
  long long a_ = 2;
  long long b_ = 1;
};

/// The pairs of numbers that a layered solid torus has on its way to {x, y}, all but the first, which is
/// {1, 2}. Nothing if there are more than `most_named`.
std::optional<std::vector<std::pair<long long, long long>>> way_up_to(long long x, long long y) {
  std::vector<std::pair<long long, long long>> way;
  std::pair<long long, long long> at = std::minmax({x, y});
  for (; at != std::pair(1LL, 2LL); at = std::minmax({at.first, at.second - at.first})) {
    if (static_cast<int>(way.size()) == most_named) return std::nullopt;
    way.push_back(at);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<Named> lens_space_called(std::string_view name) {
  const auto inside = between(name, "L(", ")");
  const std::size_t comma = inside ? inside->find(',') : std::string_view::npos;
  if (comma == std::string_view::npos) return std::nullopt;
  const auto p = whole_number(inside->substr(0, comma));
  std::string_view second = inside->substr(comma + 1);
  while (second.starts_with(' ')) second.remove_prefix(1);
  if (p && second == "?")
    throw InputError(in_quotes(name) + " leaves open which lens space is meant: give the second number");
  const auto q = whole_number(second);
  if (!p || !q) return std::nullopt;
  if (std::gcd(*p, *q) != 1)
    throw InputError(in_quotes(name) + " is no lens space: its numbers have a common divisor");
  constexpr std::array<std::string_view, 3> short_names{"S^2 x S^1", "S^3", "RP^3"};
  if (*p < 3) return find_named(short_names[static_cast<std::size_t>(*p)]);
  auto tri = lens_space(*p, *q % *p);
  if (!tri)
    throw InputError(in_quotes(name) + " would take more than " + std::to_string(most_named) + " tetrahedra");
  return Named{std::string(name), std::move(*tri)};
}

std::optional<Named> listed(std::string_view name) {
  if (const auto manifold = catalogue::find_by_name(name))
    return Named{manifold->name, from_signature(manifold->signature)};
  for (const detail::Famous& f : detail::famous)
    if (name == f.name || std::find(f.aliases.begin(), f.aliases.end(), name) != f.aliases.end())
      return Named{std::string(f.name), from_signature(f.signature)};
  if (const auto cusped = catalogue::find_cusped(name))
    return Named{std::string(cusped->name), from_signature(cusped->signature)};
  for (const auto& [known, signature] : simple)
    if (name == known) return Named{std::string(known), from_signature(signature)};
  return std::nullopt;
}

} // namespace

std::optional<Triangulation> lens_space(long long p, long long q) {
  if (p < 3 || q <= 0 || q >= p || std::gcd(p, q) != 1)
    throw PreconditionError("a lens space L(p,q) is layered here for p >= 3 and 0 < q < p prime to p");
  q = std::min(q, p - q);
  // Folding along an edge that is met `kept` times, where the other one is met q times, gives kept + 2q.
  const long long kept = p - 2 * q;
  if (kept == q) return from_signature(three_one);
  const auto way = way_up_to(kept, q);
  if (!way) return std::nullopt;
  LayeredTorus torus;
  for (const auto& next : *way) { // one of the two numbers stays, the other becomes the sum
    if (torus.a() == next.first)
      torus.cover_b();
    else
      torus.cover_a();
  }
  return torus.closed(torus.a() == kept);
}

std::optional<Named> find_named(std::string_view name) {
  if (name.empty()) return std::nullopt;
  if (auto found = listed(name)) return found;
  if (auto found = lens_space_called(name)) return found;
  return handlebody_called(name);
}

std::vector<std::string> listed_names() {
  std::vector<std::string> names = catalogue::stored_names();
  std::set<std::string_view> aliases;
  for (const detail::Famous& f : detail::famous) {
    names.emplace_back(f.name);
    for (const std::string_view alias : f.aliases)
      if (!alias.empty() && aliases.insert(alias).second) names.emplace_back(alias);
  }
  for (const auto& [name, signature] : simple) names.emplace_back(name);
  for (int k = 0; k < catalogue::cusped_count(); ++k)
    if (const std::string_view name = catalogue::cusped_at(k).name; !aliases.contains(name))
      names.emplace_back(name);
  return names;
}

} // namespace tetrarch::identify
