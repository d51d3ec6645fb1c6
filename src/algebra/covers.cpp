// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/covers.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

namespace tetrarch::algebra {
namespace {

/// A letter as a column of the table: 2 g for generator g, 2 g + 1 for its inverse.
int column(int letter) {
  return letter > 0 ? 2 * (letter - 1) : 2 * (-letter - 1) + 1;
}
int backwards(int column) {
  return column ^ 1;
}
using Columns = std::vector<int>;

Columns inverse(const Columns& word) {
  Columns reversed(word.rbegin(), word.rend());
  for (int& c : reversed) c = backwards(c);
  return reversed;
}

class Search {
public:
  Search(const Presentation& group, const std::function<bool(const Cover&)>& visit,
         const CoverOptions& options, const Progress& progress)
      : generators_(group.generators), width_(2 * group.generators), degree_(options.degree),
        steps_left_(options.most_steps), visit_(visit), progress_(progress),
        starting_(static_cast<std::size_t>(width_)) {
    for (const Word& relator : group.relators) add_relator(relator);
    table_.assign(static_cast<std::size_t>(degree_) * static_cast<std::size_t>(width_), -1);
  }

  bool run() { return degree_ < 1 || extend(0); }

private:
  /// Every rotation of the relator and of its inverse, by its first letter.
  void add_relator(const Word& relator) {
    Columns word;
    for (const int letter : cyclically_reduced(relator)) {
      if (letter == 0 || std::abs(letter) > generators_)
        throw PreconditionError("for_each_cover: a letter names no generator");
      word.push_back(column(letter));
    }
    for (std::size_t k = 0; k < word.size(); ++k) {
      std::rotate(word.begin(), word.begin() + 1, word.end());
      starting_[static_cast<std::size_t>(word.front())].push_back(word);
      const Columns back = inverse(word);
      starting_[static_cast<std::size_t>(back.front())].push_back(back);
    }
  }

  int& entry(int sheet, int column) {
    return table_[static_cast<std::size_t>(sheet) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(column)];
  }

  /// Sets an entry and its inverse. False if that contradicts what is there.
  bool set(int from, int column, int to) {
    int& there = entry(from, column);
    int& back = entry(to, backwards(column));
    if (there == to && back == from) return true;
    if (there >= 0 || back >= 0) return false;
    there = to;
    back = from;
    trail_.emplace_back(from, column);
    return true;
  }

  void undo(std::size_t mark) {
    while (trail_.size() > mark) {
      const auto [from, column] = trail_.back();
      trail_.pop_back();
      int& there = entry(from, column);
      entry(there, backwards(column)) = -1;
      there = -1;
    }
  }

  /// Follows the relator from both ends; fills the one entry that may be missing.
  bool scan(int sheet, const Columns& word) {
    int front = sheet;
    std::size_t i = 0;
    for (; i < word.size() && entry(front, word[i]) >= 0; ++i) front = entry(front, word[i]);
    if (i == word.size()) return front == sheet;
    int end = sheet;
    std::size_t j = word.size();
    for (; j > i + 1 && entry(end, backwards(word[j - 1])) >= 0; --j)
      end = entry(end, backwards(word[j - 1]));
    return j > i + 1 || set(front, word[i], end);
  }

  /// All that follows from the entries of the trail from `head` on.
  bool deduce(std::size_t head) {
    for (; head < trail_.size(); ++head) {
      const auto [from, column] = trail_[head];
      const int to = entry(from, column);
      for (const Columns& word : starting_[static_cast<std::size_t>(column)])
        if (!scan(from, word)) return false;
      for (const Columns& word : starting_[static_cast<std::size_t>(backwards(column))])
        if (!scan(to, word)) return false;
    }
    return true;
  }

  /// False: the search is to end.
  bool extend(int position) {
    while (position < sheets_ * width_ && table_[static_cast<std::size_t>(position)] >= 0) ++position;
    if (position == sheets_ * width_) return sheets_ < 2 || !is_least() || visit_(cover());
    const int from = position / width_;
    const int column = position % width_;
    const int targets = std::min(sheets_ + 1, degree_);
    for (int to = 0; to < targets; ++to) {
      if (--steps_left_ < 0) return false;
      constexpr int often = 1024;
      if (steps_left_ % often == 0) progress_.step("covers");
      if (entry(to, backwards(column)) >= 0) continue;
      const std::size_t mark = trail_.size();
      const int sheets = sheets_;
      sheets_ = std::max(sheets_, to + 1);
      const bool goes_on = !(set(from, column, to) && deduce(mark)) || extend(position);
      undo(mark);
      sheets_ = sheets;
      if (!goes_on) return false;
    }
    return true;
  }

  /// No other first sheet gives a smaller table.
  bool is_least() {
    for (int base = 1; base < sheets_; ++base)
      if (is_smaller_from(base)) return false;
    return true;
  }

  bool is_smaller_from(int base) {
    std::vector<int> number(static_cast<std::size_t>(sheets_), -1);
    std::vector<int> order{base};
    number[static_cast<std::size_t>(base)] = 0;
    for (int row = 0; row < sheets_; ++row)
      for (int c = 0; c < width_; ++c) {
        const int to = entry(order[static_cast<std::size_t>(row)], c);
        int& n = number[static_cast<std::size_t>(to)];
        if (n < 0) {
          n = static_cast<int>(order.size());
          order.push_back(to);
        }
        if (n != entry(row, c)) return n < entry(row, c);
      }
    return false;
  }

