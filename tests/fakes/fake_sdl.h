// SPDX-License-Identifier: Apache-2.0
// What a test scripts and sees of the fake SDL 2 (libsdl2.cpp): a page of memory that both map from the file
// that FAKE_SDL_PAGE names.
#pragma once

#include <atomic>
#include <cstdint>

namespace fulcrum::test {

struct FakeSdlController {
    // Scripted. Axes and buttons in SDL's order, y downwards.
    std::atomic<std::uint32_t> plugged{0}, known{1}, opens{1};
    std::atomic<std::int32_t> axis[6] = {};
    std::atomic<std::int32_t> axes{6};  ///< of the joystick
    std::atomic<std::uint32_t> buttons{0};
    std::atomic<std::uint32_t> rumble_fails{0};
    char name[64] = "Fake Pad";
    // Seen.
    std::atomic<std::uint32_t> open{0}, closed{0};
    std::atomic<std::uint32_t> slow{0}, fast{0}, rumble_ms{0}, rumbles{0};
    std::atomic<std::int64_t> felt_at{0};  ///< ns, of the first with a motor that runs; set to 0 to arm
};

/// A sound device that plays into nothing, in real time.
struct FakeSound {
    // Scripted.
    std::atomic<std::uint32_t> init_fails{0}, opens{1}, lost{0}, hang{0};
    // Seen.
    std::atomic<std::uint32_t> started{0}, ended{0}, open{0}, closed{0}, plays{0}, frames{0};
    std::atomic<std::uint64_t> blocks{0};
    std::atomic<std::uint64_t> played{0};  ///< samples that are not 0
    std::atomic<std::int64_t> heard_at{
        0};  ///< ns, when the first block with one was asked for; set to 0 to arm
    std::atomic<std::int32_t> heard_in{0};  ///< its first frame in that block
    std::atomic<std::uint32_t> outside{0};  ///< samples outside -1 to 1, or NaN
};

struct FakeSdlPage {
    FakeSdlController controller[2];
    FakeSound sound;
    std::atomic<std::uint32_t> init_fails{0}, hang{0};
    std::atomic<std::uint32_t> started{0}, ended{0};
    std::atomic<std::uint64_t> updates{0};
    std::atomic<std::uint32_t> misuse{0};  ///< calls before the start, of a closed controller, by two threads
};

}  // namespace fulcrum::test
