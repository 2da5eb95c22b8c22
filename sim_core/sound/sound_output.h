// SPDX-License-Identifier: Apache-2.0
// Plays what a Synthesiser makes on the sound device of the system, through SDL 2. A thread of its own opens
// the device, looks whether it is still there and opens the next one where it is not; SDL's thread asks for
// the samples. Where there is no sound, trouble() says why and nothing else changes.
#pragma once

#include <memory>

#include "sim_core/numerics/sentence.h"
#include "sim_core/sound/sound_state.h"

namespace fulcrum {

inline constexpr int sound_block_frames = 256;  ///< asked for at a time: 5.3 ms

class SoundOutput {
  public:
    /// Returns at once; the device is opened afterwards. What `before` counts is not heard.
    explicit SoundOutput(const SoundState& before = {});
    ~SoundOutput();
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    /// From one thread: the newest state. Half a second without another one ends every sound that lasts, and
    /// a few seconds put the device to rest.
    void play(const SoundState& state) noexcept;
    /// The device was opened and is there.
    bool plays() const;
    /// Why there is no sound and what to do; empty while there is, and before it is known.
    Sentence trouble() const;

  private:
    struct Shared;
    class Keeper;
    static void run(const std::shared_ptr<Shared>& shared);
    static void fill(void* shared, std::uint8_t* bytes, int count);
    std::shared_ptr<Shared> shared_;
};

}  // namespace fulcrum
