// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/device_fault.h"

#include "sim_core/numerics/name_table.h"

namespace fulcrum {

/// Of the service of Haply.
static const char* words_of_haply(DeviceFault fault) {
    if (fault == DeviceFault::haply_ended)
        return QT_TRANSLATE_NOOP("errors",
                                 "The Inverse service of Haply ended or closed the connection. Start it "
                                 "again, and end other programs that use the device.");
    if (fault == DeviceFault::haply_silent)
        return QT_TRANSLATE_NOOP("errors",
                                 "The Inverse service of Haply does not answer. Restart it, and check the "
                                 "cable of the device.");
    return QT_TRANSLATE_NOOP("errors",
                             "The Inverse service of Haply sends readings that cannot be used. "
                             "Restart it, and install its newest version.");
}

const char* words_of(DeviceFault fault) {
    switch (fault) {
        case DeviceFault::none:
            return "";
        case DeviceFault::needs_calibration:
            return QT_TRANSLATE_NOOP(
                "errors",
                "The device needs calibration. Put the stylus of a Touch into its inkwell and take it out "
                "after two seconds; move the handle of another device slowly to each end of its range. Where "
                "that does not help, calibrate it with the maker's program.");
        case DeviceFault::warm_motors:
            return QT_TRANSLATE_NOOP(
                "errors",
                "The motors of the device are too warm. Let go of it for half a minute, then resume.");
        case DeviceFault::too_much_force:
            return QT_TRANSLATE_NOOP("errors",
                                     "The device refused a force as too large. Resume; where it happens "
                                     "again, lower the force given to the hand on the page Settings.");
        case DeviceFault::too_fast:
            return QT_TRANSLATE_NOOP(
                "errors", "The device was moved too fast and switched its motors off. Hold it still.");
        case DeviceFault::switched_off:
            return QT_TRANSLATE_NOOP("errors",
                                     "Force is switched off at the device. Press its force button, or let "
                                     "its hand sensor see your hand.");
        case DeviceFault::no_answer:
            return QT_TRANSLATE_NOOP("errors",
                                     "The device does not answer. Check its cable and power; unplug it and "
                                     "connect it again.");
        case DeviceFault::servo_stopped:
            return QT_TRANSLATE_NOOP("errors",
                                     "The maker's driver of the device has stopped reading it. Unplug the "
                                     "device and connect it again.");
        case DeviceFault::driver:
            return QT_TRANSLATE_NOOP("errors",
                                     "The maker's driver of the device refused a request. Install the "
                                     "driver's newest version; its messages are on standard error.");
        case DeviceFault::connection_ended:
            return QT_TRANSLATE_NOOP("errors",
                                     "The connection to the tracker's server ended. Start the server again "
                                     "and check the network.");
        case DeviceFault::not_openigtlink:
            return QT_TRANSLATE_NOOP("errors",
                                     "What the tracker's server sends is not OpenIGTLink. Check its port.");
        case DeviceFault::wrong_checksum:
            return QT_TRANSLATE_NOOP("errors",
                                     "Messages of the tracker's server have wrong checksums and are not "
                                     "used. Install the newest version of the program that sends them.");
        case DeviceFault::not_a_pose:
            return QT_TRANSLATE_NOOP("errors",
                                     "The tracker sends poses that cannot be used. Bring the instrument into "
                                     "its view, and calibrate it where that does not help.");
        case DeviceFault::no_poses:
            return QT_TRANSLATE_NOOP("errors",
                                     "The tracker sends no pose of an instrument. Bring the instrument into "
                                     "its view, and check that the tracker is running.");
        case DeviceFault::spacenavd:
            return QT_TRANSLATE_NOOP("errors",
                                     "spacenavd, which reads the SpaceMouse, ended or sends something else. "
                                     "Start it again: `sudo systemctl restart spacenavd`.");
        case DeviceFault::haply_ended:
        case DeviceFault::haply_silent:
        case DeviceFault::haply_message:
            return words_of_haply(fault);
        case DeviceFault::no_power:
            return QT_TRANSLATE_NOOP("errors",
                                     "The device has no power supply, so it renders no force. Connect its "
                                     "power supply.");
        case DeviceFault::safety_brake:
            return QT_TRANSLATE_NOOP("errors",
                                     "The safety brake of the device has triggered. Let go of the handle for "
                                     "three seconds, then resume; move it more slowly.");
    }
    return "";
}

}  // namespace fulcrum
