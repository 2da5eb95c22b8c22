// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt from request to stored score without a window: the same engine, recorder and scoring as the
// window's.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "assessment/attempt/memory_sink.h"
#include "database/records/attempts.h"
#include "database/records/recorder.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"

namespace fulcrum::app {

class FrameStore;

/// Records in memory and in the store; keeps an error of the store until the caller calls rethrow().
class RecordingSink : public MemorySink {
  public:
    explicit RecordingSink(database::Recorder& recorder) : recorder_(recorder) {}
    void on_event(const Event& event) noexcept override;
    void on_tick(const RigSample& input, const TickSample& sample) noexcept override;
    void on_step(const StepRecord& step) noexcept override;
    void rethrow() const;

  private:
    template <typename Action>
    void guarded(Action&& action) noexcept;
    database::Recorder& recorder_;
    std::exception_ptr trouble_;
};

struct PerformRequest {
    LoadedTask loaded;
    std::optional<OperatorLevel> operator_level;  ///< none: `mastery` or input_trace
    std::optional<double> mastery;  ///< in place of a level: the operator learns, as draw_learner() says
    const AttemptRecord* input_trace = nullptr;
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> individual;            ///< of the operator; without it the seed selects one
    DeviceClass device_class = DeviceClass::synthetic;  ///< the operator works through a model of it
    bool assessed = true;
    std::function<bool(double)> keep_going;  ///< simulated seconds; may be empty
    FrameStore* frames = nullptr;            ///< gets key frames of the replay; null: nobody
};

struct Performed {
    AttemptRecord record;
    RunOutcome outcome;
    ScoredAttempt scored;
    std::vector<TargetSphere> targets;
    double wall_s = 0;
    std::size_t allocations = 0;
};

/// Runs and scores an attempt; with a recorder also stores and finishes it. Throws InputError, StoreError.
Performed perform(const PerformRequest& request, database::Recorder* recorder, const Limits& limits);

/// The data of an attempt that are stored before it starts.
database::AttemptMeta attempt_meta(const LoadedTask& loaded, std::uint64_t seed, AttemptMode mode,
                                   DeviceClass device_class, const std::string& device, const Limits& limits);
/// The data of an attempt that are stored at its end.
database::AttemptResult attempt_result(const ScoredAttempt& scored, const RunOutcome& outcome, double wall_s,
                                       std::uint32_t missed, std::uint64_t lost, const std::string& limits);
/// Name of the CPU feature level that this build uses; replays are bit-identical within one level.
std::string cpu_features();
/// Names what reads a state that was written: program, physics and CPU feature level.
std::string state_build();
std::string hex(std::uint64_t value);

}  // namespace fulcrum::app
