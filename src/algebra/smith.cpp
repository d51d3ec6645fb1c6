// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/smith.hpp"

#include "modular_smith.hpp"
#include "sparse_row.hpp"
#include "tetrarch/algebra/abelian_group.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <limits>
#include <optional>
#include <type_traits>

namespace tetrarch::algebra {
namespace {

using Small = std::int64_t;

/// x -= q * y; false, and nothing happens, if a machine integer does not hold the result. The most negative
/// one counts as too large, so that every entry has an absolute value.
bool subtract_multiple(Small& x, Small q, Small y) {
  Small product = 0;
  Small difference = 0;
  if (__builtin_mul_overflow(q, y, &product) || __builtin_sub_overflow(x, product, &difference)) return false;
  if (difference == std::numeric_limits<Small>::min()) return false;
  x = difference;
  return true;
}
bool subtract_multiple(Integer& x, const Integer& q, const Integer& y) {
  x -= q * y;
  return true;
}

Small magnitude(Small x) {
  return x < 0 ? -x : x;
}
Integer magnitude(const Integer& x) {
  return x < 0 ? Integer(-x) : x;
}

/// a - q * b for the integer q that makes it smallest: at most |b| / 2 in absolute value, which halves the
/// number of rounds. No intermediate result leaves the range of the arguments.
template <class S>
S nearest_remainder(const S& a, const S& b) {
  S r = a % b;
  if (magnitude(r) > magnitude(b) - magnitude(r)) r += (r < 0) == (b < 0) ? S(-b) : b;
  return r;
}

/// The q of `nearest_remainder`; b is not 0.
template <class S>
S nearest_quotient(const S& a, const S& b) {
  const S r = a % b;
  S q = a / b;
  if (magnitude(r) > magnitude(b) - magnitude(r)) q += (r < 0) == (b < 0) ? 1 : -1;
  return q;
}

template <class S>
using Row = SparseRow<S>;
template <class S>
using Entry = typename SparseRow<S>::Entry;

/// Pivots taken and what is left of the matrix. Every step is a unimodular operation, so whenever it is
/// interrupted the pivots so far and the rows left still have the Smith form sought.
template <class S>
class Elimination {
public:
  Elimination(std::vector<Row<S>> rows, int columns);

  /// False if a machine integer overflowed: take `rows` and go on with larger integers.
  bool run() { return take_units() && divide_out(); }
  bool take_units();
  /// For a matrix without units: isolate its smallest entry, as often as it takes; units may appear meanwhile.
  bool divide_out();

  int units() const { return units_; }
  const std::vector<S>& divisors() const { return divisors_; }
  const std::vector<Row<S>>& rows() const { return rows_; }

private:
  struct Pivot {
    int row;
    int column;
  };

  const S* find(int row, int column) const { return rows_[row].find(column); }
  void enqueue(int column);
  std::optional<int> shortest_column();
  std::optional<Pivot> unit_of_lone_row();
  std::optional<Pivot> unit_in_column(int column);
  bool clear_column(Pivot pivot);
  bool subtract_row(int row, int pivot_row, const S& q);
  void drop_row(int row);

  std::optional<Pivot> smallest_entry() const;
  bool isolate(Pivot pivot);
  std::optional<Pivot> smaller_in_column(Pivot pivot);
  std::optional<Pivot> smaller_in_row(Pivot pivot);

