# Run when the test program PROGRAM has been built: writes OUTPUT, a file of ctest with one entry per suite, its cases in
# one process. Entries begin in the order of their cases, the largest first, for none to be left alone at the end.
# PROPERTIES are those of each entry.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\n$" "" listed "${listed}")
string(REPLACE ";" "," listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")
set(script "")

macro(end_suite)
  if(cases GREATER 0)
    string(APPEND script "add_test([=[${suite}]=] \"${PROGRAM}\" [=[--gtest_filter=${suite}.*]=])\n"
                         "set_tests_properties([=[${suite}]=] PROPERTIES COST ${cases} ${PROPERTIES} SKIP_REGULAR_EXPRESSION [=["
                         "PASSED  \\] 0 tests\\.\n\\[  SKIPPED \\] [^\n]*\n(\\[  SKIPPED \\] [^\n]*\n)*$]=])\n")
  endif()
endmacro()

set(cases 0)
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.( |$)")
    end_suite()
    set(suite ${CMAKE_MATCH_1})
    set(cases 0)
  elseif(line MATCHES "^  ")
    math(EXPR cases "${cases} + 1")
  endif()
endforeach()
end_suite()
file(WRITE ${OUTPUT} "${script}")
