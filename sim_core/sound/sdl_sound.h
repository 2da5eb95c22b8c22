// SPDX-License-Identifier: Apache-2.0
// The functions and numbers of SDL 2 that sound needs, declared here so that the program is built without it.
// Checked against its header (tests/sim_core/sound).
#pragma once

#include <cstdint>

#include "sim_core/devices/run_time_library.h"

namespace fulcrum::sound {

inline constexpr std::uint32_t sdl_init_audio = 0x10;
inline constexpr int sdl_audio_stopped = 0;  ///< the state of a device that is gone
/// 32-bit floating point in the order of this machine's bytes.
inline constexpr std::uint16_t sdl_audio_float = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? 0x8120 : 0x9120;

struct SdlAudioSpec {
    int rate = 0;
    std::uint16_t format = 0;
    std::uint8_t channels = 0, silence = 0;
    std::uint16_t frames = 0, padding = 0;
    std::uint32_t bytes = 0;
    void (*fill)(void* user, std::uint8_t* bytes, int count) = nullptr;
    void* user = nullptr;
};

struct SdlSound {
    int (*set_hint)(const char* name, const char* value) = nullptr;
    int (*init)(std::uint32_t what) = nullptr;
    void (*quit)(std::uint32_t what) = nullptr;
    const char* (*error)() = nullptr;
    std::uint32_t (*open)(const char* device, int capture, const SdlAudioSpec* asked, SdlAudioSpec* given,
                          int changes) = nullptr;
    void (*pause)(std::uint32_t device, int pause) = nullptr;
    int (*status)(std::uint32_t device) = nullptr;
    void (*close)(std::uint32_t device) = nullptr;

    /// FULCRUM_LIBSDL2 names another file. Its functions for controllers are not asked for.
    LibraryLook load();
};

}  // namespace fulcrum::sound
