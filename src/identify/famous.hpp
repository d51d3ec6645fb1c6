// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cusped manifolds that topologists know by name. (The tests compute their signatures anew, from other
/// triangulations.)

#include <array>
#include <string_view>

namespace tetrarch::identify::detail {

struct Famous {
  std::string_view isometry_signature;
  std::string_view signature;              ///< of a smallest ideal triangulation
  std::string_view name;                   ///< as `identify` prints it
  std::array<std::string_view, 4> aliases; ///< the census's, the knot and link tables'; empty: no more
};

inline constexpr std::array<Famous, 6> famous{{
    {"bkaaid", "bkaaid", "Gieseking manifold (m000)", {"m000", "Gieseking manifold"}},
    {"cPcbbbdxm", "cPcbbbdxm", "figure-eight sister (m003)", {"m003", "figure-eight sister"}},
    {"cPcbbbiht",
     "cPcbbbiht",
     "figure-eight knot complement (m004)",
     {"m004", "figure-eight knot complement", "4_1"}},
    {"eLPkbcdddhggcv", "dLQbcccdero", "5_2 knot complement (m015)", {"m015", "5_2 knot complement", "5_2"}},
    {"eLPkbdcddhgggb",
     "eLPkbdcddhgggb",
     "Whitehead link complement (m129)",
     {"m129", "Whitehead link complement", "5^2_1", "L5a1"}},
    {"WvLvvMvzAzwvAwAQzvPPAQvQMPMMMMQPQdglliqqtxwoyBytADHGwzGzBJEK"
     "LMIIGJJMOSNSOUQRUVTVVUoaaooaaaaaooaooaaaaooaoaaoooaoooooaaaaooaooaaaaoo",
     "iLLLQPcceefgghhhddaaadada",
     "Borromean rings complement",
     {"Borromean rings", "6^3_2", "L6a4"}},
}};

} // namespace tetrarch::identify::detail
