// SPDX-License-Identifier: GPL-3.0-or-later
// Guided calibrations of devices: each step says what to do, watches the reading, and the last one stores the
// result. Used by the page of settings and by `fulcrum devices --calibrate`. One thread.
#pragma once

#include <memory>
#include <string>

#include "sim_core/controllers/game_controller.h"
#include "sim_core/devices/daemon_client.h"
#include "ui/services/device_service.h"

namespace fulcrum::app {

class GuidedCalibration {
  public:
    virtual ~GuidedCalibration() = default;
    /// Reads the device.
    virtual ui::CalibrationState look() = 0;
    /// The person did what the step asks for; no effect where look() was not ready.
    virtual void next() = 0;
    virtual void skip() {}
};

/// There is something to calibrate for devices of this kind.
bool can_calibrate(const std::string& kind);
/// Each hand is calibrated by itself.
bool calibrates_hands(const std::string& kind);
/// Opens the device that `named` says, where `client` or `pad` do not have it open, and begins.
/// `hand`: 0 left, 1 right. Throws InputError.
std::unique_ptr<GuidedCalibration> begin_calibration(const std::string& named, int hand,
                                                     std::shared_ptr<GameController> pad);

/// `named` with what calibrations of this kind stored: the file of a joystick, the zero of a
/// trainer.
std::string with_calibration(const std::string& named);
ControllerRanges controller_ranges();
/// See DeviceService.
std::string calibrated_at(const std::string& kind);
/// The file with the mapping of joysticks, next to the settings.
std::string joystick_file();

}  // namespace fulcrum::app
