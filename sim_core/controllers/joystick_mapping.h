// SPDX-License-Identifier: Apache-2.0
// What the axes of a joystick mean where it is an instrument of a box trainer: which one is which angle or
// length, in which range. A guided calibration makes it; a file keeps it (docs/FORMATS.md).
#pragma once

#include <cstdint>
#include <string>

#include "sim_core/controllers/joystick.h"
#include "sim_core/devices/device_page.h"

namespace fulcrum {

enum class JoystickMotion : std::uint8_t { pitch, yaw, insertion, roll, jaw };
inline constexpr int joystick_motions = 5;
/// In files; permanent.
inline constexpr const char* joystick_motion_names[joystick_motions] = {"pitch", "yaw", "insertion", "roll",
                                                                        "jaw"};

/// Straight lines from the low end over the rest to the high end.
struct JoystickAxis {
    int axis = -1;                                ///< of the joystick; -1: none
    double low = -1, rest = 0, high = 1;          ///< readings; low may be above high
    double at_low = 0, at_rest = 0, at_high = 0;  ///< rad, m, or share of the opening
    double value(const JoystickReading& reading) const noexcept;
};

/// One hand. Where an axis is missing the value is that of an instrument at rest: straight, 10 cm deep, open.
struct JoystickPart {
    JoystickAxis motion[joystick_motions];
    int jaws = -1, energy = -1, exchange = -1, clutch = -1;  ///< buttons; -1: none
    bool used() const { return motion[0].axis >= 0 && motion[1].axis >= 0 && motion[2].axis >= 0; }
};

struct JoystickMapping {
    std::string name;  ///< of the joystick that it was made with
    JoystickPart part[2];
};

/// Throws InputError with place and hint.
JoystickMapping read_joystick_mapping(const std::string& path);
std::string joystick_mapping_text(const JoystickMapping& mapping);

/// "joystick:raw", for calibrations alone: the axes in their order are position, roll and jaw of the left
/// part, then of the right; four buttons each.
void put_raw(const JoystickReading& reading, int axes, DevicePose (&poses)[device_slots]) noexcept;
/// The reverse.
JoystickReading raw_of(const DevicePose& left, const DevicePose& right) noexcept;
inline constexpr int raw_axes = 10;

/// Makes the part of one hand: the instrument is held still, then each motion goes from one of its ends to
/// the other, one after the other. Needs no clock but the caller's.
class JoystickCalibration {
  public:
    /// 0: at rest; 1 to 5: the motions in their order; 6: all done.
    int step() const { return step_; }
    static constexpr int steps = 1 + joystick_motions;
    bool done() const { return step_ >= steps; }
    /// A reading at this time, s.
    void see(const JoystickReading& reading, int axes, double now) noexcept;
    /// What the step asks for was seen: nothing moved for half a second, or one axis went from one end to the
    /// other and is at its end.
    bool ready() const noexcept;
    /// The next step; false, and nothing changes, where it is not ready().
    bool next() noexcept;
    /// Roll and jaws may be left out.
    bool can_skip() const { return step_ == 4 || step_ == 5; }
    void skip() noexcept;
    /// After the last step; buttons in their order.
    JoystickPart part() const;

  private:
    struct Seen {
        double least = 2, most = -2, now = 0;
        double range() const { return most > least ? most - least : 0; }
    };
    int moved() const noexcept;
    void begin_step() noexcept;
    int step_ = 0, axes_ = 0;
    double still_since_ = 0, now_ = 0;
    bool any_ = false;
    JoystickReading rest_;
    Seen seen_[most_joystick_axes];
    bool taken_[most_joystick_axes] = {};
    JoystickPart part_;
};

}  // namespace fulcrum
