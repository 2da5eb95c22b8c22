// SPDX-License-Identifier: Apache-2.0
// The cumulative sum that notices that a proficient trainee fails more often than is acceptable (docs/
// METRICS.md, Progress).
#pragma once

namespace fulcrum {

/// Acceptable and unacceptable share of failures.
inline constexpr double relapse_p0 = 0.1, relapse_p1 = 0.3;
/// Share of proficient trainees who may be alarmed within relapse_attempts by chance.
inline constexpr double relapse_false_alarms = 0.05;
inline constexpr int relapse_attempts = 20;
/// The smallest multiple of 0.01 at which the chance of an alarm within relapse_attempts at relapse_p0 is at
/// most relapse_false_alarms; relapse_alarm() computes it, a test compares.
inline constexpr double relapse_limit = 3.05;

/// Chance of an alarm within `attempts` at a share `q` of failures and the limit `h`, exact: by dynamic
/// programming over (failures, passes) since the sum was last 0.
double relapse_alarm(double q, double h, int attempts);

class RelapseCusum {
  public:
    /// One attempt; true: alarm, and the sum starts again.
    bool step(bool passed);
    double sum() const { return sum_; }

  private:
    double sum_ = 0;
};

}  // namespace fulcrum
