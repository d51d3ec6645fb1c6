# SPDX-License-Identifier: GPL-2.0-or-later
# Debian packages: `cpack -G DEB` in the build folder. Whoever uses the program needs none of the headers and -dev packages that
# whoever compiles against the library does, and neither needs Python's package, which is there if it was built.

# A project without an address of its own: whoever distributes packages gives theirs.
set(TETRARCH_MAINTAINER "Tetrarch maintainers <tetrarch@localhost>" CACHE STRING "Maintainer named in Debian packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${TETRARCH_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package begins with its own
set(CPACK_COMPONENTS_ALL program development)
if(TETRARCH_PYTHON_FOUND)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress.cmake)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tetrarch)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "tetgen, libtetrarch-dev")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "combinatorial topology of triangulated 3-manifolds
Tetrarch reads tetrahedral meshes of solids and triangulations of
3-manifolds, says what is wrong with them, and makes them small. It finds
homology and fundamental groups, hyperbolic structures with geodesic
boundary and cusps, their canonical decompositions, and the names of
manifolds in its census. It makes unit tangent bundles of surfaces, slit
maps and direct product parameterisations, and pages and pictures of all
of these.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtetrarch-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, tetrarch")
set(development_needs "libboost-dev (>= 1.74)" "nlohmann-json3-dev (>= 3.11)" libgmp-dev libmpfr-dev)
if(BUILD_SHARED_LIBS)
  list(APPEND development_needs "tetrarch (= ${PROJECT_VERSION})")
else()
  list(APPEND development_needs libpugixml-dev zlib1g-dev liblz4-dev liblzma-dev libsqlite3-dev libflint-dev libmpfi-dev)
  if(TARGET tetrarch::flint-arb)
    list(APPEND development_needs libflint-arb-dev)
  endif()
  if(cholmod_found)
    list(APPEND development_needs libsuitesparse-dev)
    if(TARGET tetrarch::openblas)
      list(APPEND development_needs libopenblas-dev)
    endif()
  endif()
endif()
list(JOIN development_needs ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "combinatorial topology of triangulated 3-manifolds - library
The library behind the program tetrarch, with its headers and a
configuration for CMake: find_package(tetrarch) gives the target
tetrarch::tetrarch.")

if(TETRARCH_PYTHON_FOUND)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tetrarch)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The compiled part is for one version of Python.
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-tqdm, python3-meshio, tetgen")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
      "combinatorial topology of triangulated 3-manifolds - Python
The package tetrarch: manifolds and triangulations as users of SnapPy and
Regina type them, meshes as arrays of NumPy, and every command of the
program tetrarch as a function.")
endif()

# Instead of the component "beside"; only packages get these.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} COMPONENT)
  set(texts ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${texts} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${texts} RENAME changelog COMPONENT ${component}
          EXCLUDE_FROM_ALL)
endforeach()
if(Python3_Interpreter_FOUND)
  install(FILES ${made}/_tetrarch DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program
          EXCLUDE_FROM_ALL)
endif()
include(CPack)
