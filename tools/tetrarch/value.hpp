// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a session can give a name to.

#include "tetrarch/workshop/open.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

namespace tetrarch::program {

/// What the workshop opens.
using Value = workshop::Content;
using workshop::kind_of;

/// Values never change; a name may come to mean another one.
using ValuePointer = std::shared_ptr<const Value>;
using Values = std::map<std::string, ValuePointer, std::less<>>;

/// A letter or underscore, then letters, digits, underscores.
bool is_name(std::string_view text);

} // namespace tetrarch::program
