// SPDX-License-Identifier: Apache-2.0
// Devices of Force Dimension and the Novint Falcon through libdrd, one or two. The library has no servo loop:
// a thread of this process reads and gives force 1000 times a second, because a call can take longer than a
// tick of the device process.
//
// Its frame is x towards the person, y to the right, z up. The turn of the handle about x is the roll, the
// gripper the jaws; a device without a gripper closes jaws with its first button.
#pragma once

#include <atomic>
#include <thread>

#include "sim_core/hapticd/force_dimension_library.h"
#include "sim_core/hapticd/servo_backend.h"

namespace fulcrum::hapticd {

/// Numbers of the devices as the library counts them.
struct ForceDimensionNumbers {
    bool given = false;  ///< else: one device moves the right hand; of two, 0 the left and 1 the right
    int hand[2] = {-1, -1};
};
/// Of "force-dimension" or "force-dimension:LEFT,RIGHT", of which one may be empty. Throws InputError.
ForceDimensionNumbers force_dimension_numbers(const std::string& specification);

class ForceDimensionDevice : public ServoBackend {
  public:
    explicit ForceDimensionDevice(ForceDimensionNumbers numbers);
    ~ForceDimensionDevice() override { close(); }
    void open() override;
    void close() noexcept override;

  private:
    struct Hand {
        char id = -1;
        bool gripper = false;
        double jaw = 1;
        std::int64_t slowed = 0;  // ns, when it switched itself off
        ServoReading last;
        FaultMemory memory;
    };
    void open_hand(int hand, int number);
    Sentence last_error() const;
    void run() noexcept;
    void serve(int hand, std::int64_t now) noexcept;
    void check(Hand& one, std::int64_t now) noexcept;
    bool read_pose(Hand& one) noexcept;

    ForceDimensionNumbers numbers_;
    ForceDimensionLibrary library_;
    Hand hands_[2];
    std::thread servo_;
    std::atomic<bool> runs_{false};
    std::uint64_t ticks_ = 0;
};

inline constexpr Maker force_dimension_maker = {"force-dimension",
                                                make_device<ForceDimensionDevice, force_dimension_numbers>,
                                                load_whole<ForceDimensionLibrary>};

}  // namespace fulcrum::hapticd
