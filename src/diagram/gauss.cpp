// SPDX-License-Identifier: GPL-2.0-or-later
/// Gauss codes and those of Dowker and Thistlethwaite: the crossings in the order of a walk.
///
/// A walk does not tell on which side a strand crosses. Put a wheel in place of each crossing: a hub, and a
/// rim of four points where the arcs end, in the order in which they lie round the crossing (in, in of the
/// other, out, out of the other). A wheel has one embedding in the plane, up to reflection, so any embedding
/// of the whole graph is a diagram with this code.
#include "readers.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace tetrarch::diagram {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                    boost::property<boost::vertex_index_t, int>,
                                    boost::property<boost::edge_index_t, int>>;

/// Points of the wheel of crossing c: rim points 5c + k, k = 0: the first passage comes in, 1: the second
/// comes in, 2: the first goes out, 3: the second goes out; 5c + 4: the hub. Each arc has a point in its
/// middle as well, so that there are no parallel ones.
constexpr int wheel = 5;

struct WheelGraph {
  Graph graph;
  std::vector<std::pair<int, int>> arcs; ///< rim points
  int circles = 0;
};

WheelGraph wheel_graph(const std::vector<std::vector<Passage>>& components, int crossings) {
  WheelGraph out;
  std::vector<int> met(static_cast<std::size_t>(crossings), 0);
  for (const auto& component : components) {
    if (component.empty()) ++out.circles;
    int first_in = -1;
    int last_out = -1;
    for (const Passage& passage : component) {
      const int in = wheel * passage.crossing + met[passage.crossing]++;
      if (last_out >= 0)
        out.arcs.emplace_back(last_out, in);
      else
        first_in = in;
      last_out = in + 2;
    }
    if (last_out >= 0) out.arcs.emplace_back(last_out, first_in);
  }
  int edge = 0;
  int next = wheel * crossings;
  out.graph = Graph(static_cast<std::size_t>(next) + out.arcs.size());
  const auto add = [&](int a, int b) {
    boost::add_edge(static_cast<std::size_t>(a), static_cast<std::size_t>(b), edge++, out.graph);
  };
  for (int c = 0; c < crossings; ++c)
    for (int k = 0; k < 4; ++k) {
      add(wheel * c + k, wheel * c + (k + 1) % 4);
      add(wheel * c + k, wheel * c + 4);
    }
  for (const auto& [a, b] : out.arcs) {
    add(a, next);
    add(b, next++);
  }
  return out;
}

/// Of each hub, the rim points in their order; false if the graph is not plane.
bool embed(const Graph& graph, int crossings, std::vector<std::array<int, 4>>& round) {
  using Rotation = std::vector<std::vector<Graph::edge_descriptor>>;
  Rotation rotation(boost::num_vertices(graph));
  if (!boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                           boost::boyer_myrvold_params::embedding = rotation.data()))
    return false;
  for (int c = 0; c < crossings; ++c) {
    const int hub = wheel * c + 4;
    const auto& spokes = rotation[static_cast<std::size_t>(hub)];
    std::array<int, 4> order{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto a = static_cast<int>(boost::source(spokes[k], graph));
      const auto b = static_cast<int>(boost::target(spokes[k], graph));
      order[k] = a == hub ? b : a;
    }
    round.push_back(order);
  }
  return true;
}

} // namespace

Draft from_passages(const std::vector<std::vector<Passage>>& components, CodeText& text) {
  int crossings = 0;
  for (const auto& component : components)
    for (const Passage& p : component) crossings = std::max(crossings, p.crossing + 1);
  std::vector<bool> first_is_over(static_cast<std::size_t>(crossings), false);
  std::vector<bool> met(static_cast<std::size_t>(crossings), false);
  for (const auto& component : components)
    for (const Passage& p : component) {
      if (!met[p.crossing]) first_is_over[p.crossing] = p.over;
      met[p.crossing] = true;
    }
  const WheelGraph wheels = wheel_graph(components, crossings);
  std::vector<std::array<int, 4>> round;
  if (!embed(wheels.graph, crossings, round)) text.fail("no plane diagram has this code");
  Draft draft;
  std::vector<int> dart_of(static_cast<std::size_t>(wheel) * static_cast<std::size_t>(crossings), -1);
  for (int c = 0; c < crossings; ++c) {
    const int dart = draft.add_node(4, true, 0);
    for (int k = 0; k < 4; ++k) dart_of[round[c][k]] = dart + k;
    // The first passage has rim points 0 and 2.
    const bool first_is_even =
        (dart_of[static_cast<std::size_t>(wheel) * static_cast<std::size_t>(c)] - dart) % 2 == 0;
    draft.nodes.back().over = first_is_even == first_is_over[c] ? 0 : 1;
  }
  for (const auto& [a, b] : wheels.arcs) draft.join(dart_of[a], dart_of[b]);
  for (int k = 0; k < wheels.circles; ++k) {
    const int dart = draft.add_node(2, false, 0);
    draft.join(dart, dart + 1);
  }
  return draft;
}