  Cover cover() {
    Cover found{sheets_, std::vector<std::vector<int>>(static_cast<std::size_t>(generators_))};
    for (int g = 0; g < generators_; ++g)
      for (int p = 0; p < sheets_; ++p) found.sheet[static_cast<std::size_t>(g)].push_back(entry(p, 2 * g));
    return found;
  }

  int generators_;
  int width_;
  int degree_;
  long long steps_left_;
  const std::function<bool(const Cover&)>& visit_;
  const Progress& progress_;
  std::vector<std::vector<Columns>> starting_;
  std::vector<int> table_;
  std::vector<std::pair<int, int>> trail_;
  int sheets_ = 1;
};

/// The letters of generator g on each sheet that a spanning tree of the cover passes along.
std::vector<bool> spanning_tree(const Cover& cover) {
  const int generators = static_cast<int>(cover.sheet.size());
  std::vector<bool> in(static_cast<std::size_t>(generators * cover.degree), false);
  std::vector<bool> reached(static_cast<std::size_t>(cover.degree), false);
  std::vector<int> queue{0};
  reached[0] = true;
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (int g = 0; g < generators; ++g)
      for (int p = 0; p < cover.degree; ++p) {
        const int q = cover.sheet[static_cast<std::size_t>(g)][static_cast<std::size_t>(p)];
        if (p != queue[head] && q != queue[head]) continue;
        const int other = p == queue[head] ? q : p;
        if (reached[static_cast<std::size_t>(other)]) continue;
        reached[static_cast<std::size_t>(other)] = true;
        queue.push_back(other);
        in[static_cast<std::size_t>(g) * static_cast<std::size_t>(cover.degree) +
           static_cast<std::size_t>(p)] = true;
      }
  return in;
}

} // namespace

std::vector<int> action(const Cover& cover, const Word& word) {
  std::vector<std::vector<int>> back(cover.sheet.size(),
                                     std::vector<int>(static_cast<std::size_t>(cover.degree)));
  for (std::size_t g = 0; g < cover.sheet.size(); ++g)
    for (int p = 0; p < cover.degree; ++p)
      back[g][static_cast<std::size_t>(cover.sheet[g][static_cast<std::size_t>(p)])] = p;
  std::vector<int> to(static_cast<std::size_t>(cover.degree));
  for (int p = 0; p < cover.degree; ++p) {
    int at = p;
    for (const int letter : word) {
      const auto& step = letter > 0 ? cover.sheet : back;
      at = step[static_cast<std::size_t>(std::abs(letter) - 1)][static_cast<std::size_t>(at)];
    }
    to[static_cast<std::size_t>(p)] = at;
  }
  return to;
}

bool for_each_cover(const Presentation& group, const std::function<bool(const Cover&)>& visit,
                    const CoverOptions& options, const Progress& progress) {
  return Search(group, visit, options, progress).run();
}

Presentation group_of(const Cover& cover, const Presentation& group) {
  Presentation above;
  above.generators = group.generators * cover.degree;
  const auto letter = [&cover](int g, int p) { return g * cover.degree + p + 1; };
  for (const Word& relator : group.relators)
    for (int p = 0; p < cover.degree; ++p) {
      Word lifted;
      int at = p;
      for (const int l : relator) {
        const int g = std::abs(l) - 1;
        const auto& step = cover.sheet[static_cast<std::size_t>(g)];
        if (l > 0) {
          lifted.push_back(letter(g, at));
          at = step[static_cast<std::size_t>(at)];
        } else {
          at = static_cast<int>(std::find(step.begin(), step.end(), at) - step.begin());
          lifted.push_back(-letter(g, at));
        }
      }
      above.relators.push_back(std::move(lifted));
    }
  const std::vector<bool> tree = spanning_tree(cover);
  for (std::size_t k = 0; k < tree.size(); ++k)
    if (tree[k]) above.relators.push_back({static_cast<int>(k) + 1});
  return above;
}

CoverHomology homology_of_covers(const Presentation& group, int degree, long long most_steps,
                                 const Progress& progress) {
  CoverHomology found;
  const auto note = [&](const Cover& cover) {
    progress.step("covers");
    if (cover.degree == degree) found.of.push_back(abelianized(group_of(cover, group)).str());
    return true;
  };
  found.complete = for_each_cover(group, note, {degree, most_steps}, progress);
  std::sort(found.of.begin(), found.of.end());
  return found;
}

CoverDifference difference_of_covers(const Presentation& x, const Presentation& y, int most_sheets,
                                     long long most_steps, const Progress& progress) {
  CoverDifference found;
  for (int degree = 2; degree <= most_sheets; ++degree) {
    const CoverHomology of_x = homology_of_covers(x, degree, most_steps, progress);
    const CoverHomology of_y = homology_of_covers(y, degree, most_steps, progress);
    if (!of_x.complete || !of_y.complete) break;
    found.compared = degree;
    if (of_x.of == of_y.of) continue;
    const std::string sheets = std::to_string(degree) + " sheets";
    if (of_x.of.size() != of_y.of.size()) {
      found.what = "the numbers of covers of " + sheets + " differ: " + std::to_string(of_x.of.size()) +
                   " against " + std::to_string(of_y.of.size());
      break;
    }
    const auto [a, b] = std::mismatch(of_x.of.begin(), of_x.of.end(), of_y.of.begin());
    found.what = "the first homology of covers of " + sheets + " differs: in sorted order, first in " + *a +
                 " against " + *b;
    break;
  }
  return found;
}

} // namespace tetrarch::algebra
