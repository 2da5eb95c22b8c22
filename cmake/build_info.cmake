# SPDX-License-Identifier: Apache-2.0
# Run at build time: writes OUTPUT with the commit that is being built; touches it only when that changes.
# A tree whose sources differ from the commit is marked; generated pages do not count as sources.
execute_process(COMMAND git rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    set(commit "unknown (not built from a repository)")
else()
    execute_process(COMMAND git status --porcelain --untracked-files=no -- . ":(exclude)docs" WORKING_DIRECTORY ${SOURCE}
        OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(changes)
        string(APPEND commit ", with uncommitted changes")
    endif()
endif()
set(text "// SPDX-License-Identifier: Apache-2.0
#include \"sim_core/lab/machine.h\"
namespace fulcrum::lab {
BuildInfo build_info() { return {\"${COMPILER}\", \"${FLAGS}\", \"${commit}\"}; }
}  // namespace fulcrum::lab
")
set(old "")
if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
    file(WRITE ${OUTPUT} "${text}")
endif()
