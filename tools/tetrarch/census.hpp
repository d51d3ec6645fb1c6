// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the commands of the census share.

#include "json.hpp"
#include "options.hpp"

#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/workshop/fields.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

/// An entry as programs read it.
Json manifold_json(const catalogue::Manifold& m);

/// The members of that.
std::vector<workshop::FieldNote> fields_of_manifold();

/// A stored volume rounded to twelve decimals.
std::string shortened(const std::string& volume);

/// `--tetrahedra N`.
Option& add_tetrahedra(OptionTable& table, Target number);
/// `--nonorientable`, for tables.
void add_nonorientable(OptionTable& table, bool& wanted);

/// Which table a command is about.
struct TableChoice {
  int tetrahedra = 3;
  bool nonorientable = false;

  catalogue::TableKey key() const { return {tetrahedra, !nonorientable}; }
};
/// `--tetrahedra N` and `--nonorientable`.
void add_table_choice(OptionTable& table, TableChoice& choice, bool required);

/// The table in a file, packed by xz or not. Throws InputError.
std::vector<catalogue::Manifold> read_table_file(const std::string& path);

} // namespace tetrarch::program
