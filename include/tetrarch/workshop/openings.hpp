// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface with its holes, ready to be mapped: those that it came with, and those that are made first.
///
///       .-----.                          .-----.
///      /       \      punched, sliced   /  (_)  \      loop 0 is the longest
///      |  ( )  |     ---------------->  |  ( )  |
///      \       /                        \   |   /
///       '-----'                          '-----'

#include "tetrarch/core/progress.hpp"
#include "tetrarch/surface/boundary_loops.hpp"
#include "tetrarch/surface/opened.hpp"
#include "tetrarch/surface/punch.hpp"
#include "tetrarch/workshop/fields.hpp"

#include <string>
#include <vector>

namespace tetrarch::workshop {

struct NumberedSurface;

/// What is cut out of a surface and cut open, in this order. Vertices go by their numbers.
struct Openings {
  std::vector<surface::RoundHole> punched;
  std::vector<std::vector<long long>> sliced; ///< each a path of shortest paths through these vertices
  bool handles = false;                       ///< cut open, along short loops
};

/// A surface, and its boundary loop by loop.
struct HoledSurface {
  surface::OpenedMesh opened;               ///< vertices are numbered as in the file, but from 0
  std::vector<surface::BoundaryLoop> loops; ///< by decreasing length

  const surface::TriangleMesh& mesh() const { return opened.mesh; }
};

/// The surface after such openings. Throws InputError as `surface::punch` and `surface::slice`, Stopped if
/// the progress says so. O(n log n) for each opening.
HoledSurface opened(const NumberedSurface& surface, const Openings& openings = {},
                    const Progress& progress = {});
/// The same of a surface that is open already.
HoledSurface opened(HoledSurface surface, const Openings& openings, const Progress& progress = {});

/// A line for each loop.
Rows rows_of(const HoledSurface& surface);
/// The same as text; a closed surface has "no boundary".
std::string text_of(const HoledSurface& surface);

template <>
const FieldList<HoledSurface>& fields_of<HoledSurface>();

} // namespace tetrarch::workshop
