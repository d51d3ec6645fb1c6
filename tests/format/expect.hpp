// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the tests of this room share: the message of an error, the fixtures, a directory of one's own.

#include "support/errors.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/read.hpp"
#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace tetrarch::format::test {

using support::error_of;

/// The message about what should be a triangulation.
inline std::string complaint(const std::string& text, const std::string& source = "f") {
  return error_of([&] { read_any(text, source); });
}

inline std::string data(const std::string& name) {
  return std::string(TETRARCH_SOURCE_DIR) + "/tests/data/format/" + name;
}

/// The files of a folder of fixtures, by name.
inline std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(data(folder)))
    paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// All files below a folder, by name.
inline std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// An empty directory that disappears with its owner.
class Scratch {
public:
  Scratch()
      : path_(std::filesystem::temp_directory_path() / ("tetrarch-format-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// How many entries there are.
  long count() const {
    return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
  }

private:
  std::filesystem::path path_;
};

/// `text` with its only occurrence of `from` replaced; a test that finds none is itself wrong.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    throw std::logic_error("'" + from + "' should occur once");
  return text.replace(at, from.size(), to);
}

} // namespace tetrarch::format::test
