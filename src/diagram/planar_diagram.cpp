// SPDX-License-Identifier: GPL-2.0-or-later
/// Planar diagram codes: crossings and vertices by the numbers of their arcs.
#include "readers.hpp"

#include <algorithm>
#include <map>

namespace tetrarch::diagram {
namespace {

/// The words before a list, and what they make of it.
enum class Item { crossing, vertex, circle };

Item item_of(const std::string& word, CodeText& text) {
  if (word.empty() || word == "x" || word == "xp" || word == "xm") return Item::crossing;
  if (word == "v" || word == "vertex" || word == "p") return Item::vertex;
  if (word == "loop") return Item::circle;
  text.fail("found " + in_quotes(word) + " (expected X, V, P or Loop)");
}

class PlanarDiagram {
public:
  explicit PlanarDiagram(CodeText& text) : text_(text) {}

  void read_item() {
    const Item item = item_of(text_.word(), text_);
    const char end = text_.open("the list of a crossing or a vertex");
    std::vector<int> labels;
    do labels.push_back(text_.integer("the number of an arc"));
    while (text_.take(','));
    text_.close(end);
    if (item == Item::crossing && labels.size() != 4)
      text_.fail("a crossing has " + std::to_string(labels.size()) + " arcs (expected 4)");
    if (item == Item::circle) {
      const int first = draft_.add_node(2, false, 0);
      draft_.join(first, first + 1);
      return;
    }
    // The lower strand has places 0 and 2.
    int dart = draft_.add_node(static_cast<int>(labels.size()), item == Item::crossing, 1);
    for (const int label : labels) add_end(label, dart++);
  }

  Draft finished() {
    for (const auto& [label, ends] : ends_) {
      if (ends.size() != 2)
        text_.fail("arc " + std::to_string(label) + " has " + std::to_string(ends.size()) +
                   (ends.size() == 1 ? " end" : " ends") + " (expected 2)");
      draft_.join(ends[0], ends[1]);
    }
    if (draft_.nodes.empty()) text_.fail("there are no crossings (expected X[...], V[...] or Loop[...])");
    return std::move(draft_);
  }

private:
  void add_end(int label, int dart) { ends_[label].push_back(dart); }

  CodeText& text_;
  Draft draft_;
  std::map<int, std::vector<int>> ends_;
};

/// Whether the bracket that comes next holds lists, rather than being one.
bool brackets_all(CodeText text) {
  if (!(text.take('[') || text.take('(') || text.take('{'))) return false;
  return !text.at_integer();
}

} // namespace

Draft read_planar_diagram(CodeText& text) {
  CodeText ahead = text;
  if (ahead.word() == "pd") text = ahead;
  PlanarDiagram code(text);
  const char end = brackets_all(text) ? text.open("a list") : '\0';
  while (!text.at_end() && text.next() != end) {
    code.read_item();
    text.skip(",;");
  }
  if (end != '\0') text.close(end);
  if (!text.at_end()) text.fail_expected("the end");
  return code.finished();
}

} // namespace tetrarch::diagram
