// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/isometries.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace tetrarch::canonical {
namespace {

/// A name needs the orders of all elements and some subgroups; beyond this nobody knows the groups by name.
constexpr std::size_t most_elements = 500;

int order_of(int element, const MultiplicationTable& group) {
  int order = 1;
  for (int x = element; x != 0; x = group[x][element]) ++order;
  return order;
}

/// How many elements have each order.
std::map<int, int> order_statistics(const MultiplicationTable& group) {
  std::map<int, int> count;
  for (int x = 0; x < static_cast<int>(group.size()); ++x) ++count[order_of(x, group)];
  return count;
}

bool is_abelian(const MultiplicationTable& group) {
  for (std::size_t x = 0; x < group.size(); ++x)
    for (std::size_t y = 0; y < x; ++y)
      if (group[x][y] != group[y][x]) return false;
  return true;
}

/// The exponents k, decreasing, with Z/p^k the parts of the Sylow subgroup at p: p^j divides the number of
/// solutions of x^(p^j) = 1 once more for each part with k >= j.
std::vector<int> exponents_at(int p, const std::map<int, int>& orders) {
  std::vector<int> parts;
  long before = 1;
  for (long q = p;; q *= p) {
    long solutions = 0;
    for (const auto& [order, count] : orders)
      if (q % order == 0) solutions += count;
    if (solutions == before) return parts;
    long ratio = solutions / before;
    before = solutions;
    for (std::size_t k = 0; ratio > 1; ratio /= p, ++k) {
      if (k == parts.size()) parts.push_back(0);
      ++parts[k];
    }
  }
}

std::string abelian_name(const MultiplicationTable& group) {
  const std::map<int, int> orders = order_statistics(group);
  std::vector<long> factors; // each divides the one before
  int rest = static_cast<int>(group.size());
  for (int p = 2; rest > 1; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    const std::vector<int> parts = exponents_at(p, orders);
    factors.resize(std::max(factors.size(), parts.size()), 1);
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (int times = 0; times < parts[k]; ++times) factors[k] *= p;
  }
  std::string name;
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor)
    name += (name.empty() ? "Z/" : " + Z/") + std::to_string(*factor);
  return name.empty() ? "trivial" : name;
}

/// A rotation of half the order, and a reflection that inverts it.
bool is_dihedral(const MultiplicationTable& group) {
  const int n = static_cast<int>(group.size()) / 2;
  if (group.size() % 2 != 0 || n < 3) return false;
  for (int r = 0; r < 2 * n; ++r) {
    if (order_of(r, group) != n) continue;
    std::vector<bool> is_power(group.size(), false);
    int inverse = 0;
    for (int x = r; !is_power[x]; x = group[x][r]) {
      is_power[x] = true;
      if (group[x][r] == 0) inverse = x;
    }
    for (int s = 0; s < 2 * n; ++s)
      if (!is_power[s] && group[s][s] == 0 && group[group[s][r]][s] == inverse) return true;
  }
  return false;
}

/// Groups that the orders of their elements tell from all others of the same size.
std::string known_name(const MultiplicationTable& group) {
  using Orders = std::map<int, int>;
  static const std::vector<std::pair<Orders, const char*>> known{
      {{{1, 1}, {2, 3}, {3, 8}}, "A4"},
      {{{1, 1}, {2, 9}, {3, 8}, {4, 6}}, "S4"},
      {{{1, 1}, {2, 15}, {3, 20}, {5, 24}}, "A5"},
      {{{1, 1}, {2, 25}, {3, 20}, {4, 30}, {5, 24}, {6, 20}}, "S5"},
      {{{1, 1}, {2, 1}, {4, 6}}, "Q8"}};
  const Orders orders = order_statistics(group);
  for (const auto& [these, name] : known)
    if (these == orders) return name;
  return {};
}

/// The smallest subgroup with these elements.
std::vector<bool> generated(std::vector<bool> in, const MultiplicationTable& group) {
  std::vector<int> members;
  for (int x = 0; x < static_cast<int>(in.size()); ++x)
    if (in[x]) members.push_back(x);
  const std::vector<int> generators = members;
  for (std::size_t head = 0; head < members.size(); ++head)
    for (const int g : generators) {
      const int x = group[members[head]][g];
      if (!in[x]) {
        in[x] = true;
        members.push_back(x);
      }
    }
  return in;
}

