// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/flow_history.hpp"

#include <array>
#include <charconv>
#include <ostream>
#include <string>

namespace tetrarch::hyperbolic {
namespace {

template <class Number>
void append(std::string& line, Number value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  line.append(text.data(), end);
}

} // namespace

void write_history_csv(std::ostream& out, const FlowHistory& history) {
  // Lines are built as text: a stream's own formatting of numbers follows its locale.
  std::string line = "step,time,step_size,squared_curvature,max_curvature\n";
  out << line;
  for (std::size_t n = 0; n < history.size(); ++n) {
    line.clear();
    append(line, n);
    for (const double value :
         {history[n].time, history[n].step_size, history[n].squared_curvature, history[n].max_curvature}) {
      line += ',';
      append(line, value);
    }
    line += '\n';
    out << line;
  }
}

} // namespace tetrarch::hyperbolic
