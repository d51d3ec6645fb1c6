// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "samples.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/diagram/layout.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/show/diagram.hpp"
#include "tetrarch/workshop/diagram.hpp"

#include <memory>

namespace tetrarch::program {
namespace {

constexpr const char* code_help =
    "the name of a knot, link or graph such as 4_1, L6a4 or hk5_3, a code such as 'braid 1 -2 1 -2', "
    "'PD[X[1,4,2,5], ...]' or 'DT[4,6,2]', a "
    "file of one (also the drawing in an Orb file), or a curve in space";

diagram::Diagram read_diagram(const std::string& argument, const Context& context) {
  context.reads->any = true;
  return workshop::open_diagram(argument, {{}, samples_folder()}, context.seed, context.progress);
}

diagram::MarkedDiagram read_marked_diagram(const std::string& argument, const Context& context) {
  context.reads->any = true;
  return workshop::open_marked_diagram(argument, {{}, samples_folder()}, context.seed, context.progress);
}

struct ExteriorOptions {
  std::string input;
  std::string output;
  bool mirror = false;
  bool parabolic = false;
  bool doubled = false;
  bool drilled = false;
  std::vector<std::string> orders;
};

/// The orders that are asked for, edge by edge: "2:3", "all:0".
void set_orders(diagram::MarkedDiagram& marked, const std::vector<std::string>& words) {
  const diagram::Classes edge = diagram::edges(marked);
  for (const std::string& word : words) {
    const std::size_t colon = word.find(':');
    const std::string name = word.substr(0, colon);
    const bool all = name == "all";
    const std::int64_t number = format::parse_integer(name).value_or(-1);
    const double order =
        colon == std::string::npos ? -1 : format::parse_double(word.substr(colon + 1)).value_or(-1);
    if (!(all || (number >= 0 && number < edge.count)) || !is_edge_order(order))
      throw InputError("--order: found " + in_quotes(word) + " (expected an edge of the graph, 0 to " +
                       std::to_string(edge.count - 1) + " or all, and an order, 0, 1 or above: 0:3)");
    for (int d = 0; d < marked.diagram.dart_count(); ++d)
      if (all || edge.of[d] == number) marked.fates[d] = order;
  }
}

Result exterior(const ExteriorOptions& options, const Context& context) {
  diagram::MarkedDiagram diagram = options.drilled ? all_drilled(read_diagram(options.input, context))
                                                   : read_marked_diagram(options.input, context);
  if (options.mirror) diagram.diagram = mirrored(diagram.diagram);
  set_orders(diagram, options.orders);
  workshop::Exterior found =
      workshop::exterior(diagram, {context.seed, {}, options.parabolic, options.doubled}, context.progress);
  Result result;
  if (found.filled_spheres > 0)
    result.warnings.push_back(counted(found.filled_spheres, "component") +
                              " without cycles: the ball round each was filled in again");
  if (found.parabolic && !found.parabolic->found) result.status = Status::undecided;
  result.json = tree_of(found);
  result.text = block(rows_of(found, found.info.signature));
  format::Document document = format::document_of(std::move(found.triangulation));
  document.marks = std::move(found.marks);
  if (!options.output.empty()) add_file(result, options.output, document);
  result.value = std::make_shared<Value>(std::move(document));
  return result;
}

struct DiagramOptions {
  std::string input;
  std::string output;
  bool mirror = false;
  bool simplify = false;
  bool handlebody = false;
};

constexpr std::size_t longest_title = 100;

Result describe_diagram(const DiagramOptions& options, const Context& context) {
  diagram::Diagram diagram = read_diagram(options.input, context);
  if (options.mirror) diagram = mirrored(diagram);
  if (options.handlebody)
    diagram = diagram::simplified_handlebody(diagram, context.progress);
  else if (options.simplify)
    diagram = diagram::simplified(diagram, context.progress);
  const workshop::DiagramFacts found = workshop::facts(diagram);
  Result result;
  result.json = tree_of(found);
  result.text = block(rows_of(found));
  if (options.output.empty()) return result;
  if (format::has_extension(options.output, ".svg")) {
    const std::string title = options.input.substr(0, longest_title);
    result.files.push_back(
        {options.output, write_svg(show::drawing(layout(diagram, context.progress), title))});
  } else {
    result.files.push_back({options.output, found.code + "\n"});
  }
  return result;
}

} // namespace

Run declare_exterior(OptionTable& table) {
  const auto options = std::make_shared<ExteriorOptions>();
  table.add("DIAGRAM", options->input, code_help).required();
  table.add("--mirror", options->mirror, "take the mirror image");
  table
      .add("--order", options->orders,
           "keep an edge of the graph in the triangulation, with the cone angle 2 pi / n around it (0: with "
           "a parabolic "
           "meridian), and drill only the others: 2:3, all:0")
      .value_name("EDGE:N");
  table.add("--drilled", options->drilled,
            "drill every edge, also those of an Orb file that stay there with orders of their own");
  table.add("--parabolic", options->parabolic,
            "look for the structure in which the meridian of every edge is parabolic, and give its volume");
  table.add(
      "--double", options->doubled,
      "two copies, glued along the spheres round the vertices: its structure is twice the parabolic one");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file(require_triangulation);
  return [options](const Context& context) { return exterior(*options, context); };
}

Run declare_diagram(OptionTable& table) {
  const auto options = std::make_shared<DiagramOptions>();
  table.add("DIAGRAM", options->input, code_help).required();
  table.add("--mirror", options->mirror, "take the mirror image");
  table.add("--simplify", options->simplify, "look for a diagram of the same with fewer crossings");
  table.add("--handlebody", options->handlebody,
            "simplify the handlebody that the graph is the core of: edges may slide over one another, so "
            "that the graph "
            "may become another one");
  table.add("-o,--output", options->output, "write a drawing (.svg), or the planar diagram code")
      .output_file();
  return [options](const Context& context) { return describe_diagram(*options, context); };
}

} // namespace tetrarch::program
