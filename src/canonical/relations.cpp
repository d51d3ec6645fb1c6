// SPDX-License-Identifier: GPL-2.0-or-later
#include "relations.hpp"

#include "tetrarch/numeric/algebraic.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace tetrarch::canonical {
namespace {

using numeric::Algebraic; // as a rational number
using numeric::Ball;

/// Beyond, the search for relations takes long.
constexpr int most_corners = 12;

/// A linear form in the symbols; the last place is the constant 1.
using Form = std::vector<int>;
using WholeVector = std::vector<int>;
using Rationals = std::vector<Algebraic>;

class RelationSearch {
public:
  RelationSearch(const SymbolMatrix& symbols, const BallMatrix& gram)
      : gram_(gram), size_(static_cast<int>(gram.size())) {
    std::map<int, int> number;
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j < i; ++j) number.try_emplace(symbols[i][j], static_cast<int>(number.size()));
    width_ = static_cast<int>(number.size()) + 1;
    entry_.assign(gram.size(), std::vector<Form>(gram.size(), Form(static_cast<std::size_t>(width_), 0)));
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j < size_; ++j)
        if (i == j)
          entry_[i][i].back() = symbols[i][i];
        else
          entry_[i][j][number.at(symbols[i][j])] = 1;
  }

  bool run() {
    find_relations();
    return kernel_is_known() || has_solution();
  }

