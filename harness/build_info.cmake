# Run at every build: writes OUTPUT from TEMPLATE if a fact has changed. ROOT: the source tree.
# LIBRARIES: "name=version" items. Facts that do not exist (no git) stay empty.

find_package(Git QUIET)
set(COMMIT "")
set(DIRTY false)
if(Git_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${ROOT} rev-parse HEAD OUTPUT_VARIABLE COMMIT
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${ROOT} status --porcelain -- problems methods harness cmake
                          CMakeLists.txt
                  OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT "${changes}" STREQUAL "")
    set(DIRTY true)
  endif()
endif()

# The hash of every source below the given folders, except those matching `without`.
function(hash_sources result without)
  set(text "")
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${ROOT} ${ARGN})
  list(SORT files)
  foreach(file IN LISTS files)
    if(NOT file MATCHES "\\.(cpp|hpp)$" OR file MATCHES "${without}")
      continue()
    endif()
    file(SHA256 ${ROOT}/${file} hash)
    string(APPEND text "${file} ${hash}\n")
  endforeach()
  string(SHA256 hash "${text}")
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

# Reports, commands and what reads runs do not change a record; the reference solver (event_driven) changes all of them.
hash_sources(common "^harness/(commands/|compare/|conformance/|machine/|runs/|scaffold/|submit/|sweep/|report|table|progress)" ${ROOT}/problems/* ${ROOT}/harness/*
             ${ROOT}/methods/kernels/* ${ROOT}/methods/event_driven/* ${ROOT}/methods/method.*
             ${ROOT}/methods/options.* ${ROOT}/methods/solution.hpp)
set(SOURCE_ITEMS "{\"\", \"${common}\"}")
file(GLOB folders LIST_DIRECTORIES true RELATIVE ${ROOT}/methods ${ROOT}/methods/*)
list(SORT folders)
foreach(folder IN LISTS folders)
  if(IS_DIRECTORY ${ROOT}/methods/${folder} AND NOT folder MATCHES "^(kernels|plugin)$")
    hash_sources(own "^$" ${ROOT}/methods/${folder}/*)
    string(APPEND SOURCE_ITEMS ", {\"${folder}\", \"${own}\"}")
  endif()
endforeach()

set(LIBRARY_ITEMS "")
string(REPLACE "," ";" LIBRARIES "${LIBRARIES}")
foreach(item IN LISTS LIBRARIES)
  string(REGEX REPLACE "^([^=]*)=(.*)$" "{\"\\1\", \"\\2\"}, " item "${item}")
  string(APPEND LIBRARY_ITEMS "${item}")
endforeach()

configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
