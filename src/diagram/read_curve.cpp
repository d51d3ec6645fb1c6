// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/curve.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace tetrarch::diagram {
namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();) {
    if (format::is_space(line[at]) || line[at] == ',') {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < line.size() && !format::is_space(line[end]) && line[end] != ',') ++end;
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// Calls visit(line, number) for each line.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    visit(text.substr(at, end - at), ++number);
    at = end + 1;
  }
}

bool is_obj(std::string_view text) {
  bool lines = false;
  bool faces = false;
  for_each_line(text, [&](std::string_view line, int) {
    lines |= line.starts_with("l ");
    faces |= line.starts_with("f ");
  });
  return lines && !faces;
}

class CurveReader {
public:
  CurveReader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  Curve points_by_lines() {
    for_each_line(text_, [&](std::string_view line, int number) { point_line(line, number); });
    close();
    return finished();
  }

  Curve obj() {
    for_each_line(text_, [&](std::string_view line, int number) { obj_line(line, number); });
    return finished();
  }

private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw InputError({source_, line}, message);
  }

  double number(std::string_view word, int line) const {
    const std::optional<double> value = format::parse_double(word);
    if (!value || !std::isfinite(*value)) fail(line, format::found_expected(word, "a finite number"));
    return *value;
  }

  void point_line(std::string_view line, int number_of_line) {
    if (format::trimmed(line).starts_with('#')) return;
    std::vector<std::string_view> words = words_of(line);
    // Of a molecule: the number of points, a comment, and the name of an element before each point.
    if (words.size() == 4 && !format::parse_double(words.front())) words.erase(words.begin());
    if (words.size() == 3 && !format::parse_double(words.front()) && curve_.points.empty()) words.clear();
    if (words.size() == 3) {
      add_point({number(words[0], number_of_line), number(words[1], number_of_line),
                 number(words[2], number_of_line)},
                number_of_line);
      return;
    }
    const bool separates = std::none_of(
        words.begin(), words.end(), [](std::string_view w) { return format::parse_double(w).has_value(); });
    if (separates || curve_.points.empty())
      close();
    else
      fail(number_of_line, "found " + std::to_string(words.size()) + " words (expected three numbers)");
  }

  void add_point(const numeric::Point& p, int line) {
    const int k = static_cast<int>(curve_.points.size());
    curve_.points.push_back(p);
    if (k > first_) curve_.segments.push_back({k - 1, k});
    last_line_ = line;
  }

  /// Ends a closed curve. One that repeats its first point at its end has it once.
  void close() {
    const int count = static_cast<int>(curve_.points.size()) - first_;
    if (count == 0) return;
    const int last = first_ + count - 1;
    if (count > 1 && curve_.points[last] == curve_.points[first_]) {
      curve_.points.pop_back();
      curve_.segments.back()[1] = first_;
    } else {
      curve_.segments.push_back({last, first_});
    }
    const int points = static_cast<int>(curve_.points.size()) - first_;
    if (points < 3)
      fail(last_line_, "a closed curve has " + std::to_string(points) + (points == 1 ? " point" : " points") +
                           " (expected three or more)");
    first_ = static_cast<int>(curve_.points.size());
  }

  void obj_line(std::string_view line, int number_of_line) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return;
    if (words[0] == "v") {
      if (words.size() < 4) fail(number_of_line, "a vertex has fewer than three coordinates");
      curve_.points.push_back({number(words[1], number_of_line), number(words[2], number_of_line),
                               number(words[3], number_of_line)});
    }
    if (words[0] != "l") return;
    int before = -1;
    for (std::size_t k = 1; k < words.size(); ++k) {
      const auto index = format::parse_integer(words[k].substr(0, words[k].find('/')));
      const auto count = static_cast<std::int64_t>(curve_.points.size());
      if (!index || *index == 0 || *index > count || *index < -count)
        fail(number_of_line, format::found_expected(words[k], "the number of a vertex above"));
      const int at = static_cast<int>(*index > 0 ? *index - 1 : count + *index);
      if (before >= 0) curve_.segments.push_back({before, at});
      before = at;
    }
  }

  /// Points of OBJ that no line has are left out.
  Curve finished() {
    std::set<std::pair<int, int>> seen;
    std::vector<int> valence(curve_.points.size(), 0);
    for (const auto& [a, b] : curve_.segments) {
      if (a == b) fail(0, "a segment joins point " + std::to_string(a) + " to itself");
      if (!seen.insert(std::minmax(a, b)).second)
        fail(0,
             "the segment of points " + std::to_string(a) + " and " + std::to_string(b) + " is given twice");
      ++valence[a];
      ++valence[b];
    }
    if (curve_.segments.empty()) fail(0, "there are no segments (expected the points of a curve)");
    std::vector<int> image(curve_.points.size(), -1);
    Curve out;
    for (std::size_t p = 0; p < curve_.points.size(); ++p)
      if (valence[p] > 0) {
        image[p] = static_cast<int>(out.points.size());
        out.points.push_back(curve_.points[p]);
      }
    for (const auto& [a, b] : curve_.segments) out.segments.push_back({image[a], image[b]});
    return out;
  }

  std::string_view text_;
  const std::string& source_;
  Curve curve_;
  int first_ = 0; ///< point of the component
  int last_line_ = 0;
};

} // namespace

bool looks_like_curve(std::string_view text) {
  if (is_obj(text)) return true;
  bool good = true;
  int points = 0;
  for_each_line(text, [&](std::string_view line, int number) {
    const auto words = words_of(line);
    if (words.empty() || format::trimmed(line).starts_with('#')) return;
    good &= words[0] != "v" && words[0] != "f"; // OBJ without lines
    const auto numbers = static_cast<std::size_t>(std::count_if(
        words.begin(), words.end(), [](std::string_view w) { return format::parse_double(w).has_value(); }));
    if (numbers == 3 && words.size() <= 4)
      ++points;
    else if (number > 2 && numbers > 0)
      good = false;
  });
  return good && points >= 3;
}

Curve read_curve(std::string_view text, const std::string& source) {
  CurveReader reader(text, source);
  return is_obj(text) ? reader.obj() : reader.points_by_lines();
}

} // namespace tetrarch::diagram
