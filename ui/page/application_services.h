// SPDX-License-Identifier: GPL-3.0-or-later
// What the window needs from the program around it: the store, the tasks, attempts that run on their own
// threads, replays. The window knows no thread, no world and no recorder; app/ implements this interface,
// tests implement it without threads.
//
// Threads: every call comes from the UI thread unless a comment says otherwise, and returns at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/task/monitor.h"
#include "assessment/task/task.h"
#include "database/records/tissues.h"
#include "database/rows/attempt_records.h"
#include "database/store/store.h"
#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/sample.h"
#include "sim_core/world/snapshot.h"

namespace fulcrum::database {
struct Trace;
}

namespace fulcrum::ui {

/// Called from any thread with 0..1 and one line of what is being done; false asks the work to stop.
using Progress = std::function<bool(double done, const std::string& line)>;

enum class AttemptPhase {
    starting,  ///< parts are being built; no snapshot yet
    ready,  ///< built: snapshot() shows the first moment; nothing runs and nothing is stored before start()
    running,
    paused,       ///< by the trainee or the lock; the scene is hidden, the clock stands
    device_lost,  ///< a device is gone: force was ramped to 0, the clock stands; message() says what to do
    finishing,    ///< the attempt has ended; metrics and score are being computed and stored
    finished,     ///< stored: outcome() is there
    failed,       ///< the program could not go on; message() says why and what is kept
};

struct AttemptOutcome {
    std::string attempt_id;  ///< in the store
    std::string state;       ///< completed | timed_out | abandoned | interrupted | failed_simulation
    double duration_s = 0;
    std::uint32_t missed_ticks = 0;
    std::uint64_t lost_samples = 0;
};

/// How the loop is doing; shown small in the HUD.
struct LoopHealth {
    std::uint32_t ticks = 0, missed_ticks = 0, late_steps = 0;
    std::uint64_t lost_samples = 0;
    bool force_felt[hand_count] = {false, false};  ///< the hand's device renders force
};

/// After a device was lost: where the devices are now, beside the instruments that wait in their last pose
/// (snapshot().tools).
struct Realignment {
    bool back = false;      ///< every device answers again
    bool in_place = false;  ///< and each stands near enough to its instrument: resume() takes hold
    struct OneHand {
        bool exists = false, in_place = false;
        double distance = 0;  ///< m
        double angle = 0;     ///< rad
        ToolPose device;      ///< where the instrument would be
    } hand[hand_count];
};

/// One attempt while it runs. Destroying it before the end closes the attempt as interrupted and stores it.
class AttemptSession {
  public:
    virtual ~AttemptSession() = default;
    virtual const Scene& scene() const = 0;
    virtual const TaskDefinition& task() const = 0;
    virtual bool assessed() const = 0;
    /// It began as assessed and goes on as practice, because a device was lost; assessed() is false from then
    /// on.
    virtual bool became_practice() const = 0;
    virtual AttemptPhase phase() const = 0;
    /// Puts a ready attempt on the clock: hands, physics and record begin.
    virtual void start() = 0;
    /// Takes the newest world and display if there are newer ones; call once a painted frame. True if they
    /// changed.
    virtual bool update() = 0;
    virtual const WorldSnapshot& snapshot() const = 0;
    virtual const TaskDisplay& display() const = 0;
    virtual LoopHealth health() const = 0;
    virtual void pause() = 0;
    /// Goes on after a pause; from device_lost only once the device is back and in place, and then as
    /// practice.
    virtual void resume() = 0;
    /// In device_lost: how the devices stand.
    virtual Realignment realignment() = 0;
    /// Ends the attempt as abandoned (or interrupted, when closed by the lock).
    virtual void abandon() = 0;
    virtual void interrupt() = 0;
    /// For device_lost and failed: one line of what happened and what to do; else empty.
    virtual std::string message() const = 0;
    /// Set once phase() is finished.
    virtual const std::optional<AttemptOutcome>& outcome() const = 0;
};

struct AttemptRequest {
    database::Session session;  ///< whose attempt it is
    std::string task_id;
    bool assessed = false;
    std::uint64_t seed = 0;  ///< 0: the program draws one outside 1000-1999
    /// The hands. Called on the haptic thread once a tick: must neither lock nor allocate. Pause, abandon and
    /// loss flags are added by the session. Device class and name are stored with the attempt.
    std::shared_ptr<Rig> rig;
    std::string device_class = "mouse-keyboard";
    std::string device = "mouse and keyboard";
};

/// What the world looked like at a moment of a stored attempt.
class ReplaySource {
  public:
    virtual ~ReplaySource() = default;
    virtual const Scene& scene() const = 0;
    virtual double duration_s() const = 0;
    /// Asks for the world at a time on the record's clock (s); the answer comes through update() when it is
    /// ready.
    virtual void seek(double time_s) = 0;
    /// True if a newer snapshot is there.
    virtual bool update() = 0;
    virtual const WorldSnapshot& snapshot() const = 0;
    /// Time that snapshot() shows.
    virtual double shown_s() const = 0;
    /// How far the re-simulation has come, 0..1; 1 when only poses are shown.
    virtual double ready() const = 0;
    /// From here on the re-simulated tissue differs from the record (another build): poses stay the recorded
    /// ones.
    virtual std::optional<double> differs_from_s() const = 0;
};

/// An interrupted attempt that was scored now.
struct InterruptedScore {
    std::string attempt_id, task_id;
    std::int64_t started = 0;    ///< UTC ms
    double duration_s = 0;       ///< of the recorded part
    std::optional<bool> passed;  ///< false: failed for good; empty: it does not count
    std::string why;             ///< what failed, or why it was not scored
};

/// A score that was out of date and has a newer one beside it now.
struct RecomputedScore {
    std::string attempt_id, person_name, task_id;
    std::string why;                      ///< what it rested on before, and what is in force
    std::optional<bool> passed_in_force;  ///< of the score in force, which stays
    std::optional<bool> passed;           ///< of the new one
    std::string not_scored_because;       ///< where it has neither passed nor failed
    std::string problem;                  ///< why there is no new one; empty if there is
};

/// One value that a site may set in place of the scene file's.
struct SiteTissueValue {
    std::string tissue, key;
    std::string words, unit, range;  ///< for screens
    double scene = 0;                ///< what the scene file says
    double value = 0;                ///< what is in force
};

/// The tissues of a task that blades cut.
struct SiteTissues {
    std::vector<SiteTissueValue> values;  ///< empty: the task cuts nothing by force
    int version = 0;                      ///< of the site's values in force; 0: never set
    bool differ = false;                  ///< from the scene file's
    std::string limits_note;  ///< why attempts are not held against the task's limits; empty if they are
};

class ApplicationServices {
  public:
    virtual ~ApplicationServices() = default;

