// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "doctor.hpp"
#include "info.hpp"
#include "input.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <chrono>
#include <memory>

namespace tetrarch::program {
namespace {

struct SimplifyArguments {
  std::string input;
  std::string output;
  std::string log;
  Doctor doctor;
  bool audit = false;
  bool keep_spheres = false;
  bool keep_boundary = false;
};

void declare_shared(OptionTable& table, SimplifyArguments& options) {
  table.add("-o,--output", options.output, "the file to write (its extension names the format)")
      .value_name("FILE");
  table.add("--moves", options.log, "write a log of all moves to this file, one per line").value_name("FILE");
  declare_doctor(table, options.doctor);
  table.add("--audit", options.audit,
            "compare the triangulation with one built from nothing after every 1,000th move; slow");
}

/// What a run has cost and made, beside the triangulation itself.
struct Job {
  format::Document input;
  moves::SimplifyOptions simplify;
  moves::MoveLog log;
  double seconds = 0; ///< of the simplification alone, without reading and describing
};

/// Runs `job` and takes its time.
template <class Work>
auto timed(Job& job, Work work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

/// Compares a Complex with what is computed from nothing: the numbers of classes, and the homology.
std::function<void(const moves::Complex&)> auditor(const Triangulation& input) {
  const auto homology = [](const Triangulation& tri, const Skeleton& skeleton) {
    return algebra::homology(tri, skeleton, 1).str();
  };
  const std::string before = homology(input, Skeleton(input));
  return [before, homology](const moves::Complex& complex) {
    const Triangulation tri = complex.triangulation();
    const Skeleton skeleton(tri);
    if (!is_valid(skeleton) || skeleton.vertex_count() != complex.vertex_count() ||
        skeleton.edge_count() != complex.edge_count() ||
        skeleton.boundary_face_count() != complex.boundary_face_count() || homology(tri, skeleton) != before)
      throw PreconditionError("the audit found a fault in the complex at " + std::to_string(complex.size()) +
                              " tetrahedra");
  };
}

Job prepare(const SimplifyArguments& options, const Context& context) {
  if (!options.output.empty()) output_format(options.output);
  require_folder(options.log);
  Job run{read_triangulation(options.input, context, options.doctor), {}, {}};
  require_manifolds(run.input.triangulation, options.input);
  run.simplify.seed = context.seed;
  if (options.audit) run.simplify.audit = auditor(run.input.triangulation);
  return run;
}

/// The result as `info` has it, with what the run adds, and its files.
Result simplified_result(const SimplifyArguments& options, const Job& run, Triangulation tri, Info info) {
  Result result;
  result.warnings = run.input.warnings;
  info.json["input_tetrahedra"] = run.input.triangulation.size();
  info.json["seconds"] = run.seconds;
  result.json = std::move(info.json);
  result.text = block(info.rows);
  format::Document document = format::document_of(std::move(tri), run.input.name);
  if (!options.output.empty()) add_file(result, options.output, document);
  result.value = std::make_shared<Value>(std::move(document));
  if (!options.log.empty()) {
    std::string lines;
    for (const moves::Move& move : run.log) lines += move.str() + "\n";
    result.files.push_back({options.log, std::move(lines)});
  }
  return result;
}

Result simplify(const SimplifyArguments& options, const Context& context) {
  Job run = prepare(options, context);
  if (!options.log.empty()) run.simplify.log = &run.log;
  run.simplify.change_boundary = !options.keep_boundary;
  Triangulation tri =
      timed(run, [&] { return moves::simplified(run.input.triangulation, run.simplify, context.progress); });
  Info info = info_of(tri, run.input.name, context);
  return simplified_result(options, run, std::move(tri), std::move(info));
}

Json boundary_map(const moves::Truncation& made) {
  Json list = Json::array();
  for (std::size_t k = 0; k < made.boundary.size(); ++k) {
    const moves::BoundaryImage& b = made.boundary[k];
    const bool filled = b.vertex.tet < 0;
    list.push_back({{"input_component", k},
                    {"type", b.type.str()},
                    {"triangles", b.triangles},
                    {"vertex", filled ? Json() : Json{b.vertex.tet, b.vertex.vertex}}});
  }
  return list;
}

Result truncate(const SimplifyArguments& options, const Context& context) {
  Job run = prepare(options, context);
  if (!options.log.empty()) run.simplify.log = &run.log;
  moves::TruncateOptions how;
  how.keep_spheres = options.keep_spheres;
  how.simplify = run.simplify;
  moves::Truncation made =
      timed(run, [&] { return moves::truncate(run.input.triangulation, how, context.progress); });
  Info info = info_of(made.tri, run.input.name, context);
  info.json["boundary_map"] = boundary_map(made);
  info.json["finite_vertices"] = made.finite_vertices;
  Json steps = Json::array();
  std::vector<std::pair<std::string, std::string>> rows;
  for (const moves::TruncateStep& s : made.steps) {
    steps.push_back(
        {{"name", s.name}, {"tetrahedra", s.tetrahedra}, {"vertices", s.vertices}, {"edges", s.edges}});
    rows.emplace_back(rows.empty() ? "steps" : "", counted(s.tetrahedra, "tetrahedron") + ", " +
                                                       counted(s.vertices, "vertex") + ": " + s.name);
  }
  info.json["steps"] = std::move(steps);
  for (std::size_t k = 0; k < made.boundary.size(); ++k) {
    const moves::BoundaryImage& b = made.boundary[k];
    rows.emplace_back("component " + std::to_string(k),
                      b.type.str() + (b.vertex.tet < 0
                                          ? ", filled in"
                                          : ", at vertex " + std::to_string(b.vertex.vertex) +
                                                " of tetrahedron " + std::to_string(b.vertex.tet)));
  }
  info.rows.insert(info.rows.begin(), rows.begin(), rows.end());
  Result result = simplified_result(options, run, std::move(made.tri), std::move(info));
  if (made.finite_vertices > 0)
    result.warnings.push_back("the result has " + counted(made.finite_vertices, "finite vertex") +
                              ", because there is no other boundary to truncate at");
  return result;
}

} // namespace

Run declare_simplify(OptionTable& table) {
  const auto options = std::make_shared<SimplifyArguments>();
  table.add("X", options->input, "a triangulation or a mesh").required();
  table.add("--keep-boundary", options->keep_boundary,
            "leave the triangles of the real boundary as they are");
  declare_shared(table, *options);
  return [options](const Context& context) { return simplify(*options, context); };
}

Run declare_truncate(OptionTable& table) {
  const auto options = std::make_shared<SimplifyArguments>();
  table
      .add("MESH", options->input, "a mesh of tetrahedra, a closed surface, or a triangulation with boundary")
      .required();
  table.add("--keep-spheres", options->keep_spheres, "truncate boundary spheres instead of filling them in");
  declare_shared(table, *options);
  return [options](const Context& context) { return truncate(*options, context); };
}

} // namespace tetrarch::program
