// SPDX-License-Identifier: Apache-2.0
// Performs and scores one attempt of a rig, as far as it takes to know the verdict.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "assessment/attempt/memory_sink.h"
#include "assessment/metrics/registry.h"
#include "assessment/operators/cheats.h"
#include "assessment/scoring/limit_watch.h"
#include "tests/assessment/operators/earliest_end.h"

namespace fulcrum::test {

struct CheatVerdict {
    Score score;
    AttemptState state = AttemptState::interrupted;
    double seconds = 0;  ///< simulated
    /// A device was lost and came back, after which nothing passes (Score,
    /// ALostDeviceTakesBackNothingAndGivesNoPass).
    bool lost_device = false;
    bool early = false;  ///< ended before the attempt did, because no continuation passes
    /// Where it ended early: the score if the task were completed from there as soon as it can be, and what
    /// of it no continuation takes back.
    Score at_best;
    std::string decided_by;
    /// The gates that were not met and the critical errors, for messages.
    std::string why() const {
        std::string text;
        for (const CriticalError& error : score.critical_errors) text += error.event + "! ";
        for (const GateResult& gate : score.gates)
            if (gate.passed == false) text += name_of(gate) + " ";
        return text;
    }
};

inline Score score_so_far(const CheatStage& stage, const AttemptRecord& record,
                          const std::vector<TargetSphere>& targets) {
    return score_by(stage, stage.task, record.samples, record.events, targets);
}

// s after which an attempt is not followed further: before its first movement (what cheats do begins within
// 20 s), and while hands, pedals and camera stay exactly as they are (a hand that an operator holds still
// trembles). Both would last to the end of the time limit.
inline constexpr double longest_rest_s = 21, longest_stillness_s = 12;

inline bool same_input(const RigSample& a, const RigSample& b) {
    static_assert(std::has_unique_object_representations_v<DeviceSample>);
    return a.flags == b.flags && std::memcmp(&a.hand, &b.hand, sizeof a.hand) == 0 &&
           std::memcmp(&a.camera, &b.camera, sizeof a.camera) == 0;
}

/// When an attempt need not be followed further.
class Verdict {
  public:
    Verdict(const CheatStage& stage, const AttemptEngine& engine, const AttemptRecord& record,
            const std::vector<TargetSphere>& targets, const CheatingRig& rig)
        : stage_(stage),
          engine_(engine),
          record_(record),
          targets_(targets),
          rig_(rig),
          watch_(stage.task, stage.scene, stage.limits),
          values_(stage.lasting.gates.size(), 0.0) {}

    /// Called once a simulated second.
    bool is_open(double seconds) {
        see(seconds);
        if (seconds - still_since_ >= longest_stillness_s) return false;
        if (seconds >= longest_rest_s && !engine_.display().moving_seen) return false;
        if (!rig_.has_cheated() || !is_due(seconds)) return true;
        const Score score = score_at_best(stage_.lasting);
        decided_by_ = broken_for_good(score);
        decided_ = lost_device_ || !decided_by_.empty();
        watch_.written();
        plan(seconds, score);
        return !decided_;
    }
    bool decided() const { return decided_; }
    const std::string& decided_by() const { return decided_by_; }
    /// By the gates of `task`, if it were completed as soon as it can be.
    Score score_at_best(const TaskDefinition& task) const {
        return score_by(
            stage_, task, record_.samples,
            completed_after(record_.events, record_.samples.back().tick, holds(), stage_.scene.tick_period()),
            targets_);
    }

  private:
    double holds() const { return holds_after(stage_.task, engine_.display().goal); }

    void see(double seconds) {
        const std::vector<RigSample>& inputs = record_.inputs;
        for (; input_ < inputs.size(); ++input_)
            if (!same_input(inputs[input_], inputs[input_ - 1])) still_since_ = seconds;
        for (; sample_ < record_.samples.size(); ++sample_) watch_.see(record_.samples[sample_]);
        for (; event_ < record_.events.size(); ++event_) {
            watch_.see(record_.events[event_]);
            lost_device_ = lost_device_ || record_.events[event_].kind == EventKind::device_back;
        }
    }

    /// Whether to look at the score. Each look reads the record from its beginning: in a constant interval
    /// the looks would cost more than the attempt.
    bool is_due(double seconds) const {
        constexpr double clock_slack = 0.25;  // s between the monitor's clock and the metric's beginning
        const bool late =
            stage_.longest_s && engine_.display().elapsed_s + holds() > *stage_.longest_s + clock_slack;
        return lost_device_ || late || watch_.due(0) || seconds >= next_look_;
    }

    /// The next look comes when a sum reaches its limit at the pace since the last one.
    void plan(double seconds, const Score& score) {
        next_look_ = std::max(seconds + 5, 1.3 * seconds);
        for (std::size_t i = 0; i < score.gates.size(); ++i) {
            const GateResult& gate = score.gates[i];
            if (!gate.value || !gate.limit || gate.metric == "time" ||
                find_metric(gate.metric)->aggregation != Aggregation::total)
                continue;
            const double pace = (*gate.value - values_[i]) / (seconds - last_look_);
            values_[i] = *gate.value;
            if (pace > 0)
                next_look_ =
                    std::min(next_look_, seconds + std::max(1.0, (*gate.limit - *gate.value) / pace));
        }
        last_look_ = seconds;
    }

    const CheatStage& stage_;
    const AttemptEngine& engine_;
    const AttemptRecord& record_;
    const std::vector<TargetSphere>& targets_;
    const CheatingRig& rig_;
    LimitWatch watch_;
    std::vector<double> values_;  ///< of the gates, at the last look
    std::string decided_by_;
    std::size_t input_ = 1, sample_ = 0, event_ = 0;
    bool lost_device_ = false, decided_ = false;
    double still_since_ = 0, last_look_ = 0, next_look_ = 4;
};

/// Stops as soon as no continuation passes, and leaves the attempt as a closed program would; `whole` runs to
/// the end all the same.
inline CheatVerdict judge(const CheatStage& stage, CheatingRig& rig, std::uint64_t seed, bool whole = false) {
    AttemptEngine engine(stage.scene, stage.task, seed);
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    MemorySink sink;
    Verdict open(stage, engine, sink.record, targets, rig);
    const RunOutcome outcome =
        run_headless(engine, rig, sink, [&](double seconds) { return whole || open.is_open(seconds); });
    CheatVerdict verdict;
    verdict.seconds = outcome.ticks * stage.scene.tick_period();
    verdict.score = score_so_far(stage, sink.record, targets);
    verdict.state = attempt_state(sink.record.events);
    const std::vector<Event>& events = sink.record.events;
    verdict.lost_device = std::any_of(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::device_back;
    });
    if (!open.decided()) return verdict;
    verdict.early = true;
    verdict.decided_by = open.decided_by();
    verdict.at_best = open.score_at_best(stage.task);
    return verdict;
}

}  // namespace fulcrum::test
