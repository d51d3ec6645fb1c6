// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A command for each of the triangulations in a file.
///
///     info knots.rga#*              is  info knots.rga#1,  info knots.rga#2,  ...
///     convert 'knots.rga#*' -o 'knot_*.tri'      and the * of other words is the number
///
/// The file is read once. What fails for one triangulation is told, and the others are done all the same.

#include "job.hpp"

#include "tetrarch/format/collection.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::program {

struct Mapping {
  std::vector<std::string> words;
  std::size_t at = 0; ///< the word that stands for all
  std::string path;   ///< its file
  format::Collection collection;
};

/// The mapping that a line means; nothing if no word ends in "#*" behind a file's name. Reads the file:
/// throws InputError as `format::read_all`, and where two words stand for all, or one file is to be written
/// by many.
std::optional<Mapping> mapping_in(const std::vector<std::string>& words);

/// The words of the line for element `number`, counted from 1.
std::vector<std::string> words_for(const Mapping& mapping, std::size_t number);

/// Runs every line, in order; with --json each gives one object on one line, which begins with its "input".
/// The status is that of the gravest: interrupted, a fault, bad input, undecided, no, done. Throws InputError
/// where the first line is no command line.
Status run_mapping(Mapping mapping, const std::vector<Command>& table, const std::string& program,
                   const Common& defaults, const Values* values, const std::string& speaker);

} // namespace tetrarch::program
