// SPDX-License-Identifier: Apache-2.0
// How mouse and keyboard move the handle of an instrument: the window's mapping, and that of the model of
// this device through which synthetic operators are driven.
#pragma once

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

inline constexpr double metres_per_pixel = 0.35e-3;  ///< of the handle, across its shaft
inline constexpr double metres_per_notch = 4e-3;     ///< of insertion, wheel
inline constexpr double key_handle_speed = 0.07;     ///< m/s
inline constexpr double key_insertion_speed = 0.05;  ///< m/s
inline constexpr double key_camera_speed = 0.045;    ///< m/s of the scope's handle
inline constexpr double key_turn_speed = 1.8;        ///< rad/s of a shaft, a light post, a camera head
inline constexpr double stick_handle_speed = 0.12;   ///< m/s of the handle, a stick pushed as far as it goes
inline constexpr double trigger_closed = 0.7;  ///< of a trigger's range: closed; further on the jaws press
inline constexpr double open_jaw_share = 0.6;  ///< of the opening, while no button is pressed

/// The handle of an instrument at the given insertion along its nominal shaft.
DeviceReading start_reading(double shaft_length, double insertion, double jaw);
/// Moves a handle by `shift` (m, patient frame) across its shaft, within the cone that a trocar allows; the
/// insertion stays.
void shift_handle(DeviceReading& reading, const Trocar& trocar, const Vector3& shift);
/// Inserts by `depth` (m), within the shaft's range.
void insert_handle(DeviceReading& reading, const Trocar& trocar, double depth);

/// Follows targets that come with the window's events as steady ticks: from one to the next in a straight
/// line, then two low-passes at 12 Hz in a row. Allocates nothing, never throws.
class HandleFollower {
  public:
    explicit HandleFollower(const DeviceReading& start = {});
    /// A new target, to be reached after `ticks` more ticks.
    void aim(const DeviceReading& target, int ticks);
    DeviceSample tick();

  private:
    DeviceReading target_;
    Vector3 line_, line_step_ = Vector3::Zero();  ///< of the handle, m and m a tick
    Vector3 first_, second_;                      ///< the two low-passes of it
    double roll_ = 0, jaw_ = 0, grip_ = 0;
    int ramp_ = 0;  ///< ticks left on the line to the target
    DeviceSample last_;
};

}  // namespace fulcrum