    /// The programme's store on the UI thread; null until opened or created. Throws StoreError from
    /// open_store().
    virtual database::Store* store() = 0;
    /// Where the store is or would be. `demo`: the demo programme's own file.
    virtual std::string store_path(bool demo) const = 0;
    /// Opens the store (creates it when missing) and makes it the current one. Throws database::StoreError.
    virtual void open_store(bool demo) = 0;
    virtual bool demo_is_built() const = 0;
    /// Builds the demo store by really simulating a synthetic cohort. Called on a worker thread; false when
    /// stopped, leaving nothing.
    virtual bool build_demo(const Progress& progress) = 0;

    /// All tasks of assets/tasks, in curriculum order.
    virtual const std::vector<TaskDefinition>& tasks() const = 0;
    /// Throws InputError.
    virtual Scene scene_for(const TaskDefinition& task) const = 0;
    /// Prepares an attempt; it begins with AttemptSession::start(). Throws InputError, database::StoreError,
    /// database::AccessDenied.
    virtual std::unique_ptr<AttemptSession> start_attempt(const AttemptRequest& request) = 0;
    /// An expert operator performs the task to be watched; nothing is stored. Prepares like an attempt; its
    /// outcome stays empty.
    virtual std::unique_ptr<AttemptSession> start_demonstration(const database::Session& session,
                                                                const std::string& task_id) = 0;
    /// Scores what was interrupted and has no score yet, as far as the session may, from its record
    /// (docs/MANUAL.md: it does not count unless what was recorded failed already). Called on a worker
    /// thread; opens the store for itself.
    virtual std::vector<InterruptedScore> score_interrupted(const database::Session& session,
                                                            const Progress& progress) = 0;
    /// How many scores within the session's scope rest on metrics or limits that are no longer in force.
    /// Worker thread.
    virtual std::size_t stale_scores(const database::Session& session) = 0;
    /// Makes a new score beside each of these. Called on a worker thread; opens the store for itself.
    virtual std::vector<RecomputedScore> recompute_scores(const database::Session& session,
                                                          const Progress& progress) = 0;
    /// A replay of a stored trace, kept alive by the source. Throws InputError when the task or scene is not
    /// known here.
    virtual std::unique_ptr<ReplaySource> open_replay(const database::Session& session,
                                                      const database::AttemptSummary& attempt,
                                                      std::shared_ptr<const database::Trace> trace) = 0;
    /// The scene as a stored attempt used it. Throws as open_replay, and StoreError, AccessDenied.
    virtual Scene scene_of(const database::Session& session,
                           const database::AttemptSummary& attempt) const = 0;
    /// What blades meet in a task's tissues here. Throws InputError, AccessDenied.
    virtual SiteTissues site_tissues(const database::Session& session, const std::string& task_id) = 0;
    /// For attempts that begin afterwards. `values`: in place of the scene file's; none: back to those.
    /// Throws InputError naming tissue, value and hint; as database::Tissues::set().
    virtual void set_site_tissues(const database::Session& session, const std::string& task_id, int seen,
                                  const database::TissueValues& values, const std::string& reason) = 0;
    /// For the about box and for reports.
    virtual std::string program_version() const = 0;
};

}  // namespace fulcrum::ui
