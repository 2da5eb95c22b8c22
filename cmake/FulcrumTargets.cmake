# SPDX-License-Identifier: Apache-2.0
# One static library a floor, its public includes rooted at the repository.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Threads REQUIRED)
find_program(FULCRUM_CCACHE ccache)
if(FULCRUM_CCACHE)
    # Precompiled headers need these two sloppiness settings to be cached.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${FULCRUM_CCACHE})
endif()

add_library(fulcrum_flags INTERFACE)
target_include_directories(fulcrum_flags INTERFACE ${PROJECT_SOURCE_DIR})
# Bit-for-bit replay: no contraction of a*b+c, no fast math; one instruction set for the whole product.
# Position-independent code everywhere, as Qt asks for: precompiled headers then fit libraries and programs alike.
target_compile_options(fulcrum_flags INTERFACE -fPIC -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(fulcrum_flags INTERFACE -march=x86-64-v3)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # False positives of GCC 12 inside Eigen at -O2 and above.
    target_compile_options(fulcrum_flags INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overread -Wno-stringop-overflow)
    target_compile_options(fulcrum_flags INTERFACE -fpch-preprocess)
endif()
if(FULCRUM_SANITIZE)
    target_compile_options(fulcrum_flags INTERFACE -fsanitize=${FULCRUM_SANITIZE} -fno-omit-frame-pointer -g1)
    target_link_options(fulcrum_flags INTERFACE -fsanitize=${FULCRUM_SANITIZE})
endif()
if(FULCRUM_FUZZ)
    target_compile_options(fulcrum_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined -g1)
    target_link_options(fulcrum_flags INTERFACE -fsanitize=address,undefined)
endif()
# External headers are system headers: their warnings are not ours.
get_target_property(_eigen_include Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(fulcrum_flags SYSTEM INTERFACE ${_eigen_include})
target_link_libraries(fulcrum_flags INTERFACE Threads::Threads)

# Headers that nearly every source includes, parsed once: they were two thirds of the time of a build.
add_library(fulcrum_precompiled STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
target_link_libraries(fulcrum_precompiled PUBLIC fulcrum_flags)
target_precompile_headers(fulcrum_precompiled PRIVATE <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <cstring> <fstream> <functional>
    <limits> <map> <memory> <optional> <random> <set> <sstream> <string> <utility> <vector>)

# fulcrum_floor(name FOLDER folder LINKS libs... PCH headers...): all sources below the folder. Without PCH: the headers above.
function(fulcrum_floor name)
    cmake_parse_arguments(ARG "" "FOLDER" "LINKS;PCH" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${ARG_FOLDER}/*.cpp ${PROJECT_SOURCE_DIR}/${ARG_FOLDER}/*.h ${PROJECT_SOURCE_DIR}/${ARG_FOLDER}/*.qrc)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    if(NOT sources)
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE fulcrum_flags ${ARG_LINKS})
        return()
    endif()
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC fulcrum_flags ${ARG_LINKS})
    if(ARG_PCH)
        target_precompile_headers(${name} PRIVATE ${ARG_PCH})
    else()
        target_precompile_headers(${name} REUSE_FROM fulcrum_precompiled)
    endif()
endfunction()

# fulcrum_embed_text(target symbol file): `extern const char* const fulcrum::symbol` holds the file's text, so that the library needs no
# search path for what is part of its own contract (schemas).
function(fulcrum_embed_text target symbol file)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [=[// SPDX-License-Identifier: Apache-2.0
namespace fulcrum {
extern const char* const @symbol@;
const char* const @symbol@ = R"embedded(@text@)embedded";
}  // namespace fulcrum
]=])
    target_sources(${target} PRIVATE ${source})
endfunction()

# fulcrum_build_info: lab::build_info() with compiler, flags and the commit, found anew by every build; links to programs only, so that a
# new commit compiles one small file.
function(fulcrum_build_info_library)
    get_target_property(options fulcrum_flags INTERFACE_COMPILE_OPTIONS)
    list(FILTER options EXCLUDE REGEX "^-W|^-fpch")
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
    target_link_libraries(fulcrum_build_info PUBLIC fulcrum_sim_core)
endfunction()
