// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a session can give a name to.

#include "tetrarch/format/document.hpp"
#include "tetrarch/format/group_json.hpp"
#include "tetrarch/format/mesh_json.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

namespace tetrarch::program {

/// A triangulation (with its metric, if it has one), a mesh or surface (with its fields), a group.
using Value = std::variant<format::Document, format::MeshDocument, format::GroupDocument>;

/// Values never change; a name may come to mean another one.
using ValuePointer = std::shared_ptr<const Value>;
using Values = std::map<std::string, ValuePointer, std::less<>>;

/// "triangulation", "mesh", "surface" or "group".
std::string kind_of(const Value& value);

/// A letter or underscore, then letters, digits, underscores.
bool is_name(std::string_view text);

} // namespace tetrarch::program
