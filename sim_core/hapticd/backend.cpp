// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/backend.h"

#include "sim_core/hapticd/virtual_device.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {

std::unique_ptr<Backend> make_backend(const std::string& specification) {
    const std::string prefix = "virtual:";
    if (specification.rfind(prefix, 0) != 0)
        throw InputError(
            "device", "", {QT_TRANSLATE_NOOP("errors", "'%1' is not known"), specification},
            QT_TRANSLATE_NOOP("errors", "use virtual:SCRIPT.json; `fulcrum devices` lists the devices"));
    return std::make_unique<VirtualDevice>(read_device_script(specification.substr(prefix.size())));
}

}  // namespace fulcrum::hapticd
