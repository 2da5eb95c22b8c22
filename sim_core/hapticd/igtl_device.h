// SPDX-License-Identifier: Apache-2.0
// Instruments that another program tracks and sends over OpenIGTLink (docs/DEVICES.md, Tracked instruments):
// PLUS, 3D Slicer, the program of a tracker. Without force.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim_core/hapticd/backend.h"
#include "sim_core/hapticd/followed_handle.h"
#include "sim_core/igtl/connection.h"
#include "sim_core/igtl/content.h"

namespace fulcrum::hapticd {

struct IgtlSpecification {
    igtl::Address address;
    std::array<std::string, device_slots> tool = {"LeftTipToPatient", "RightTipToPatient",
                                                  "ScopeTipToPatient"};
    std::array<bool, device_slots> named = {};  ///< by the person: it has to be there
    double length = 0.34;                ///< m, from the tracked point back along the shaft to the handle
    Matrix3 axes = Matrix3::Identity();  ///< the device frame from the tracker's
    Vector3 shaft = Vector3::UnitZ();    ///< towards the tip, in the tool's frame
};
/// "openigtlink", "openigtlink:HOST:PORT,left=NAME,…" (docs/DEVICES.md). Throws InputError.
IgtlSpecification igtl_specification(const std::string& specification);

TrackedHandle handle_of(const igtl::Pose& pose, const IgtlSpecification& specification) noexcept;

class IgtlDevice : public Backend {
  public:
    explicit IgtlDevice(IgtlSpecification specification) : wanted_(std::move(specification)) {}
    const DeviceFacts& facts() const override { return facts_; }
    void open() override;
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int /*hand*/, const Vector3& /*force*/, double /*torque*/) noexcept override {}
    FaultReport fault() const noexcept override { return report_; }
    bool lost() const noexcept override { return needs_opening(ended_); }

  private:
    struct Slot {
        FollowedHandle handle;
        double jaw = 1;
        std::uint32_t buttons = 0;
    };
    void take_arrived(std::int64_t now) noexcept;
    void take(const igtl::Message& message, std::int64_t now) noexcept;
    void take_pose(std::string_view tool, const std::optional<igtl::Pose>& pose, std::int64_t now) noexcept;
    void take_jaw(std::string_view device, const igtl::Sensor& sensor, std::int64_t now) noexcept;
    void note(std::string_view tool);
    bool all_seen(bool named_only) const noexcept;
    [[noreturn]] void refuse() const;

    IgtlSpecification wanted_;
    DeviceFacts facts_;
    igtl::Connection connection_;
    igtl::Decoder decoder_;
    Slot slots_[device_slots];
    DeviceFault ended_ = DeviceFault::none;
    std::int64_t wrong_checksum_at_ = 0, bad_pose_at_ = 0;  // ns; 0: never
    std::uint64_t sequence_ = 0;
    FaultReport report_;
    bool opening_ = false;
    std::vector<std::string> other_tools_;  // seen while opening
};

inline constexpr Maker igtl_maker = {"openigtlink", make_device<IgtlDevice, igtl_specification>};

}  // namespace fulcrum::hapticd
