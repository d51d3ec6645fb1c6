// SPDX-License-Identifier: GPL-2.0-or-later
#include "modular_smith.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace tetrarch::algebra {
namespace {

using Residue = std::uint64_t;
__extension__ using Wide = unsigned __int128;

/// Arithmetic modulo an odd prime below 2^63, on residues times 2^64. Source: Montgomery, "Modular
/// multiplication without trial division" (1985).
class Field {
public:
  explicit Field(Residue prime) : p_(prime) {
    for (int k = 0; k < 6; ++k) minus_inverse_ *= 2 + p_ * minus_inverse_; // Newton: digits double
    const Residue shift = static_cast<Residue>((static_cast<Wide>(1) << 64) % p_);
    shift_twice_ = static_cast<Residue>(static_cast<Wide>(shift) * shift % p_);
  }
  Residue prime() const { return p_; }
  Residue times(Residue a, Residue b) const {
    const Wide product = static_cast<Wide>(a) * b;
    const Residue q = static_cast<Residue>(product) * minus_inverse_;
    const Residue r = static_cast<Residue>((product + static_cast<Wide>(q) * p_) >> 64);
    return r < p_ ? r : r - p_;
  }
  Residue minus(Residue a, Residue b) const { return a < b ? a + p_ - b : a - b; }
  Residue of(const Integer& x) const { return times(remainder(x), shift_twice_); }
  Residue plain(Residue a) const { return times(a, 1); }
  Residue inverse(Residue a) const {
    Residue power = a;
    Residue result = of(1);
    for (Residue e = p_ - 2; e > 0; e >>= 1) {
      if ((e & 1) != 0) result = times(result, power);
      power = times(power, power);
    }
    return result;
  }
  Residue remainder(const Integer& x) const { return mpz_fdiv_ui(x.backend().data(), p_); }

private:
  Residue p_;
  Residue minus_inverse_ = 1; ///< of p modulo 2^64, after Newton's steps
  Residue shift_twice_ = 0;
};

/// Primes, the greatest below 2^62 first.
class Primes {
public:
  Residue next() {
    do below_ -= 2;
    while (mpz_probab_prime_p(Integer(below_).backend().data(), 25) == 0);
    return below_;
  }

private:
  Residue below_ = (Residue(1) << 62) + 1;
};

using SmallRow = std::map<int, Residue>;
using Rows = std::vector<SparseRow<Integer>>;

struct Pivot {
  int row;
  int column;
};

/// row -= factor * by. `count`: of the entries of each column.
void subtract(SmallRow& row, const SmallRow& by, Residue factor, const Field& field,
              std::vector<int>& count) {
  for (const auto& [column, value] : by) {
    const auto [at, is_new] = row.try_emplace(column, 0);
    at->second = field.minus(at->second, field.times(factor, value));
    if (is_new) ++count[column];
    if (at->second != 0) continue;
    row.erase(at);
    --count[column];
  }
}

/// Pivots of a Gaussian elimination modulo a prime: the shortest column, and in it the shortest row.
std::vector<Pivot> plan(const Rows& rows, int columns, const Field& field) {
  std::vector<SmallRow> left(rows.size());
  std::vector<int> count(static_cast<std::size_t>(columns), 0);
  for (std::size_t r = 0; r < rows.size(); ++r)
    rows[r].each([&](int column, const Integer& value) {
      const Residue x = field.of(value);
      if (x == 0) return;
      left[r].emplace(column, x);
      ++count[column];
    });
  std::vector<Pivot> pivots;
  while (true) {
    int column = -1;
    for (int c = 0; c < columns; ++c)
      if (count[c] > 0 && (column < 0 || count[c] < count[column])) column = c;
    if (column < 0) return pivots;
    int row = -1;
    for (std::size_t r = 0; r < left.size(); ++r)
      if (left[r].count(column) > 0 && (row < 0 || left[r].size() < left[row].size()))
        row = static_cast<int>(r);
    const SmallRow pivot = std::move(left[row]);
    left[row].clear();
    for (const auto& [c, value] : pivot) --count[c];
    const Residue inverse = field.inverse(pivot.at(column));
    for (SmallRow& other : left)
      if (const auto at = other.find(column); at != other.end())
        subtract(other, pivot, field.times(at->second, inverse), field, count);
    pivots.push_back({row, column});
  }
}

/// A matrix whose pivots stand on the diagonal: rows and columns are in their order, other ones behind.
class Ordered {
public:
  Ordered(const Rows& rows, int columns, const std::vector<Pivot>& pivots) : rank_(pivots.size()) {
    std::vector<int> place(static_cast<std::size_t>(columns), -1);
    std::vector<char> is_taken(rows.size(), 0);
    for (const Pivot& p : pivots) {
      place[p.column] = width_++;
      is_taken[p.row] = 1;
      order_.push_back(p.row);
    }
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (is_taken[r] == 0) order_.push_back(static_cast<int>(r));
    for (int& at : place)
      if (at < 0) at = width_++;
    for (const int r : order_) {
      auto& row = rows_.emplace_back();
      rows[r].each([&](int column, const Integer& value) { row.emplace_back(place[column], value); });
    }
  }

