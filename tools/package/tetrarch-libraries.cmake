# SPDX-License-Identifier: GPL-2.0-or-later
# tetrarch_library(NAME [REQUIRED]): the imported target tetrarch::NAME of a library that comes without a CMake
# package, where there is one. The build uses it and so does the installed configuration, which therefore names no
# place on the machine where Tetrarch was built.
function(tetrarch_library name)
  find_library(TETRARCH_${name}_LIBRARY ${name} ${ARGN})
  mark_as_advanced(TETRARCH_${name}_LIBRARY)
  if(TETRARCH_${name}_LIBRARY AND NOT TARGET tetrarch::${name})
    add_library(tetrarch::${name} UNKNOWN IMPORTED)
    set_target_properties(tetrarch::${name} PROPERTIES IMPORTED_LOCATION ${TETRARCH_${name}_LIBRARY})
  endif()
endfunction()
