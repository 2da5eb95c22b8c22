// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that fulcrum-hapticd reads, each the fake of a kind that the program opens as it opens the real
// one (a maker's library, a service, a server, a port), moved, broken and repaired by a test. They set the
// variables that lead the program to them: make them before the services.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim_core/devices/device_table.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/device_class.h"
#include "sim_core/numerics/types.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "ui/theatre/hand_deeds.h"

namespace fulcrum::app::program_test {

/// What a hand does with its device apart from moving it.
struct HeldParts {
    double roll = 0;
    double open = 1;  ///< of jaws whose handle says how far, where a button closes those of other devices
    bool closed = false, energy = false, exchange = false, clutch = false;
};

class HeldDevice {
  public:
    virtual ~HeldDevice() = default;
    /// Device frame of docs/DEVICES.md, m. Of a cap: it is pushed from its middle, begin(), so that its
    /// instrument goes so far.
    virtual void put(int hand, const Vector3& position) = 0;
    /// As far as the device has it, see `own`.
    virtual void hold(int hand, const HeldParts& parts) = 0;
    /// Where it is before it is moved.
    virtual Vector3 begin() const { return Vector3::Zero(); }
    /// N, the largest at the motors now.
    virtual double force() const { return 0; }
    /// N, the largest of the newest command, also where the motors have let go of it since.
    virtual double commanded() const { return force(); }

    /// Has this fault until it is repaired; one of those of its kind.
    virtual void break_it(DeviceFault fault) = 0;
    virtual void repair() = 0;
    /// What is said where it is opened again in vain while it has this fault; empty: it opens.
    virtual const char* refusal(DeviceFault /*fault*/) const { return ""; }
    /// Begins at 0 when it is opened again: moves it on towards its instrument, which is so far away (m).
    virtual void go_back(double /*distance*/) {}

    const char* title = "";    ///< in results
    const char* model = "";    ///< in what an attempt keeps of its device
    const char* strip = "";    ///< in the first line of its first steps
    const char* library = "";  ///< of its maker
    DeviceClass device_class = DeviceClass::tracked;
    bool moves[hand_count] = {true, true};  ///< a hand that it does not move is the mouse's
    bool is_pushed = false;  ///< a deflection is a speed: a place is reached where it is let go
    ui::HandDeeds own;       ///< what the fake can do apart from moving its handles
    bool feels() const { return device_class == DeviceClass::haptic; }

  protected:
    /// The rest of FULCRUM_DEVICE.
    void name(const std::string& specification) {
        device_ = std::make_unique<fulcrum::test::Variable>("FULCRUM_DEVICE", specification);
    }

  private:
    fulcrum::test::Variable daemon_{"FULCRUM_HAPTICD", fulcrum::test::hapticd_program()};
    std::unique_ptr<fulcrum::test::Variable> device_;
};

struct HeldKind {
    const char* name;
    /// Without `named` a joystick is to be chosen on the page *Settings*: its calibration is where the
    /// program keeps it.
    std::unique_ptr<HeldDevice> (*make)(bool named);
    std::vector<DeviceFault> faults;  ///< that it can have; together all of them
};
/// Each for two hands, the SpaceMouse for the left one.
const std::vector<HeldKind>& held_kinds();
const HeldKind& held_kind(const std::string& name);
std::unique_ptr<HeldDevice> make_held(const std::string& kind, bool named = true);

}  // namespace fulcrum::app::program_test
