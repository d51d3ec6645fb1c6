// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "embedding.hpp"
#include "output.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/show/in_model.hpp"
#include "tetrarch/workshop/embed.hpp"

#include <memory>
#include <optional>

namespace tetrarch::program {
namespace {

using show::Body;
using show::ModelOptions;

struct EmbedArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string model = "half-space";
  std::optional<std::int64_t> copies;
  std::optional<int> word_length;
  std::optional<double> radius;
  std::optional<int> boundary;
  double chord_error = 0;
  double tube_radius = ModelOptions{}.tube_radius;
  double cusp_area = embed::DomainOptions{}.cusp_area;
  bool outside = false;
  std::string colors = "tetrahedron";
};

embed::PieceBounds wanted_bounds(const EmbedArguments& options) {
  if (options.copies && *options.copies < 1)
    throw InputError("--copies " + std::to_string(*options.copies) + ": expected at least 1");
  if (options.word_length && *options.word_length < 1)
    throw InputError("--word-length " + std::to_string(*options.word_length) + ": expected at least 1");
  if (options.radius && !(*options.radius > 0 && *options.radius <= 700))
    throw InputError("--radius " + format::to_text(*options.radius) +
                     ": expected a positive distance, at most 700");
  embed::PieceBounds bounds{options.copies.value_or(0), options.word_length.value_or(0),
                            options.radius.value_or(0)};
  if (!options.copies && !options.word_length && !options.radius) bounds.copies = 1;
  return bounds;
}

void require_output(const std::string& path) {
  if (!format::has_extension(path, ".svg") && !scene::scene_format_for_extension(path))
    throw InputError({path, 0}, "no picture has this extension (expected .glb, .ply, .obj, .vtu or .svg)");
}

/// The domain with its copies, or one boundary component with its own.
workshop::Embedding embedded(workshop::Placement at, const EmbedArguments& options,
                             const embed::PieceBounds& wanted, const Context& context) {
  const embed::PieceBounds bounds = allowed_bounds(wanted, allowed_gigabytes(context));
  const int components = at.boundary_count();
  if (options.boundary && (*options.boundary < 0 || *options.boundary >= components))
    throw InputError("--boundary " + std::to_string(*options.boundary) + ": " + at.name + " has " +
                     counted(components, "component") + ", counted from 0");
  workshop::Embedding found =
      workshop::embedding(std::move(at), {bounds, options.boundary}, context.progress);
  require_complete(found.piece, wanted, allowed_gigabytes(context));
  return found;
}

Body body_of(const workshop::Embedding& e) {
  const workshop::Placement& at = e.at;
  return e.lift ? show::body_of(at.skeleton, *e.lift, e.piece)
                : show::body_of(at.triangulation(), at.skeleton, at.domain, e.piece);
}

/// One of the names that are allowed.
ModelOptions::Colors colors_named(const std::string& name) {
  if (name == "face") return ModelOptions::Colors::face;
  return name == "word-length" ? ModelOptions::Colors::word_length : ModelOptions::Colors::tetrahedron;
}

ModelOptions model_options(const Body& body, const EmbedArguments& options) {
  ModelOptions how;
  how.model = *embed::model_named(options.model);
  how.chord_error = options.chord_error > 0 ? options.chord_error : extent(body, how.model) / 400;
  how.tube_radius = options.tube_radius;
  how.inner = !options.outside;
  how.colors = colors_named(options.colors);
  return how;
}

std::string picture(const std::string& path, const Body& body, const EmbedArguments& options,
                    const Context& context) {
  const ModelOptions how = model_options(body, options);
  if (format::has_extension(path, ".svg"))
    return write_svg(body.view == show::View::space ? circles_at_infinity(body) : drawing_of(body, how));
  require_memory(std::to_string(body.copies.size()) + " copies in " + path, scene_bytes(body, how),
                 allowed_gigabytes(context));
  return write_scene(in_model(body, how, context.progress), *scene::scene_format_for_extension(path));
}

Result run_embed(const EmbedArguments& options, const Context& context) {
  for (const std::string& path : options.outputs) require_output(path);
  const embed::PieceBounds wanted = wanted_bounds(options); // complains before anything is computed
  PlacedInput input = placed(options.input, options.cusp_area, context);
  const workshop::Embedding found = embedded(std::move(input.placement), options, wanted, context);
  Result result;
  result.warnings = std::move(input.warnings);
  for (const std::string& remark : found.remarks()) result.warnings.push_back(remark);
  result.text = block(rows_of(found));
  result.json = tree_of(found);
  if (options.outputs.empty()) return result;
  const Body body = body_of(found);
  for (const std::string& path : options.outputs)
    result.files.push_back({path, picture(path, body, options, context)});
  return result;
}

} // namespace

Run declare_embed(OptionTable& table) {
  const auto o = std::make_shared<EmbedArguments>();
  table.add("X", o->input, "a hyperbolic manifold; the structure is found first, as by hyperbolize")
      .required();
  table
      .add("-o,--output", o->outputs,
           "write a picture: .glb, .ply, .obj or .vtu; .svg for the circles at infinity or the tiling of a "
           "boundary; may be repeated")
      .output_file();
  table.add("--copies", o->copies, "greatest number of copies of the domain (1 if no option bounds them)");
  table.add("--word-length", o->word_length, "greatest number of face crossings to a copy");
  table.add("--radius", o->radius, "greatest distance to the center of a copy");
  table.add("--boundary", o->boundary,
            "unroll this boundary component or cusp in the plane, and show nothing else");
  table.add("--model", o->model, "model of hyperbolic space: half-space, ball or klein")
      .one_of({"half-space", "ball", "klein"})
      .with_default();
  table.add("--color", o->colors, "color the faces by tetrahedron, face or word-length")
      .one_of({"tetrahedron", "face", "word-length"})
      .with_default();
  table
      .add("--chord-error", o->chord_error,
           "greatest distance of a chord from its curve in the model (0: 1/400 of the size of the domain)")
      .with_default();
  table.add("--tube-radius", o->tube_radius, "hyperbolic radius of the tubes around edges (0: no tubes)")
      .with_default();
  table.add("--outside", o->outside, "omit the faces inside a copy");
  table.add("--cusp-area", o->cusp_area, "area of the cross-section that cuts a cusp off").with_default();
  return [o](const Context& context) { return run_embed(*o, context); };
}

} // namespace tetrarch::program
