// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What --json prints, as JSON Schemas (draft 2020-12): `tetrarch help --schema COMMAND`. They are made of
/// the lists of fields that results are printed from.

#include "command.hpp"

#include "tetrarch/workshop/fields.hpp"

#include <vector>

namespace tetrarch::program {

/// The members that every object of --json may have, whatever the command: input, name and passed_over.
const std::vector<workshop::FieldNote>& common_notes();

/// The members of the object of `error`, one line on standard error where --json is given.
const std::vector<workshop::FieldNote>& error_notes();

/// Of the object that the command prints. Throws InputError for a command that prints none.
Json schema_of(const Command& command);

/// Of each command that prints an object, by its name, in "commands"; of what is printed on standard error,
/// "error"; and of the lines of `shell --json`, "statement".
Json schemas_of(const std::vector<Command>& table);

} // namespace tetrarch::program
