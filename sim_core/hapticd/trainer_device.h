// SPDX-License-Identifier: Apache-2.0
// A box trainer whose sensors a micro-controller reads and sends over a serial port (docs/TRAINER.md): one or
// two instruments and the scope, with buttons and a pedal. Without force.
#pragma once

#include <string>
#include <vector>

#include "sim_core/hapticd/backend.h"
#include "sim_core/hapticd/followed_handle.h"
#include "sim_core/hapticd/trainer_line.h"

namespace fulcrum::hapticd {

struct TrainerSpecification {
    std::string port;      ///< empty: the only serial port of a micro-controller
    int baud = 115200;     ///< bits a second; a port of USB alone ignores it
    double length = 0.34;  ///< m from the tip to the handle along the shaft
    /// rad, of each hand: what pitch, yaw and roll are where the instrument points straight away from the
    /// person.
    double zero[2][3] = {};
    std::int64_t patience =
        4000LL * 1'000'000;  ///< ns for the first answer: a board that is opened begins again
};
/// "trainer", "trainer:PORT,baud=57600,length=330,zero-left=12;-3;0" (mrad). Throws InputError.
TrainerSpecification trainer_specification(const std::string& specification);

/// Where the handle is whose tip is where the trainer says, with the pivot at the origin, device frame.
TrackedHandle handle_of(const TrainerPose& pose, double length) noexcept;

class TrainerDevice : public Backend {
  public:
    explicit TrainerDevice(TrainerSpecification specification) : wanted_(std::move(specification)) {}
    ~TrainerDevice() override;
    TrainerDevice(const TrainerDevice&) = delete;
    TrainerDevice& operator=(const TrainerDevice&) = delete;
    const DeviceFacts& facts() const override { return facts_; }
    void open() override;
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int /*hand*/, const Vector3& /*force*/, double /*torque*/) noexcept override {}
    FaultReport fault() const noexcept override { return report_; }
    bool lost() const noexcept override { return ended_; }

  private:
    struct Part {
        FollowedHandle handle;
        double jaw = 1;
        std::uint32_t buttons = 0;
        std::uint16_t sequence = 0;
        std::uint32_t time_us = 0;
        bool any = false, again = false;  // a pose came; the trainer may have begun again since
    };
    void open_port();
    void ask() noexcept;
    void take_arrived(std::int64_t now) noexcept;
    void take(const TrainerMessage& message, std::int64_t now) noexcept;
    void take_pose(const TrainerPose& pose, std::int64_t now) noexcept;
    /// Of the parts that the trainer said it has.
    bool all_seen() const noexcept;
    DeviceFault fault_at(std::int64_t now) const noexcept;
    [[noreturn]] void refuse() const;

    TrainerSpecification wanted_;
    DeviceFacts facts_;
    int port_ = -1;
    TrainerDecoder decoder_;
    TrainerHello hello_;
    Part parts_[device_slots];
    bool greeted_ = false, ended_ = false, any_bytes_ = false;
    int other_version_ = 0;
    std::int64_t checksum_at_ = 0, line_at_ = 0, values_at_ = 0;  // ns of the last such fault; 0: never
    std::int64_t asked_at_ = 0;
    std::uint64_t sequence_ = 0;
    FaultReport report_;
};

inline constexpr Maker trainer_maker = {"trainer", make_device<TrainerDevice, trainer_specification>};

}  // namespace fulcrum::hapticd
