// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// XML texts as trees, and their errors as ours.

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace tetrarch::format {

/// Throws InputError at the line where `text` is no XML.
pugi::xml_document parse_xml(std::string_view text, const std::string& source);

} // namespace tetrarch::format
