// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that fulcrum-hapticd reads, each the fake of a kind that the program opens as it opens the real
// one, moved by a test. They set the variables that lead the program to them: make them before the services.
#pragma once

#include <memory>
#include <string>

#include "sim_core/numerics/types.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"
#include "ui/theatre/hand_deeds.h"

namespace fulcrum::app::program_test {

/// What a hand does with its device apart from moving it.
struct HeldParts {
    double roll = 0;
    bool closed = false, energy = false, exchange = false, clutch = false;
};

class HeldDevice {
  public:
    virtual ~HeldDevice() = default;
    /// Device frame of docs/DEVICES.md, m. Of a cap: it is pushed from its middle, begin(), towards there.
    virtual void put(int hand, const Vector3& position) = 0;
    /// As far as the device has it, see `own`.
    virtual void hold(int hand, const HeldParts& parts) = 0;
    /// Where it is before it is moved.
    virtual Vector3 begin() const { return Vector3::Zero(); }
    /// N, the largest component that the motors got last.
    virtual double force() const { return 0; }

    const char* title = "";  ///< in results
    const char* strip = "";  ///< in the first line of its first steps
    ui::HandDeeds own;       ///< what the fake can do apart from moving its handles

  protected:
    /// The rest of FULCRUM_DEVICE.
    void name(const std::string& specification) {
        device_ = std::make_unique<fulcrum::test::Variable>("FULCRUM_DEVICE", specification);
    }

  private:
    fulcrum::test::Variable daemon_{"FULCRUM_HAPTICD", fulcrum::test::hapticd_program()};
    std::unique_ptr<fulcrum::test::Variable> device_;
};

/// The kinds for two hands: "Touch", "Haply", "ForceDimension", "Tracker", "Trainer", "Joystick"; and
/// "SpaceMouse" for the left one. Without `named` a joystick is to be chosen on the page *Settings*: its
/// calibration is where the program keeps it.
std::unique_ptr<HeldDevice> make_held(const std::string& kind, bool named = true);

}  // namespace fulcrum::app::program_test
