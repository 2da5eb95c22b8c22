// SPDX-License-Identifier: Apache-2.0
// A SpaceMouse through the socket of spacenavd, the free program that reads it (docs/DEVICES.md, SpaceMouse).
// Without force. The cap's deflection is a speed of the handle, its turn a speed of the roll.
#pragma once

#include <array>
#include <string>

#include "sim_core/hapticd/backend.h"

namespace fulcrum::hapticd {

inline constexpr double space_mouse_full = 350;    ///< counts of a full deflection
inline constexpr double space_mouse_speed = 0.08;  ///< m/s of the handle there
inline constexpr double space_mouse_turn = 1.5;    ///< rad/s of the roll there

/// Share of the full speed for a deflection in counts; 0 in the middle.
double space_mouse_response(std::int32_t counts) noexcept;
/// The slot of "space-mouse" (the scope), "space-mouse:left", "space-mouse:right". Throws InputError.
int space_mouse_slot(const std::string& specification);

class SpaceMouseDevice : public Backend {
  public:
    /// `slot`: of DevicePose that it moves.
    explicit SpaceMouseDevice(int slot) : slot_(slot) {}
    ~SpaceMouseDevice() override;
    SpaceMouseDevice(const SpaceMouseDevice&) = delete;
    SpaceMouseDevice& operator=(const SpaceMouseDevice&) = delete;
    const DeviceFacts& facts() const override { return facts_; }
    void open() override;
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int /*hand*/, const Vector3& /*force*/, double /*torque*/) noexcept override {}
    FaultReport fault() const noexcept override;
    bool lost() const noexcept override { return ended_; }
    /// 1, or 0 for spacenavd before version 1.
    int protocol() const { return protocol_; }

  private:
    static constexpr std::size_t numbers = 8;
    using Event = std::array<std::int32_t, numbers>;
    void greet();
    void take_arrived(std::int64_t now) noexcept;
    void take(const Event& event, std::int64_t now) noexcept;

    int slot_, socket_ = -1, protocol_ = 0;
    DeviceFacts facts_;
    std::array<std::uint8_t, sizeof(Event)> partial_{};
    std::size_t have_ = 0;  // bytes of it
    std::array<std::int32_t, 6> deflection_{};
    std::int64_t moved_at_ = 0, before_ = 0;  // ns
    Vector3 position_ = Vector3::Zero();
    double roll_ = 0;
    bool pressed_[3] = {false, false, false};
    std::uint64_t sequence_ = 0;
    bool ended_ = false;
};

inline constexpr Maker space_mouse_maker = {"space-mouse", make_device<SpaceMouseDevice, space_mouse_slot>};

}  // namespace fulcrum::hapticd
