// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One reader for each kind of code; each has been told its kind by the words before.

#include "code_text.hpp"
#include "draft.hpp"

#include <vector>

namespace tetrarch::diagram {

Draft read_embedding(CodeText& text);
/// The crossings follow, with or without brackets round all.
Draft read_planar_diagram(CodeText& text);
Draft read_braid(CodeText& text);
/// The closure of a braid of so many strands or more, if the letters need more. O(strands + letters).
Draft closed_braid(const std::vector<int>& letters, int strands);
Draft read_dt(CodeText& text);
Draft read_gauss(CodeText& text);
Draft read_conway(CodeText& text);

/// A passage of a Gauss code: the crossing, from 0, and whether it is over.
struct Passage {
  int crossing = 0;
  bool over = false;
};
/// The diagram of components that pass crossings in these orders, each crossing twice; an empty component is
/// a circle. Fails at the text's place if no plane diagram has the code.
Draft from_passages(const std::vector<std::vector<Passage>>& components, CodeText& text);

} // namespace tetrarch::diagram
