# SPDX-License-Identifier: Apache-2.0
# One static library a room (a folder), grouped into floors; includes are rooted at the repository.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Threads REQUIRED)
find_program(FULCRUM_CCACHE ccache)
if(FULCRUM_CCACHE)
    # Precompiled headers need these two sloppiness settings to be cached. Not include_file_mtime: with it an object of the old contents
    # was found under the new ones after a merge during a build. DEPEND: what a source includes is taken from the compiler, so that nothing
    # is preprocessed only to look it up: of a build from nothing that was a sixth of the time.
    set(CMAKE_CXX_COMPILER_LAUNCHER /usr/bin/env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_DEPEND=1 ${FULCRUM_CCACHE})
endif()

add_library(fulcrum_flags INTERFACE)
target_include_directories(fulcrum_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
# Bit-for-bit replay: no contraction of a*b+c, no fast math; one instruction set for the whole product.
# Position-independent code everywhere, as Qt requires: libraries and programs can then share precompiled headers.
target_compile_options(fulcrum_flags INTERFACE -fPIC -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(fulcrum_flags INTERFACE -march=x86-64-v3)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # False positives of GCC 12 inside Eigen at -O2 and above.
    target_compile_options(fulcrum_flags INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread -Wno-stringop-overflow)
    target_compile_options(fulcrum_flags INTERFACE -fpch-preprocess)
    # The compiler collects garbage less often: the large precompiled header made each collection slow.
    target_compile_options(fulcrum_flags INTERFACE "SHELL:--param ggc-min-expand=30" "SHELL:--param ggc-min-heapsize=1000000")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # Without the time of each header in it, a precompiled header is the same in every clone, so ccache finds what was compiled with it.
    target_compile_options(fulcrum_flags INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
endif()
# Assertions print the path of their source; without the clone's folder in it, ccache finds in one clone what another compiled.
target_compile_options(fulcrum_flags INTERFACE $<$<NOT:$<CONFIG:Release>>:-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=>)
if(FULCRUM_SANITIZE)
    target_compile_options(fulcrum_flags INTERFACE -fsanitize=${FULCRUM_SANITIZE} -fno-omit-frame-pointer -g1)
    target_link_options(fulcrum_flags INTERFACE -fsanitize=${FULCRUM_SANITIZE})
endif()
if(FULCRUM_FUZZ)
    # In a unit, clang also reports a local variable with the name of another source's constant.
    # Without the checks of each pointer, which AddressSanitizer makes for those that matter: they took a third of the time that compiling takes.
    target_compile_options(fulcrum_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined
        -fno-sanitize=alignment,function,null,object-size,pointer-overflow,vptr -g1 -Wno-shadow)
    target_link_options(fulcrum_flags INTERFACE -fsanitize=address,undefined)
endif()
# External headers are system headers: their warnings are not reported.
get_target_property(_eigen_include Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(fulcrum_flags SYSTEM INTERFACE ${_eigen_include})
target_link_libraries(fulcrum_flags INTERFACE Threads::Threads)

# Headers that nearly every source includes are precompiled: parsing them took two thirds of the build time.
add_library(fulcrum_precompiled STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
target_link_libraries(fulcrum_precompiled PUBLIC fulcrum_flags)
target_precompile_headers(fulcrum_precompiled PRIVATE <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <cstring> <fstream> <functional>
    <limits> <map> <memory> <optional> <random> <set> <sstream> <string> <utility> <vector>)

# fulcrum_compile_together(TARGET NAME sources...): these sources, with paths in full, as one source of the target. Not CMake's own unity build,
# which includes them by their full paths: what one clone compiled, ccache would not find for another without preprocessing it.
function(fulcrum_compile_together target name)
    fulcrum_compile_also(${target} ${name} ${ARGN})
    set_source_files_properties(${ARGN} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()

# fulcrum_compile_also(TARGET NAME sources...): the same for sources that are none of the target's own; where they belong they are compiled as before.
function(fulcrum_compile_also target name)
    set(includes)
    foreach(source ${ARGN})
        file(RELATIVE_PATH relative ${PROJECT_SOURCE_DIR} ${source})
        string(APPEND includes "#include \"${relative}\"\n")
    endforeach()
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/units/${target}_${name}.cpp)
    file(CONFIGURE OUTPUT ${unit} @ONLY CONTENT "// Made by CMake (fulcrum_compile_together).\n@includes@")
    target_sources(${target} PRIVATE ${unit})
    set_source_files_properties(${unit} PROPERTIES SKIP_AUTOGEN ON)
endfunction()

# fulcrum_in_batches(TARGET SIZE sources...): the same, so many at a time.
function(fulcrum_in_batches target size)
    list(LENGTH ARGN count)
    set(first 0)
    set(number 0)
    while(first LESS count)
        list(SUBLIST ARGN ${first} ${size} batch)
        fulcrum_compile_together(${target} ${number} ${batch})
        math(EXPR first "${first} + ${size}")
        math(EXPR number "${number} + 1")
    endwhile()
endfunction()

# fulcrum_room(FOLDER [USES rooms...] [LINKS libs...] [PCH target] [APART sources...] [WITH folders...]): the sources of one folder (not of the folders below it)
# as the library fulcrum_FOLDER, '/' read as '_'. USES names the rooms whose headers the folder may include, in full:
# tests/structure/rooms_test.cpp reads these calls, refuses every include that they do not name, and every cycle.
# WITH names folders below that belong to the same room. FULCRUM_UNITY sources are compiled together; APART names those that cannot share a translation unit with their neighbours.
set(FULCRUM_UNITY 1 CACHE STRING "Sources of a room compiled together as one; 1 compiles each by itself")
set(FULCRUM_TEST_UNITY 1 CACHE STRING "Sources of a test program compiled together as one; 1 compiles each by itself")
# Rooms that the fuzzers link but whose code they do not run: no input reaches it before a scene steps.
set(FULCRUM_NOT_FUZZED sim_core/bowel sim_core/contact sim_core/cutting sim_core/membrane sim_core/rigid sim_core/rod sim_core/strand sim_core/world/part)
function(fulcrum_room folder)
    cmake_parse_arguments(ARG "" "PCH" "USES;LINKS;APART;WITH" ${ARGN})
    string(REPLACE "/" "_" name fulcrum_${folder})
    if(NOT folder MATCHES "/")
        string(APPEND name "_root")  # fulcrum_FLOOR is the whole floor
    endif()
    set(uses fulcrum_flags ${ARG_LINKS})
    foreach(room ${ARG_USES})
        if(NOT room MATCHES "/")
            string(APPEND room "_root")
        endif()
        string(REPLACE "/" "_" room fulcrum_${room})
        list(APPEND uses ${room})
    endforeach()
    set_property(GLOBAL APPEND PROPERTY FULCRUM_ROOMS ${folder})
    set(path ${PROJECT_SOURCE_DIR}/${folder})
    file(GLOB sources CONFIGURE_DEPENDS ${path}/*.cpp ${path}/*.qrc)
    list(FILTER sources EXCLUDE REGEX "/(main|processor_check)\\.cpp$")  # of the program itself
    if(NOT sources)
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${uses})
        return()
    endif()
    file(GLOB headers CONFIGURE_DEPENDS ${path}/*.h)
    foreach(part ${ARG_WITH})
        set_property(GLOBAL APPEND PROPERTY FULCRUM_ROOMS ${folder}/${part})
        set_property(GLOBAL APPEND PROPERTY FULCRUM_ROOM_PARTS ${folder}/${part})
        file(GLOB more CONFIGURE_DEPENDS ${path}/${part}/*.cpp ${path}/${part}/*.h)
        list(APPEND sources ${more})
    endforeach()
    add_library(${name} STATIC ${sources} ${headers})
    target_link_libraries(${name} PUBLIC ${uses})
    if(FULCRUM_FUZZ AND folder IN_LIST FULCRUM_NOT_FUZZED)
        target_compile_options(${name} PRIVATE -fno-sanitize=undefined)
    endif()
    if(NOT ARG_PCH)
        set(ARG_PCH fulcrum_precompiled)
    endif()
    if(NOT ARG_PCH STREQUAL "none")
        target_precompile_headers(${name} REUSE_FROM ${ARG_PCH})
    endif()
    # Every source includes the code that moc makes of its header, so nothing is left in the file that CMake makes of all others.
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${name}_autogen/mocs_compilation.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    if(FULCRUM_UNITY GREATER 1)
        list(FILTER sources INCLUDE REGEX "\\.cpp$")
        foreach(source ${ARG_APART})
            list(REMOVE_ITEM sources ${path}/${source})
        endforeach()
        fulcrum_in_batches(${name} ${FULCRUM_UNITY} ${sources})
    endif()
endfunction()

# fulcrum_floor(FLOOR): the library fulcrum_FLOOR, all rooms of the floor; an error names every folder with sources that is not a room.
function(fulcrum_floor floor)
    get_property(rooms GLOBAL PROPERTY FULCRUM_ROOMS)
    get_property(parts GLOBAL PROPERTY FULCRUM_ROOM_PARTS)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${floor}/*.cpp ${PROJECT_SOURCE_DIR}/${floor}/*.h)
    foreach(source ${sources})
        get_filename_component(folder ${source} DIRECTORY)
        if(NOT folder IN_LIST rooms)
            message(SEND_ERROR "${source} is in no room. Add fulcrum_room(${folder} USES ...) to ${floor}/CMakeLists.txt.")
        endif()
    endforeach()
    add_library(fulcrum_${floor} INTERFACE)
    list(REMOVE_ITEM rooms "" ${parts})
    foreach(room ${rooms})
        if(room STREQUAL floor OR room MATCHES "^${floor}/")
            if(room STREQUAL floor)
                string(APPEND room "_root")
            endif()
            string(REPLACE "/" "_" room fulcrum_${room})
            target_link_libraries(fulcrum_${floor} INTERFACE ${room})
        endif()
    endforeach()
endfunction()

# fulcrum_embed_text(target symbol file): `extern const char* const fulcrum::symbol` holds the file's text, so that the library needs no
# search path for what is part of its own contract (schemas). fulcrum_embed_texts(target symbol files...): the same for each file, as symbol_NAME.
set(FULCRUM_EMBEDDED_TEXT [=[
extern const char* const @name@;
const char* const @name@ = R"embedded(@text@)embedded";
]=])
function(fulcrum_embed_sources target symbol)
    set(texts)
    set(name ${symbol})
    foreach(file ${ARGN})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        if(FULCRUM_EMBED_MANY)
            get_filename_component(name ${file} NAME_WE)
            set(name ${symbol}_${name})
        endif()
        string(CONFIGURE "${FULCRUM_EMBEDDED_TEXT}" one @ONLY)
        string(APPEND texts "${one}")
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [=[// SPDX-License-Identifier: Apache-2.0
namespace fulcrum {@texts@}  // namespace fulcrum
]=])
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES SKIP_AUTOGEN ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
function(fulcrum_embed_text target symbol file)
    set(FULCRUM_EMBED_MANY OFF)
    fulcrum_embed_sources(${target} ${symbol} ${file})
endfunction()
function(fulcrum_embed_texts target symbol)
    set(FULCRUM_EMBED_MANY ON)
    fulcrum_embed_sources(${target} ${symbol} ${ARGN})
endfunction()

# fulcrum_all_headers(FOLDER SUFFIX): the header FOLDER/all_SUFFIXs.h, which includes every FOLDER/*_SUFFIX.h, and the macro ALL_SUFFIXS(use), which
# writes use(NAME) for each of them. So a list of what is in a folder needs no line in it for each.
function(fulcrum_all_headers folder suffix)
    file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*_${suffix}.h)
    list(SORT headers)
    set(includes)
    set(uses)
    foreach(header ${headers})
        string(APPEND includes "#include \"${header}\"\n")
        string(REGEX REPLACE "^.*/(.*)_${suffix}\\.h$" "\\1" name ${header})
        string(APPEND uses " use(${name})")
    endforeach()
    string(TOUPPER ALL_${suffix}S macro)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${folder}/all_${suffix}s.h @ONLY CONTENT
"// Made by CMake (fulcrum_all_headers).
#pragma once
@includes@#define @macro@(use)@uses@
")
endfunction()

# fulcrum_build_info: lab::build_info() with compiler, flags and the commit, determined again by every build; links to programs only, so
# that a new commit compiles one small file.
function(fulcrum_build_info_library)
    get_target_property(options fulcrum_flags INTERFACE_COMPILE_OPTIONS)
    list(FILTER options EXCLUDE REGEX "^-W|^-fpch|^SHELL:--param")  # what changes no value
    string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
    list(JOIN options " " options)
    set(source ${CMAKE_BINARY_DIR}/build_info/build_info.cpp)
    add_custom_target(fulcrum_commit BYPRODUCTS ${source}
        COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${source}
            "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "-DFLAGS=${CMAKE_CXX_FLAGS_${type}} ${options}"
            -P ${PROJECT_SOURCE_DIR}/cmake/build_info.cmake
        COMMENT "" VERBATIM)
    add_library(fulcrum_build_info STATIC ${source})
    add_dependencies(fulcrum_build_info fulcrum_commit)
    target_link_libraries(fulcrum_build_info PUBLIC fulcrum_sim_core_lab)
endfunction()
