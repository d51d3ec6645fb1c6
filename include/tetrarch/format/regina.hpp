// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Regina's data files (`.rga`), XML of its second or third generation, plain or compressed by gzip as Regina
/// writes them unless told otherwise. They are read only.
///
///     <reginadata ...>                                   <regina engine="7.3">
///     <packet typeid="3" label="figure eight">           <tri dim="3" size="2" perm="index"
///       <tetrahedra ntet="2">                                 label="figure eight">
///         <tet> 1 141 1 114 1 108 1 198 </tet>             <simplex> 1 11 1 13 1 5 1 15 </simplex>
///         <tet> 0 141 0 114 0 108 0 198 </tet>             <simplex> 0 11 0 13 0 5 0 15 </simplex>
///       </tetrahedra>                                    </tri>
///     </packet>                                          </regina>
///
/// Per tetrahedron and face 0 to 3: the neighbour (-1 on the boundary) and the gluing. Left, that is the
/// images of 0 to 3 in two bits each, from the lowest on; right, Regina's number of the permutation, which is
/// the rank (core/perm4.hpp) where that has the parity of the permutation, else the rank with its last bit
/// turned. SnapPea triangulations that Regina keeps as such are SnapPea files (format/snappea.hpp) inside of
/// an element `snappea` (left) or `snappeadata` (right). Packets of other kinds are passed over, by kind.
/// Found by looking at what Regina 7.3 writes and ships, and at its documentation of `Perm<4>::S4`.

#include "tetrarch/format/collection.hpp"

#include <string>
#include <string_view>

namespace tetrarch::format {

/// All triangulations of 3-manifolds in the file, by their labels, in its order. Of a gzip file all members
/// are read. Throws InputError where the text is no Regina file or packs far more than a text can; what is
/// wrong with one triangulation is told by its element. O(length).
Collection read_regina_packets(std::string_view text, const std::string& source);

/// The one triangulation in the file. Throws InputError also if there is none or there are several.
Document read_regina(std::string_view text, const std::string& source);

} // namespace tetrarch::format
