// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/whitehead.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>

namespace tetrarch::algebra {
namespace {

/// A letter as a point of the graph; point ^ 1 is its inverse.
int point(int letter) {
  return letter > 0 ? 2 * (letter - 1) : 2 * (-letter - 1) + 1;
}
int letter_of(int point) {
  return point % 2 == 0 ? point / 2 + 1 : -(point / 2 + 1);
}

/// lines[x][y]: how many lines join two points.
using Graph = std::vector<std::vector<int>>;

Graph whitehead_graph(const Presentation& group) {
  const std::size_t points = 2 * static_cast<std::size_t>(group.generators);
  Graph lines(points, std::vector<int>(points, 0));
  for (const Word& relator : group.relators)
    for (std::size_t k = 0; k < relator.size(); ++k) {
      const auto x = static_cast<std::size_t>(point(relator[k]));
      const auto y = static_cast<std::size_t>(point(-relator[(k + 1) % relator.size()]));
      ++lines[x][y];
      ++lines[y][x];
    }
  return lines;
}

int degree(const Graph& lines, int x) {
  int sum = 0;
  for (const int n : lines[static_cast<std::size_t>(x)]) sum += n;
  return sum;
}

/// The points on the side of `source` of a smallest cut between it and its inverse, and how many lines it
/// cuts.
struct Cut {
  std::vector<bool> side;
  int lines = 0;
};

/// Ford and Fulkerson's way, with shortest augmenting paths. Nothing if `steps` are used up before.
std::optional<Cut> smallest_cut(Graph room, int source, long long& steps) {
  const int sink = source ^ 1;
  Cut cut;
  for (;;) {
    std::vector<int> from(room.size(), -1);
    std::vector<int> queue{source};
    from[static_cast<std::size_t>(source)] = source;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      steps -= static_cast<long long>(room.size());
      if (steps < 0) return std::nullopt;
      for (int y = 0; y < static_cast<int>(room.size()); ++y)
        if (from[static_cast<std::size_t>(y)] < 0 &&
            room[static_cast<std::size_t>(queue[head])][static_cast<std::size_t>(y)] > 0) {
          from[static_cast<std::size_t>(y)] = queue[head];
          queue.push_back(y);
        }
    }
    if (from[static_cast<std::size_t>(sink)] < 0) {
      for (const int f : from) cut.side.push_back(f >= 0);
      return cut;
    }
    for (int y = sink; y != source; y = from[static_cast<std::size_t>(y)]) {
      const auto a = static_cast<std::size_t>(from[static_cast<std::size_t>(y)]);
      const auto b = static_cast<std::size_t>(y);
      --room[a][b];
      ++room[b][a];
    }
    ++cut.lines;
  }
}

/// The word after the automorphism (side, a), not reduced at its ends.
Word image(const Word& word, const std::vector<bool>& side, int a) {
  const int letter = letter_of(a);
  Word out;
  for (const int x : word) {
    const bool other = std::abs(x) != std::abs(letter);
    if (other && side[static_cast<std::size_t>(point(-x))]) out.push_back(-letter);
    out.push_back(x);
    if (other && side[static_cast<std::size_t>(point(x))]) out.push_back(letter);
  }
  return freely_reduced(out);
}

Renamed after(const Renamed& before, const std::vector<bool>& side, int a) {
  Renamed now;
  now.presentation.generators = before.presentation.generators;
  for (const Word& relator : before.presentation.relators)
    now.presentation.relators.push_back(cyclically_reduced(image(relator, side, a)));
  for (const Word& word : before.image) now.image.push_back(image(word, side, a));
  return now;
}

/// The first rotation, by letters, of the cyclic word or of its inverse.
Word standard(Word word) {
  Word best = word;
  for (int sense = 0; sense < 2; ++sense) {
    for (std::size_t k = 0; k < word.size(); ++k) {
      std::rotate(word.begin(), word.begin() + 1, word.end());
      best = std::min(best, word);
    }
    std::reverse(word.begin(), word.end());
    for (int& x : word) x = -x;
  }
  return best;
}

std::vector<Word> key(const Presentation& group) {
  std::vector<Word> words;
  for (const Word& relator : group.relators) words.push_back(standard(relator));
  std::sort(words.begin(), words.end());
  return words;
}

/// Visits every set with `a` and without its inverse that cuts as many lines as there are at a.
template <class Visit>
void for_each_even_cut(const Graph& lines, int a, Visit visit) {
  const int points = static_cast<int>(lines.size());
  std::vector<int> others;
  for (int x = 0; x < points; ++x)
    if (x != a && x != (a ^ 1)) others.push_back(x);
  const int at_a = degree(lines, a);
  std::vector<bool> side(lines.size(), false);
  side[static_cast<std::size_t>(a)] = true;
  int cut = at_a;
  const auto sets = std::uint32_t{1} << others.size();
  // In Gray's order, each set differs from the one before in one point.
  for (std::uint32_t n = 1; n < sets; ++n) {
    int bit = 0;
    while ((n >> bit & 1U) == 0) ++bit;
    const auto x = static_cast<std::size_t>(others[static_cast<std::size_t>(bit)]);
    side[x] = !side[x];
    for (std::size_t y = 0; y < lines.size(); ++y)
      if (y != x) cut += side[y] == side[x] ? -lines[x][y] : lines[x][y];
    if (cut == at_a && !visit(side)) return;
  }
}

} // namespace

