// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/touch_library.h"

namespace fulcrum::hapticd {

LibraryLook TouchLibrary::load() {
    return load_library(
        *device_row("touch"), {"libHD.so", "libHD.so.3.5", "libHD.so.3.4", "libHD.so.3.3", "libHD.so.3.0"},
        {symbol("hdInitDevice", init_device), symbol("hdDisableDevice", disable_device),
         symbol("hdMakeCurrentDevice", make_current), symbol("hdBeginFrame", begin_frame),
         symbol("hdEndFrame", end_frame), symbol("hdEnable", enable), symbol("hdGetDoublev", get_double),
         symbol("hdGetIntegerv", get_integer), symbol("hdGetString", get_string),
         symbol("hdSetDoublev", set_double), symbol("hdGetError", get_error),
         symbol("hdGetErrorString", error_string), symbol("hdCheckCalibration", check_calibration),
         symbol("hdUpdateCalibration", update_calibration), symbol("hdScheduleAsynchronous", schedule),
         symbol("hdSetSchedulerRate", set_rate), symbol("hdStartScheduler", start_scheduler),
         symbol("hdStopScheduler", stop_scheduler), symbol("hdUnschedule", unschedule)});
}

}  // namespace fulcrum::hapticd