  std::vector<Row<S>> rows_;                  ///< exact
  std::vector<std::vector<int>> column_rows_; ///< a superset of each column's rows, repetitions possible
  std::vector<int> column_count_;             ///< exact
  std::vector<int> queued_;                   ///< the count under which a column waits in its bucket, or 0
  /// Columns by count; outdated ones are skipped when met. First in, first out: along a chain of short
  /// relations pairs are joined in rounds then, and not one row grows by every next one, which costs the
  /// square.
  std::vector<std::deque<int>> buckets_;
  std::size_t lowest_ = 0;        ///< no bucket below it holds anything
  std::vector<int> lone_rows_;    ///< rows that came down to one entry
  std::vector<Entry<S>> changes_; ///< of the row in hand
  int units_ = 0;
  std::vector<S> divisors_;
};

template <class S>
Elimination<S>::Elimination(std::vector<Row<S>> rows, int columns) : rows_(std::move(rows)) {
  const auto width = static_cast<std::size_t>(columns);
  column_rows_.resize(width);
  column_count_.assign(width, 0);
  queued_.assign(width, 0);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    rows_[r].each([&](int column, const S&) {
      column_rows_[column].push_back(static_cast<int>(r));
      ++column_count_[column];
    });
    if (rows_[r].size() == 1) lone_rows_.push_back(static_cast<int>(r));
  }
  for (int c = 0; c < columns; ++c) enqueue(c);
}

template <class S>
void Elimination<S>::enqueue(int column) {
  const int count = column_count_[column];
  if (count == 0 || queued_[column] == count) return;
  queued_[column] = count;
  const auto bucket = static_cast<std::size_t>(count);
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(column);
  lowest_ = std::min(lowest_, bucket);
}

template <class S>
std::optional<int> Elimination<S>::shortest_column() {
  for (; lowest_ < buckets_.size(); ++lowest_) {
    while (!buckets_[lowest_].empty()) {
      const int column = buckets_[lowest_].front();
      buckets_[lowest_].pop_front();
      if (queued_[column] != static_cast<int>(lowest_)) continue;
      queued_[column] = 0;
      if (column_count_[column] > 0) return column;
    }
  }
  return std::nullopt;
}

template <class S>
auto Elimination<S>::unit_of_lone_row() -> std::optional<Pivot> {
  while (!lone_rows_.empty()) {
    const int row = lone_rows_.back();
    lone_rows_.pop_back();
    if (rows_[row].size() != 1) continue;
    const Entry<S> only = rows_[row].only();
    if (magnitude(only.value) == 1) return Pivot{row, only.column};
  }
  return std::nullopt;
}

/// The unit with the shortest row; forgets outdated row numbers on the way.
template <class S>
auto Elimination<S>::unit_in_column(int column) -> std::optional<Pivot> {
  std::optional<Pivot> best;
  auto& candidates = column_rows_[column];
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::erase_if(candidates, [&](int row) { return find(row, column) == nullptr; });
  for (const int row : candidates) {
    if (magnitude(*find(row, column)) != 1) continue;
    if (!best || rows_[row].size() < rows_[best->row].size()) best = Pivot{row, column};
  }
  return best;
}

template <class S>
bool Elimination<S>::take_units() {
  while (true) {
    std::optional<Pivot> pivot = unit_of_lone_row();
    while (!pivot) {
      const std::optional<int> column = shortest_column();
      if (!column) return true;
      pivot = unit_in_column(*column);
    }
    if (!clear_column(*pivot)) return false;
    ++units_;
    drop_row(pivot->row);
  }
}

/// Subtracts multiples of the pivot's row until every other entry of its column is at most half of it.
template <class S>
bool Elimination<S>::clear_column(Pivot pivot) {
  const S a = *find(pivot.row, pivot.column);
  const std::vector<int> others = column_rows_[pivot.column];
  for (const int row : others) {
    if (row == pivot.row) continue;
    const S* value = find(row, pivot.column);
    if (value == nullptr) continue;
    const S q = nearest_quotient(*value, a);
    if (q != 0 && !subtract_row(row, pivot.row, q)) return false;
  }
  return true;
}

/// row -= q * pivot_row. Finds all changes first, so that an overflow leaves all as it was.
template <class S>
bool Elimination<S>::subtract_row(int row, int pivot_row, const S& q) {
  changes_.clear();
  bool fits = true;
  rows_[pivot_row].each([&](int column, const S& y) {
    const S* old = find(row, column);
    S value = old != nullptr ? *old : S(0);
    fits = fits && subtract_multiple(value, q, y);
    changes_.push_back({column, std::move(value)});
  });
  if (!fits) return false;
  for (const Entry<S>& e : changes_) {
    const bool was = find(row, e.column) != nullptr;
    if (was && e.value == 0) --column_count_[e.column];
    if (!was) {
      ++column_count_[e.column];
      column_rows_[e.column].push_back(row);
    }
    enqueue(e.column);
  }
  rows_[row].change(changes_);
  if (rows_[row].size() == 1) lone_rows_.push_back(row);
  return true;
}

template <class S>
void Elimination<S>::drop_row(int row) {
  rows_[row].each([&](int column, const S&) {
    --column_count_[column];
    enqueue(column);
  });
  rows_[row] = Row<S>();
}

template <class S>
bool Elimination<S>::divide_out() {
  while (const std::optional<Pivot> pivot = smallest_entry())
    if (!isolate(*pivot) || !take_units()) return false;
  return true;
}

/// The smallest entry, in the shortest row and column among equals.
template <class S>
auto Elimination<S>::smallest_entry() const -> std::optional<Pivot> {
  std::optional<Pivot> best;
  S least = 0;
  long long least_fill = 0;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    rows_[r].each([&](int column, const S& value) {
      const S size = magnitude(value);
      if (best && size > least) return;
      const long long fill = static_cast<long long>(rows_[r].size() - 1) * (column_count_[column] - 1);
      if (best && size == least && fill >= least_fill) return;
      best = Pivot{static_cast<int>(r), column};
      least = size;
      least_fill = fill;
    });
  }
  return best;
}

/// Euclid's algorithm on the pivot's column and row, until the pivot stands alone in both: then it is a
/// divisor.
template <class S>
bool Elimination<S>::isolate(Pivot pivot) {
  while (true) {
    if (!clear_column(pivot)) return false;
    std::optional<Pivot> smaller = smaller_in_column(pivot);
    if (!smaller) smaller = smaller_in_row(pivot);
    if (!smaller) break;
    pivot = *smaller;
  }
  const S divisor = magnitude(*find(pivot.row, pivot.column));
  drop_row(pivot.row);
  if (divisor == 1)
    ++units_;
  else
    divisors_.push_back(divisor);
  return true;
}

