// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/identify/finite_images.hpp"

#include "tetrarch/algebra/group.hpp"
#include "tetrarch/canonical/pair.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <bitset>
#include <unordered_map>
#include <utility>

namespace tetrarch::identify {
namespace {

using algebra::Word;

/// A finite group by its multiplication; element 0 is the identity.
struct FiniteGroup {
  std::vector<std::vector<int>> times;
  std::vector<int> inverse;
  int order() const { return static_cast<int>(times.size()); }
};

using Permutation = std::vector<int>;

Permutation after(const Permutation& a, const Permutation& b) {
  Permutation c;
  for (const int x : b) c.push_back(a[static_cast<std::size_t>(x)]);
  return c;
}

FiniteGroup generated(const std::vector<Permutation>& generators) {
  Permutation identity;
  for (int k = 0; k < static_cast<int>(generators.front().size()); ++k) identity.push_back(k);
  std::vector<Permutation> elements{identity};
  std::map<Permutation, int> number{{identity, 0}};
  for (std::size_t head = 0; head < elements.size(); ++head)
    for (const Permutation& g : generators) {
      Permutation next = after(elements[head], g);
      if (number.emplace(next, static_cast<int>(elements.size())).second) elements.push_back(std::move(next));
    }
  FiniteGroup group;
  group.inverse.resize(elements.size());
  for (std::size_t a = 0; a < elements.size(); ++a) {
    group.times.emplace_back();
    for (std::size_t b = 0; b < elements.size(); ++b) {
      group.times.back().push_back(number.at(after(elements[a], elements[b])));
      if (group.times.back().back() == 0) group.inverse[a] = static_cast<int>(b);
    }
  }
  return group;
}

struct NamedGroup {
  const char* name;
  std::vector<Permutation> generators;
};
const std::vector<NamedGroup>& groups() {
  static const std::vector<NamedGroup> known{{"S3", {{1, 0, 2}, {1, 2, 0}}},
                                             {"A4", {{1, 2, 0, 3}, {1, 0, 3, 2}}},
                                             {"S4", {{1, 0, 2, 3}, {1, 2, 3, 0}}},
                                             {"A5", {{1, 2, 0, 3, 4}, {1, 2, 3, 4, 0}}}};
  return known;
}

/// A set of elements.
using Elements = std::bitset<64>;
Elements bit(int x) {
  return Elements().set(static_cast<std::size_t>(x));
}

/// Subgroups by what generates them, each found once.
class Subgroups {
public:
  explicit Subgroups(const FiniteGroup& group) : group_(group) {}

  Elements generated(Elements by) {
    const auto [known, fresh] = generated_.emplace(by, Elements());
    if (fresh) known->second = closure(by);
    return known->second;
  }
  /// The smallest one that contains the elements and is normalized by `by`.
  Elements normal(Elements elements, Elements by) {
    auto& found = normal_[by];
    const auto [known, fresh] = found.emplace(elements, Elements());
    if (!fresh) return known->second;
    Elements all;
    while (elements != all) {
      all = elements;
      for (int x = 0; x < group_.order(); ++x)
        for (int g = 0; all[x] && g < group_.order(); ++g)
          if (by[g]) elements |= bit(group_.times[group_.times[g][x]][group_.inverse[g]]);
    }
    known->second = closure(all);
    return known->second;
  }

private:
  Elements closure(Elements by) const {
    Elements members = bit(0);
    std::vector<int> pending{0};
    while (!pending.empty()) {
      const int at = pending.back();
      pending.pop_back();
      for (int g = 0; g < group_.order(); ++g) {
        if (!by[g]) continue;
        const int next = group_.times[at][g];
        if (!members[next]) pending.push_back(next);
        members |= bit(next);
      }
    }
    return members;
  }

  const FiniteGroup& group_;
  std::unordered_map<Elements, Elements> generated_;
  std::unordered_map<Elements, std::unordered_map<Elements, Elements>> normal_;
};

int order_of(Elements group) {
  return static_cast<int>(group.count());
}

/// One element of each conjugacy class, and how many it stands for; 0 of the others.
std::vector<int> class_sizes(const FiniteGroup& group) {
  std::vector<int> size(static_cast<std::size_t>(group.order()), 0);
  Elements seen;
  for (int x = 0; x < group.order(); ++x) {
    if (seen[x]) continue;
    Elements conjugates;
    for (int g = 0; g < group.order(); ++g)
      conjugates |= bit(group.times[group.times[g][x]][group.inverse[g]]);
    size[static_cast<std::size_t>(x)] = order_of(conjugates);
    seen |= conjugates;
  }
  return size;
}

/// The words of one boundary component in the generators of the exterior.
struct BoundaryWords {
  std::vector<Word> loops;
  std::vector<Word> kernel;
};

/// Runs through all homomorphisms, up to conjugacy where the first image is chosen: chooses images of
/// generators, and takes those that relators leave no choice of.
class Homomorphisms {
public:
  Homomorphisms(const algebra::Presentation& presentation, const FiniteGroup& group, long long most,
                const Progress& progress)
      : presentation_(presentation), group_(group), most_(most), progress_(progress),
        class_size_(class_sizes(group)), image_(static_cast<std::size_t>(presentation.generators), -1) {}

