// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Any triangulation file, recognised by what stands in it.
///
/// "{" begins a JSON document, "% orb" an Orb file and any other "%" a SnapPea file, "<" a Regina file, a
/// line with nothing but a number, and more after it, a census record; a single word is an isomorphism
/// signature, and so is the first of a list. Where that says nothing, the extension of the source does. Any
/// of these may be compressed by gzip.

#include "tetrarch/format/collection.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::format {

enum class FileFormat { json, snappea, signature, fmp, regina, orb };

/// "json", "snappea", "signature", "fmp", "regina", "orb".
std::string name_of(FileFormat format);

/// The format of `text`; none where neither the text nor the extension of `source` tells. A gzip file counts
/// as Regina's, who packs by default. O(length).
std::optional<FileFormat> recognise(std::string_view text, const std::string& source);

/// .json, .tri, .sig and .txt (a signature), .fmp, .rga, .orb, in any case; none for other extensions.
std::optional<FileFormat> format_for_extension(std::string_view path);

/// All triangulations in `text`. Throws InputError as `read_any` does, but not for a single one of several
/// that is bad, nor for their number. O(length).
Collection read_all(std::string_view text, const std::string& source);
/// The one triangulation in `text`. Throws InputError of one line that names place and cause; among them: an
/// empty text, no format that is known, a file with several triangulations.
/// O(length).
Document read_any(std::string_view text, const std::string& source);
/// The same of a file, or of standard input for "-".
Document read_document(const std::string& path);

/// Throws InputError where the format has no way to hold the triangulation, and for Regina's and Orb's, which
/// are read only.
Written write_any(const Document& document, FileFormat format);

} // namespace tetrarch::format