Renamed unchanged(const Presentation& group) {
  Renamed same;
  same.presentation.generators = group.generators;
  for (const Word& relator : group.relators) {
    Word word = cyclically_reduced(relator);
    if (!word.empty()) same.presentation.relators.push_back(std::move(word));
  }
  for (int g = 0; g < group.generators; ++g) same.image.push_back({g + 1});
  return same;
}

Renamed substituted(const Renamed& before, const std::vector<Word>& word_of) {
  const auto replaced = [&word_of](const Word& word) {
    Word out;
    for (const int letter : word) {
      const Word& by = word_of[static_cast<std::size_t>(std::abs(letter) - 1)];
      if (letter > 0)
        out.insert(out.end(), by.begin(), by.end());
      else
        std::transform(by.rbegin(), by.rend(), std::back_inserter(out), [](int x) { return -x; });
    }
    return freely_reduced(out);
  };
  Renamed now;
  now.presentation.generators = before.presentation.generators;
  for (const Word& relator : before.presentation.relators) {
    Word word = cyclically_reduced(replaced(relator));
    if (!word.empty()) now.presentation.relators.push_back(std::move(word));
  }
  for (const Word& word : before.image) now.image.push_back(replaced(word));
  return now;
}

Renamed shortest(const Presentation& group, const Progress& progress, long long most_steps) {
  Renamed now = unchanged(group);
  for (;;) {
    const Graph lines = whitehead_graph(now.presentation);
    std::optional<Cut> best;
    int at = -1;
    int gain = 0;
    for (int a = 0; a < 2 * group.generators; ++a) {
      progress.step("shortening relators");
      most_steps -= static_cast<long long>(lines.size() * lines.size()); // for the copy
      std::optional<Cut> cut = smallest_cut(lines, a, most_steps);
      if (!cut) return now;
      const int less = degree(lines, a) - cut->lines;
      if (less <= gain) continue;
      gain = less;
      at = a;
      best = std::move(cut);
    }
    if (!best) return now;
    now = after(now, best->side, at);
    std::erase_if(now.presentation.relators, [](const Word& word) { return word.empty(); });
  }
}

std::vector<Renamed> as_short(const Renamed& from, int most, const Progress& progress) {
  constexpr int most_generators = 7;
  std::vector<Renamed> found{from};
  if (from.presentation.generators > most_generators) return found;
  std::set<std::vector<Word>> known{key(from.presentation)};
  for (std::size_t head = 0; head < found.size() && static_cast<int>(found.size()) < most; ++head) {
    progress.step("presentations of equal length");
    const Graph lines = whitehead_graph(found[head].presentation);
    for (int a = 0; a < static_cast<int>(lines.size()); ++a)
      for_each_even_cut(lines, a, [&](const std::vector<bool>& side) {
        Renamed next = after(found[head], side, a);
        if (known.insert(key(next.presentation)).second) found.push_back(std::move(next));
        return static_cast<int>(found.size()) < most;
      });
  }
  return found;
}

} // namespace tetrarch::algebra
