// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// XML texts as trees, and their errors as ours.

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throws InputError at the line where `text` is no XML. Without an `encoding` the text is UTF-8 whatever it
/// declares; `pugi::encoding_auto` believes the declaration and the byte order mark.
pugi::xml_document parse_xml(std::string_view text, const std::string& source,
                             pugi::xml_encoding encoding = pugi::encoding_utf8);

} // namespace tetrarch::format
