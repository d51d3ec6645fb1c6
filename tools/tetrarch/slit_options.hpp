// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `slit` can be asked.

#include "doctor.hpp"
#include "options.hpp"
#include "slit_openings.hpp"

#include "tetrarch/workshop/slit.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

struct SlitArguments {
  std::string input;
  std::vector<std::string> outputs;
  std::string domain = "concentric";
  std::string outer;
  std::string inner;
  std::string center;
  std::string method = "harmonic";
  OpeningWords openings;
  bool list_loops = false;
  bool fingerprint = false;
  std::string distance;
  bool mirror = false;
  bool unflip = false;
  bool balance = false;
  bool allow_flips = false;
  bool intrinsic = false;
  int stage = -1;
  int basis = -1;
  int quads = 0;
  double quad_edge = 0;
  std::string corners;
  Doctor doctor;

  bool has_quads() const { return quads > 0 || quad_edge > 0; }
  bool is_rectangle() const { return domain == "rectangle"; }
  bool is_free() const { return domain == "free"; }
  /// Whether the map begins with round holes.
  bool is_circular() const { return domain == "circular" || is_free(); }
  bool is_ricci() const { return method == "ricci"; }
};

/// Puts them into the table.
void declare(OptionTable& table, SlitArguments& options);

/// Throws InputError for options that do not go together, and for outputs that cannot be.
void require_sense(const SlitArguments& options);

/// What is asked of the map of this surface. Throws InputError for loops and vertices that are not there, and
/// for a basis or a stage beyond the last.
workshop::MapOptions map_options(const SlitArguments& options, const workshop::HoledSurface& surface);

} // namespace tetrarch::program
