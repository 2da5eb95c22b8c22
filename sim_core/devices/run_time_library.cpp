// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/run_time_library.h"

#include <dlfcn.h>
#include <locale.h>

#include <cstdlib>

namespace fulcrum {
namespace {

/// The last error of the dynamic linker, in English: its words alone say what is missing, and a window has
/// put the process into the person's language.
std::string linker_error() {
    const locale_t english = newlocale(LC_ALL_MASK, "C", nullptr);
    const locale_t before = uselocale(english);
    const char* const error = dlerror();
    std::string said = error != nullptr ? error : "unknown";
    uselocale(before);
    freelocale(english);
    return said;
}

}  // namespace

LibraryLook load_run_time_library(const char* variable, const std::vector<std::string>& names,
                                  const std::vector<Symbol>& symbols) {
    std::vector<std::string> tried = names;
    if (const char* const named = std::getenv(variable)) tried = {named};
    void* library = nullptr;
    LibraryLook look;
    for (const std::string& name : tried) {
        library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library != nullptr) break;
        const std::string said = linker_error();
        // "NAME: cannot open shared object file: …" names the file that was not found.
        const bool absent = said.find("cannot open shared object file") != std::string::npos;
        const LibraryState state = !absent                    ? LibraryState::unusable
                                   : said.rfind(name, 0) == 0 ? LibraryState::missing
                                                              : LibraryState::incomplete;
        if (look.detail.empty() || (look.state == LibraryState::missing && state != look.state))
            look = {state, said};
    }
    if (library == nullptr) return look;
    for (const Symbol& one : symbols) {
        *one.address = dlsym(library, one.name);
        if (*one.address == nullptr) return {LibraryState::outdated, one.name};
    }
    return {};
}

}  // namespace fulcrum
