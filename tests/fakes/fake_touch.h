// SPDX-License-Identifier: Apache-2.0
// What a test scripts and sees of the fake libHD (libhd.cpp): a page of memory that both map from the file
// that FAKE_TOUCH_PAGE names. Devices: 0 is "Left Device", 1 any other name.
#pragma once

#include <atomic>
#include <cstdint>

namespace fulcrum::test {

struct FakeTouchDevice {
    // Scripted.
    std::atomic<double> position[3] = {}, gimbal[3] = {};  ///< mm, rad
    std::atomic<std::int32_t> buttons{0};
    std::atomic<std::uint32_t> tick_error{0};  ///< put into the queue at each end of a frame
    std::atomic<std::uint32_t> calibration{0x5000};
    std::atomic<double> max_force{3.3}, continuous_force{0.88}, max_stiffness{0.5};
    std::atomic<double> workspace[6] = {};  ///< mm; all 0: it states none
    std::atomic<double> firmware{0};
    // Seen.
    std::atomic<double> force[3] = {};        ///< N, what the motors got at the last end of a frame
    std::atomic<std::int64_t> force_time{0};  ///< ns, CLOCK_MONOTONIC
    std::atomic<std::int64_t> zero_time{0};   ///< ns: the first end of a frame with 0 after another force
    std::atomic<std::uint64_t> frames{0};
    std::atomic<std::uint32_t> updates{0};  ///< hdUpdateCalibration
    std::atomic<std::uint32_t> open{0}, enabled{0};
};

struct FakeTouchPage {
    FakeTouchDevice device[2];
    std::atomic<std::uint32_t> init_error{0};
    std::atomic<std::uint32_t> old_firmware{0};  ///< 1: errors are put down to the firmware
    std::atomic<std::uint32_t> init_errors{0};   ///< how many calls get it; then hdInitDevice works
    std::atomic<std::uint32_t> hang{0};          ///< 1: the servo loop stops
    std::atomic<std::uint32_t> of_desktop{0};    ///< 1: it takes the language of the desktop, as libraries do
    std::atomic<std::uint32_t> inits{0}, closed_in_order{0}, rate{0};
    std::atomic<std::uint32_t> misuse{0};  ///< calls in an order that the library does not allow
    std::atomic<std::uint32_t> comma{0};   ///< 1: numbers were written in the language of the desktop
};

}  // namespace fulcrum::test
