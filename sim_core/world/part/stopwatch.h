// SPDX-License-Identifier: Apache-2.0
// Times a block of the step when the laboratory asks; never read by anything that feeds back.
#pragma once

#include <chrono>

namespace fulcrum {

/// Writes the wall time of its life into `target`, microseconds, when on.
class Stopwatch {
  public:
    Stopwatch(bool on, double& target) : on_(on), target_(target) {
        if (on_) begin_ = std::chrono::steady_clock::now();
    }
    ~Stopwatch() {
        if (on_)
            target_ =
                std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    bool on_;
    double& target_;
    std::chrono::steady_clock::time_point begin_;
};

}  // namespace fulcrum
