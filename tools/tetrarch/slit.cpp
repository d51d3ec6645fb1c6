// SPDX-License-Identifier: GPL-2.0-or-later
#include "command.hpp"
#include "in_file.hpp"
#include "slit_files.hpp"
#include "slit_options.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/workshop/fingerprint.hpp"
#include "tetrarch/workshop/slit.hpp"

#include <memory>
#include <utility>

namespace tetrarch::program {
namespace {

/// Which option leads on from a surface that has no slit map.
std::string way_on(const SurfaceType& type) {
  if (!type.orientable) return {};
  if (type.genus() > 0) return "; --open-handles cuts it open";
  return type.boundary_curves == 0 ? "; --punch makes holes"
                                   : "; --domain circular maps it, --punch makes more holes";
}

bool asks_for_type(const SlitArguments& options) {
  return options.fingerprint || !options.distance.empty();
}

/// What the map would refuse, said before a loop is missed.
void check_type(const surface::Surface& surface, const SlitArguments& options, const std::string& path) {
  const bool one_is_enough = (options.is_circular() || options.is_rectangle()) && !asks_for_type(options);
  const std::string why = workshop::why_not_mapped(surface, one_is_enough ? 1 : 2);
  if (!why.empty()) throw InputError({path, 0}, why + way_on(surface::type_of(surface)));
}

/// Options that a surface with so many loops gives nothing to do.
void require_use(const SlitArguments& options, std::size_t loops) {
  const auto refuse = [&](const char* option, const char* why) {
    throw InputError({options.input, 0}, std::string(option) + ": " + why);
  };
  if (loops > 1 && !options.center.empty())
    refuse("--center", "the surface has several loops, and the inner one goes around 0 (--inner)");
  if (loops > 1) return;
  if (!options.outer.empty() && options.outer != "0" && options.outer.front() != 'v')
    refuse("--outer", "the surface has one loop");
  if (!options.inner.empty()) refuse("--inner", "the surface has one loop");
  if (options.basis >= 0) refuse("--basis", "the surface has one loop, and so no one-forms");
  if (options.stage >= 0) refuse("--stage", "the surface has one loop, and so no slits to open");
}

/// Adds the distance to the other surface.
void compare(workshop::ConformalType& own, const SlitArguments& options, Result& result,
             const Context& context) {
  const SurfaceInput input = read_surface(options.distance, context, options.doctor);
  workshop::HoledSurface other = workshop::opened(input);
  check_type(other.mesh().surface, options, options.distance);
  const workshop::ConformalType theirs =
      workshop::conformal_type(std::move(other), {options.distance, {}}, context.progress);
  own.comparison = workshop::comparison(own, theirs, options.mirror);
  result.warnings.insert(result.warnings.end(), input.warnings.begin(), input.warnings.end());
}

Result run_fingerprint(workshop::HoledSurface surface, const SlitArguments& options, Result result,
                       const Context& context) {
  workshop::FingerprintOptions how;
  how.name = options.input;
  if (!options.outer.empty() || !options.inner.empty())
    how.circles = circles_named(options.outer, options.inner, surface);
  workshop::ConformalType found = workshop::conformal_type(std::move(surface), how, context.progress);
  if (!options.distance.empty()) compare(found, options, result, context);
  result.status = status_of(found.verdict());
  result.text = block(rows_of(found));
  result.json = tree_of(found);
  return result;
}

Result run_map(workshop::HoledSurface surface, const SlitArguments& options, Result result,
               const Context& context) {
  const workshop::MapOptions how = map_options(options, surface);
  const workshop::ConformalMap found = workshop::conformal_map(std::move(surface), how, context.progress);
  if (found.impossible_quads)
    throw InputError("--quad-edge " + rounded(options.quad_edge) + ": this makes " +
                     rounded(*found.impossible_quads) +
                     " quads around the ring, and 3 to 1000000 are possible");
  result.status = status_of(found.verdict());
  workshop::Rows rows = rows_of(found);
  const auto [scale, shift] = std::pair(found.layout.texture_scale, found.layout.texture_shift);
  if (!options.outputs.empty())
    rows.emplace_back("texture",
                      "the domain times " + rounded(scale) + (shift == 0 ? "" : ", plus " + rounded(shift)));
  result.text = block(rows);
  result.json = tree_of(found);
  for (const std::string& remark : found.remarks()) result.warnings.push_back(remark);
  for (const std::string& path : options.outputs)
    result.files.push_back({path, slit_file(path, found, options.input)});
  if (context.values != nullptr) result.value = std::make_shared<Value>(slit_document(found, options.input));
  return result;
}

Result run_slit(const SlitArguments& options, const Context& context) {
  require_sense(options);
  const SurfaceInput input = read_surface(options.input, context, options.doctor);
  workshop::HoledSurface surface =
      in_file(options.input, [&] { return opened(input, options.openings, context.progress); });
  Result result;
  result.warnings = input.warnings;
  if (options.list_loops) {
    result.text = text_of(surface);
    result.json = tree_of(surface);
    return result;
  }
  check_type(surface.mesh().surface, options, options.input);
  require_use(options, surface.loops.size());
  return asks_for_type(options) ? run_fingerprint(std::move(surface), options, std::move(result), context)
                                : run_map(std::move(surface), options, std::move(result), context);
}

} // namespace

Run declare_slit(OptionTable& table) {
  const auto options = std::make_shared<SlitArguments>();
  declare(table, *options);
  return [options](const Context& context) { return run_slit(*options, context); };
}

} // namespace tetrarch::program
