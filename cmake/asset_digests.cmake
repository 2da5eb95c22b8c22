# SPDX-License-Identifier: Apache-2.0
# Run at build time: writes OUTPUT with the SHA-256 of every file that decides a result (scenes, tasks, benchmark sets, curricula of ASSETS), and of the demonstration.
file(GLOB files RELATIVE ${ASSETS} ${ASSETS}/scenes/*.json ${ASSETS}/tasks/*.json ${ASSETS}/benchmarks/*.json ${ASSETS}/curricula/*.json ${ASSETS}/demonstration/*.zst)
list(SORT files)
set(rows "")
foreach(file ${files})
    file(SHA256 ${ASSETS}/${file} digest)
    string(APPEND rows "        {\"${file}\", \"${digest}\"},\n")
endforeach()
set(text "// SPDX-License-Identifier: GPL-3.0-or-later
#include \"database/store/accepted_assets.h\"
namespace fulcrum::database {
const std::vector<AssetFile>& delivered_assets() {
    static const std::vector<AssetFile> files = {
${rows}    };
    return files;
}
}  // namespace fulcrum::database
")
set(old "")
if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
    file(WRITE ${OUTPUT} "${text}")
endif()
