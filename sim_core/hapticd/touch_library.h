// SPDX-License-Identifier: Apache-2.0
// The functions of libHD that are used (3D Systems OpenHaptics, HD layer), loaded while the program runs.
// Names, types and numbers: docs/BIBLIOGRAPHY.md.
#pragma once

#include <cstdint>

#include "sim_core/hapticd/vendor_library.h"

namespace fulcrum::hapticd {

namespace hd {
using Handle = std::uint32_t;
inline constexpr Handle invalid_handle = 0xFFFFFFFF;
struct ErrorInfo {
    std::uint32_t code;
    std::int32_t internal;
    Handle device;
};
using Callback = std::uint32_t (*)(void*);

enum Parameter : std::uint32_t {
    current_buttons = 0x2000,           ///< int, bits
    current_position = 0x2050,          ///< 3 double, mm
    current_gimbal_angles = 0x2150,     ///< 3 double, rad; the third is the turn of the stylus
    device_model_type = 0x2501,         ///< string
    device_driver_version = 0x2502,     ///< string
    device_firmware_version = 0x2505,   ///< double
    usable_workspace = 0x2551,          ///< 6 double, mm: least, most
    calibration_style = 0x2555,         ///< int, CalibrationStyle mask
    nominal_max_stiffness = 0x2602,     ///< double, N/mm
    nominal_max_force = 0x2603,         ///< double, N
    nominal_continuous_force = 0x2604,  ///< double, N
    current_force = 0x2700              ///< 3 double, N
};
enum Capability : std::uint32_t { force_output = 0x4000, max_force_clamping = 0x4001 };
enum CalibrationStyle : std::uint32_t { encoder_reset = 1, automatic = 2, inkwell = 4 };
enum Calibration : std::uint32_t { calibrated = 0x5000, needs_update = 0x5001, needs_manual_input = 0x5002 };
enum Code : std::uint32_t {
    success = 0,
    warm_motors = 0x0200,
    exceeded_max_velocity = 0x0203,
    force_error = 0x0204,
    device_fault = 0x0300,
    already_initiated = 0x0301,
    timer_error = 0x0304,
    invalid_license = 0x0600
};
enum Again : std::uint32_t { callback_done = 0, callback_continue = 1 };
inline constexpr std::uint16_t highest_priority = 0xFFFF;
}  // namespace hd

struct TouchLibrary {
    hd::Handle (*init_device)(const char*) = nullptr;
    void (*disable_device)(hd::Handle) = nullptr;
    void (*make_current)(hd::Handle) = nullptr;
    void (*begin_frame)(hd::Handle) = nullptr;
    void (*end_frame)(hd::Handle) = nullptr;
    void (*enable)(std::uint32_t) = nullptr;
    void (*get_double)(std::uint32_t, double*) = nullptr;
    void (*get_integer)(std::uint32_t, std::int32_t*) = nullptr;
    const char* (*get_string)(std::uint32_t) = nullptr;
    void (*set_double)(std::uint32_t, const double*) = nullptr;
    hd::ErrorInfo (*get_error)() = nullptr;
    const char* (*error_string)(std::uint32_t) = nullptr;
    std::uint32_t (*check_calibration)() = nullptr;
    void (*update_calibration)(std::uint32_t) = nullptr;
    unsigned long (*schedule)(hd::Callback, void*, std::uint16_t) = nullptr;
    void (*set_rate)(unsigned long) = nullptr;
    void (*start_scheduler)() = nullptr;
    void (*stop_scheduler)() = nullptr;
    void (*unschedule)(unsigned long) = nullptr;

    LibraryLook load();
};

}  // namespace fulcrum::hapticd
