// SPDX-License-Identifier: GPL-3.0-or-later
// The sound of the window's attempts: the choice in the settings of the program, and the output, which is
// open from the first attempt with sound on. UI thread.
#pragma once

#include <memory>

#include "sim_core/sound/sound_output.h"
#include "ui/services/sound_service.h"

namespace fulcrum::app {

class Sounds {
  public:
    static ui::SoundChoice choice();
    void choose(const ui::SoundChoice& choice);
    void play(SoundState state);
    void test();
    Sentence trouble();

  private:
    /// Null where no sound is wanted.
    SoundOutput* output();
    std::unique_ptr<SoundOutput> output_;
    ui::SoundChoice choice_ = choice();
    SoundState newest_;
    std::uint64_t tests_ = 0;
};

}  // namespace fulcrum::app
