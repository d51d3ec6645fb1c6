// SPDX-License-Identifier: GPL-2.0-or-later
#include "samples.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

namespace tetrarch::program {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "samples/";

/// At the same place from the program in the build folder as where it was installed; nothing on a system that
/// does not say where a running program lies.
fs::path samples_folder() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : (program.parent_path() / TETRARCH_SAMPLES).lexically_normal();
}

std::string names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

} // namespace

std::string located(const std::string& argument) {
  std::error_code ignored;
  if (!argument.starts_with(prefix) || fs::exists(argument, ignored)) return argument;
  const fs::path folder = samples_folder();
  const fs::path sample = folder / argument.substr(prefix.size());
  if (fs::is_regular_file(sample, ignored)) return sample.string();
  const std::string names = names_in(folder);
  throw InputError({argument, 0}, names.empty()
                                      ? "no such file, and no samples are installed in " + folder.string()
                                      : "no such file, and no such sample (expected one of " + names + ")");
}

} // namespace tetrarch::program