MultiplicationTable subgroup(const std::vector<bool>& in, const MultiplicationTable& group) {
  std::vector<int> number(group.size(), -1);
  int count = 0;
  for (std::size_t x = 0; x < group.size(); ++x)
    if (in[x]) number[x] = count++;
  MultiplicationTable table;
  for (std::size_t x = 0; x < group.size(); ++x) {
    if (!in[x]) continue;
    table.emplace_back();
    for (std::size_t y = 0; y < group.size(); ++y)
      if (in[y]) table.back().push_back(number[group[x][y]]);
  }
  return table;
}

/// A subgroup of index 2 without z: grown from the squares by all that does not bring z in.
std::optional<std::vector<bool>> complement(int z, const MultiplicationTable& group) {
  std::vector<bool> in(group.size(), false);
  in[0] = true;
  for (std::size_t x = 0; x < group.size(); ++x) in[group[x][x]] = true;
  in = generated(in, group);
  if (in[z]) return std::nullopt;
  for (std::size_t x = 0; x < group.size(); ++x) {
    if (in[x]) continue;
    std::vector<bool> more = in;
    more[x] = true;
    more = generated(more, group);
    if (!more[z]) in = more;
  }
  return in;
}

/// With a central involution as a factor.
std::string product_name(const MultiplicationTable& group) {
  for (int z = 1; z < static_cast<int>(group.size()); ++z) {
    if (group[z][z] != 0) continue;
    bool central = true;
    for (int x = 0; x < static_cast<int>(group.size()); ++x) central &= group[x][z] == group[z][x];
    if (!central) continue;
    const auto rest = complement(z, group);
    if (!rest) continue;
    const std::string name = name_of_group(subgroup(*rest, group));
    if (!name.empty()) return name + " x Z/2";
  }
  return {};
}

Isomorphism composed(const Isomorphism& a, const Isomorphism& b) {
  Isomorphism ab;
  for (std::size_t t = 0; t < a.tet.size(); ++t) {
    ab.tet.push_back(b.tet[a.tet[t]]);
    ab.perm.push_back(b.perm[a.tet[t]] * a.perm[t]);
  }
  return ab;
}

bool is_identity(const Isomorphism& iso) {
  return iso.tet[0] == 0 && iso.perm[0] == Perm4();
}

/// An automorphism of a connected triangulation is known by the image of tetrahedron 0.
int key(const Isomorphism& iso) {
  return 24 * iso.tet[0] + iso.perm[0].rank();
}

} // namespace

MultiplicationTable multiplication_table(std::vector<Isomorphism> group) {
  const auto identity = std::find_if(group.begin(), group.end(), is_identity);
  if (identity == group.end()) throw PreconditionError("multiplication_table: there is no identity");
  std::iter_swap(group.begin(), identity);
  std::map<int, int> number;
  for (std::size_t x = 0; x < group.size(); ++x) number.emplace(key(group[x]), static_cast<int>(x));
  MultiplicationTable table(group.size());
  for (std::size_t x = 0; x < group.size(); ++x)
    for (const Isomorphism& y : group) {
      const auto at = number.find(key(composed(group[x], y)));
      if (at == number.end()) throw PreconditionError("multiplication_table: a product is missing");
      table[x].push_back(at->second);
    }
  return table;
}

std::string name_of_group(const MultiplicationTable& group) {
  if (group.size() > most_elements) return {};
  if (is_abelian(group)) return abelian_name(group);
  if (is_dihedral(group)) return "D" + std::to_string(group.size() / 2);
  std::string name = known_name(group);
  return name.empty() ? product_name(group) : name;
}

std::optional<bool> is_amphichiral(const Triangulation& tri, const std::vector<Isomorphism>& automorphisms) {
  const auto handed = orientation(tri);
  if (!handed) return std::nullopt;
  return std::any_of(automorphisms.begin(), automorphisms.end(), [&](const Isomorphism& iso) {
    return iso.perm[0].sign() * (*handed)[0] * (*handed)[iso.tet[0]] < 0;
  });
}

} // namespace tetrarch::canonical
