# SPDX-License-Identifier: GPL-2.0-or-later
# bundle(VARIABLE FOLDER/main.js): the module main.js and all that it imports from, as one script. Each module becomes a
# function that is called once, after those that it needs. Imports and exports go by name and begin a line:
#
#     import { a, b } from './other.js';      const { a, b } = module_2;
#     export const c = ...                    const c = ...   and at the end   return { c };
#
# Whole lines of comment and the blanks that lines begin with are left out.

# A module's text without its exports; `names` are theirs, each with a comma.
function(strip_exports text_variable names_variable)
  set(text "${${text_variable}}")
  set(names "")
  string(REGEX MATCHALL "\nexport (const|function|class) [A-Za-z0-9_]+" exports "${text}")
  foreach(export IN LISTS exports)
    string(REGEX REPLACE ".* " "" name "${export}")
    string(APPEND names " ${name},")
  endforeach()
  string(REGEX REPLACE "\nexport (const|function|class) " "\n\\1 " text "${text}")
  set(${text_variable} "${text}" PARENT_SCOPE)
  set(${names_variable} "${names}" PARENT_SCOPE)
endfunction()

# Appends to `script` the module of this path, and before it those that it needs, unless they are there already. Sets
# `number` to the module's.
function(append_module page path)
  get_property(known GLOBAL PROPERTY "${page} ${path}")
  if(known STREQUAL "open")
    message(FATAL_ERROR "${path} needs itself, through what it imports from")
  elseif(known)
    set(number ${known} PARENT_SCOPE)
    return()
  endif()
  set_property(GLOBAL PROPERTY "${page} ${path}" open)
  file(READ ${path} text)
  get_filename_component(folder ${path} DIRECTORY)
  set(given "")
  string(REGEX MATCHALL "\nimport {[^}]*} from '[^']*'" imports "${text}")
  foreach(import IN LISTS imports)
    string(REGEX MATCH "{([^}]*)} from '([^']*)'" ignored "${import}")
    set(names "${CMAKE_MATCH_1}")
    get_filename_component(other "${folder}/${CMAKE_MATCH_2}" ABSOLUTE)
    append_module("${page}" ${other})
    string(APPEND given "const {${names}} = module_${number};\n")
  endforeach()
  string(REGEX REPLACE "\nimport {[^}]*} from '[^']*';" "" text "${text}")
  strip_exports(text made)
  if(text MATCHES "\n(import|export) ")
    message(FATAL_ERROR "${path} imports or exports in a way that bundle.cmake does not know")
  endif()
  get_property(number GLOBAL PROPERTY "${page}")
  math(EXPR number "0${number} + 1")
  set_property(GLOBAL PROPERTY "${page}" ${number})
  set_property(GLOBAL PROPERTY "${page} ${path}" ${number})
  set(script "${script}const module_${number} = (() => {\n${given}${text}return {${made} };\n})();\n" PARENT_SCOPE)
  set(number ${number} PARENT_SCOPE)
endfunction()

function(bundle variable path)
  set(script "")
  append_module("modules of ${path}" ${path})
  string(REGEX REPLACE "\n *//[^\n]*" "" script "\n${script}")
  string(REGEX REPLACE "\n[\n ]+" "\n" script "${script}")
  set(${variable} "(() => {${script}})();" PARENT_SCOPE)
endfunction()
