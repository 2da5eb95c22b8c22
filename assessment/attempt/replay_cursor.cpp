// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/replay_cursor.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "sim_core/numerics/state_archive.h"

namespace fulcrum {

/// Stores the results of the replay.
class ReplayCursor::Sink : public AttemptSink {
  public:
    explicit Sink(ReplayOutcome& outcome) : outcome_(outcome) {}
    void on_event(const Event& event) noexcept override { outcome_.events.push_back(event); }
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& step) noexcept override { last_ = step; }
    const StepRecord& last() const noexcept { return last_; }

  private:
    ReplayOutcome& outcome_;
    StepRecord last_;
};

namespace {

/// A hand whose device renders no force was sent none: what older records hold there was never felt.
void forget_unfelt(const ForceDevices& devices, TickSample& sample) {
    for (std::size_t h = 0; h < devices.size(); ++h) {
        if (devices[h]) continue;
        HandSample& hand = sample.hand[h];
        std::fill(std::begin(hand.device_force), std::end(hand.device_force), 0);
        hand.flags = static_cast<std::uint16_t>(hand.flags & ~static_cast<unsigned>(hand_clamped));
    }
}

}  // namespace

ReplayCursor::ReplayCursor(AttemptEngine& engine, const AttemptRecord& record)
    : engine_(engine),
      record_(record),
      ticks_(record.ticks != nullptr ? record.ticks->reader() : nullptr),
      count_(record.ticks != nullptr ? record.ticks->size() : 0),
      place_{{}, 0, 0, engine.loop().model_step()} {
    static_assert(std::has_unique_object_representations_v<HandSample> &&
                  std::has_unique_object_representations_v<CameraSample>);
    engine_.use_devices(record.devices);
}

std::uint32_t ReplayCursor::tick() const {
    return engine_.next_tick() - 1;
}

void ReplayCursor::diverged(std::uint32_t tick) {
    if (outcome_.identical) outcome_.first_divergence_s = tick * engine_.scene().tick_period();
    outcome_.identical = false;
}

void ReplayCursor::step_once() {
    const StepRecord& recorded = record_.steps[next_step()];
    std::size_t count = 0;
    while (count < place_.outputs.size() && place_.outputs[count].sample.tick <= recorded.last_tick) ++count;
    Sink sink(outcome_);
    engine_.step(place_.outputs.data(), count, sink);
    place_.outputs.erase(place_.outputs.begin(), place_.outputs.begin() + static_cast<std::ptrdiff_t>(count));
    if (sink.last().state_hash != recorded.state_hash || sink.last().outcome != recorded.outcome)
        diverged(recorded.last_tick);
    if (after_step_ && !after_step_(engine_.world().snapshot())) stopped_ = true;
    ++place_.next_step;
}

void ReplayCursor::run_tick() {
    const RigSample& input = this->input(next_input());
    const TickSample& recorded = this->recorded(next_input());
    if (recorded.model_step !=
        place_.adopted) {  // the step whose model was used in this tick, from the record
        while (next_step() < record_.steps.size() && record_.steps[next_step()].step <= recorded.model_step)
            step_once();
        engine_.adopt(engine_.world().local_models());
        place_.adopted = recorded.model_step;
    }
    TickOutput output = engine_.tick(input);
    output.sample.missed = recorded.missed;  // depends on wall time, not on the simulation
    TickSample expected = recorded;
    forget_unfelt(record_.devices, expected);
    if (std::memcmp(&output.sample, &expected, sizeof expected) != 0) diverged(recorded.tick);
    if (keep_samples_) outcome_.samples.push_back(output.sample);
    place_.outputs.push_back(output);
    ++place_.next_input;
    // Where no tick waits for a model any more (never one without instruments), steps follow their ticks:
    // what waits would otherwise grow with the attempt.
    if (last_model_step() != place_.adopted) return;
    while (next_step() < record_.steps.size() && record_.steps[next_step()].last_tick <= recorded.tick &&
           !stopped_)
        step_once();
}

void ReplayCursor::run_to(std::uint32_t tick) {
    while (!at_end() && !stopped_ && input(next_input()).tick <= tick) run_tick();
}

void ReplayCursor::run_to_end() {
    while (!at_end() && !stopped_) run_tick();
    while (next_step() < record_.steps.size() && !stopped_) step_once();
}

bool ReplayCursor::settle() {
    while (next_step() < record_.steps.size() && record_.steps[next_step()].last_tick <= tick()) step_once();
    return place_.outputs.empty();
}

void ReplayPlace::transfer(StateArchive& archive, AttemptEngine& engine) {
    engine.transfer(archive);
    archive(outputs, next_input, next_step, adopted);
    archive.finish();
}

void ReplayCursor::transfer(StateArchive& archive) {
    place_.transfer(archive, engine_);
    if (!archive.reads()) return;
    if (place_.next_input > tick_count() || place_.next_step > record_.steps.size())
        throw StateArchiveError(QT_TRANSLATE_NOOP("errors", "the stored state belongs to another attempt"));
    outcome_ = ReplayOutcome();
    stopped_ = false;
}

void ReplayCursor::drop_run(AttemptRecord& record) {
    const auto drop = [](auto& records, std::size_t count) {
        records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count));
    };
    const std::size_t inputs = next_input(), steps = next_step();
    drop(record.inputs, inputs);
    drop(record.samples, inputs);
    drop(record.steps, steps);
    dropped_inputs_ += inputs;
    dropped_steps_ += steps;
    outcome_.events.clear();
}

ReplayOutcome ReplayCursor::take_outcome() {
    outcome_.state_hash = engine_.state_hash();
    return std::move(outcome_);
}

}  // namespace fulcrum
