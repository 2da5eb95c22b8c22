// SPDX-License-Identifier: GPL-3.0-or-later
// Sound during attempts: whether it is wanted, how loud, and why there is none. UI thread.
#pragma once

#include "sim_core/numerics/sentence.h"
#include "sim_core/sound/sound_state.h"

namespace fulcrum::ui {

/// Kept for this station.
struct SoundChoice {
    bool wanted = true;
    double volume = 0.5;  ///< 0 to 1
};

class SoundService {
  public:
    virtual ~SoundService() = default;
    virtual SoundChoice sound_choice() const { return {}; }
    virtual void choose_sound(const SoundChoice& /*choice*/) {}
    /// The newest state, 60 times a second while a task is shown; volume and tests are filled in. Opens the
    /// sound device where sound is wanted and it is not open. Does not wait.
    virtual void play_sound(const SoundState& /*state*/) {}
    /// Plays every sound once.
    virtual void test_sound() {}
    /// Why there is no sound and what to do; empty while there is, or none is wanted. Opens the device like
    /// play_sound().
    virtual Sentence sound_trouble() { return {}; }
};

}  // namespace fulcrum::ui
