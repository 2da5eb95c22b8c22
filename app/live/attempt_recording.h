// SPDX-License-Identifier: GPL-3.0-or-later
// The recorder thread's half of a live attempt: moves the record into the store, keeps at once what can fail
// the attempt, and decides what a lost device does to an assessed attempt.
#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "app/live/live_attempt.h"
#include "assessment/scoring/limit_watch.h"

namespace fulcrum::app {

/// Used by one thread. Functions throw StoreError, but wait out a store that another program has locked.
class AttemptRecording {
  public:
    /// Begins the attempt in the store. The request must outlive it.
    AttemptRecording(const LiveRequest& request, std::vector<TargetSphere> targets);

    void append(const RigSample& input, const TickSample& sample);
    void append(const StepRecord& step);
    void append(const Event& event);
    /// The program stood still for this long while an assessed attempt ran: it becomes practice, as after a
    /// lost device.
    void stood_still(double seconds);
    /// After everything up to `tick` was appended: writes it at least once a second, and at once where it can
    /// fail the attempt (LimitWatch).
    void keep(std::uint32_t tick);
    /// Before the end: writes all of it, and settles what a lost device did.
    void settle();
    /// From the store, not from memory, so that the score belongs to what was stored.
    ScoredAttempt score() const;
    /// A device was lost and came back, or the program stood still, and nothing recorded before it fails the
    /// attempt.
    bool became_practice() const { return practice_; }

    const std::string& attempt_id() const { return recorder_.attempt_id(); }
    void finish(const database::AttemptResult& result);

  private:
    void relabel();

    const LiveRequest& request_;
    std::vector<TargetSphere> targets_;
    database::Recorder recorder_;
    LimitWatch watch_;
    std::uint32_t flushed_tick_ = 0;
    bool keep_now_ = false, lost_now_ = false, came_back_ = false, practice_ = false;
    Statement why_practice_ = StatementId::practice_device_lost;
    /// Whether what was recorded before the first loss is failed; computed on a thread of its own.
    std::shared_future<bool> failed_before_;
};

}  // namespace fulcrum::app
