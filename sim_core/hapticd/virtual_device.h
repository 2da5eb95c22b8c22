// SPDX-License-Identifier: Apache-2.0
// A device without hardware, from a script (docs/DEVICES.md, Scripts): each slot replays a recording, follows
// a path, or is a simulated hand whose arm is pulled along a path and which yields to the force.
#pragma once

#include <optional>
#include <vector>

#include "sim_core/hapticd/backend.h"
#include "sim_core/instrument/moving_hand.h"

namespace fulcrum::hapticd {

struct PathPoint {
    double time = 0;  ///< s
    Vector3 position = Vector3::Zero();
    double roll = 0, jaw = 1;  ///< rad; share of the opening
    std::uint32_t buttons = 0;
};

/// Straight lines between points; buttons are those of the point before.
struct ScriptedPath {
    std::vector<PathPoint> points;  ///< times rise
    bool repeat = false;
    PathPoint at(double time) const noexcept;
};

enum class ScriptedFaultKind : std::uint8_t { silence, not_a_number, jump };
/// For `length` s from `time` on the device does this.
struct ScriptedFault {
    double time = 0, length = 0;  ///< s
    bool after_force = false;     ///< `time` counts from the first force on a hand
    ScriptedFaultKind kind = ScriptedFaultKind::silence;
};

struct DeviceScript {
    DeviceFacts facts;
    struct Slot {
        ScriptedPath path;
        std::optional<HandProperties> hand;  ///< yields to the force; else the path itself
    } slots[device_slots];
    std::vector<ScriptedFault> faults;
};

/// Throws InputError with place and hint.
DeviceScript read_device_script(const std::string& path);
/// The script that "virtual:SCRIPT.json" names. Throws InputError also where it names none.
DeviceScript read_script(const std::string& specification);
/// A recording as a path of each slot that it names: CSV of docs/DEVICES.md. Throws InputError.
void read_recording(const std::string& path, DeviceScript& script);

class VirtualDevice : public Backend {
  public:
    explicit VirtualDevice(DeviceScript script);
    const DeviceFacts& facts() const override { return script_.facts; }
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int hand, const Vector3& force, double torque) noexcept override;

  private:
    DeviceScript script_;
    MovingHand hands_[2];
    Vector3 rendered_[2] = {Vector3::Zero(), Vector3::Zero()};
    std::int64_t begun_ = 0, before_ = 0;
    std::int64_t pushed_ = 0;  // ns, first reading after a force; 0: none yet
    std::uint64_t sequence_ = 0;
};

inline constexpr Maker virtual_maker = {"virtual", make_device<VirtualDevice, read_script>};

}  // namespace fulcrum::hapticd
