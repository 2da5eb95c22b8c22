// SPDX-License-Identifier: Apache-2.0
// A HID joystick as an instrument of a box trainer: its axes are angles and lengths by the mapping that a
// calibration made. A thread of its own reads it through SDL 2 every 4 ms.
#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>

#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/devices/shared_latest.h"
#include "sim_core/hapticd/backend.h"
#include "sim_core/hapticd/followed_handle.h"

namespace fulcrum::hapticd {

struct JoystickSpecification {
    std::optional<JoystickMapping> mapping;  ///< none: raw
    std::string name;                        ///< empty: the first one
};
/// "joystick:FILE.json" with a mapping, or "joystick:raw", "joystick:raw,NAME" for a calibration: the axes in
/// their order are position and roll and jaw of the left part, then of the right. Throws InputError.
JoystickSpecification joystick_specification(const std::string& specification);

class JoystickDevice : public Backend {
  public:
    explicit JoystickDevice(JoystickSpecification specification) : wanted_(std::move(specification)) {}
    ~JoystickDevice() override;
    JoystickDevice(const JoystickDevice&) = delete;
    JoystickDevice& operator=(const JoystickDevice&) = delete;
    const DeviceFacts& facts() const override { return facts_; }
    void open() override;
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int /*hand*/, const Vector3& /*force*/, double /*torque*/) noexcept override {}
    FaultReport fault() const noexcept override { return report_; }
    bool lost() const noexcept override { return fault_ != DeviceFault::none; }

  private:
    struct Read {
        std::int64_t time = 0;  ///< ns
        std::uint64_t count = 0;
        JoystickReading now;
    };
    /// Outlives the device where the library hangs.
    struct Shared {
        std::mutex mutex;
        std::condition_variable changed;
        bool opened = false, stop = false, ended = false;
        std::exception_ptr error;
        std::string name;
        int axes = 0;
        SharedLatest<Read> newest;
        std::atomic<bool> gone{false};
    };
    static void run(const std::shared_ptr<Shared>& shared, const std::string& name);
    void move(const Read& newest, std::int64_t now, DevicePose (&poses)[device_slots]) noexcept;

    JoystickSpecification wanted_;
    DeviceFacts facts_;
    std::shared_ptr<Shared> shared_;
    Read last_;
    FollowedHandle handle_[2];
    std::uint64_t sequence_ = 0;
    DeviceFault fault_ = DeviceFault::none;
    FaultReport report_;
};

inline constexpr Maker joystick_maker = {"joystick", make_device<JoystickDevice, joystick_specification>};

}  // namespace fulcrum::hapticd
