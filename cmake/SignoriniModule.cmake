# Warnings, sanitizers and the two ways a target of this project is made.

add_library(signorini_warnings INTERFACE)
target_compile_options(signorini_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion)
# GCC 12 warns of overlaps inside its own std::string (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(signorini_warnings INTERFACE -Wno-restrict)
endif()

add_library(signorini_build INTERFACE)
set_target_properties(signorini_build PROPERTIES EXPORT_NAME build)
target_compile_features(signorini_build INTERFACE cxx_std_20)
target_include_directories(signorini_build INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/signorini>)
# Fused multiply-adds would make results differ between machines.
target_compile_options(signorini_build INTERFACE -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC collects no garbage below this heap [KiB]: a unit full of Eigen takes a sixth less time (docs/decisions/0017).
  target_compile_options(signorini_build INTERFACE $<BUILD_INTERFACE:--param=ggc-min-heapsize=1048576>)
endif()
set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # Eigen forms blocks of empty matrices at an offset from a null pointer, and reads nothing there.
  list(APPEND sanitizers -fno-sanitize=pointer-overflow)
endif()
if(SIGNORINI_SANITIZE)
  target_compile_options(signorini_build INTERFACE ${sanitizers})
  target_link_options(signorini_build INTERFACE -fsanitize=address,undefined)
endif()

# The headers that most files include, parsed once: a quarter of the time of a build. Tests add GoogleTest's. Off
# for lint, whose clang cannot read them. With the preset release eight to ten files at a time are compiled as one
# (CMAKE_UNITY_BUILD), which makes a fresh build half as long; of tests too, each in a namespace with its name. With lint
# units are larger (docs/decisions/0025): clang-tidy walks through the headers of each.
set(common_headers <Eigen/Dense> <Eigen/SparseCore> <algorithm> <cmath> <complex> <functional>
    <map> <memory> <numbers> <optional> <stdexcept> <string> <utility> <vector>)

# signorini_precompiled(NAME HEADERS ... LINK ...): a target whose precompiled headers others reuse.
function(signorini_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LINK")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} STATIC ${source})
  target_link_libraries(${name} PRIVATE signorini_build signorini_warnings ${arg_LINK})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# What reads the text of strangers, for a build with SIGNORINI_FUZZ: its branches tell the fuzzer that they were taken,
# and sanitizers watch it. The numerics below it stay as they are, which makes that build four times as fast; they have
# the sanitizers of the preset asan.
function(signorini_fuzzed target)
  if(SIGNORINI_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link ${sanitizers})
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# For libraries: a plugin may link them too. Hidden symbols keep the code as fast as without -fPIC, and the
# libraries inside one plugin out of the others' way.
function(signorini_position_independent target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# The kernels of dense products are compiled in problems alone, to which all that is made of these headers is linked.
signorini_precompiled(signorini_precompiled
  HEADERS ${common_headers} ${PROJECT_SOURCE_DIR}/problems/linear_algebra/eigen_kernels.hpp LINK Eigen3::Eigen)
signorini_position_independent(signorini_precompiled)

# signorini_module(NAME SOURCES ... LINK ...): a static library with the alias signorini::NAME.
function(signorini_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;PRIVATE_LINK")
  add_library(signorini_${name} STATIC ${arg_SOURCES})
  add_library(signorini::${name} ALIAS signorini_${name})
  set_target_properties(signorini_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(signorini_${name} PUBLIC signorini_build ${arg_LINK}
                                          PRIVATE $<BUILD_INTERFACE:signorini_warnings> ${arg_PRIVATE_LINK})
  signorini_position_independent(signorini_${name})
  target_precompile_headers(signorini_${name} REUSE_FROM signorini_precompiled)
endfunction()

# signorini_method(NAME SOURCES ...): the method in the folder that calls this, methods/NAME. Its tests are in
# tests/methods/NAME, see signorini_method_test.
function(signorini_method name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES")
  target_sources(signorini_methods PRIVATE ${arg_SOURCES})
  set_property(GLOBAL APPEND PROPERTY SIGNORINI_METHODS ${name})
endfunction()

# Of test programs and of their precompiled headers, which must agree.
set(signorini_test_options $<$<CONFIG:Release>:-O0>)

# signorini_test_program(TARGET): the executable TARGET consists of GoogleTest's cases. They are compiled without optimisation, in
# two thirds of the time. What they test is optimised, and so are the functions that both instantiate: of several copies the
# linker takes the first, and our libraries come first, whole.
function(signorini_test_program target)
  get_target_property(linked ${target} LINK_LIBRARIES)
  set(libraries signorini_problems)
  if(signorini_test_support IN_LIST linked)
    list(PREPEND libraries signorini_methods signorini_numerics)
  endif()
  if(signorini::harness IN_LIST linked)
    list(PREPEND libraries signorini_harness)
  endif()
  list(TRANSFORM libraries REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  list(JOIN libraries " " libraries)
  target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive ${libraries} -Wl,--no-whole-archive")
  target_link_libraries(${target} PRIVATE signorini_warnings GTest::gtest_main)
  target_precompile_headers(${target} REUSE_FROM signorini_precompiled_tests)
  target_compile_options(${target} PRIVATE ${signorini_test_options})
endfunction()

# signorini_test(NAME SOURCES ... LINK ... [LABELS ...] [SLOW Suite.Case ...]): a GoogleTest program whose suites ctest knows one by
# one, of slow ones the cases. SLOW names cases, Suite.* for all of one, that are labelled slow in a program that is not.
function(signorini_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;LABELS;SLOW")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK})
  signorini_test_program(${name})
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  # The cases of slow ones side by side; where ctest has not run them yet they begin first: none is left alone at the end.
  if(slow IN_LIST arg_LABELS)
    gtest_discover_tests(${name} PROPERTIES LABELS "${arg_LABELS}" COST 100 TIMEOUT 600 DISCOVERY_TIMEOUT 60)
    return()
  endif()
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  add_custom_command(TARGET ${name} POST_BUILD BYPRODUCTS ${list}
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}> -DOUTPUT=${list}
            "-DPROPERTIES=LABELS [=[${arg_LABELS}]=] TIMEOUT 600" "-DSLOW=${arg_SLOW}" -P ${PROJECT_SOURCE_DIR}/cmake/discover_suites.cmake
    VERBATIM)
  # Until it is built, its tests are one that fails.
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake)
  file(WRITE ${include} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()

# signorini_method_test(NAME SOURCES ... [LINK ...] [LABELS ...]): the tests of the method NAME, test_method_NAME, in the
# folder that calls this, tests/methods/NAME.
function(signorini_method_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;LABELS")
  signorini_test(test_method_${name} SOURCES ${arg_SOURCES} LINK signorini::methods signorini_test_support ${arg_LINK}
                 LABELS ${arg_LABELS})
endfunction()

# signorini_unity_rooms(TARGET ["FOLDER FOLDER ..." ...]): a unity build of TARGET compiles one unit per folder; the
# folders of a list are one unit together. What is dear to include is so paid once by the folder that uses it.
function(signorini_unity_rooms target)
  foreach(list IN LISTS ARGN)
    string(REGEX MATCH "^[^ ]+" first "${list}")
    string(REPLACE " " ";" folders "${list}")
    foreach(folder IN LISTS folders)
      set(unit_of_${folder} ${first})
    endforeach()
  endforeach()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    if(NOT IS_ABSOLUTE "${source}")
      if(DEFINED unit_of_${folder})
        set(folder ${unit_of_${folder}})
      endif()
      string(REPLACE "/" "_" unit "${folder}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "room_${unit}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# signorini_unity_batches(TARGET SIZE UNITS "FILE FILE ..." ... ALONE FILE ...): a unity build of TARGET compiles the files of each list as
# one unit, those of ALONE one by one, and the others SIZE at a time in the order of TARGET's sources.
function(signorini_unity_batches target size)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "UNITS;ALONE")
  get_target_property(others ${target} SOURCES)
  list(REMOVE_ITEM others ${arg_ALONE})
  foreach(unit IN LISTS arg_UNITS)
    string(REPLACE " " ";" files "${unit}")
    list(GET files 0 first)
    string(MAKE_C_IDENTIFIER "unit_${first}" group)
    set_source_files_properties(${files} PROPERTIES UNITY_GROUP ${group})
    list(REMOVE_ITEM others ${files})
  endforeach()
  set(count 0)
  foreach(source IN LISTS others)
    math(EXPR batch "${count} / ${size}")
    math(EXPR count "${count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "batch_${batch}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
