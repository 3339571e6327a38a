# Run at every build: writes OUTPUT from TEMPLATE if a fact has changed. ROOT: the source tree.
# METHODS: the folders of the methods; LIBRARIES: "name=version" items; both separated by commas. Facts that do not
# exist (no git) stay empty.

find_package(Git QUIET)
set(COMMIT "$Format:%H$")  # in the tarball of a release, where .gitattributes has git fill it in
set(DIRTY false)
if(COMMIT MATCHES "^.Format")
  set(COMMIT "")
else()
  set(Git_FOUND FALSE)
endif()
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

# The folders of the methods; the other folders of methods/ are shared.
string(REPLACE "," ";" folders "${METHODS}")

# The reference solver (event_driven) changes every record; the other methods, reports and commands change those of others not.
set(other_methods ${folders})
list(REMOVE_ITEM other_methods event_driven)
list(JOIN other_methods "|" other_methods)
string(JOIN "|" readers "commands/" "compare/" "conformance/" "doctor/" "records/(manifest_check|merge|resume|run_folder|shards|status)"
                        "extend/scaffold/" "cluster/" "sweep/" "report/" "table" "progress")
hash_sources(common "^methods/(${other_methods}|plugin)/|^methods/catalogue\\.|^harness/(${readers})"
             ${ROOT}/problems/* ${ROOT}/methods/* ${ROOT}/harness/*)
set(SOURCE_ITEMS "{\"\", \"${common}\"}")
foreach(folder IN LISTS folders)
  hash_sources(own "^$" ${ROOT}/methods/${folder}/*)
  string(APPEND SOURCE_ITEMS ", {\"${folder}\", \"${own}\"}")
endforeach()

set(LIBRARY_ITEMS "")
string(REPLACE "," ";" LIBRARIES "${LIBRARIES}")
foreach(item IN LISTS LIBRARIES)
  string(REGEX REPLACE "^([^=]*)=(.*)$" "{\"\\1\", \"\\2\"}, " item "${item}")
  string(APPEND LIBRARY_ITEMS "${item}")
endforeach()

configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
