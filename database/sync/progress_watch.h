// SPDX-License-Identifier: GPL-3.0-or-later
// Long reading that somebody may stop: asks at each part, and now and then between the rows of a long one.
#pragma once

#include "database/store/store.h"

namespace fulcrum::database {

class ProgressWatch {
  public:
    struct Stopped {};
    /// `progress` may be empty, and has to stay as long as this.
    explicit ProgressWatch(const StoreProgress& progress) : progress_(progress) {}
    /// This share of the whole is done. Throws Stopped.
    void at(double share, const char* line) {
        share_ = share;
        line_ = line;
        ask();
    }
    /// Another row was read. Throws Stopped.
    void row() {
        constexpr int rows_between = 512;
        if (++rows_ % rows_between == 0) ask();
    }

  private:
    void ask() const {
        if (progress_ && !progress_(share_, line_)) throw Stopped();
    }
    const StoreProgress& progress_;
    double share_ = 0;
    const char* line_ = "";
    int rows_ = 0;
};

}  // namespace fulcrum::database
