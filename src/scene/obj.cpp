// SPDX-License-Identifier: GPL-2.0-or-later
#include "elements.hpp"
#include "writers.hpp"

#include "tetrarch/format/text.hpp"
#include "tetrarch/numeric/vector.hpp"

namespace tetrarch::scene {
namespace {

/// What a line takes at most on average; more only costs time.
constexpr std::size_t line_bytes = 48;

template <class Number, std::size_t dimension>
void append_vectors(std::string& out, const char* keyword,
                    const std::vector<std::array<double, dimension>>& vectors) {
  for (const auto& vector : vectors) {
    out += keyword;
    for (const double x : vector) {
      out += ' ';
      format::append_number(out, static_cast<Number>(x));
    }
    out += '\n';
  }
}

/// A name as one word: whoever reads the file may take a space for its end.
std::string one_word(std::string name, std::size_t element) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  return name.empty() ? "element_" + std::to_string(element) : name;
}

/// Points, textures and normals are counted from 1 through the whole file, each by themselves.
struct Counts {
  std::int64_t points = 1;
  std::int64_t textures = 1;
  std::int64_t normals = 1;
};

/// What every corner of the file names. Readers such as VTK's drop faces where corners differ in that.
struct Corners {
  bool textures = false;
  bool normals = false;
};

/// A surface without places in a texture has one place for all corners.
void append_triangles(std::string& out, const Surface& surface, const Counts& first, const Corners& named) {
  for (const auto& corners : surface.triangles) {
    out += 'f';
    for (const int corner : corners) {
      out += ' ';
      format::append_number(out, first.points + corner);
      if (!named.textures && !named.normals) continue;
      out += '/';
      if (named.textures)
        format::append_number(out, first.textures + (surface.textures.empty() ? 0 : corner));
      if (!named.normals) continue;
      out += '/';
      format::append_number(out, first.normals + corner);
    }
    out += '\n';
  }
}

} // namespace

std::string write_obj(const Scene& scene) {
  const AllSurfaces surfaces(scene);
  std::size_t lines = 0;
  Corners named;
  for (const Surface* s : surfaces.all) {
    named.textures = named.textures || !s->textures.empty();
    named.normals = named.normals || !s->normals.empty();
    lines += 1 + s->points.size() + s->textures.size() + s->normals.size() + s->triangles.size();
  }
  std::string out;
  out.reserve(lines * line_bytes);
  Counts first;
  for (std::size_t k = 0; k < surfaces.all.size(); ++k) {
    const Surface& surface = *surfaces.all[k];
    out += "o " + one_word(surface.name, k) + "\n";
    append_vectors<double>(out, "v", surface.points);
    append_vectors<double>(out, "vt", surface.textures);
    const bool lacks_texture = named.textures && surface.textures.empty();
    if (lacks_texture) out += "vt 0 0\n";
    append_vectors<float>(out, "vn", surface.normals);
    const bool lacks_normals = named.normals && surface.normals.empty();
    if (lacks_normals) append_vectors<float>(out, "vn", mean_normals(surface));
    append_triangles(out, surface, first, named);
    first.points += static_cast<std::int64_t>(surface.points.size());
    first.textures += static_cast<std::int64_t>(surface.textures.size()) + (lacks_texture ? 1 : 0);
    first.normals +=
        static_cast<std::int64_t>(lacks_normals ? surface.points.size() : surface.normals.size());
  }
  return out;
}

} // namespace tetrarch::scene