  /// Tells each, and how many it stands for; false if there was too much to do.
  template <class Told>
  bool each(Told told, int weight = 0) {
    if (--most_ < 0) return false;
    constexpr long long between = 4096;
    if (most_ % between == 0) progress_.step("images in finite groups", -1);
    std::vector<int> forced;
    bool possible = true;
    while (possible) {
      const int before = static_cast<int>(forced.size());
      for (const Word& r : presentation_.relators) possible = possible && follow(r, forced);
      if (static_cast<int>(forced.size()) == before) break;
    }
    bool in_time = true;
    if (possible) {
      const auto open = std::find(image_.begin(), image_.end(), -1);
      if (open == image_.end()) {
        told(*this, std::max(1, weight));
      } else {
        for (int x = 0; in_time && x < group_.order(); ++x) {
          const int stands_for = weight == 0 ? class_size_[static_cast<std::size_t>(x)] : weight;
          if (stands_for == 0) continue;
          *open = x;
          in_time = each(told, stands_for);
        }
        *open = -1;
      }
    }
    for (const int g : forced) image_[static_cast<std::size_t>(g)] = -1;
    return in_time;
  }

  int of(const Word& word) const {
    int x = 0;
    for (const int letter : word) x = group_.times[x][of(letter)];
    return x;
  }
  const std::vector<int>& images() const { return image_; }

private:
  int of(int letter) const {
    const int x = image_[static_cast<std::size_t>(std::abs(letter) - 1)];
    return letter > 0 ? x : group_.inverse[x];
  }

  /// Checks a relator, or finds the image of the one letter that is not known; false if it does not hold.
  bool follow(const Word& relator, std::vector<int>& forced) {
    int open = -1;
    for (int k = 0; k < static_cast<int>(relator.size()); ++k)
      if (image_[static_cast<std::size_t>(std::abs(relator[k]) - 1)] < 0) {
        if (open >= 0) return true;
        open = k;
      }
    if (open < 0) return of(relator) == 0;
    // a x b = 1, so x = (b a)^-1.
    Word rest(relator.begin() + open + 1, relator.end());
    rest.insert(rest.end(), relator.begin(), relator.begin() + open);
    const int x = group_.inverse[of(rest)];
    const int letter = relator[static_cast<std::size_t>(open)];
    image_[static_cast<std::size_t>(std::abs(letter) - 1)] = letter > 0 ? x : group_.inverse[x];
    forced.push_back(std::abs(letter) - 1);
    return true;
  }

  const algebra::Presentation& presentation_;
  const FiniteGroup& group_;
  long long most_;
  const Progress& progress_;
  std::vector<int> class_size_;
  std::vector<int> image_;
};

/// The crossings of a face, near whatever vertex, as letters of the dual presentation.
moves::Monodromy dual_letters(const Triangulation& tri, const algebra::DualPresentation& dual) {
  moves::Monodromy words(tri.size());
  for (int g = 0; g < static_cast<int>(dual.generator_face.size()); ++g) {
    const TetFace f = dual.generator_face[static_cast<std::size_t>(g)];
    const Gluing to = tri.gluing(f);
    for (const int v : face_vertex[f.face]) {
      words.at(f.tet, v, f.face) = {g + 1};
      words.at(to.tet, to.perm[v], to.perm[f.face]) = {-(g + 1)};
    }
  }
  return words;
}

} // namespace

std::vector<std::string> finite_groups() {
  std::vector<std::string> names;
  for (const NamedGroup& g : groups()) names.emplace_back(g.name);
  return names;
}

std::optional<ImageCounts> image_counts(const Triangulation& tri, const moves::Monodromy& monodromy,
                                        const std::string& group_name, long long most,
                                        const Progress& progress) {
  const auto named = std::find_if(groups().begin(), groups().end(),
                                  [&](const NamedGroup& g) { return group_name == g.name; });
  if (named == groups().end()) throw PreconditionError("image_counts: no group " + in_quotes(group_name));
  const FiniteGroup group = generated(named->generators);
  const algebra::DualPresentation dual = algebra::dual_presentation(tri, Skeleton(tri));
  std::vector<BoundaryWords> boundaries;
  for (const canonical::Correspondence& c : canonical::link_loops(tri, monodromy, dual_letters(tri, dual))) {
    BoundaryWords words{{}, c.kernel()};
    for (const auto& [first, second] : c.pairs()) words.loops.push_back(second);
    boundaries.push_back(std::move(words));
  }
  ImageCounts counts;
  Subgroups subgroups(group);
  const auto bits_of = [](const auto& rho, const std::vector<Word>& words) {
    Elements bits;
    for (const Word& w : words) bits |= bit(rho.of(w));
    return bits;
  };
  const auto count = [&](const auto& rho, int stands_for) {
    Elements images;
    for (const int x : rho.images()) images |= bit(x);
    std::vector<std::pair<int, int>> orders;
    for (const BoundaryWords& words : boundaries) {
      const Elements boundary = subgroups.generated(bits_of(rho, words.loops));
      orders.emplace_back(order_of(boundary),
                          order_of(subgroups.normal(bits_of(rho, words.kernel), boundary)));
    }
    std::sort(orders.begin(), orders.end());
    std::vector<int> key{order_of(subgroups.generated(images))};
    for (const auto& [boundary, kernel] : orders) key.insert(key.end(), {boundary, kernel});
    counts[key] += stands_for;
  };
  const bool in_time = Homomorphisms(dual.presentation, group, most, progress).each(count);
  if (!in_time) return std::nullopt;
  return counts;
}

} // namespace tetrarch::identify
