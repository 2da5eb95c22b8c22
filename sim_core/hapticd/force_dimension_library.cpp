// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/force_dimension_library.h"

#include <cstdlib>

namespace fulcrum::hapticd {

LibraryLook ForceDimensionLibrary::load() {
    std::vector<std::string> names;
    if (const char* const sdk = std::getenv("FDSDK"))
        names.push_back(std::string(sdk) + "/lib/release/lin-x86_64-gcc/libdrd.so");
    names.insert(names.end(), {"libdrd.so", "/usr/local/lib/libdrd.so"});
    return load_library(
        *device_row("force-dimension"), names,
        {symbol("dhdGetDeviceCount", device_count), symbol("dhdOpenID", open), symbol("dhdClose", close),
         symbol("dhdGetSystemName", name), symbol("dhdGetPositionAndOrientationFrame", get_pose),
         symbol("dhdGetGripperAngleRad", get_gripper), symbol("dhdGetButtonMask", get_buttons),
         symbol("dhdEnableForce", enable_force), symbol("dhdSetForceAndTorqueAndGripperForce", set_force),
         symbol("dhdSetMaxForce", set_max_force), symbol("dhdGetStatus", get_status),
         symbol("dhdErrorGetLastStr", last_error)});
}

}  // namespace fulcrum::hapticd