private:
  Form product(int row, const WholeVector& u) const {
    Form sum(static_cast<std::size_t>(width_), 0);
    for (int j = 0; j < size_; ++j)
      for (int s = 0; s < width_; ++s) sum[s] += u[j] * entry_[row][j][s];
    return sum;
  }

  /// v_A + v_B - v_C - v_D and v_A - v_B, for all choices.
  void find_relations() {
    for (int a = 0; a < size_; ++a)
      for (int b = 0; b < size_; ++b)
        for (int c = 0; c < size_; ++c)
          for (int d = 0; d < size_; ++d) {
            WholeVector u(static_cast<std::size_t>(size_), 0);
            if (a == b && c == d) {
              if (!(a < c)) continue;
              u[a] = 1;
              u[c] = -1;
            } else {
              if (!(a < b && c < d && a < c) || b == c || b == d) continue;
              u[a] = u[b] = 1;
              u[c] = u[d] = -1;
            }
            if (const auto eigenvalue = formal_eigenvalue(u); eigenvalue && vanishes(u)) {
              relations_.push_back(*eigenvalue);
              kernel_.push_back(u);
            }
          }
  }

  /// The kernel has dimension n - 4, and the sum of u is 0.
  bool kernel_is_known() const {
    std::vector<Rationals> lines;
    for (const WholeVector& u : kernel_) lines.emplace_back(u.begin(), u.end());
    return null_space(std::move(lines), size_).size() <= 4;
  }

  /// lambda with G u = lambda u whatever the symbols are; nothing if there is none, or if it is 0 formally.
  std::optional<Form> formal_eigenvalue(const WholeVector& u) const {
    std::optional<Form> lambda;
    for (int i = 0; i < size_; ++i) {
      Form here = product(i, u);
      const bool is_zero = std::all_of(here.begin(), here.end(), [](int x) { return x == 0; });
      if (u[i] == 0) {
        if (!is_zero) return std::nullopt;
        continue;
      }
      for (int& x : here) x *= u[i];
      if (is_zero || (lambda && *lambda != here)) return std::nullopt;
      lambda = std::move(here);
    }
    return lambda;
  }

  /// G maps the complement of u to itself. If it has rank 4 there, nothing is left for u.
  bool vanishes(const WholeVector& u) const {
    if (abs(product_in_balls(u, u)) > 0) return false;
    std::vector<WholeVector> complement;
    const auto first = static_cast<std::size_t>(std::find(u.begin(), u.end(), 1) - u.begin());
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (i == first) continue;
      WholeVector v(u.size(), 0);
      v[i] = 1;
      v[first] = -u[i]; // u[first] is 1
      complement.push_back(std::move(v));
    }
    return has_rank_four(complement, {}, 0);
  }

  /// Some four of these vectors have a regular matrix of products.
  bool has_rank_four(const std::vector<WholeVector>& vectors, std::vector<int> chosen,
                     std::size_t from) const {
    if (chosen.size() == 4) {
      BallMatrix m(4, std::vector<Ball>(4, Ball(0)));
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
          m[i][j] = product_in_balls(vectors[chosen[i]], vectors[chosen[j]]);
      return is_regular(std::move(m));
    }
    for (std::size_t k = from; k < vectors.size(); ++k) {
      chosen.push_back(static_cast<int>(k));
      if (has_rank_four(vectors, chosen, k + 1)) return true;
      chosen.pop_back();
    }
    return false;
  }

  Ball product_in_balls(const WholeVector& u, const WholeVector& v) const {
    Ball sum = 0;
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j < size_; ++j)
        if (u[i] * v[j] != 0) sum += (u[i] * v[j]) * gram_[i][j];
    return sum;
  }

  /// Rational w and multipliers of relations with (G w)_i - (G w)_0 = sum of multiples, for all i: then G w
  /// is constant, and if that constant is not 0, so much for 1.
  bool has_solution() const {
    const int relations = static_cast<int>(relations_.size());
    const int unknowns = size_ + (size_ - 1) * relations;
    std::vector<Rationals> equations;
    for (int i = 1; i < size_; ++i)
      for (int s = 0; s < width_; ++s) {
        Rationals line(static_cast<std::size_t>(unknowns), Algebraic(0));
        for (int j = 0; j < size_; ++j) line[j] = Algebraic(entry_[i][j][s] - entry_[0][j][s]);
        for (int r = 0; r < relations; ++r)
          line[size_ + (i - 1) * relations + r] = Algebraic(-relations_[r][s]);
        equations.push_back(std::move(line));
      }
    for (const Rationals& w : null_space(std::move(equations), unknowns)) {
      Ball constant = 0;
      for (int j = 0; j < size_; ++j) constant += gram_[0][j] * w[j].value();
      if (abs(constant) > 0) return true;
    }
    return false;
  }

  /// By elimination; a basis.
  static std::vector<Rationals> null_space(std::vector<Rationals> lines, int unknowns) {
    std::vector<int> pivot_of(static_cast<std::size_t>(unknowns), -1); // of each unknown, its line
    std::size_t rank = 0;
    for (int c = 0; c < unknowns && rank < lines.size(); ++c) {
      std::size_t r = rank;
      while (r < lines.size() && lines[r][c] == Algebraic(0)) ++r;
      if (r == lines.size()) continue;
      std::swap(lines[r], lines[rank]);
      const Algebraic inverse = *lines[rank][c].inverse();
      for (Algebraic& x : lines[rank]) x *= inverse;
      for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k == rank || lines[k][c] == Algebraic(0)) continue;
        const Algebraic times = lines[k][c];
        for (int j = 0; j < unknowns; ++j) lines[k][j] -= times * lines[rank][j];
      }
      pivot_of[c] = static_cast<int>(rank++);
    }
    std::vector<Rationals> basis;
    for (int c = 0; c < unknowns; ++c) {
      if (pivot_of[c] >= 0) continue;
      Rationals w(static_cast<std::size_t>(unknowns), Algebraic(0));
      w[c] = Algebraic(1);
      for (int p = 0; p < unknowns; ++p)
        if (pivot_of[p] >= 0) w[p] = -lines[pivot_of[p]][c];
      basis.push_back(std::move(w));
    }
    return basis;
  }

  const BallMatrix& gram_;
  int size_;
  int width_ = 0;
  std::vector<std::vector<Form>> entry_;
  std::vector<WholeVector> kernel_; ///< vectors that G takes to 0
  std::vector<Form> relations_;     ///< each is 0 at the structure
};

} // namespace

bool is_flat_by_relations(const SymbolMatrix& symbols, const BallMatrix& gram) {
  return gram.size() <= most_corners && RelationSearch(symbols, gram).run();
}

} // namespace tetrarch::canonical
