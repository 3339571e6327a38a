# Run at every build: writes OUTPUT if a header that plugins include has changed. ROOT: the source tree.
file(GLOB_RECURSE headers LIST_DIRECTORIES false RELATIVE ${ROOT} ${ROOT}/problems/*.hpp ${ROOT}/methods/*.hpp)
list(SORT headers)
set(text "")
foreach(header IN LISTS headers)
  file(SHA256 ${ROOT}/${header} hash)
  string(APPEND text "${header} ${hash}\n")
endforeach()
string(SHA256 hash "${text}")
string(SUBSTRING ${hash} 0 16 hash)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
// Written at every build: SHA-256 of the headers of problems/ and methods/.
#define SIGNORINI_HEADERS \"${hash}\"
")