namespace {

/// Lists of signed numbers: one list, or a list of lists.
std::vector<std::vector<int>> read_lists(CodeText& text, std::string_view expected) {
  std::vector<std::vector<int>> lists;
  const auto read_numbers = [&](char end) {
    std::vector<int> list;
    while (!text.at_end() && text.next() != end) {
      list.push_back(text.integer(expected));
      text.skip(",;");
    }
    lists.push_back(std::move(list));
  };
  const char c = text.next();
  if (c != '[' && c != '(' && c != '{') {
    read_numbers('\0');
    return lists;
  }
  const char end = text.open("a list");
  if (text.next() != '[' && text.next() != '(' && text.next() != '{') {
    read_numbers(end);
    text.close(end);
  } else {
    while (!text.at_end() && text.next() != end) {
      const char inner = text.open("a list");
      read_numbers(inner);
      text.close(inner);
      text.skip(",;");
    }
    text.close(end);
    return lists;
  }
  // Further components may follow as lists of their own.
  text.skip(",;");
  while (!text.at_end()) {
    const char inner = text.open("a list, or the end");
    read_numbers(inner);
    text.close(inner);
    text.skip(",;");
  }
  return lists;
}

/// Crossings by their numbers in the text, each passed over once and under once.
class PassageList {
public:
  explicit PassageList(CodeText& text) : text_(text) {}
  void start_component() { components_.emplace_back(); }
  void add(int label, bool over) {
    auto [at, fresh] = number_.emplace(label, static_cast<int>(number_.size()));
    auto& passages = passed_[label];
    if (std::find(passages.begin(), passages.end(), over) != passages.end())
      text_.fail("crossing " + std::to_string(label) + " is passed twice " + (over ? "over" : "under"));
    passages.push_back(over);
    components_.back().push_back({at->second, over});
  }
  Draft finished() {
    for (const auto& [label, passages] : passed_)
      if (passages.size() != 2)
        text_.fail("crossing " + std::to_string(label) + " is passed once (expected twice)");
    return from_passages(components_, text_);
  }

private:
  CodeText& text_;
  std::vector<std::vector<Passage>> components_;
  std::map<int, int> number_;
  std::map<int, std::vector<bool>> passed_;
};

Draft read_over_under(CodeText& text) {
  PassageList list(text);
  list.start_component();
  while (!text.at_end()) {
    if (text.take('|') || text.take(';')) {
      list.start_component();
      continue;
    }
    const std::string word = text.word();
    if (word != "o" && word != "u") text.fail_expected("O or U and the number of a crossing");
    list.add(text.integer("the number of a crossing"), word == "o");
    // The sign of a crossing may follow; what separates two of them looks alike.
    text.skip("+-,");
  }
  return list.finished();
}

/// DT letters: after the numbers of crossings and components, and of crossings of each component, small
/// letters a = 2, b = 4, ..., capital ones negative.
std::vector<std::vector<int>> lists_of_letters(const std::string& letters, CodeText& text) {
  const auto value = [](char c) { return c >= 'a' ? c - 'a' + 1 : -(c - 'A' + 1); };
  if (letters.size() < 3) text.fail("the DT code is too short");
  const int crossings = value(letters[0]);
  const int components = value(letters[1]);
  std::vector<std::vector<int>> lists;
  std::size_t at = 2 + static_cast<std::size_t>(std::max(0, components));
  if (crossings <= 0 || components <= 0 || letters.size() != at + static_cast<std::size_t>(crossings))
    text.fail("the DT code has " + std::to_string(letters.size()) +
              " letters, which is not what its first say");
  for (int k = 0; k < components; ++k) {
    std::vector<int> list;
    for (int n = value(letters[2 + static_cast<std::size_t>(k)]); n > 0; --n) {
      if (at >= letters.size()) text.fail("the components of the DT code have more crossings than it says");
      list.push_back(2 * value(letters[at++]));
    }
    lists.push_back(std::move(list));
  }
  return lists;
}

} // namespace

Draft read_gauss(CodeText& text) {
  CodeText ahead = text;
  const std::string word = ahead.word();
  if (word == "o" || word == "u") return read_over_under(text);
  const std::vector<std::vector<int>> lists =
      read_lists(text, "the number of a crossing, negative where one passes under");
  if (!text.at_end()) text.fail_expected("the end");
  PassageList passages(text);
  for (const auto& list : lists) {
    passages.start_component();
    for (const int label : list) {
      if (label == 0) text.fail("crossing 0 has no sign (expected numbers from 1)");
      passages.add(std::abs(label), label > 0);
    }
  }
  return passages.finished();
}

Draft read_dt(CodeText& text) {
  std::vector<std::vector<int>> lists;
  CodeText ahead = text;
  const char opening = ahead.next();
  const bool bracketed = ahead.take('[') || ahead.take('(');
  if (const std::string letters = ahead.letters(); !letters.empty()) {
    lists = lists_of_letters(letters, ahead);
    if (bracketed) ahead.close(opening == '[' ? ']' : ')');
    text = ahead;
  } else {
    lists = read_lists(text, "an even number of the DT code");
  }
  if (!text.at_end()) text.fail_expected("the end");
  int count = 0;
  for (const auto& list : lists) count += static_cast<int>(list.size());
  // Times 1, 3, 5, ... meet the even times that are listed; a negative one passes over at its even time
  // where a positive one passes under.
  std::vector<Passage> at(2 * static_cast<std::size_t>(count) + 1);
  std::vector<bool> used(at.size(), false);
  int odd = 1;
  for (const auto& list : lists)
    for (const int even : list) {
      const int time = std::abs(even);
      if (time == 0 || time % 2 != 0 || time > 2 * count)
        text.fail("found " + std::to_string(even) + " (expected even numbers from 2 to " +
                  std::to_string(2 * count) + ")");
      if (used[time]) text.fail("the DT code lists " + std::to_string(time) + " twice");
      used[time] = true;
      const int crossing = (odd - 1) / 2;
      at[odd] = {crossing, even > 0};
      at[time] = {crossing, even < 0};
      odd += 2;
    }
  std::vector<std::vector<Passage>> components;
  int time = 1;
  for (const auto& list : lists) {
    components.emplace_back();
    for (std::size_t k = 0; k < 2 * list.size(); ++k) components.back().push_back(at[time++]);
  }
  return from_passages(components, text);
}

} // namespace tetrarch::diagram
