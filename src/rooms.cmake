# SPDX-License-Identifier: GPL-2.0-or-later
# tetrarch_room(NAME FLOOR n [PUBLIC room...] [PRIVATE room...] [LIBRARIES target...] [PARSED set]) makes a room: the object
# library tetrarch_NAME of src/NAME/*.cpp, which sees the public headers of the rooms it declares and no others. The libraries
# are those that not every room has; the set is one of those that are parsed once, see below.
#
# All public headers lie under include/tetrarch. What one room sees of them is a folder of links in the build tree:
#
#     rooms/product/tetrarch/core     -> include/tetrarch/core
#     rooms/product/tetrarch/product  -> include/tetrarch/product
#     rooms/product/tetrarch/doctor/build.hpp  -> include/tetrarch/doctor/build.hpp
#                                   tetrarch/format/soup.hpp  -> ...
#
# Headers of doctor include headers of format, which product does not declare. A quoted #include is sought beside the file
# that says it first, so that a folder "tetrarch" beside the headers of doctor shows them format, and nobody else. It is
# the compiler alone that sees these folders: no target of a room waits for another, and users have include/.
set(rooms_folder ${PROJECT_BINARY_DIR}/rooms)
file(REMOVE_RECURSE ${rooms_folder})

# Shows the headers of `room` as `folder`, and beside them those rooms of `hidden` which they include.
function(show_room room folder hidden)
  set(headers ${PROJECT_SOURCE_DIR}/include/tetrarch/${room})
  set(beside ${TETRARCH_PUBLIC_${room}})
  list(REMOVE_ITEM beside ${TETRARCH_SHOWN})
  if(room IN_LIST hidden)
    list(APPEND beside ${room})
  endif()
  if(NOT beside)
    file(CREATE_LINK ${headers} ${folder} SYMBOLIC)
    return()
  endif()
  file(MAKE_DIRECTORY ${folder}/tetrarch)
  file(GLOB files CONFIGURE_DEPENDS ${headers}/*.hpp)
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME)
    file(CREATE_LINK ${file} ${folder}/${name} SYMBOLIC)
  endforeach()
  foreach(other IN LISTS beside)
    file(CREATE_LINK ${TETRARCH_HIDDEN_FOLDER}/${other} ${folder}/tetrarch/${other} SYMBOLIC)
  endforeach()
endfunction()

# The folder of links of one room, rooms/NAME. `uses` are the rooms it declares.
function(link_headers name uses)
  set(TETRARCH_SHOWN ${name} ${uses})
  set(TETRARCH_HIDDEN_FOLDER ${rooms_folder}/${name}/hidden)
  set(hidden "")
  set(reached ${TETRARCH_SHOWN})
  while(reached)
    list(POP_FRONT reached room)
    foreach(other IN LISTS TETRARCH_PUBLIC_${room})
      if(NOT other IN_LIST TETRARCH_SHOWN AND NOT other IN_LIST hidden)
        list(APPEND hidden ${other})
        list(APPEND reached ${other})
      endif()
    endforeach()
  endwhile()
  file(MAKE_DIRECTORY ${rooms_folder}/${name}/tetrarch)
  foreach(room IN LISTS TETRARCH_SHOWN)
    show_room(${room} ${rooms_folder}/${name}/tetrarch/${room} "")
  endforeach()
  foreach(room IN LISTS hidden)
    file(MAKE_DIRECTORY ${TETRARCH_HIDDEN_FOLDER})
    show_room(${room} ${TETRARCH_HIDDEN_FOLDER}/${room} "${hidden}")
  endforeach()
endfunction()

# How all rooms are compiled. A static library, too, may end in somebody's shared object. Nobody replaces single functions of
# ours there, so that calls between them may be inlined as ever. The same objects make a static and a shared library.
function(compile_as_room target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  target_link_libraries(${target} PRIVATE tetrarch_flags Boost::headers nlohmann_json::nlohmann_json tetrarch::mpfr
                        tetrarch::gmp Threads::Threads)
endfunction()

# Headers that are parsed once for many rooms: the standard library's, and with them those of a library that most files of a
# room include. A set costs three to five seconds; multiprecision saves half of what these rooms take. (Eigen's would save nothing:
# there it is the code made of it that takes the time.)
function(parse_once set)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/no_room.cpp CONTENT "")
  add_library(tetrarch_headers_${set} OBJECT ${PROJECT_BINARY_DIR}/no_room.cpp)
  compile_as_room(tetrarch_headers_${set})
  target_precompile_headers(tetrarch_headers_${set} PRIVATE ${TETRARCH_STANDARD_HEADERS} ${ARGN})
endfunction()
if(TETRARCH_PRECOMPILE)
  parse_once(standard)
  parse_once(multiprecision <boost/multiprecision/gmp.hpp> <boost/multiprecision/mpfr.hpp>)
endif()

function(tetrarch_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "FLOOR;PARSED" "PUBLIC;PRIVATE;LIBRARIES")
  if(DEFINED room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tetrarch_room(${name}): unknown word '${room_UNPARSED_ARGUMENTS}'")
  endif()
  foreach(other IN LISTS room_PUBLIC room_PRIVATE)
    if(NOT TARGET tetrarch_${other})
      message(FATAL_ERROR "tetrarch_room(${name}): there is no room '${other}' before it")
    endif()
  endforeach()
  set(TETRARCH_PUBLIC_${name} ${room_PUBLIC})
  set(TETRARCH_PUBLIC_${name} ${room_PUBLIC} PARENT_SCOPE)
  link_headers(${name} "${room_PUBLIC};${room_PRIVATE}")

  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  add_library(tetrarch_${name} OBJECT ${sources})
  target_include_directories(tetrarch_${name} PRIVATE ${rooms_folder}/${name})
  compile_as_room(tetrarch_${name})
  if(TETRARCH_PRECOMPILE)
    if(NOT TARGET tetrarch_headers_${room_PARSED})
      set(room_PARSED standard)
    endif()
    target_precompile_headers(tetrarch_${name} REUSE_FROM tetrarch_headers_${room_PARSED})
  endif()
  foreach(library IN LISTS room_LIBRARIES)
    if(TARGET ${library})
      target_link_libraries(tetrarch_${name} PRIVATE ${library})
    endif()
  endforeach()
  target_sources(tetrarch PRIVATE $<TARGET_OBJECTS:tetrarch_${name}>)
  set_property(GLOBAL APPEND PROPERTY TETRARCH_ROOMS ${name})
  set_property(GLOBAL PROPERTY TETRARCH_USES_${name} ${room_PUBLIC} ${room_PRIVATE})
endfunction()
