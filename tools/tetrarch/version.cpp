// SPDX-License-Identifier: GPL-2.0-or-later
#include "version.hpp"

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <flint/flint.h>
#include <gmp.h>
#include <lz4.h>
#include <lzma.h>
#include <mpfi.h>
#include <mpfr.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <zlib.h>
#ifdef TETRARCH_HAS_CHOLMOD
#include <cholmod.h>
#endif
#ifdef TETRARCH_HAS_LIBEDIT
#include <histedit.h>
#endif

namespace tetrarch::program {
namespace {

std::string dotted(int a, int b, int c) {
  return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
}

/// Those that the program can be built without.
std::string optional_libraries() {
  std::string text;
#ifdef TETRARCH_HAS_CHOLMOD
  text += ", CHOLMOD " + dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION);
#endif
#ifdef TETRARCH_HAS_LIBEDIT
  text += ", libedit " + std::to_string(LIBEDIT_MAJOR) + "." + std::to_string(LIBEDIT_MINOR);
#endif
  return text;
}

} // namespace

std::string version_text() {
  return "tetrarch " TETRARCH_VERSION " (" TETRARCH_BUILD_TYPE ")\n"
         "Boost " +
         dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100) + ", Eigen " +
         dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) + ", GMP " + gmp_version +
         ", MPFR " + mpfr_get_version() + ", MPFI " + mpfi_get_version() +
         ", FLINT " FLINT_VERSION ", nlohmann-json " +
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH) +
         ", CLI11 " CLI11_VERSION ", pugixml " +
         dotted(PUGIXML_VERSION / 1000, PUGIXML_VERSION / 10 % 100, PUGIXML_VERSION % 10) + ", zlib " +
         zlibVersion() + ", LZ4 " + LZ4_versionString() + ", liblzma " + lzma_version_string() +
         optional_libraries();
}

} // namespace tetrarch::program
