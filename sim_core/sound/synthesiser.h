// SPDX-License-Identifier: Apache-2.0
// Makes the sounds of an attempt, sample by sample:
//
//   contact     a short click, louder the harder the contact; low for tissue with a limit of force, high else
//   over-force  a tone that gets higher and louder with the excess
//   energy      a hum while energy is on
//   bleeding    two short tones, once a second
//
// The left hand is louder in the left channel. Every level is ramped, so that nothing crackles. fill() may be
// called from a thread of the sound system: no lock, allocation, system call or exception. The same states
// and block sizes give the same samples.
#pragma once

#include "sim_core/sound/sound_state.h"

namespace fulcrum {

inline constexpr int sound_rate = 48000;  ///< Hz
inline constexpr int sound_channels = 2;
inline constexpr double sound_test_lasts = 2;  ///< s

class Synthesiser {
  public:
    /// `frames` pairs of samples, left and right in turn, each within -1 to 1. Contacts and tests that were
    /// counted before the first call are not heard.
    void fill(const SoundState& state, float* samples, int frames) noexcept;

  private:
    /// A value that moves towards another one.
    struct Ramp {
        double now = 0, target = 0;
        double step(double share) noexcept;
    };
    struct Click {
        double level = 0, rise = 0, phase = 0, frequency = 0;
        int rising = 0;  ///< samples
        void start(double strength, bool hard) noexcept;
        double next() noexcept;
    };
    struct Voice {
        Ramp gain, frequency;
        double phase = 0;
        double turn() noexcept;  ///< the phase after one more sample, 0 to 1
    };
    void take(const SoundState& state) noexcept;
    void follow_test() noexcept;
    void follow_alarm() noexcept;
    void mix(float* pair) noexcept;

    Ramp volume_;
    Click click_[2];
    Voice over_[2], energy_[2], alarm_;
    SoundState wanted_;
    std::int64_t alarm_at_ = -1;  // samples since it began; -1: off
    std::int64_t test_at_ = -1;
    bool known_ = false;
};

}  // namespace fulcrum
