# signorini_add_plugin(NAME SOURCES FILE... [LINK TARGET...]): NAME.so, a plugin for `signorini --plugin NAME.so`.
# Without a build type it is optimised as the program is.
function(signorini_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "signorini_add_plugin(${name}): usage: NAME SOURCES FILE... [LINK TARGET...]")
  endif()
  add_library(${name} MODULE ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE signorini::methods ${arg_LINK})
  target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O2> $<$<CONFIG:>:-DNDEBUG>)
  # Hidden: nothing of one plugin is taken for that of another. No symbol may be left open until it is called.
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_options(${name} PRIVATE -Wl,--exclude-libs,ALL)
  if(NOT (SIGNORINI_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)) # there the program has the sanitizers' functions
    target_link_options(${name} PRIVATE -Wl,--no-undefined)
  endif()
endfunction()
