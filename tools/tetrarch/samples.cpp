// SPDX-License-Identifier: GPL-2.0-or-later
#include "samples.hpp"

#include "tetrarch/workshop/element.hpp"

#include <filesystem>

namespace tetrarch::program {

/// At the same place from the program in the build folder as where it was installed.
std::string samples_folder() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::string() : (program.parent_path() / TETRARCH_SAMPLES).lexically_normal().string();
}

std::string located(const std::string& argument) {
  return workshop::located(argument, samples_folder());
}

} // namespace tetrarch::program
