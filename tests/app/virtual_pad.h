// SPDX-License-Identifier: GPL-3.0-or-later
// A game controller that a test moves: one that the fake SDL 2 reports, or a virtual one of SDL 2 itself.
#pragma once

#include <cstdint>
#include <memory>

#include "tests/fakes/fake_sdl.h"

namespace fulcrum::app::program_test {

class VirtualPad {
  public:
    virtual ~VirtualPad() = default;
    /// In SDL's order, -32768 to 32767; triggers from 0.
    virtual void set_axis(int axis, std::int32_t value) = 0;
    /// A bit for each button, in SDL's order.
    virtual void set_buttons(std::uint32_t held) = 0;
};

class FakePad : public VirtualPad {
  public:
    explicit FakePad(fulcrum::test::FakeSdlController& pad) : pad_(pad) {}
    void set_axis(int axis, std::int32_t value) override { pad_.axis[axis] = value; }
    void set_buttons(std::uint32_t held) override { pad_.buttons = held; }

  private:
    fulcrum::test::FakeSdlController& pad_;
};

/// Exists in SDL 2, as the program loads it, while this object does. Null where this SDL 2 has none.
std::unique_ptr<VirtualPad> make_pad_of_sdl(const char* name);

}  // namespace fulcrum::app::program_test
