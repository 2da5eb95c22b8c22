// SPDX-License-Identifier: GPL-3.0-or-later
// The device that the window's attempts use: mouse and keyboard, or one that fulcrum-hapticd drives. UI
// thread.
#pragma once

#include "app/live/force_test.h"
#include "app/services/calibration.h"
#include "sim_core/controllers/game_controller.h"
#include "sim_core/devices/daemon_client.h"
#include "ui/services/device_service.h"

namespace fulcrum::app {

class DeviceRig;

class Devices {
  public:
    /// `specification`: empty for mouse and keyboard, else as for fulcrum-hapticd. Nothing is opened yet.
    explicit Devices(std::string specification);
    ui::DeviceInUse in_use() const;
    /// Throws InputError.
    std::shared_ptr<Rig> hands(const Scene& scene, std::shared_ptr<Rig> others);
    /// Of the latest hands(); null where no device process moves them or nobody holds that rig any more.
    std::shared_ptr<const DeviceRig> rig() const { return rig_.lock(); }
    /// Null where the device is none. Throws InputError.
    std::shared_ptr<GameController> game_controller();
    Sentence trouble();
    std::optional<ui::DeviceReadings> readings();
    /// Opens the device without an attempt. Throws InputError.
    void open_now();
    /// A kind of list_devices(); kept in the settings of the program. The device before is closed.
    void choose(const std::string& kind);
    /// The device that choose() kept, as for the constructor.
    static std::string chosen();
    bool start_force_test();
    void stop_force_test() { test_.reset(); }
    ui::ForceTestState force_test() const;
    /// Of the device in use, which is closed for it; a guided calibration that ended is kept until the next.
    void start_calibration(int hand);
    ui::CalibrationState calibration();
    GuidedCalibration* running_calibration() { return calibration_.get(); }
    void stop_calibration() { calibration_.reset(); }
    static double motion_scale(const std::string& kind);
    static void set_motion_scale(const std::string& kind, double scale);
    static bool begins_at_ring(const std::string& kind);
    static void set_begins_at_ring(const std::string& kind, bool wanted);
    static ui::SlotChoice slot_choice(const std::string& kind);
    static void set_slot_choice(const std::string& kind, const ui::SlotChoice& choice);
    /// Share of the model's force for devices of this kind, kept in the settings of the program.
    static double force_scale(const std::string& kind);
    static void set_force_scale(const std::string& kind, double scale);
    static bool rumble_wanted();
    static void set_rumble_wanted(bool wanted);

  private:
    void open();
    std::string specification_;
    std::shared_ptr<DaemonClient> client_;
    std::shared_ptr<GameController> pad_;
    std::weak_ptr<const DeviceRig> rig_;
    std::unique_ptr<ForceTest> test_;
    std::unique_ptr<GuidedCalibration> calibration_;
    std::uint64_t counted_ = 0;     ///< readings at the last call of readings()
    std::int64_t counted_at_ = -1;  ///< ns; -1: not called since the device was opened
};

/// The class of a device: that of its row in device_table; one without force is not haptic.
DeviceClass class_of(const DeviceFacts& facts);

}  // namespace fulcrum::app
