# SPDX-License-Identifier: GPL-2.0-or-later
# README.md and the guide as they are installed, in FOLDER and FOLDER/guide:
#   cmake "-DTEXTS=README.md;overview.md;domain.png;..." -DFOLDER=texts -P texts.cmake
# From there the guide, the census tables and the samples lie elsewhere than in the source tree.
file(REMOVE_RECURSE ${FOLDER})
foreach(path IN LISTS TEXTS)
  get_filename_component(name ${path} NAME)
  if(NOT name MATCHES "[.]md$")
    file(COPY ${path} DESTINATION ${FOLDER}/guide)
    continue()
  endif()
  file(READ ${path} text)
  string(REPLACE "](tools/guide/" "](guide/" text "${text}")
  string(REPLACE "\"tools/guide/" "\"guide/" text "${text}")
  string(REPLACE "](../../census/" "](../../../tetrarch/census/" text "${text}")
  string(REGEX REPLACE "[]][(][./]*tests/data/[a-z0-9_/]*/([a-z0-9_]+[.][a-z]+)" "](../../../tetrarch/samples/\\1" text "${text}")
  string(REGEX REPLACE "tests/data/(mesh/|frozen/1/|)([a-z0-9_]+[.][a-z]+)" "samples/\\2" text "${text}")
  if(name STREQUAL "README.md" AND NOT path MATCHES "/guide/")
    file(WRITE ${FOLDER}/README.md "${text}")
  else()
    file(WRITE ${FOLDER}/guide/${name} "${text}")
  endif()
endforeach()
