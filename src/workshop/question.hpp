// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A question within a result: yes with what that rests on, or undecided with all doubts.

#include "tetrarch/workshop/text.hpp"
#include "tetrarch/workshop/tree.hpp"
#include "tetrarch/workshop/type.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::workshop {

struct Question {
  const char* text;    ///< before the answer, as in "a mesh of it"
  const char* because; ///< what a yes rests on
  std::vector<std::string> doubts;
};

/// Verdict and doubts.
inline Tree tree_of(const Question& question) {
  return {{"verdict", question.doubts.empty() ? "yes" : "undecided"}, {"doubts", question.doubts}};
}

inline Type question_type() {
  return type::object({{"verdict", type::one_of({"yes", "undecided"})}, {"doubts", type::list(type::text)}});
}

inline std::pair<std::string, std::string> row_of(const Question& question) {
  return {question.text, question.doubts.empty() ? std::string("yes: ") + question.because
                                                 : "undecided: " + joined(question.doubts, "; ")};
}

} // namespace tetrarch::workshop
