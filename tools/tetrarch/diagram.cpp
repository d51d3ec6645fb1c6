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
    "file of one, or a curve in space";

diagram::Diagram read_diagram(const std::string& argument, const Context& context) {
  context.reads->any = true;
  return workshop::open_diagram(argument, {{}, samples_folder()}, context.seed, context.progress);
}

struct ExteriorOptions {
  std::string input;
  std::string output;
  bool mirror = false;
  bool parabolic = false;
  bool doubled = false;
};

Result exterior(const ExteriorOptions& options, const Context& context) {
  if (!options.output.empty()) output_format(options.output);
  diagram::Diagram diagram = read_diagram(options.input, context);
  if (options.mirror) diagram = mirrored(diagram);
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
  if (!options.output.empty()) add_file(result, options.output, document);
  result.value = std::make_shared<Value>(std::move(document));
  return result;
}

struct DiagramOptions {
  std::string input;
  std::string output;
  bool mirror = false;
  bool simplify = false;
};

constexpr std::size_t longest_title = 100;

Result describe_diagram(const DiagramOptions& options, const Context& context) {
  diagram::Diagram diagram = read_diagram(options.input, context);
  if (options.mirror) diagram = mirrored(diagram);
  if (options.simplify) diagram = diagram::simplified(diagram, context.progress);
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
  table.add("--parabolic", options->parabolic,
            "look for the structure in which the meridian of every edge is parabolic, and give its volume");
  table.add(
      "--double", options->doubled,
      "two copies, glued along the spheres round the vertices: its structure is twice the parabolic one");
  table.add("-o,--output", options->output, "the file to write (its extension names the format)")
      .output_file();
  return [options](const Context& context) { return exterior(*options, context); };
}

Run declare_diagram(OptionTable& table) {
  const auto options = std::make_shared<DiagramOptions>();
  table.add("DIAGRAM", options->input, code_help).required();
  table.add("--mirror", options->mirror, "take the mirror image");
  table.add("--simplify", options->simplify, "look for a diagram of the same with fewer crossings");
  table.add("-o,--output", options->output, "write a drawing (.svg), or the planar diagram code")
      .output_file();
  return [options](const Context& context) { return describe_diagram(*options, context); };
}

} // namespace tetrarch::program
