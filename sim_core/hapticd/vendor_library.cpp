// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/vendor_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "sim_core/hapticd/force_dimension_library.h"
#include "sim_core/hapticd/touch_library.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {

LibraryLook load_library(const VendorDriver& driver, const std::vector<std::string>& names,
                         const std::vector<Symbol>& symbols) {
    std::vector<std::string> tried = names;
    if (const char* const named = std::getenv(driver.variable)) tried = {named};
    void* library = nullptr;
    LibraryLook look;
    for (const std::string& name : tried) {
        library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library != nullptr) break;
        const char* const error = dlerror();
        const std::string said = error != nullptr ? error : "unknown";
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

void require_ready(const VendorDriver& driver, const LibraryLook& look) {
    if (look.state == LibraryState::ready) return;
    throw InputError(driver.title, "", {"%1 (%2)", Sentence(problem_of(look.state)), look.detail},
                     hint_of(driver, look.state));
}

LibraryLook look_at_own_library(const std::string& kind) {
    if (kind == "touch") {
        TouchLibrary library;
        return library.load();
    }
    if (kind == "force-dimension") {
        ForceDimensionLibrary library;
        return library.load();
    }
    return {LibraryState::unusable, kind};
}

void refuse_to_open(const VendorDriver& driver, const std::string& device, const Sentence& problem,
                    const Sentence& hint, const UsbFolders& folders) {
    for (const UsbDevice& one : usb_devices(folders)) {
        if (!is_of(driver, one)) continue;
        for (const std::string& node : one.nodes)
            if (access(node.c_str(), R_OK | W_OK) != 0)
                throw InputError(driver.title, device,
                                 {QT_TRANSLATE_NOOP("errors", "%1; %2 may not be opened: %3"), problem, node,
                                  std::string(std::strerror(errno))},
                                 driver.rule);
    }
    throw InputError(driver.title, device, problem, hint);
}

}  // namespace fulcrum::hapticd
