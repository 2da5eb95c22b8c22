// SPDX-License-Identifier: Apache-2.0
// The two pages of memory that fulcrum-hapticd shares with the program that uses the device
// (docs/DEVICES.md).
//
// The daemon alone writes the state page: the other side can map it for reading only. The program writes the
// command page. Device frame: +x to the right, +y up, +z towards the person, right-handed. Times: ns of
// CLOCK_MONOTONIC.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "sim_core/devices/shared_latest.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr int device_slots = 3;  ///< left hand, right hand, scope
inline constexpr int scope_slot = 2;
/// In files and on the command line; permanent.
inline constexpr const char* device_slot_names[device_slots] = {"left", "right", "scope"};

/// The newest reading of one slot.
struct DevicePose {
    std::uint64_t sequence = 0;      ///< rises by 1 with each reading
    std::int64_t time = 0;           ///< ns, when it was read
    double position[3] = {0, 0, 0};  ///< m, device frame
    double roll = 0;                 ///< rad about the shaft, positive from trocar to tip
    double jaw = 0;                  ///< share of the opening, 0 closed, 1 open
    std::uint32_t buttons = 0;       ///< DeviceButton mask
    std::uint32_t present = 0;       ///< 1: the device answered
};

/// The force that the program asks for.
struct ForceCommand {
    std::uint64_t sequence = 0;   ///< rises with each command
    std::int64_t time = 0;        ///< ns, when it was written
    double force[3] = {0, 0, 0};  ///< N on the hand, device frame
    double torque = 0;            ///< N m about the shaft
};

/// Why a hand's motors get no force.
enum class ForceOff : std::uint32_t {
    none,              ///< force is rendered
    starting,          ///< it was off, and the commands have not been good for long enough
    no_program,        ///< the program is gone
    silent,            ///< no new command
    not_finite,        ///< a command with NaN or infinity
    too_large,         ///< a command above the device's peak force
    sequence_back,     ///< a command older than the one before
    overseer_stopped,  ///< the process that would switch off the motors does not run
    device_stopped,    ///< the process that reads the device stopped or ended
    device_fault       ///< the device has a fault, see device_table.h
};
const char* words_of(ForceOff why);

/// What the motors of one hand got.
struct ForceReport {
    std::uint64_t sequence = 0;     ///< of the command
    std::int64_t command_time = 0;  ///< ns, of the command
    std::int64_t time = 0;          ///< ns, when it was rendered
    double force[3] = {0, 0, 0};    ///< N, rendered
    std::uint64_t off = 0;          ///< ForceOff
};

/// What is wrong with the device.
struct FaultReport {
    std::uint64_t fault = 0;  ///< DeviceFault (device_table.h)
    std::uint64_t hands = 0;  ///< bit 0: left, bit 1: right
};

/// How the daemon's loop runs.
struct LoopReport {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;         ///< ticks that began a period or more after their time
    std::uint64_t late_own = 0;     ///< of these: because of the process's own work or waits (TickAccount)
    std::int64_t worst_late = 0;    ///< ns
    std::int64_t period = 1000000;  ///< ns
    std::uint64_t real_time = 0;    ///< 1: with real-time priority
    double jitter = 0;              ///< s, see Jitter
};

struct StatePage {
    SharedLatest<DevicePose> pose[device_slots];
    SharedLatest<ForceReport> report[2];  ///< written by the device process, or by the overseer after its end
    SharedLatest<LoopReport> loop;
    SharedLatest<FaultReport> fault;             ///< as report
    std::atomic<std::int64_t> overseer_time{0};  ///< ns, rises while the overseer runs
    std::atomic<std::uint64_t> connection{0};    ///< 0: no program is connected
    std::atomic<std::uint64_t> stopping{0};      ///< 1: the device process is to end
};

struct CommandPage {
    SharedLatest<ForceCommand> command[2];
};

/// Shared memory with a T. Throws std::system_error where the system refuses.
template <typename T>
class SharedPage {
  public:
    SharedPage() = default;
    /// New memory of this process, which may write it. `others_read`: another process can map it for reading
    /// only.
    static SharedPage create(const char* name, bool others_read);
    /// The memory behind `descriptor`, which is closed with it. Throws std::runtime_error if its size or its
    /// seals are not those of a page that create() made.
    static SharedPage open(int descriptor, bool writes);
    SharedPage(SharedPage&& other) noexcept { swap(other); }
    SharedPage& operator=(SharedPage&& other) noexcept {
        swap(other);
        return *this;
    }
    ~SharedPage();
    T* get() const { return page_; }
    T* operator->() const { return page_; }
    explicit operator bool() const { return page_ != nullptr; }
    int descriptor() const { return descriptor_; }

  private:
    void swap(SharedPage& other) noexcept {
        std::swap(page_, other.page_);
        std::swap(descriptor_, other.descriptor_);
    }
    T* page_ = nullptr;
    int descriptor_ = -1;
};
extern template class SharedPage<StatePage>;
extern template class SharedPage<CommandPage>;

/// ns of CLOCK_MONOTONIC.
std::int64_t monotonic_ns() noexcept;

}  // namespace fulcrum
