// SPDX-License-Identifier: GPL-3.0-or-later
// The devices that the window can use for the hands. UI thread.
#pragma once

#include <memory>
#include <string>

#include "ui/services/attempt_session.h"

namespace fulcrum::ui {

/// Why attempts with a device are never assessed.
enum class PracticeOnly : std::uint8_t {
    no,
    scripted,  ///< no person moves it
    no_limits  ///< no limits exist for it, and those of its class were made with less
};

/// What the next attempt is made with.
struct DeviceInUse {
    DeviceClass device_class = window_device;
    std::string title = "mouse and keyboard";  ///< stored with the attempt
    PracticeOnly practice_only = PracticeOnly::no;
    bool virtual_mice = false;  ///< two pointers of the X server, for tests
    bool two_mice = false;      ///< the window reads one mouse for each hand
};

class DeviceService {
  public:
    virtual ~DeviceService() = default;
    virtual DeviceInUse device_in_use() const { return {}; }
    /// The hands of an attempt in `scene`: the device in use, opened where it is not, and `others` (mouse and
    /// keyboard) for what it does not have. Throws InputError where it does not open.
    virtual std::shared_ptr<Rig> hands(const Scene& /*scene*/, std::shared_ptr<Rig> others) { return others; }
    /// What is wrong with the device in use and what to do; empty while nothing is.
    virtual std::string device_trouble() { return {}; }
};

}  // namespace fulcrum::ui
