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

    /// Last tick run; that before the record's first one at the beginning.
    std::uint32_t tick() const;
    bool at_end() const { return next_input_ >= record_.inputs.size(); }

    /// Writes engine and place, or reads them: it continues from there bit for bit. The comparison with the
    /// record begins again. Throws StateArchiveError.
    void transfer(StateArchive& archive);

    const ReplayOutcome& outcome() const { return outcome_; }
    ReplayOutcome take_outcome();

  private:
    class Sink;
    void step_once();
    void run_tick();
    void diverged(std::uint32_t tick);

    AttemptEngine& engine_;
    const AttemptRecord& record_;
    std::function<bool(const WorldSnapshot&)> after_step_;
    ReplayOutcome outcome_;
    std::vector<TickOutput> outputs_;  ///< of ticks that no step has used yet
    std::size_t next_input_ = 0, next_step_ = 0;
    std::uint32_t adopted_ = 0;  ///< step whose model the tick uses
    bool keep_samples_ = false, stopped_ = false;
};

}  // namespace fulcrum
