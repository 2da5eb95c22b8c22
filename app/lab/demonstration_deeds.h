// SPDX-License-Identifier: GPL-3.0-or-later
// What people of the demonstration do apart from practising: trainees read comments and ask for corrections;
// educators comment, fill in observer forms, void and decide.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::app {

/// An attempt that was recorded on the day, with its trace.
struct ShownAttempt {
    std::string id, task;
    bool passed = false;
    double moment_s = 0;     ///< that a comment is about
    double mastery = 0;      ///< of the trainee, for the answers to forms
    std::size_t number = 0;  ///< of all attempts whose trace is kept
};

/// At the end of a day, at the store's time. `trainees`: the first so many of the plan.
void do_deeds(const database::Store& store, std::size_t trainees, int day,
              const std::vector<ShownAttempt>& shown);

}  // namespace fulcrum::app
