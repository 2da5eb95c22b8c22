// SPDX-License-Identifier: GPL-3.0-or-later
// Qt aborts the program where it can open no display. While a DisplayNeeded lives, the program ends with one
// line and status 2 instead.
#pragma once

#include <string>
#include <vector>

#include "sim_core/numerics/sentence.h"

namespace fulcrum::app {

/// Around the construction of the application that draws; one at a time, first thread.
class DisplayNeeded {
  public:
    /// `hint`: what to do without a display.
    explicit DisplayNeeded(Sentence hint);
    /// Prints what Qt had to say where the display could be opened.
    ~DisplayNeeded();
    DisplayNeeded(const DisplayNeeded&) = delete;
    DisplayNeeded& operator=(const DisplayNeeded&) = delete;

    const Sentence& hint() const { return hint_; }
    void note(std::string line) { notes_.push_back(std::move(line)); }

  private:
    Sentence hint_;
    std::vector<std::string> notes_;
};

}  // namespace fulcrum::app
