# SPDX-License-Identifier: Apache-2.0
# Read by ctest when it starts: asks a GoogleTest executable for its tests and makes an entry of ctest for each suite, or for each test.
# A suite in one process is started once, and what its tests prepare is prepared once.
#
#   floor       part of the entries' names: FLOOR.SUITE or FLOOR.SUITE.TEST
#   program     the executable
#   filter      of its tests, as --gtest_filter takes it
#   each        ON: an entry for each test
#   label, cost, lock    properties of the entries
#   launcher    a command in front of the executable, or empty
execute_process(COMMAND env QT_QPA_PLATFORM=offscreen "${program}" --gtest_list_tests "--gtest_filter=${filter}"
    OUTPUT_VARIABLE listed ERROR_VARIABLE trouble RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} does not list its tests (${result}):\n${listed}${trouble}")
endif()
string(REGEX REPLACE "[^\n]*gtest_main\\.cc\n" "" listed "${listed}")
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")
string(REPLACE "\n" ";" listed "${listed}")
set(made)
foreach(line IN LISTS listed)
    set(entry)
    if(line MATCHES "^  +(.+)$")
        if(each)
            set(entry "${suite}.${CMAKE_MATCH_1}")
            set(pattern "${entry}")
        endif()
    elseif(line MATCHES "^(.+)\\.$")
        set(suite "${CMAKE_MATCH_1}")
        if(NOT each)
            set(entry "${suite}")
            set(pattern "${suite}.*")
        endif()
    endif()
    if(entry)
        add_test("${floor}.${entry}" ${launcher} "${program}" "--gtest_filter=${pattern}")
        list(APPEND made "${floor}.${entry}")
    endif()
endforeach()
if(made)
    set_tests_properties(${made} PROPERTIES LABELS ${label} TIMEOUT 600 COST ${cost})
    if(lock)
        set_tests_properties(${made} PROPERTIES RESOURCE_LOCK ${lock})
    endif()
endif()
