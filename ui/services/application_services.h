// SPDX-License-Identifier: GPL-3.0-or-later
// What the window needs from the program around it, one small interface for each concern. app/ implements
// them, tests implement them without threads.
//
// Threads: every call comes from the UI thread unless a comment says otherwise, and returns at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/forms/observer_form.h"
#include "assessment/scoring/judged_limits.h"
#include "database/records/attempts.h"
#include "database/records/tissues.h"
#include "database/rows/attempt_records.h"
#include "database/scoring/rescoring.h"
#include "database/scoring/site_tissues.h"
#include "database/store/store.h"
#include "ui/services/attempt_session.h"
#include "ui/services/device_service.h"
#include "ui/services/replay_source.h"
#include "ui/services/sound_service.h"

namespace fulcrum::database {
struct Trace;
}

namespace fulcrum::ui {

/// Called from any thread with 0..1 and one line of what is being done; false asks the work to stop.
using Progress = std::function<bool(double done, const std::string& line)>;

/// An interrupted attempt that was scored now.
struct InterruptedScore {
    std::string attempt_id, task_id;
    std::int64_t started = 0;    ///< UTC ms
    double duration_s = 0;       ///< of the recorded part
    std::optional<bool> passed;  ///< false: failed for good; empty: it does not count
    Statement why;               ///< what failed, or why it was not scored
    Sentence problem;            ///< instead of `why`: why it cannot be scored now
};

/// The programme's store on the UI thread, and the demonstration.
class StoreService {
  public:
    virtual ~StoreService() = default;
    /// Null until opened or created.
    virtual database::Store* store() = 0;
    /// Where the store is or would be. `demo`: the demonstration programme's own file.
    virtual std::string store_path(bool demo) const = 0;
    /// Opens the store (creates it when missing) and makes it the current one; a store of a programme is
    /// looked at before (database/store/quick_check.h). Throws database::StoreError.
    virtual void open_store(bool demo) = 0;
    /// There is none until the next open_store(). Nobody may be signed in.
    virtual void close_store() = 0;
    /// The programme's store is this file from now on, until the program ends.
    virtual void choose_store(const std::string& path) = 0;
    virtual bool demo_is_built() const = 0;
    /// Unpacks the delivered demonstration store. Called on a worker thread; false when stopped, leaving
    /// nothing.
    virtual bool unpack_demo(const Progress& progress) = 0;
};

/// The tasks that are installed.
class TaskService {
  public:
    virtual ~TaskService() = default;
    /// All tasks of assets/tasks, in curriculum order.
    virtual const std::vector<TaskDefinition>& tasks() const = 0;
    /// The curriculum that trainees follow.
    /// It and its versions stay where they are while the program runs, also after a newer one was published.
    virtual const Curriculum& curriculum() const = 0;
    /// What another window has published since, or an exchange has brought, is curriculum() from then on.
    /// Throws InputError (a file that is not valid, a version that people follow is missing), StoreError.
    virtual void look_for_curriculum() = 0;
    /// Puts the version after `follows` in force (database/records/curriculum_publishing.h); curriculum() is
    /// it from then on. Throws as publish_curriculum().
    virtual void publish_curriculum(const database::Session& session, const Curriculum& follows,
                                    const std::string& text, const std::string& reason) = 0;
    /// The observer forms that are installed. Throws InputError.
    virtual std::vector<ObserverForm> forms() const = 0;
    /// Throws InputError. Any thread.
    /// `variant` empty, here and below: the standard one.
    virtual Scene scene_for(const TaskDefinition& task, const std::string& variant = {}) const = 0;
    /// The text of that scene's file. Throws InputError.
    virtual std::string scene_text(const TaskDefinition& task, const std::string& variant = {}) const = 0;
    /// The world when an attempt begins, with a fixed seed. Builds it, which takes up to seconds: any thread.
    /// Throws InputError.
    virtual WorldSnapshot world_at_start(const TaskDefinition& task,
                                         const std::string& variant = {}) const = 0;
};

/// Attempts and demonstrations that run.
class AttemptService {
  public:
    virtual ~AttemptService() = default;
    /// Prepares an attempt; it begins with AttemptSession::start(). Throws InputError (also where the task is
    /// not assessed with this device or with these files), database::StoreError, database::AccessDenied.
    virtual std::unique_ptr<AttemptSession> start_attempt(const AttemptRequest& request) = 0;
    /// Why attempts with this device are not compared with the task's limits; empty where they are, or where
    /// it has none. Throws InputError, database::AccessDenied.
    virtual Statement why_not_comparable(const database::Session& session, const std::string& task_id,
                                         DeviceClass device_class, const std::string& variant = {}) = 0;
    /// The files of an attempt with this device that are neither part of the program nor accepted by the
    /// programme; with any it is practice only. Throws InputError, database::AccessDenied.
    virtual std::vector<database::AssetFile> unknown_assets(const database::Session& session,
                                                            const std::string& task_id,
                                                            DeviceClass device_class,
                                                            const std::string& variant = {}) = 0;
    /// What an attempt with this device would be held against, in the order of the task's gates. Throws
    /// InputError, database::AccessDenied.
    virtual std::vector<JudgedLimit> judged_limits(const database::Session& session,
                                                   const std::string& task_id, DeviceClass device_class,
                                                   const std::string& variant = {}) = 0;
    /// An expert operator performs the task to be watched; nothing is stored. Prepares like an attempt; its
    /// outcome stays empty.
    virtual std::unique_ptr<AttemptSession> start_demonstration(const database::Session& session,
                                                                const std::string& task_id,
                                                                const std::string& variant = {}) = 0;
};

/// Scores that are computed after an attempt. All calls come from a worker thread and open the store for
/// themselves.
class ScoringService {
  public:
    virtual ~ScoringService() = default;
    /// Scores what was interrupted and has no score yet, as far as the session may, from its record
    /// (docs/MANUAL.md: it does not count unless what was recorded failed already).
    virtual std::vector<InterruptedScore> score_interrupted(const database::Session& session,
                                                            const Progress& progress) = 0;
    /// Scores within the session's scope that are based on metrics or limits that are no longer in force.
    virtual std::vector<database::StaleScore> stale_scores(const database::Session& session) = 0;
    /// Makes a new score next to each of these.
    virtual std::vector<RecomputedScore> recompute_scores(const database::Session& session,
                                                          const Progress& progress) = 0;
};

/// The check of the store, with a sample of attempts that are simulated again.
class StoreCheckService {
  public:
    virtual ~StoreCheckService() = default;
    /// As `fulcrum db check` without options. Called on a worker thread; opens the store for itself. Throws
    /// database::StoreError, database::AccessDenied.
    virtual database::CheckReport check_store(const database::Session& session, const Progress& progress) = 0;
};

/// An expert's attempt for comparison: simulated, not stored.
struct ExpertAttempt {
    database::AttemptSummary summary;  ///< without an id
    database::ScoreRow score;
    std::shared_ptr<const database::Trace> trace;
};

/// Stored attempts played again.
class ReplayService {
  public:
    virtual ~ReplayService() = default;
    /// A replay of a stored trace, kept alive by the source. Throws InputError when the task or scene is not
    /// known here.
    virtual std::unique_ptr<ReplaySource> open_replay(const database::Session& session,
                                                      const database::AttemptSummary& attempt,
                                                      std::shared_ptr<const database::Trace> trace) = 0;
    /// Makes ready, on a thread of the lowest priority, replays that would have to be simulated when they are
    /// opened first; returns at once, and does nothing where that is at work already. An attempt that begins
    /// or a replay that is opened stops it.
    virtual void prepare_replays(const database::Session& session) = 0;
    virtual void stop_preparing_replays() = 0;
    /// The first of the synthetic experts of the provisional benchmark performs the task of this attempt in
    /// its scene. The function that is returned does the work and may run on any thread; it is empty when
    /// stopped. Throws as scene_of.
    virtual std::function<std::optional<ExpertAttempt>(const Progress&)> expert_attempt(
        const database::Session& session, const database::AttemptSummary& attempt) = 0;
    /// The picture of such an attempt, as open_replay. `attempt`: the one it was made for.
    virtual std::unique_ptr<ReplaySource> open_expert_replay(const database::Session& session,
                                                             const database::AttemptSummary& attempt,
                                                             const ExpertAttempt& expert) = 0;
    /// The scene as a stored attempt used it. Throws as open_replay, and StoreError, AccessDenied.
    virtual Scene scene_of(const database::Session& session,
                           const database::AttemptSummary& attempt) const = 0;
};

/// The site's own values for tissues that blades cut.
class TissueService {
  public:
    virtual ~TissueService() = default;
    /// Throws InputError, AccessDenied.
    virtual SiteTissues site_tissues(const database::Session& session, const std::string& task_id) = 0;
    /// For attempts that begin afterwards. `values`: in place of the scene file's; none: back to those.
    /// Throws InputError naming tissue, value and hint; as database::Tissues::set().
    virtual void set_site_tissues(const database::Session& session, const std::string& task_id, int seen,
                                  const database::TissueValues& values, const std::string& reason) = 0;
};

/// Everything that the window needs. A page that needs one concern takes that interface alone.
class ApplicationServices : public StoreService,
                            public TaskService,
                            public AttemptService,
                            public ScoringService,
                            public StoreCheckService,
                            public ReplayService,
                            public TissueService,
                            public DeviceService,
                            public SoundService {
  public:
    /// For the about box and for reports.
    virtual std::string program_version() const = 0;
};

}  // namespace fulcrum::ui
