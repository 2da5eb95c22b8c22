// SPDX-License-Identifier: Apache-2.0
// What is wrong with a device that is open, as the process that reads it reports it. While there is a fault
// the force is 0 and the hand that has it is not present, which pauses an attempt.
#pragma once

#include <cstdint>

namespace fulcrum {

enum class DeviceFault : std::uint32_t {
    none,
    needs_calibration,  ///< positions are not valid yet
    warm_motors,        ///< the motors were too warm within the last seconds
    too_much_force,     ///< the device refused a force within the last second
    too_fast,           ///< it switched its motors off because it was moved too fast
    switched_off,       ///< force is switched off at the device
    no_answer,          ///< communication error: cable, power or firmware
    servo_stopped,      ///< the loop of the maker's library does not run
    driver,             ///< the maker's library refused a call
    connection_ended,   ///< the server of a tracker closed the connection, or it failed
    not_openigtlink,    ///< what that server sends is not OpenIGTLink
    wrong_checksum,     ///< its messages have wrong checksums
    not_a_pose,         ///< its poses are not numbers, or not a rotation and a place
    no_poses,           ///< it sends no poses of a tool
    spacenavd,          ///< the program that reads a SpaceMouse ended, or sends something else
    haply_ended,        ///< the service of Haply ended or closed the connection
    haply_silent,       ///< it does not answer
    haply_message,      ///< what it sends cannot be used
    no_power,           ///< the device has no power supply, so it renders no force
    safety_brake        ///< the device braked itself within the last seconds
};

struct FaultReport {
    std::uint64_t fault = 0;  ///< DeviceFault
    std::uint64_t hands = 0;  ///< bit 0: left, bit 1: right
};

/// What is wrong and what to do, a sentence in English that is translated in the context "errors"; empty for
/// none and for a number that is not a fault.
const char* words_of(DeviceFault fault);

/// True if the device has to be opened again.
constexpr bool needs_opening(DeviceFault fault) {
    return fault == DeviceFault::no_answer || fault == DeviceFault::servo_stopped ||
           fault == DeviceFault::driver || fault == DeviceFault::connection_ended ||
           fault == DeviceFault::not_openigtlink || fault == DeviceFault::spacenavd ||
           fault == DeviceFault::haply_ended || fault == DeviceFault::haply_silent;
}

}  // namespace fulcrum
