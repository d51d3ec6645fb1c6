// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/read.hpp"

#include "readers.hpp"

#include <array>

namespace tetrarch::diagram {
namespace {

using Reader = Draft (*)(CodeText&);

struct Kind {
  std::string_view word;
  Reader read;
};

/// The word "x", "v", "p" or "loop" is part of the list that it begins, and so are "o" and "u".
constexpr std::array<Kind, 11> kinds{{{"embedding", read_embedding},
                                      {"pd", read_planar_diagram},
                                      {"braid", read_braid},
                                      {"br", read_braid},
                                      {"conway", read_conway},
                                      {"dt", read_dt},
                                      {"gauss", read_gauss},
                                      {"gausscode", read_gauss},
                                      {"knot", read_planar_diagram},
                                      {"link", read_planar_diagram},
                                      {"graph", read_planar_diagram}}};

Reader reader_of(std::string_view word) {
  for (const Kind& kind : kinds)
    if (kind.word == word) return kind.read;
  return nullptr;
}

bool begins_planar_list(std::string_view word) {
  return word == "x" || word == "v" || word == "p" || word == "loop" || word == "xp" || word == "xm" ||
         word == "vertex";
}

Draft read_code(std::string_view text, const std::string& source) {
  CodeText code(text, source);
  if (code.at_end()) code.fail("the file is empty (expected the code of a diagram)");
  CodeText ahead = code;
  const std::string word = ahead.word();
  if (const Reader read = reader_of(word)) {
    ahead.skip(":=");
    return read(ahead);
  }
  if (begins_planar_list(word)) return read_planar_diagram(code);
  if (word == "o" || word == "u") return read_gauss(code);
  if (!word.empty())
    code.fail_expected("the code of a diagram: embedding, PD, X[...], braid, DT, Gauss or Conway");
  return read_planar_diagram(code);
}

} // namespace

bool looks_like_diagram(std::string_view text) {
  CodeText code(text.substr(0, 4096), {});
  CodeText ahead = code;
  const std::string word = ahead.word();
  const char after = ahead.next();
  if (begins_planar_list(word)) return after == '[' || after == '(';
  if (word == "embedding") return after == ':' || after == '{' || after == '-';
  if (word == "o" || word == "u") return ahead.at_integer();
  if (reader_of(word) != nullptr)
    return after == '[' || after == '(' || after == '{' || after == ':' || after == '=' || ahead.at_integer();
  if (!word.empty() || !(code.take('[') || code.take('('))) return false;
  return (code.take('[') || code.take('(')) && code.at_integer();
}

Diagram read_diagram(std::string_view text, const std::string& source) {
  Draft draft = read_code(text, source);
  if (const std::string wrong = why_not(draft.nodes, draft.opposite); !wrong.empty())
    throw InputError({source, 0}, "no diagram: " + wrong);
  return std::move(draft).finished();
}

} // namespace tetrarch::diagram
