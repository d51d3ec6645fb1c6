// SPDX-License-Identifier: GPL-2.0-or-later
/// Conway's notation of rational and Montesinos links.
///
///     NW \ | / NE     n         n crossings in a row from west to east, whose upper strands rise to the east
///         [t]         a b       a reflected in the diagonal from NW to SE, and b to the east of it
///     SW / | \ SE     a, b, c   each reflected, side by side; "+" or "-" at the end: one crossing more
///
/// The ends of the whole are joined, NW to NE and SW to SE. Source: Conway, "An enumeration of knots and
/// links" (1970).
#include "readers.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace tetrarch::diagram {
namespace {

enum End { northwest, northeast, southwest, southeast };

/// Nodes of a draft from `first` to the last there is, and four loose darts.
struct Tangle {
  std::size_t first = 0;
  std::array<int, 4> end{};
};

class ConwayReader {
public:
  explicit ConwayReader(CodeText& text) : text_(text) {}

  Draft run() {
    const char close = text_.open("a list in brackets");
    Tangle whole = rational();
    if (text_.take(',')) {
      reflect(whole);
      do {
        Tangle next = rational();
        reflect(next);
        add(whole, next);
      } while (text_.take(','));
    }
    for (;;) {
      if (text_.take('+'))
        add(whole, row(1));
      else if (text_.take('-'))
        add(whole, row(-1));
      else
        break;
    }
    text_.close(close);
    if (!text_.at_end()) text_.fail_expected("the end");
    draft_.join(whole.end[northwest], whole.end[northeast]);
    draft_.join(whole.end[southwest], whole.end[southeast]);
    return std::move(draft_);
  }

private:
  Tangle rational() {
    Tangle tangle = row(number());
    while (text_.at_integer()) {
      reflect(tangle);
      const Tangle next = row(number());
      add(tangle, next);
    }
    return tangle;
  }

  int number() {
    constexpr int most_crossings = 1'000'000;
    const int n = text_.integer("a number of crossings");
    crossings_ += std::abs(n);
    if (crossings_ > most_crossings)
      text_.fail("the link has more than " + std::to_string(most_crossings) + " crossings");
    return n;
  }

  Tangle row(int crossings) {
    Tangle tangle{draft_.nodes.size(), {}};
    const int upper = draft_.add_node(2, false, 0);
    const int lower = draft_.add_node(2, false, 0);
    tangle.end = {upper, upper + 1, lower, lower + 1};
    for (int k = 0; k < std::abs(crossings); ++k) {
      // Darts to the southwest, southeast, northeast, northwest.
      const int x = draft_.add_node(4, true, crossings > 0 ? 0 : 1);
      draft_.join(tangle.end[northeast], x + 3);
      draft_.join(tangle.end[southeast], x);
      tangle.end[northeast] = x + 2;
      tangle.end[southeast] = x + 1;
    }
    return tangle;
  }

  /// In the plane through the diagonal that stands upright on the picture: what is above stays above.
  void reflect(Tangle& tangle) {
    for (std::size_t n = tangle.first; n < draft_.nodes.size(); ++n) {
      Node& node = draft_.nodes[n];
      std::reverse(node.darts.begin(), node.darts.end());
      if (node.crossing) node.over = 1 - node.over;
    }
    std::swap(tangle.end[northeast], tangle.end[southwest]);
  }

  /// Sets `right`, whose nodes come next, to the east.
  void add(Tangle& left, const Tangle& right) {
    draft_.join(left.end[northeast], right.end[northwest]);
    draft_.join(left.end[southeast], right.end[southwest]);
    left.end[northeast] = right.end[northeast];
    left.end[southeast] = right.end[southeast];
  }

  CodeText& text_;
  Draft draft_;
  int crossings_ = 0;
};

} // namespace

Draft read_conway(CodeText& text) {
  return ConwayReader(text).run();
}

} // namespace tetrarch::diagram
