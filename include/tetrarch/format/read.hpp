// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Any triangulation file, recognised by what stands in it.
///
/// "{" begins a JSON document, "% orb" an Orb file and any other "%" a SnapPea file, "<" or gzip's mark a
/// Regina file, a line with nothing but a number, and more after it, a census record; a single word is an
/// isomorphism signature. Where that says nothing, the extension of the source does.

#include "tetrarch/format/document.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tetrarch::format {

enum class FileFormat { json, snappea, signature, fmp, regina, orb };

/// "json", "snappea", "signature", "fmp", "regina", "orb".
std::string name_of(FileFormat format);

/// The format of `text`; none where neither the text nor the extension of `source` tells. O(length).
std::optional<FileFormat> recognise(std::string_view text, const std::string& source);

/// .json, .tri, .sig and .txt (a signature), .fmp, .rga, .orb, in any case; none for other extensions.
std::optional<FileFormat> format_for_extension(std::string_view path);

/// The one triangulation in `text`. Throws InputError of one line that names place and cause; among them: an
/// empty text, no format that is known, a file with several triangulations, text after a signature.
/// O(length).
Document read_any(std::string_view text, const std::string& source);
/// The same of a file, or of standard input for "-".
Document read_document(const std::string& path);

/// Throws InputError where the format has no way to hold the triangulation, and for Regina's and Orb's, which
/// are read only.
Written write_any(const Document& document, FileFormat format);

} // namespace tetrarch::format
