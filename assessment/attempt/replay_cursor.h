// SPDX-License-Identifier: Apache-2.0
// A replay that can stop anywhere, be kept as bytes, and continue from them: what replay_record(), seeking
// and taking over are made of.
//
// It follows the record's schedule: before a tick that used a step's model, the steps up to that one are
// made. So the world is up to two steps (10 ms) behind the tick, as it was in the attempt.
#pragma once

#include <functional>
#include <vector>

#include "assessment/attempt/engine.h"

namespace fulcrum {

/// What a cursor needs in addition to its engine's state.
struct ReplayPlace {
    std::vector<TickOutput> outputs;            ///< of ticks that no step has used yet
    std::size_t next_input = 0, next_step = 0;  ///< in the whole record
    std::uint32_t adopted = 0;                  ///< step whose model the tick uses

    /// Writes engine and place, or reads them. Throws StateArchiveError.
    void transfer(StateArchive& archive, AttemptEngine& engine);
};

/// Used by one thread; engine and record must outlive it.
class ReplayCursor {
  public:
    /// `engine`: new, or at the state that the record begins with.
    ReplayCursor(AttemptEngine& engine, const AttemptRecord& record);

    /// Keep every sample in the outcome.
    void keep_samples(bool keep) { keep_samples_ = keep; }
    /// Called after every step with the world; false stops the run.
    void after_step(std::function<bool(const WorldSnapshot&)> call) { after_step_ = std::move(call); }

    /// Runs the ticks of the record up to and including this one. Does not go back.
    void run_to(std::uint32_t tick);
    /// Runs what is left, then the steps that no tick has waited for.
    void run_to_end();
    /// Makes the steps that the record has up to the last tick run, so that nothing of it is outstanding.
    /// False where the record has no step that ends with it. Afterwards only AttemptEngine::begin_here()
    /// makes sense.
    bool settle();
    /// For a record that still grows: removes from it the inputs, samples and steps that were run. `record`
    /// is the one that the cursor was made with, in memory. It cannot read a state afterwards.
    void drop_run(AttemptRecord& record);

    /// Last tick run; that before the record's first one at the beginning.
    std::uint32_t tick() const;
    bool at_end() const { return next_input() >= tick_count(); }

    /// Writes engine and place (ReplayPlace), or reads them: it continues from there bit for bit. The
    /// comparison with the record begins again. Throws StateArchiveError.
    void transfer(StateArchive& archive);

    const ReplayOutcome& outcome() const { return outcome_; }
    ReplayOutcome take_outcome();

  private:
    class Sink;
    /// Of the record as it is now.
    std::size_t tick_count() const { return ticks_ != nullptr ? count_ : record_.inputs.size(); }
    const RigSample& input(std::size_t index) {
        return ticks_ ? ticks_->input(index) : record_.inputs[index];
    }
    const TickSample& recorded(std::size_t index) {
        return ticks_ ? ticks_->sample(index) : record_.samples[index];
    }
    std::uint32_t last_model_step() const {
        return ticks_ ? record_.ticks->last_sample().model_step : record_.samples.back().model_step;
    }
    std::size_t next_input() const { return place_.next_input - dropped_inputs_; }
    std::size_t next_step() const { return place_.next_step - dropped_steps_; }
    void step_once();
    void run_tick();
    void diverged(std::uint32_t tick);

    AttemptEngine& engine_;
    const AttemptRecord& record_;
    std::unique_ptr<TickReader> ticks_;  ///< null: those of the record are in memory
    std::size_t count_ = 0;              ///< with a reader
    std::function<bool(const WorldSnapshot&)> after_step_;
    ReplayOutcome outcome_;
    ReplayPlace place_;  ///< its numbers count what drop_run() removed
    std::size_t dropped_inputs_ = 0, dropped_steps_ = 0;
    bool keep_samples_ = false, stopped_ = false;
};

}  // namespace fulcrum
