// SPDX-License-Identifier: GPL-2.0-or-later
#include "tietze.hpp"

#include "tietze_windows.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace tetrarch::algebra {
namespace {

/// Below this total length a presentation may always grow: what is printed on two lines needs no thrift.
constexpr long long small_length = 100;

bool precedes(const Word& a, const Word& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](int x, int y) { return rank_of(x) < rank_of(y); });
}

/// The start of the least rotation, by the two-candidates method: of two starts that agree on k letters, the
/// one that then loses drags the next k starts with it.
std::size_t least_start(const Word& w) {
  const std::size_t n = w.size();
  std::size_t i = 0;
  std::size_t j = 1;
  std::size_t k = 0;
  while (i < n && j < n && k < n) {
    const int a = rank_of(w[(i + k) % n]);
    const int b = rank_of(w[(j + k) % n]);
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

Word rotated(const Word& w, std::size_t start) {
  Word out(w);
  std::rotate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(start), out.end());
  return out;
}

/// Generator `generator` occurs once in relator `relator`; expressing it by the others makes the presentation
/// longer by `growth`.
struct Choice {
  int relator;
  int generator;
  long long growth;
};

/// A set of small integers that is filled, taken, and filled again.
class Marked {
public:
  explicit Marked(std::size_t size) : is_marked_(size, 0) {}
  void add(int x) {
    if (std::exchange(is_marked_[x], 1) == 0) list_.push_back(x);
  }
  bool contains(int x) const { return is_marked_[x] != 0; }
  /// All of them in increasing order; none is left.
  std::vector<int> take() {
    std::sort(list_.begin(), list_.end());
    for (const int x : list_) is_marked_[x] = 0;
    return std::exchange(list_, {});
  }

private:
  std::vector<char> is_marked_;
  std::vector<int> list_;
};

/// An elimination changes a few relators, so every question is asked again only where something changed:
/// otherwise thousands of eliminations in chains of thousands of relators would take seconds.
class Tietze {
public:
  Tietze(const Presentation& p, const TietzeOptions& options, const Progress& progress);
  Kept run();

private:
  bool spend(std::size_t letters) {
    return (letters_ += static_cast<long long>(letters)) <= options_.max_letters;
  }
  bool spent() const { return letters_ > options_.max_letters; }
  void sort_by_length(std::vector<int>& relators) const;
  void replace(int relator, Word word);

  void forget_choice(int relator);
  void refresh_choices();
  bool eliminate_pass();
  bool eliminate_with_growth(long long limit);
  std::optional<Choice> best_generator(int relator);
  void eliminate(Choice choice);

  bool shorten_pass();
  bool shorten_others_by(int relator);
  std::vector<int> shortenable_by(int relator) const;
  Kept result() const;

  const TietzeOptions& options_;
  const Progress& progress_;
  std::vector<Word> relators_;
  std::vector<std::set<int>> where_; ///< per generator, the relators that contain it
  std::vector<long long> count_;     ///< per generator, its letters in all relators
  std::vector<char> gone_;           ///< per generator
  /// Growth, length and number of each relator that has a choice, as of the last `refresh_choices`.
  std::set<std::tuple<long long, std::size_t, int>> costs_;
  std::vector<std::optional<std::pair<long long, std::size_t>>> cost_; ///< per relator, its entry there
  Marked counted_;          ///< generators whose count changed since then
  Marked changed_;          ///< relators that changed since the last pass of shortening began
  std::vector<char> fresh_; ///< per relator: it changed since the pass before that
  std::vector<int> occurs_; ///< scratch: letters per generator, all 0 between uses
  Marked used_;             ///< scratch: generators
  Marked near_;             ///< scratch: relators
  long long length_ = 0;
  long long letters_ = 0;
};

Tietze::Tietze(const Presentation& p, const TietzeOptions& options, const Progress& progress)
    : options_(options), progress_(progress), relators_(p.relators.size()),
      where_(static_cast<std::size_t>(p.generators)), count_(where_.size(), 0), gone_(where_.size(), 0),
      cost_(relators_.size()), counted_(where_.size()), changed_(relators_.size()),
      fresh_(relators_.size(), 0), occurs_(where_.size(), 0), used_(where_.size()), near_(relators_.size()) {
  for (std::size_t r = 0; r < relators_.size(); ++r) replace(static_cast<int>(r), p.relators[r]);
}

void Tietze::replace(int relator, Word word) {
  Word& old = relators_[relator];
  for (const int letter : old) {
    const int g = generator_of(letter);
    --count_[g];
    counted_.add(g);
    where_[g].erase(relator);
  }
  for (const int letter : word) {
    const int g = generator_of(letter);
    ++count_[g];
    counted_.add(g);
    where_[g].insert(relator);
  }
  length_ += static_cast<long long>(word.size()) - static_cast<long long>(old.size());
  old = std::move(word);
  changed_.add(relator);
  forget_choice(relator);
}

void Tietze::forget_choice(int relator) {
  if (cost_[relator]) costs_.erase({cost_[relator]->first, cost_[relator]->second, relator});
  cost_[relator].reset();
}

void Tietze::sort_by_length(std::vector<int>& relators) const {
  std::sort(relators.begin(), relators.end(), [this](int a, int b) {
    return std::pair(relators_[a].size(), a) < std::pair(relators_[b].size(), b);
  });
}

/// Among the generators that occur once in the relator, one whose elimination costs least.
std::optional<Choice> Tietze::best_generator(int relator) {
  const Word& word = relators_[relator];
  spend(word.size());
  for (const int letter : word) ++occurs_[generator_of(letter)];
  std::optional<Choice> best;
  const auto length = static_cast<long long>(word.size());
  for (const int letter : word) {
    const int g = generator_of(letter);
    if (occurs_[g] != 1) continue;
    const long long growth = (count_[g] - 1) * (length - 2) - length;
    if (!best || growth < best->growth) best = Choice{relator, g, growth};
  }
  for (const int letter : word) occurs_[generator_of(letter)] = 0;
  return best;
}

/// u g v = 1 says g = U V = the inverse of v u.
void Tietze::eliminate(Choice choice) {
  const Word relator = relators_[choice.relator];
  std::size_t at = 0;
  while (generator_of(relator[at]) != choice.generator) ++at;
  Word rest = rotated(relator, at);
  const bool inverted = rest[0] < 0;
  rest.erase(rest.begin());
  const Word for_letter = inverted ? rest : inverse(rest);
  const Word for_inverse = inverse(for_letter);

  replace(choice.relator, {});
  gone_[choice.generator] = 1;
  const std::set<int> places = where_[choice.generator];
  for (const int r : places) {
    Word word;
    bool met = false;
    for (const int letter : relators_[r]) {
      if (generator_of(letter) != choice.generator) {
        word.push_back(letter);
        continue;
      }
      met = true;
      const Word& by = letter > 0 ? for_letter : for_inverse;
      word.insert(word.end(), by.begin(), by.end());
    }
    spend(word.size());
    if (met) replace(r, cyclically_reduced(word));
  }
}

/// Only where a count changed can the least growth be another one.
void Tietze::refresh_choices() {
  for (const int g : counted_.take())
    for (const int r : where_[g]) near_.add(r);
  for (const int r : near_.take()) {
    forget_choice(r);
    const std::optional<Choice> choice = best_generator(r);
    if (!choice) continue;
    cost_[r] = {choice->growth, relators_[r].size()};
    costs_.insert({cost_[r]->first, cost_[r]->second, r});
  }
}

/// The eliminations that make nothing longer, shortest relator first.
bool Tietze::eliminate_pass() {
  refresh_choices();
  std::vector<int> relators;
  for (const auto& [growth, length, r] : costs_) {
    if (growth > 0) break;
    relators.push_back(r);
  }
  sort_by_length(relators);
  bool any = false;
  for (const int r : relators) {
    if (relators_[r].empty() || spent()) continue;
    progress_.step("simplify the group");
    const std::optional<Choice> choice = best_generator(r);
    if (!choice || choice->growth > 0) continue;
    eliminate(*choice);
    any = true;
  }
  return any;
}

/// The one elimination that adds least, if the length stays within the limit.
bool Tietze::eliminate_with_growth(long long limit) {
  refresh_choices();
  if (costs_.empty() || spent()) return false;
  const auto& [growth, length, r] = *costs_.begin();
  if (length_ + growth > limit) return false;
  eliminate(*best_generator(r));
  return true;
}

/// The relators of which more than half of this one may be a part. Any such part has one of two opposite
/// letters in it; of all pairs the rarest is taken.
std::vector<int> Tietze::shortenable_by(int relator) const {
  const Word& word = relators_[relator];
  const std::size_t half = word.size() / 2;
  const auto place = [&](std::size_t k) -> const std::set<int>& {
    return where_[generator_of(word[k % word.size()])];
  };
  std::size_t best = 0;
  for (std::size_t k = 1; k < word.size(); ++k)
    if (place(k).size() + place(k + half).size() < place(best).size() + place(best + half).size()) best = k;
  std::vector<int> found;
  std::set_union(place(best).begin(), place(best).end(), place(best + half).begin(), place(best + half).end(),
                 std::back_inserter(found));
  std::erase_if(found, [&](int s) {
    return s == relator || relators_[s].size() < half + 1 || !(fresh_[relator] || fresh_[s]);
  });
  return found;
}

bool Tietze::shorten_others_by(int relator) {
  const Word by = relators_[relator];
  const std::size_t width = by.size() / 2 + 1;
  std::optional<Windows> windows;
  bool any = false;
  for (const int s : shortenable_by(relator)) {
    if (spent()) break;
    if (!windows && spend(4 * by.size())) windows.emplace(by, width);
    while (windows && relators_[s].size() >= width && spend(relators_[s].size())) {
      auto word = windows->shortened(relators_[s]);
      if (!word) break;
      replace(s, std::move(*word));
      any = true;
    }
  }
  return any;
}

/// Of two relators that have not changed since the last pass none shortens the other.
bool Tietze::shorten_pass() {
  const std::vector<int> fresh = changed_.take();
  for (const int r : fresh) {
    fresh_[r] = 1;
    for (const int letter : relators_[r]) used_.add(generator_of(letter));
  }
  for (const int g : used_.take())
    for (const int r : where_[g]) near_.add(r);
  std::vector<int> order = near_.take();
  sort_by_length(order);
  bool any = false;
  for (const int r : order) {
    if (spent()) break;
    progress_.step("simplify the group");
    if (!relators_[r].empty() && shorten_others_by(r)) any = true;
  }
  for (const int r : fresh) fresh_[r] = 0;
  return any;
}

Kept Tietze::run() {
  std::optional<long long> limit;
  while (!spent()) {
    if (eliminate_pass() || shorten_pass()) continue;
    if (!limit) {
      const auto grown = static_cast<long long>(options_.max_growth * static_cast<double>(length_));
      limit = std::max(small_length, std::min(grown, options_.max_length));
    }
    if (!eliminate_with_growth(*limit)) break;
  }
  return result();
}

Kept Tietze::result() const {
  Kept kept;
  Presentation& out = kept.presentation;
  std::vector<int> number(gone_.size(), 0);
  for (std::size_t g = 0; g < gone_.size(); ++g) {
    if (gone_[g]) continue;
    number[g] = ++out.generators;
    kept.generator.push_back(static_cast<int>(g));
  }
  for (const Word& relator : relators_) {
    if (relator.empty()) continue;
    Word word;
    for (const int letter : relator) word.push_back(letter > 0 ? number[letter - 1] : -number[-letter - 1]);
    out.relators.push_back(least_rotation(word));
  }
  std::sort(out.relators.begin(), out.relators.end(), precedes);
  out.relators.erase(std::unique(out.relators.begin(), out.relators.end()), out.relators.end());
  return kept;
}

} // namespace

Word inverse(const Word& word) {
  Word out(word.rbegin(), word.rend());
  for (int& letter : out) letter = -letter;
  return out;
}

Word least_rotation(const Word& word) {
  const Word turned = inverse(word);
  Word a = rotated(word, least_start(word));
  Word b = rotated(turned, least_start(turned));
  return precedes(b, a) ? b : a;
}

Kept tietze_reduced(const Presentation& presentation, const TietzeOptions& options,
                    const Progress& progress) {
  return Tietze(presentation, options, progress).run();
}

Kept simplified_keeping(const Presentation& presentation, const TietzeOptions& options,
                        const Progress& progress) {
  require_letters(presentation);
  const Kept first = without_short_relators(presentation);
  Kept kept = tietze_reduced(first.presentation, options, progress);
  for (int& g : kept.generator) g = first.generator[g];
  return kept;
}

Presentation simplified(const Presentation& presentation, const TietzeOptions& options,
                        const Progress& progress) {
  return simplified_keeping(presentation, options, progress).presentation;
}

} // namespace tetrarch::algebra
