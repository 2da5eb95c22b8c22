// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/vendor_library.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim_core/hapticd/force_dimension_library.h"
#include "sim_core/hapticd/touch_library.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {

LibraryLook load_library(const VendorDriver& driver, const std::vector<std::string>& names,
                         const std::vector<Symbol>& symbols) {
    return load_run_time_library(driver.variable, names, symbols);
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
