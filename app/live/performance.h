// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt from request to stored score without a window: the same engine, recorder and scoring as the
// window's.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/scoring.h"
#include "assessment/attempt/memory_sink.h"
#include "database/records/attempts.h"
#include "database/records/recorder.h"
#include "database/store/store.h"
#include "sim_core/scene/cutting_values.h"

namespace fulcrum::app {

/// A task with everything it needs.
struct LoadedTask {
    TaskDefinition task;
    Scene scene;
    std::string scene_text;  ///< what `scene` was read from, its fidelity aside
};
/// Throws InputError. `fidelity` empty: the scene's own. `cutting`: values in place of the scene file's own;
/// what does not fit the scene is told with `source`, who says so.
LoadedTask load_task_and_scene(const std::string& task_id, const std::string& fidelity = {},
                               const CuttingValues& cutting = {}, const std::string& source = {});
/// With what this site says of the task's tissues. Throws InputError, AccessDenied.
LoadedTask load_site_task(const database::Store& store, const database::Session& session,
                          const std::string& task_id, const std::string& fidelity = {});
/// As a stored attempt used it: the scene from its record; from the assets for attempts of before scenes were
/// kept. Throws InputError (the task is not known here), AccessDenied, StoreError.
LoadedTask load_recorded(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& summary);

/// Memory and store at once; store trouble is kept and rethrown by rethrow() on the caller's side.
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
    std::string operator_name;  ///< empty: input_trace
    const AttemptRecord* input_trace = nullptr;
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> individual;  ///< operator: who performs; without it the seed draws one
    bool assessed = true;
    std::function<bool(double)> keep_going;  ///< simulated seconds; may be empty
};

struct Performed {
    AttemptRecord record;
    RunOutcome outcome;
    ScoredAttempt scored;
    std::vector<Vector3> targets;
    double wall_s = 0;
    std::size_t allocations = 0;
};

/// Runs and scores; stores when a recorder is given (finish() included). Throws InputError, StoreError.
Performed perform(const PerformRequest& request, database::Recorder* recorder, const BenchmarkSet* benchmark);

/// What perform writes about an attempt into the store before it starts.
database::AttemptMeta attempt_meta(const LoadedTask& loaded, std::uint64_t seed, const std::string& mode,
                                   const std::string& device_class, const std::string& device,
                                   const BenchmarkSet* benchmark);
/// What is written at the end.
database::AttemptResult attempt_result(const ScoredAttempt& scored, const RunOutcome& outcome, double wall_s,
                                       std::uint32_t missed, std::uint64_t lost, const std::string& limits);
/// The name of the CPU feature level that this build computes with; a replay is bit for bit within it.
std::string cpu_features();
std::string hex(std::uint64_t value);

}  // namespace fulcrum::app
