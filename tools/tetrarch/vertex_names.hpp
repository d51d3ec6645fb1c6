// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Vertices as people type them: v17 or 17, counted from 0 whatever the file counts from.

#include "tetrarch/core/error.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::program {

/// Of "v17" or "17"; none of other words.
std::optional<long long> vertex_in(std::string_view word);

/// Of "3,17,20". Throws InputError that names the option.
std::vector<long long> vertices_in(const char* option, const std::string& word);

/// What is wrong with the word after an option.
InputError refusal(const char* option, const std::string& word, const std::string& why);

} // namespace tetrarch::program
