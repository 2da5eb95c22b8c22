// SPDX-License-Identifier: GPL-3.0-or-later
// Two mice, one for each hand, read one by one from the X server (XInput 2.1 or later, raw events), whatever
// the pointer on the screen does. UI thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::ui {

/// A mouse as the X server names it.
struct MouseDevice {
    int id = 0;
    std::string name;
};

/// What one mouse did since the last call.
struct MouseMotion {
    double right = 0, down = 0;            ///< counts of the mouse
    double notches = 0;                    ///< of the wheel, away from the person positive
    double turned_notches = 0;             ///< of the wheel while the right button was held
    double held_right = 0, held_down = 0;  ///< counts while the right button was held: not in right and down
    bool left_button = false, middle_button = false, side_button = false;  ///< held now
    bool connected = true;
};

class TwoMice {
  public:
    /// The mice that are connected, in the server's order. `virtual_too`: also the server's own pointers for
    /// tests. Empty where there is no X server, or an older one.
    static std::vector<MouseDevice> connected(bool virtual_too);
    /// The first two of them, the first for the left hand. Throws InputError where there are fewer.
    static std::unique_ptr<TwoMice> open(bool virtual_too);
    virtual ~TwoMice() = default;
    virtual const MouseDevice& mouse(int hand) const = 0;
    /// Gives each mouse to the other hand.
    virtual void swap() = 0;
    /// Does not wait.
    virtual void read(MouseMotion (&motion)[2]) = 0;
};

}  // namespace fulcrum::ui
