// SPDX-License-Identifier: GPL-2.0-or-later
#include "banks.hpp"

#include <algorithm>
#include <vector>

namespace tetrarch::slit {
namespace {

/// The nearest sequence that rises: neighbours that fall are pooled to their mean.
std::vector<double> risen(const std::vector<double>& values) {
  struct Pool {
    double sum = 0;
    int count = 0;
    double mean() const { return sum / count; }
  };
  std::vector<Pool> pools;
  for (const double x : values) {
    pools.push_back({x, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().count += last.count;
    }
  }
  std::vector<double> result;
  for (const Pool& pool : pools)
    result.insert(result.end(), static_cast<std::size_t>(pool.count), pool.mean());
  return result;
}

/// Of each side of the loop +1 where its triangle asks for rising angles, -1 for falling ones. An ear asks
/// for nothing: it goes with the side before.
std::vector<int> directions(const OneForms& forms, const SlitMap& map, const surface::BoundaryLoop& loop) {
  const surface::Surface& surface = forms.mesh().surface;
  std::vector<int> result;
  for (const surface::SideEnd e : loop.sides) {
    const double up = map.log_radius[surface.vertex(e)] - map.log_radius[surface.apex(e.side)];
    result.push_back(up > 0 ? 1 : up < 0 ? -1 : 0);
  }
  for (int round = 0; round < 2; ++round)
    for (std::size_t j = 0; j < result.size(); ++j)
      if (result[j] == 0) result[j] = result[(j + result.size() - 1) % result.size()];
  return result;
}

/// One loop, in which places are counted from the vertex that is the start of its slit.
class Banks {
public:
  Banks(std::vector<double> angle, std::size_t to_end) : angle_(std::move(angle)), to_end_(to_end) {
    const auto [low, high] = std::minmax_element(angle_.begin(), angle_.end());
    const auto n = static_cast<double>(angle_.size());
    // Near the ends of a slit vertices lie as squares do; a tenth of what even ones would have.
    gap_ = (*high - *low) / (n * n);
    start_ = *low == angle_[0] ? *low : *low - gap_;
    end_ = *high == angle_[to_end_] ? *high : *high + gap_;
  }

  std::vector<double> ordered() const {
    std::vector<double> result = angle_;
    result[0] = start_;
    result[to_end_] = end_;
    std::vector<double> rising(angle_.begin() + 1, angle_.begin() + static_cast<std::ptrdiff_t>(to_end_));
    std::vector<double> falling(angle_.begin() + static_cast<std::ptrdiff_t>(to_end_) + 1, angle_.end());
    rising = between_ends(std::move(rising));
    std::reverse(falling.begin(), falling.end());
    falling = between_ends(std::move(falling));
    std::copy(rising.begin(), rising.end(), result.begin() + 1);
    std::copy(falling.rbegin(), falling.rend(), result.begin() + static_cast<std::ptrdiff_t>(to_end_) + 1);
    return result;
  }

private:
  std::vector<double> between_ends(std::vector<double> bank) const {
    const std::size_t n = bank.size();
    const auto gaps = [&](std::size_t k) { return static_cast<double>(k) * gap_; };
    for (std::size_t k = 0; k < n; ++k) bank[k] -= gaps(k);
    bank = risen(bank);
    for (std::size_t k = 0; k < n; ++k)
      bank[k] = std::clamp(bank[k] + gaps(k), start_ + gaps(k + 1), end_ - gaps(n - k));
    return bank;
  }

  std::vector<double> angle_;
  std::size_t to_end_;
  double gap_ = 0;
  double start_ = 0;
  double end_ = 0;
};

void add_shifts(const OneForms& forms, const SlitMap& map, int slit_loop, std::map<int, double>& shifts) {
  const surface::BoundaryLoop& loop = forms.loops()[slit_loop];
  const std::size_t n = loop.sides.size();
  const std::vector<int> direction = directions(forms, map, loop);
  std::size_t start = n;
  std::size_t end = n;
  int turns = 0;
  for (std::size_t j = 0; j < n; ++j) {
    if (direction[j] == direction[(j + n - 1) % n]) continue;
    (direction[j] > 0 ? start : end) = j;
    ++turns;
  }
  if (turns != 2) return;
  std::vector<double> angle;
  double sum = 0;
  bool is_ordered = true;
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t at = (start + j) % n;
    const double step = map.form.imaginary[loop.sides[at].side.value];
    angle.push_back(sum);
    sum += step;
    is_ordered = is_ordered && step * direction[at] > 0;
  }
  if (is_ordered) return;
  const std::vector<double> ordered = Banks(angle, (end + n - start) % n).ordered();
  for (std::size_t j = 0; j < n; ++j)
    if (ordered[j] != angle[j])
      shifts[forms.mesh().surface.vertex(loop.sides[(start + j) % n])] = ordered[j] - angle[j];
}

} // namespace

std::map<int, double> shifts_into_order(const OneForms& forms, const SlitMap& map) {
  std::map<int, double> shifts;
  for (const Slit& slit : map.slits) add_shifts(forms, map, slit.loop, shifts);
  return shifts;
}

} // namespace tetrarch::slit
