// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One of the triangulations in a file that holds several.
///
///     knots.rga#3          the third, counted from 1
///     knots.rga#fig8       the one called fig8
///     knots.rga#*          all: what is to be done is done once for each

#include "tetrarch/format/collection.hpp"

#include <optional>
#include <string>

namespace tetrarch::workshop {

/// The folder of the files that came with a program, if there are such: "samples/torus.off" is torus.off
/// there, unless it is a file as it stands.
using Samples = std::optional<std::string>;

/// Where the file that an argument names lies. Throws InputError, with the list of samples, for a sample that
/// is not there.
std::string located(const std::string& argument, const Samples& samples);
/// Whether the argument is "-" or names what exists in the file system, or a sample.
bool is_file(const std::string& argument, const Samples& samples = std::nullopt);

/// A file and which of its triangulations is meant.
struct FileElement {
  std::string path;
  std::string element; ///< "3", "fig8", "*"
};

/// What stands before and after the first # before which a file is named. Nothing if there is none such, or
/// if the whole argument is a file's name.
std::optional<FileElement> file_element(const std::string& argument, const Samples& samples = std::nullopt);

/// All triangulations of a file. Throws InputError as `format::read_all`.
format::Collection read_collection(const std::string& path, const Samples& samples = std::nullopt);

/// The element that is meant: its number, else its name, else the only name that begins so. The ledger of the
/// file is added to its own. Throws InputError that names `argument` if there is none or no telling which.
format::Document chosen(format::Collection collection, const std::string& element,
                        const std::string& argument);

} // namespace tetrarch::workshop
