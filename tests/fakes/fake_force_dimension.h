// SPDX-License-Identifier: Apache-2.0
// What a test scripts and sees of the fake libdrd (libdrd.cpp): a page of memory that both map from the file
// that FAKE_FORCE_DIMENSION_PAGE names.
#pragma once

#include <atomic>
#include <cstdint>

namespace fulcrum::test {

struct FakeForceDimensionDevice {
    // Scripted. Frame of the library: x towards the person, y to the right, z up.
    std::atomic<double> position[3] = {};  ///< m
    std::atomic<double> turn{0}, tilt{0};  ///< rad: about x, after that about y
    std::atomic<double> gripper{0.5};      ///< rad
    std::atomic<std::uint32_t> has_gripper{1}, buttons{0};
    std::atomic<std::uint32_t> pose_fails{0}, force_fails{0}, saturated{0};
    std::atomic<int> status[17] = {};     ///< set by the library where it opens; force by dhdEnableForce
    std::atomic<std::uint32_t> opens{1};  ///< 0: dhdOpenID fails
    // Seen.
    std::atomic<double> force[3] = {};  ///< N, frame of the library
    std::atomic<double> max_force{0};
    std::atomic<std::uint64_t> ticks{0};
    std::atomic<std::uint32_t> open{0}, closed{0}, enabled{0};
};

struct FakeForceDimensionPage {
    FakeForceDimensionDevice device[2];
    std::atomic<int> count{2};
    std::atomic<std::uint32_t> old_firmware{0};  ///< 1: errors are put down to the firmware
    std::atomic<std::uint32_t> hang{0};          ///< 1: calls do not return
    std::atomic<std::uint32_t> misuse{0};        ///< calls for a device that is not open
};

}  // namespace fulcrum::test
