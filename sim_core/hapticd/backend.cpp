// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/backend.h"

#include "sim_core/hapticd/force_dimension_device.h"
#include "sim_core/hapticd/haply_device.h"
#include "sim_core/hapticd/igtl_device.h"
#include "sim_core/hapticd/space_mouse_device.h"
#include "sim_core/hapticd/touch_device.h"
#include "sim_core/hapticd/virtual_device.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {

std::unique_ptr<Backend> make_backend(const std::string& specification) {
    const std::string prefix = "virtual:", kind = specification.substr(0, specification.find(':'));
    if (kind == "touch") return std::make_unique<TouchDevice>(touch_names(specification));
    if (kind == "force-dimension")
        return std::make_unique<ForceDimensionDevice>(force_dimension_numbers(specification));
    if (kind == "haply") return std::make_unique<HaplyDevice>(haply_specification(specification));
    if (kind == "openigtlink") return std::make_unique<IgtlDevice>(igtl_specification(specification));
    if (kind == "space-mouse") return std::make_unique<SpaceMouseDevice>(space_mouse_slot(specification));
    if (specification.rfind(prefix, 0) != 0)
        throw InputError(
            "device", "",
            {QT_TRANSLATE_NOOP("errors", "'%1' is not the name of a kind of device"), specification},
            QT_TRANSLATE_NOOP("errors",
                              "write two-mice, controller, touch, force-dimension, haply, "
                              "openigtlink, space-mouse or virtual:SCRIPT.json, in small letters; "
                              "`fulcrum devices` lists what is connected"));
    return std::make_unique<VirtualDevice>(read_device_script(specification.substr(prefix.size())));
}

}  // namespace fulcrum::hapticd