  /// The determinant of the pivots' rows and columns modulo a prime; 0 if a pivot vanishes there. `is_more`
  /// tells if the rank is greater.
  Residue determinant(const Field& field, bool& is_more) {
    const auto width = static_cast<std::size_t>(width_);
    work_.assign(width, 0);
    met_.assign(width / 64 + 1, 0);
    upper_.clear();
    inverse_.clear();
    Residue product = field.of(1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (const auto& [column, value] : rows_[i]) set(column, field.of(value));
      eliminate(std::min(i, rank_), field);
      if (i >= rank_) {
        is_more = is_more || !take_row().empty();
        if (is_more) return 0;
        continue;
      }
      if (work_[i] == 0) return 0;
      product = field.times(product, work_[i]);
      inverse_.push_back(field.inverse(work_[i]));
      upper_.push_back(take_row());
    }
    return field.plain(product);
  }

private:
  using Entries = std::vector<std::pair<int, Residue>>;

  void set(int column, Residue value) {
    work_[column] = value;
    met_[static_cast<std::size_t>(column) / 64] |= Residue(1) << (column % 64);
  }

  /// Subtracts multiples of the rows of the first pivots.
  void eliminate(std::size_t pivots, const Field& field) {
    for (std::size_t word = 0; 64 * word < pivots; ++word)
      for (Residue done = 0;;) {
        const Residue waiting = met_[word] & ~done;
        if (waiting == 0) break;
        const int bit = std::countr_zero(waiting);
        const std::size_t at = 64 * word + static_cast<std::size_t>(bit);
        if (at >= pivots) break;
        done |= (Residue(2) << bit) - 1; // what comes later stands to the right
        if (work_[at] == 0) continue;
        const Residue factor = field.times(work_[at], inverse_[at]);
        for (const auto& [column, value] : upper_[at])
          set(column, field.minus(work_[column], field.times(factor, value)));
      }
  }

  /// The entries of the row in hand, which is cleared.
  Entries take_row() {
    Entries row;
    for (std::size_t word = 0; word < met_.size(); ++word)
      for (; met_[word] != 0; met_[word] &= met_[word] - 1) {
        const std::size_t at = 64 * word + static_cast<std::size_t>(std::countr_zero(met_[word]));
        if (work_[at] != 0) row.emplace_back(static_cast<int>(at), work_[at]);
        work_[at] = 0;
      }
    return row;
  }

  std::size_t rank_;
  int width_ = 0;
  std::vector<int> order_;
  std::vector<std::vector<std::pair<int, Integer>>> rows_;
  std::vector<Entries> upper_;     ///< rows of the pivots so far
  std::vector<Residue> inverse_;   ///< of the pivots
  std::vector<Residue> work_;      ///< the row in hand
  std::vector<std::uint64_t> met_; ///< a bit for each column that may not be 0 in it
};

/// log2 of a bound of all minors: Hadamard's, of all rows longer than 1.
double bits_of_minors(const Rows& rows) {
  double bits = 0;
  for (const SparseRow<Integer>& row : rows) {
    Integer square = 0;
    row.each([&](int, const Integer& value) { square += value * value; });
    if (square > 1) bits += (static_cast<double>(msb(square)) + 1) / 2;
  }
  return bits;
}

struct Minor {
  int rank = 0;
  Integer value; ///< positive
};

/// A nonzero minor of greatest size.
Minor greatest_minor(const Rows& rows, int columns) {
  const double bits = bits_of_minors(rows) + 2; // one for the sign
  Primes primes;
  while (true) {
    const Field first(primes.next());
    const std::vector<Pivot> pivots = plan(rows, columns, first);
    if (pivots.empty()) return {0, 1};
    Ordered matrix(rows, columns, pivots);
    Integer value = 0;
    Integer modulus = 1;
    bool is_more = false;
    while (!is_more && static_cast<double>(msb(modulus)) < bits) {
      const Field field(primes.next());
      const Residue at = matrix.determinant(field, is_more);
      if (at == 0) continue; // another order of pivots would do, or there is more rank
      // value + modulus * x = at
      const Residue gap = field.minus(field.of(Integer(at)), field.of(value));
      value += modulus * field.plain(field.times(gap, field.inverse(field.of(modulus))));
      modulus *= field.prime();
    }
    if (is_more) continue;
    if (2 * value > modulus) value -= modulus;
    return {static_cast<int>(pivots.size()), abs(value)};
  }
}

/// g = s a + t b, the greatest common divisor.
struct Bezout {
  Bezout(const Integer& a, const Integer& b) {
    mpz_gcdext(g.backend().data(), s.backend().data(), t.backend().data(), a.backend().data(),
               b.backend().data());
  }
  Integer g, s, t;
};

/// A matrix over Z/D on its way to a diagonal.
class Diagonal {
public:
  Diagonal(const Rows& rows, int columns, Integer modulus)
      : modulus_(std::move(modulus)), rows_(rows.size()), holding_(static_cast<std::size_t>(columns)) {
    for (std::size_t r = 0; r < rows.size(); ++r)
      rows[r].each([&](int column, const Integer& value) { set(static_cast<int>(r), column, value); });
  }

