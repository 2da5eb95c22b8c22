// SPDX-License-Identifier: GPL-3.0-or-later
// The devices that the window can use for the hands. UI thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/numerics/name_table.h"
#include "ui/services/attempt_session.h"

namespace fulcrum::ui {

enum class DeviceState : std::uint8_t { usable, connected, absent };
inline constexpr NameRow<DeviceState> device_states[] = {
    {DeviceState::usable, "usable", QT_TRANSLATE_NOOP("fulcrum::device_states", "can be used")},
    {DeviceState::connected, "connected",
     QT_TRANSLATE_NOOP("fulcrum::device_states", "connected, cannot be used")},
    {DeviceState::absent, "absent", QT_TRANSLATE_NOOP("fulcrum::device_states", "not connected")}};
static_assert(in_order(device_states));

/// A kind of device on this machine: one line of `fulcrum devices` and of the page of settings.
struct ListedDevice {
    std::string kind, title;  ///< texts in English, see device_words()
    DeviceClass device_class = DeviceClass::haptic;
    DeviceState state = DeviceState::absent;
    std::vector<std::string> found;  ///< what is connected
    std::string why, what_to_do;     ///< empty where it can be used
    std::string detail = {};         ///< of why: what the system says, in no language
};

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
    std::string kind;           ///< of a device with a driver of its own, "virtual"; else empty
};

/// The newest readings of a device that is open.
struct DeviceReadings {
    struct Slot {
        const char* name = "";  ///< "left", "right", "scope"
        bool present = false;   ///< it answered
        Vector3 position = Vector3::Zero();
        double jaw = 0;  ///< share of the opening
        std::uint32_t buttons = 0;
    };
    std::vector<Slot> held;
    double rate = 0;  ///< Hz, since the call before
};

/// Share of the model's force that a device may render: at least this, at most 1.
inline constexpr double least_force_scale = 0.1;

class DeviceService {
  public:
    virtual ~DeviceService() = default;
    virtual DeviceInUse device_in_use() const { return {}; }
    /// The hands of an attempt in `scene`: the device in use, opened where it is not, and `others` (mouse and
    /// keyboard) for what it does not have. Throws InputError where it does not open.
    virtual std::shared_ptr<Rig> hands(const Scene& /*scene*/, std::shared_ptr<Rig> others) { return others; }
    /// What is wrong with the device in use and what to do; empty while nothing is.
    virtual Sentence device_trouble() { return {}; }
    /// The devices of this machine. The function that is returned does the work and may run on any thread.
    virtual std::function<std::vector<ListedDevice>()> list_devices() {
        return [] { return std::vector<ListedDevice>(); };
    }
    /// Nothing while the device in use is not open: the first attempt opens it. Does not wait.
    virtual std::optional<DeviceReadings> device_readings() { return std::nullopt; }
    /// For attempts that begin afterwards, with devices of this kind; remembered. 1 unless it was set.
    virtual double force_scale(const std::string& /*kind*/) const { return 1; }
    virtual void set_force_scale(const std::string& /*kind*/, double /*scale*/) {}
};

}  // namespace fulcrum::ui
