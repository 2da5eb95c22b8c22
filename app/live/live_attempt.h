// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt on the clock: the engine's two halves on their threads, the recorder on a third
// (docs/THREADS.md).
//
//   haptic thread   1 kHz on an absolute clock; reads the rig, ticks the loop, pushes to two rings; never
//   locks, allocates or writes world thread    steps when m ticks are there; publishes models and view
//   through triple buffers recorder thread builds the world; once the attempt has begun drains both record
//   rings into the store; after the end reads the record
//                   back, scores it, finishes the attempt
//
// Nothing is on the clock and nothing is stored before start(): whoever prepares a picture first does so in
// peace.
//
// The thread that owns a LiveAttempt (the window's, or the command line's) only polls and raises flags.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "app/live/loop_statistics.h"
#include "app/live/performance.h"
#include "database/records/recorder.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

struct LiveRequest {
    LoadedTask loaded;
    std::uint64_t seed = 1;
    bool assessed = true;
    std::shared_ptr<Rig> rig;
    std::string store_path;  ///< empty: a demonstration, which is neither stored nor scored
    std::optional<database::Session>
        session;  ///< set with store_path: whose right it is to perform and to read the record back
    database::AttemptMeta meta;  ///< person, mode, device
    std::optional<BenchmarkSet> benchmark;
};

class LiveAttempt : public ui::AttemptSession {
  public:
    /// Returns at once; the world is built on a thread. What goes wrong there ends in AttemptPhase::failed.
    explicit LiveAttempt(LiveRequest request);
    /// Closes an attempt that still runs as interrupted, waits until it is stored. One that has not begun
    /// leaves nothing.
    ~LiveAttempt() override;

    const Scene& scene() const override;
    const TaskDefinition& task() const override;
    bool assessed() const override;
    bool became_practice() const override;
    ui::AttemptPhase phase() const override;
    ui::Realignment realignment() override;
    void start() override;
    bool update() override;
    const WorldSnapshot& snapshot() const override;
    const TaskDisplay& display() const override;
    ui::LoopHealth health() const override;
    void pause() override;
    void resume() override;
    void abandon() override;
    void interrupt() override;
    std::string message() const override;
    const std::optional<ui::AttemptOutcome>& outcome() const override;

    /// Waits until the attempt is finished or failed.
    void wait();
    /// After wait(): throws what went wrong, if something did (InputError, StoreError, AccessDenied).
    void rethrow() const;
    /// At any time: the threads count in atomics.
    LoopStatistics statistics() const;
    /// After the end: what was scored. Null before.
    const ScoredAttempt* scored() const;
    std::uint64_t state_hash() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fulcrum::app