template <class S>
auto Elimination<S>::smaller_in_column(Pivot pivot) -> std::optional<Pivot> {
  std::optional<Pivot> best;
  for (const int row : column_rows_[pivot.column]) {
    const S* value = row == pivot.row ? nullptr : find(row, pivot.column);
    if (value == nullptr) continue;
    if (!best || magnitude(*value) < magnitude(*find(best->row, pivot.column)))
      best = Pivot{row, pivot.column};
  }
  return best;
}

/// With its column clear, column operations with the pivot change its own row alone: replace every other
/// entry by its remainder. Nothing if all remainders are zero.
template <class S>
auto Elimination<S>::smaller_in_row(Pivot pivot) -> std::optional<Pivot> {
  const S a = *find(pivot.row, pivot.column);
  changes_.clear();
  std::optional<Pivot> best;
  S least = 0;
  rows_[pivot.row].each([&](int column, const S& value) {
    if (column == pivot.column) return;
    const S rest = nearest_remainder(value, a);
    changes_.push_back({column, rest});
    if (rest == 0) {
      --column_count_[column];
      return;
    }
    if (!best || magnitude(rest) < least) {
      best = Pivot{pivot.row, column};
      least = magnitude(rest);
    }
    enqueue(column);
  });
  rows_[pivot.row].change(changes_);
  return best;
}

std::vector<Row<Integer>> sorted_rows(const SparseMatrix& matrix) {
  std::vector<Row<Integer>> rows(static_cast<std::size_t>(matrix.rows()));
  for (int r = 0; r < matrix.rows(); ++r) {
    std::vector<Entry<Integer>> row;
    for (const SparseMatrix::Entry& e : matrix.row(r)) row.push_back({e.column, e.value});
    std::stable_sort(row.begin(), row.end(),
                     [](const auto& x, const auto& y) { return x.column < y.column; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (kept > 0 && row[kept - 1].column == row[i].column)
        row[kept - 1].value += row[i].value;
      else if (kept++ != i)
        row[kept - 1] = row[i];
    }
    row.erase(row.begin() + static_cast<std::ptrdiff_t>(kept), row.end());
    std::erase_if(row, [](const Entry<Integer>& e) { return e.value == 0; });
    rows[r] = Row<Integer>(std::move(row));
  }
  return rows;
}

/// The rows in machine integers, if these hold all entries.
std::optional<std::vector<Row<Small>>> in_machine_integers(const std::vector<Row<Integer>>& rows) {
  const Integer limit = std::numeric_limits<Small>::max();
  std::vector<Row<Small>> small;
  small.reserve(rows.size());
  for (const Row<Integer>& row : rows) {
    std::vector<Entry<Small>> entries;
    bool fits = true;
    row.each([&](int column, const Integer& value) {
      fits = fits && value <= limit && value >= -limit;
      if (fits) entries.push_back({column, value.convert_to<Small>()});
    });
    if (!fits) return std::nullopt;
    small.emplace_back(std::move(entries));
  }
  return small;
}

std::vector<Row<Integer>> in_large_integers(const std::vector<Row<Small>>& rows) {
  std::vector<Row<Integer>> large;
  large.reserve(rows.size());
  for (const Row<Small>& row : rows) {
    std::vector<Entry<Integer>> entries;
    row.each([&](int column, Small value) { entries.push_back({column, value}); });
    large.emplace_back(std::move(entries));
  }
  return large;
}

/// Whether eliminating in integers, which outgrew the machine's, would let them grow on: many rows are left.
bool is_for_modular(const std::vector<Row<Integer>>& rows) {
  constexpr int many = 16;
  return std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.size() > 0; }) >= many;
}

} // namespace

SmithForm smith_normal_form(const SparseMatrix& matrix) {
  SmithForm form;
  std::vector<Row<Integer>> rows = sorted_rows(matrix);
  bool done = false;
  if (auto small = in_machine_integers(rows)) {
    rows.clear();
    Elimination<Small> elimination(std::move(*small), matrix.columns());
    done = elimination.run();
    form.units = elimination.units();
    form.factors.assign(elimination.divisors().begin(), elimination.divisors().end());
    if (!done) rows = in_large_integers(elimination.rows());
  }
  if (!done) {
    Elimination<Integer> elimination(std::move(rows), matrix.columns());
    elimination.take_units();
    if (is_for_modular(elimination.rows())) {
      const SmithForm rest = modular_smith_form(elimination.rows());
      form.units += rest.units;
      form.factors.insert(form.factors.end(), rest.factors.begin(), rest.factors.end());
    } else {
      elimination.divide_out();
    }
    form.units += elimination.units();
    form.factors.insert(form.factors.end(), elimination.divisors().begin(), elimination.divisors().end());
  }
  // Normalising the divisors can turn pairs such as 2, 3 into 1, 6.
  const std::size_t divisors = form.factors.size();
  form.factors = invariant_factors(std::move(form.factors));
  form.units += static_cast<int>(divisors - form.factors.size());
  return form;
}

} // namespace tetrarch::algebra
