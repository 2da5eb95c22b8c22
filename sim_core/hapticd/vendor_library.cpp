// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/vendor_library.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {

LibraryLook load_library(const DeviceRow& device, const std::vector<std::string>& names,
                         const std::vector<Symbol>& symbols) {
    return load_run_time_library(device.library.variable, names, symbols);
}

void require_ready(const DeviceRow& device, const LibraryLook& look) {
    if (look.state == LibraryState::ready) return;
    throw InputError(device.title, "", {"%1 (%2)", Sentence(problem_of(look.state)), look.detail},
                     hint_of(device, look.state));
}

void refuse_to_open(const DeviceRow& kind, const std::string& device, const Sentence& problem,
                    const Sentence& hint, const UsbFolders& folders) {
    for (const UsbDevice& one : usb_devices(folders)) {
        if (!is_of(kind, one)) continue;
        for (const std::string& node : one.nodes)
            if (access(node.c_str(), R_OK | W_OK) != 0)
                throw InputError(kind.title, device,
                                 {QT_TRANSLATE_NOOP("errors", "%1; %2 may not be opened: %3"), problem, node,
                                  std::string(std::strerror(errno))},
                                 kind.rule);
    }
    throw InputError(kind.title, device, problem, hint);
}

bool names_firmware(const char* words) noexcept {
    // Without the first letter, which may be a capital one.
    return words != nullptr && std::strstr(words, "irmware") != nullptr;
}

const char* firmware_hint() {
    return QT_TRANSLATE_NOOP("errors",
                             "update the firmware of the device with its maker's program, or install the "
                             "driver that belongs to it");
}

}  // namespace fulcrum::hapticd
