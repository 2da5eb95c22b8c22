// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt in real time: the engine's two halves on two threads, the recorder on a third
// (docs/THREADS.md).
//
//   haptic thread    1 kHz on an absolute clock: reads the rig, ticks the loop, pushes to two rings;
//                    never locks, allocates or writes
//   world thread     steps after every m ticks; publishes models and view through triple buffers
//   recorder thread  builds the world; after the start moves both rings of the record into the store;
//                    at the end reads the record back, scores it and finishes the attempt
//   follower         (FrameFollower) makes key frames of what was recorded, at the lowest priority
//
// Before start() nothing is timed and nothing is stored, so that the first picture can be prepared.
//
// The thread that owns a LiveAttempt (the window's, or the command line's) only polls and raises flags.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "app/live/loop_statistics.h"
#include "app/live/performance.h"
#include "app/live/sample_tap.h"
#include "assessment/attempt/ghost.h"
#include "database/records/recorder.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

class DeviceRig;
class FrameFollower;

struct LiveRequest {
    LoadedTask loaded;
    std::uint64_t seed = 1;
    bool assessed = true;
    std::shared_ptr<Rig> rig;
    std::string store_path;  ///< empty: a demonstration, which is neither stored nor scored
    std::optional<database::Session>
        session;  ///< set with store_path: the session that performs the attempt and reads the record
    database::AttemptMeta meta;  ///< person, mode, device
    Limits limits;
    /// Brings the new engine to the state that the attempt begins with (meta.origin says where that is from);
    /// false where `stop` became true before. Empty: it begins at the beginning. Called on the recorder's
    /// thread; may throw.
    std::function<bool(AttemptEngine& engine, const std::atomic<bool>& stop)> bring = {};
    /// Makes the ghost to be shown, null where `stop` became true before. Empty: none. As bring.
    std::function<std::shared_ptr<const GhostPath>(const std::atomic<bool>& stop)> make_ghost = {};
    /// Gets every sample and event; null: nobody looks.
    std::shared_ptr<SampleTap> tap = {};
    /// Makes the key frames of the replay while the attempt runs; null: nobody.
    std::shared_ptr<FrameFollower> follower = {};
    /// Within `rig`, for its timing; null: no device process moves the hands.
    std::shared_ptr<const DeviceRig> device = {};
    /// For tests: while it is true the simulator fails at every step (World::fail_while). Null: nobody asks.
    std::shared_ptr<const std::atomic<bool>> simulator_fails = {};
};

class LiveAttempt : public ui::AttemptSession {
  public:
    /// Returns immediately; the world is built on another thread. An error there leads to
    /// AttemptPhase::failed.
    explicit LiveAttempt(LiveRequest request);
    /// Closes a running attempt as interrupted and waits until it is stored. Of an attempt that has not begun
    /// nothing is stored.
    ~LiveAttempt() override;

    const Scene& scene() const override;
    const TaskDefinition& task() const override;
    bool assessed() const override;
    bool became_practice() const override;
    ui::AttemptPhase phase() const override;
    ui::Realignment realignment() override;
    const RigSample* hands_at_start() const override;
    std::shared_ptr<const GhostPath> ghost() const override;
    void start() override;
    bool update() override;
    const WorldSnapshot& snapshot() const override;
    const TaskDisplay& display() const override;
    ui::LoopHealth health() const override;
    void pause() override;
    void resume() override;
    void abandon() override;
    void interrupt() override;
    Sentence message() const override;
    const std::optional<ui::AttemptOutcome>& outcome() const override;

    /// Waits until the attempt is finished or failed.
    void wait();
    /// After wait(): rethrows the error of a failed attempt (InputError, StoreError, AccessDenied).
    void rethrow() const;
    /// May be called at any time: the counters are atomic.
    LoopStatistics statistics() const;
    /// The score after the end of the attempt; null before.
    const ScoredAttempt* scored() const;
    std::uint64_t state_hash() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fulcrum::app
