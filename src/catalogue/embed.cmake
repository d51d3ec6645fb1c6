# SPDX-License-Identifier: GPL-2.0-or-later
# Turns the census tables into a source file:
# cmake -DTABLES=a.json;b.json -DCUSPED=c.txt -DGRAPHS=d.json -DOUTPUT=file.cpp -P embed.cmake
set(text "// Generated from census/.\n#include \"tables.hpp\"\nnamespace tetrarch::catalogue::detail {\n")
string(APPEND text "const std::vector<std::string_view>& embedded_tables() {\n  static const std::vector<std::string_view> tables{\n")
foreach(table IN LISTS TABLES)
  file(READ ${table} content)
  string(APPEND text "R\"table(${content})table\",\n")
endforeach()
string(APPEND text "};\n  return tables;\n}\n")
foreach(table cusped graphs)
  string(TOUPPER ${table} path)
  file(READ ${${path}} content)
  string(APPEND text "std::string_view embedded_${table}() {\n  return R\"table(${content})table\";\n}\n")
endforeach()
string(APPEND text "} // namespace tetrarch::catalogue::detail\n")
file(WRITE ${OUTPUT} "${text}")
