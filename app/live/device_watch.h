// SPDX-License-Identifier: GPL-3.0-or-later
// Detects a lost device and decides when the trainee may resume; sets the device_lost flag of every tick
// (docs/MANUAL.md, When a device is lost).
//
//   watching  a reading that is not a number, or a jump, means that the device is lost at once; silence
//             means it after silent_ticks
//   lost      the instruments are stopped and the devices move freely. After steady_ticks of usable readings
//             from every device, the devices are back; with each hand within 5 mm and 10 degrees of its
//             instrument, resume() is accepted. After limit_ticks the attempt ends.
//
// Haptic thread: no allocation, lock or exception. The result depends on the arguments only.
#pragma once

#include <cstdint>

#include "sim_core/instrument/device.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum::app {

struct DeviceWatchLimits {
    std::uint32_t silent_ticks = 50;     ///< a device that is silent for longer is lost
    std::uint32_t steady_ticks = 100;    ///< consecutive usable readings until the device counts as back
    std::uint32_t limit_ticks = 60000;   ///< after this time without the device the attempt is interrupted
    double distance = 5e-3;              ///< m, of the handle
    double angle = 0.17453292519943295;  ///< rad, of shaft and roll
};

enum class DeviceTrouble : std::uint8_t { none, silent, impossible_reading };

/// Pose of a hand's device relative to its stopped instrument. Valid while a device is lost.
struct HandAlignment {
    DeviceSample device;  ///< with the clutch applied: the pose that the instrument would take
    double distance = 0;  ///< m between handles
    double angle = 0;     ///< rad, the larger of shaft and roll
    bool in_place = false;
};

class DeviceWatch {
  public:
    explicit DeviceWatch(const DeviceWatchLimits& limits = {}) : limits_(limits) {}

    /// Before the first tick of an attempt that begins with a state of another one: what its instruments
    /// follow there (HapticLoop::held()).
    void begin_from(const DeviceSample& left, const DeviceSample& right) noexcept;
    /// Processes one tick; returns the flag to add to the sample's flags (rig_device_lost or 0). `paused`:
    /// the instruments are stopped for another reason. `resume`: the trainee asks to resume; ignored unless
    /// in_place().
    std::uint32_t tick(const RigSample& sample, bool paused, bool resume) noexcept;

    bool lost() const noexcept { return lost_; }
    bool back() const noexcept { return lost_ && steady_ >= limits_.steady_ticks; }
    bool in_place() const noexcept { return back() && hand_[0].in_place && hand_[1].in_place; }
    /// The device has been lost for longer than the limit.
    bool expired() const noexcept { return lost_ && lost_for_ > limits_.limit_ticks; }
    /// The trainee has resumed after a loss: from then on the attempt is practice.
    bool went_on() const noexcept { return went_on_; }
    DeviceTrouble trouble() const noexcept { return trouble_; }
    /// The device that was lost: 0 left, 1 right, 2 scope.
    int culprit() const noexcept { return culprit_; }
    std::uint32_t lost_for() const noexcept { return lost_for_; }
    const HandAlignment& alignment(Hand hand) const noexcept { return hand_[static_cast<int>(hand)]; }

  private:
    void lose(DeviceTrouble trouble, int culprit) noexcept;
    void follow(const RigSample& sample, bool on_hold) noexcept;

    DeviceWatchLimits limits_;
    HandAlignment hand_[hand_count];
    DeviceSample held_[hand_count];            // as in the haptic loop: the pose of the instrument
    std::int32_t offset_[hand_count][4] = {};  // the loop's clutch: handle and roll
    std::uint32_t silent_[3] = {0, 0, 0}, lost_for_ = 0, steady_ = 0;
    DeviceTrouble trouble_ = DeviceTrouble::none;
    int culprit_ = 0;
    bool lost_ = false, was_held_ = false, went_on_ = false, seen_ = false;
};

/// Alignment of the devices with the instruments while a device is lost.
struct Watched {
    bool back = false, in_place = false;
    DeviceTrouble trouble = DeviceTrouble::none;
    int culprit = 0;
    HandAlignment hand[hand_count];
};

/// What happened to the device of `culprit` (0 left hand, 1 right hand, 2 scope), and what to do.
Sentence loss_of(DeviceTrouble trouble, int culprit);

}  // namespace fulcrum::app
