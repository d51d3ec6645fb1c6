// SPDX-License-Identifier: GPL-2.0-or-later
#include "output.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"

namespace tetrarch::program {

std::function<void(const std::string&)> with_extension(const std::string& extension) {
  return [extension](const std::string& path) {
    if (!format::has_extension(path, extension))
      throw InputError({path, 0},
                       "this command writes no file with this extension (expected " + extension + ")");
  };
}

void require_triangulation(const std::string& path) {
  output_format(path);
}

format::FileFormat output_format(const std::string& path) {
  if (const auto format = format::format_for_extension(path)) return *format;
  throw InputError({path, 0},
                   "no triangulation format has this extension (expected .json, .tri, .sig, .txt or .fmp)");
}

format::MeshFormat mesh_output_format(const std::string& path) {
  if (const auto format = format::mesh_format_for_extension(path)) return *format;
  throw InputError({path, 0}, "no mesh format has this extension");
}

void add_file(Result& result, const std::string& path, const format::Document& document) {
  format::Written written = format::write_any(document, output_format(path));
  result.warnings.insert(result.warnings.end(), written.warnings.begin(), written.warnings.end());
  result.files.push_back({path, std::move(written.text)});
}

} // namespace tetrarch::program