  /// The entries, as divisors of D: those that are not 0.
  std::vector<Integer> run() {
    std::vector<Integer> entries;
    while (true) {
      const int column = shortest_column();
      if (column < 0) return entries;
      while (true) {
        const int row = clear_column(column);
        if (row < 0) break; // all of it was 0 modulo D
        const Integer divisor = gcd(rows_[row].at(column), modulus_);
        const int other = not_divided(row, column, divisor);
        if (other >= 0) {
          mix_columns(row, column, other);
          continue;
        }
        entries.push_back(divisor);
        drop_row(row);
        break;
      }
    }
  }

private:
  void set(int row, int column, Integer value) {
    if (abs(value) >= modulus_) value %= modulus_;
    if (value == 0) {
      rows_[row].erase(column);
      holding_[column].erase(row);
    } else {
      rows_[row].insert_or_assign(column, std::move(value));
      holding_[column].insert(row);
    }
  }
  Integer at(int row, int column) const {
    const auto found = rows_[row].find(column);
    return found == rows_[row].end() ? Integer(0) : found->second;
  }

  int shortest_column() const {
    int best = -1;
    for (std::size_t c = 0; c < holding_.size(); ++c)
      if (!holding_[c].empty() && (best < 0 || holding_[c].size() < holding_[best].size()))
        best = static_cast<int>(c);
    return best;
  }

  /// Leaves one entry in the column; tells its row, -1 if none is left.
  int clear_column(int column) {
    if (holding_[column].empty()) return -1;
    int row = *holding_[column].begin();
    for (const int r : holding_[column])
      if (rows_[r].size() < rows_[row].size()) row = r;
    const std::set<int> others = holding_[column];
    for (const int other : others) {
      if (other == row) continue;
      const Integer a = at(row, column);
      const Integer b = at(other, column);
      if (a == 0) {
        row = other;
      } else if (b % a == 0) {
        combine(row, other, 1, 0, -(b / a), 1);
      } else {
        const Bezout z(a, b);
        combine(row, other, z.s, z.t, -(b / z.g), a / z.g);
      }
    }
    return at(row, column) == 0 ? -1 : row;
  }

  /// Rows x, y become a x + b y, c x + d y.
  void combine(int x, int y, const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
    std::set<int> columns;
    for (const int r : {x, y})
      for (const auto& [column, value] : rows_[r]) columns.insert(column);
    for (const int column : columns) {
      const Integer p = at(x, column);
      const Integer q = at(y, column);
      set(x, column, a * p + b * q);
      set(y, column, c * p + d * q);
    }
  }

  /// A column of the row with an entry that `divisor` does not divide, -1 if there is none.
  int not_divided(int row, int column, const Integer& divisor) const {
    for (const auto& [other, value] : rows_[row])
      if (other != column && value % divisor != 0) return other;
    return -1;
  }

  /// Column `column`, which has one entry, in `row`, gets the greatest common divisor of it and the entry of
  /// `other` there.
  void mix_columns(int row, int column, int other) {
    const Integer a = at(row, column);
    const Integer e = at(row, other);
    const Bezout z(a, e);
    const std::set<int> rows = holding_[other];
    for (const int r : rows) {
      const Integer p = at(r, column);
      const Integer q = at(r, other);
      set(r, column, z.s * p + z.t * q);
      set(r, other, (a / z.g) * q - (e / z.g) * p);
    }
  }

  void drop_row(int row) {
    for (const auto& [column, value] : rows_[row]) holding_[column].erase(row);
    rows_[row].clear();
  }

  Integer modulus_;
  std::vector<std::map<int, Integer>> rows_;
  std::vector<std::set<int>> holding_; ///< the rows of each column
};

} // namespace

SmithForm modular_smith_form(const std::vector<SparseRow<Integer>>& rows) {
  // Columns without entries are of no use to anybody.
  std::map<int, int> number;
  Rows compact;
  for (const SparseRow<Integer>& row : rows) {
    if (row.size() == 0) continue;
    std::vector<SparseRow<Integer>::Entry> entries;
    row.each([&](int column, const Integer& value) {
      entries.push_back({number.try_emplace(column, static_cast<int>(number.size())).first->second, value});
    });
    std::sort(entries.begin(), entries.end(),
              [](const auto& a, const auto& b) { return a.column < b.column; });
    compact.emplace_back(std::move(entries));
  }
  const int columns = static_cast<int>(number.size());
  const Minor minor = greatest_minor(compact, columns);
  SmithForm form;
  std::vector<Integer> entries = Diagonal(compact, columns, minor.value).run();
  for (const Integer& entry : entries)
    if (entry != 1) form.factors.push_back(entry);
  // What is 0 modulo D is free, but for so many factors that are D itself.
  const int zeros = columns - static_cast<int>(entries.size());
  if (minor.value != 1)
    for (int k = columns - minor.rank; k < zeros; ++k) form.factors.push_back(minor.value);
  form.factors = invariant_factors(std::move(form.factors));
  form.units = minor.rank - static_cast<int>(form.factors.size());
  return form;
}

} // namespace tetrarch::algebra
