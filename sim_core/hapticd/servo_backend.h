// SPDX-License-Identifier: Apache-2.0
// A device whose library has a servo loop of its own, in a thread of its own: readings and forces cross
// between that thread and the loop of the device process as latest values, and neither waits for the other.
// Whichever of the two stops, the force is 0 within `servo_silence`.
#pragma once

#include "sim_core/devices/shared_latest.h"
#include "sim_core/hapticd/backend.h"

namespace fulcrum::hapticd {

inline constexpr std::int64_t servo_silence = 20'000'000;  ///< ns
/// ns: two silences that are closer than this are one, until it has kept up for so long. Without that the
/// hand of a device that answers every 30 ms would be present and absent in turn, and no attempt would pause.
inline constexpr std::int64_t falls_behind = 200 * 1'000'000;
inline constexpr std::int64_t time_to_be_lost = 1000 * 1'000'000;  ///< ns with a fault that needs opening

/// What the servo thread read of one hand.
struct ServoReading {
    std::uint64_t sequence = 0;      ///< rises by 1 with each reading
    double position[3] = {0, 0, 0};  ///< m, device frame
    double roll = 0, jaw = 1;        ///< as DevicePose
    std::uint64_t buttons = 0;       ///< DeviceButton mask
    std::uint64_t fault = 0;         ///< DeviceFault
};

/// A fault that passes stays for a while after it was seen last, so that an attempt does not flicker. Servo
/// thread.
class FaultMemory {
  public:
    void see(DeviceFault fault, std::int64_t now) noexcept {
        // Until the device was opened again, nothing milder replaces it.
        if (needs_opening(fault_) && !needs_opening(fault)) return;
        fault_ = fault;
        until_ = needs_opening(fault) ? INT64_MAX : now + time_of(fault);
    }
    DeviceFault at(std::int64_t now) noexcept {
        if (now >= until_) fault_ = DeviceFault::none;
        return fault_;
    }

  private:
    static std::int64_t time_of(DeviceFault fault) noexcept {
        constexpr std::int64_t ms = 1'000'000;
        return fault_row(fault).remembered * ms;
    }
    DeviceFault fault_ = DeviceFault::none;
    std::int64_t until_ = 0;
};

class ServoBackend : public Backend {
  public:
    const DeviceFacts& facts() const override { return facts_; }
    void read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept override;
    void render(int hand, const Vector3& force, double torque) noexcept override;
    FaultReport fault() const noexcept override { return report_; }
    bool lost() const noexcept override { return lost_; }

  protected:
    /// Servo thread: the force for a hand, within its peak; 0 where the device process has written none
    /// lately.
    Vector3 wanted_force(int hand, std::int64_t now) const noexcept;
    double wanted_torque(int hand, std::int64_t now) const noexcept;
    /// Servo thread; counts.
    void publish(int hand, ServoReading reading) noexcept;
    std::uint64_t published(int hand) const noexcept { return count_[hand].load(std::memory_order_acquire); }
    /// Waits until the servo thread has run twice more, at most 20 ms. Not real-time.
    void wait_for_servo() const noexcept;

    DeviceFacts facts_;  ///< set by open()
    /// What is wrong where no new reading comes.
    DeviceFault silent_ = DeviceFault::servo_stopped;

  private:
    struct Wanted {
        std::int64_t time = 0;
        double force[3] = {0, 0, 0}, torque = 0;
    };
    struct Silence {
        std::int64_t new_at = 0, seen_at = 0;  // ns: newest reading; silence seen last
        bool now = false, again = false;
    };
    bool newest(int hand, std::int64_t now, Wanted& wanted) const noexcept;
    static bool is_silent(Silence& silence, bool is_new, std::int64_t now) noexcept;
    SharedLatest<Wanted> wanted_[2];
    SharedLatest<ServoReading> reading_[2];
    std::atomic<std::uint64_t> count_[2] = {};
    ServoReading newest_[2];
    Silence silence_[2];
    std::int64_t faulty_since_ = 0;
    FaultReport report_;
    bool lost_ = false;
};

}  // namespace fulcrum::hapticd
