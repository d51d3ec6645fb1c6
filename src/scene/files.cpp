// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/scene/files.hpp"

#include "elements.hpp"
#include "writers.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

namespace tetrarch::scene {

std::optional<SceneFormat> scene_format_for_extension(std::string_view path) {
  if (format::has_extension(path, ".ply")) return SceneFormat::ply;
  if (format::has_extension(path, ".obj")) return SceneFormat::obj;
  if (format::has_extension(path, ".glb")) return SceneFormat::glb;
  if (format::has_extension(path, ".vtu")) return SceneFormat::vtu;
  return std::nullopt;
}

std::string write_scene(const Scene& scene, SceneFormat format) {
  require_sound(scene);
  switch (format) {
  case SceneFormat::ply:
    return write_ply(scene);
  case SceneFormat::obj:
    return write_obj(scene);
  case SceneFormat::glb:
    return write_glb(scene);
  case SceneFormat::vtu:
    return write_vtu(scene);
  }
  throw PreconditionError("no such scene format");
}

} // namespace tetrarch::scene
