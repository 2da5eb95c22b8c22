// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt while it runs, as the window sees it. The window does not know the threads, the world or the
// recorder behind it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "assessment/attempt/ghost.h"
#include "assessment/task/monitor.h"
#include "assessment/task/task.h"
#include "database/access/access.h"
#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum::ui {

enum class AttemptPhase {
    starting,  ///< parts are being built; no snapshot yet
    ready,  ///< built: snapshot() shows the first moment; nothing runs and nothing is stored before start()
    running,
    paused,       ///< by the trainee or the lock; the scene is hidden, the timer is stopped
    device_lost,  ///< a device was lost: force was ramped to 0, the timer is stopped; message() says what to
                  ///< do
    finishing,    ///< the attempt has ended; metrics and score are being computed and stored
    finished,     ///< stored: outcome() is there
    failed,       ///< the program could not continue; message() says why and what is kept
};

struct AttemptOutcome {
    std::string attempt_id;  ///< in the store
    AttemptState state = AttemptState::running;
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

/// After a device was lost: where the devices are now, compared with the instruments, which wait in their
/// last pose (snapshot().tools).
struct Realignment {
    bool back = false;      ///< every device answers again
    bool in_place = false;  ///< and each is near enough to its instrument: resume() connects them
    struct OneHand {
        bool exists = false, in_place = false;
        double distance = 0;  ///< m
        double angle = 0;     ///< rad
        ToolPose device;      ///< where the instrument would be
    } hand[hand_count];
};

/// One attempt while it runs. Destroying it before the end closes and stores it: as abandoned after
/// abandon(), else as interrupted.
class AttemptSession {
  public:
    virtual ~AttemptSession() = default;
    virtual const Scene& scene() const = 0;
    virtual const TaskDefinition& task() const = 0;
    virtual bool assessed() const = 0;
    /// It began as assessed and continues as practice, because a device was lost and nothing before had
    /// failed the attempt; assessed() is false from then on.
    virtual bool became_practice() const = 0;
    virtual AttemptPhase phase() const = 0;
    /// Of a ready attempt that begins with a state of another one: what the devices said then, so that the
    /// hands can begin there. Null: they begin at the scene's start.
    virtual const RigSample* hands_at_start() const { return nullptr; }
    /// Of a ready attempt: the expert's path to be shown; null: none.
    virtual std::shared_ptr<const GhostPath> ghost() const { return nullptr; }
    /// Starts the timer of a ready attempt: input, physics and recording begin.
    virtual void start() = 0;
    /// Takes the newest world and display if there are newer ones; call once a painted frame. True if they
    /// changed.
    virtual bool update() = 0;
    virtual const WorldSnapshot& snapshot() const = 0;
    virtual const TaskDisplay& display() const = 0;
    virtual LoopHealth health() const = 0;
    virtual void pause() = 0;
    /// Resumes after a pause; from device_lost only once the device is back and in place, and then as
    /// practice.
    virtual void resume() = 0;
    /// In device_lost: where the devices are.
    virtual Realignment realignment() = 0;
    /// Ends the attempt as abandoned: also where the trainee closes the window or signs out. interrupt() is
    /// for what no trainee decides.
    virtual void abandon() = 0;
    virtual void interrupt() = 0;
    /// For device_lost and failed: one line of what happened and what to do; else empty.
    virtual Sentence message() const = 0;
    /// Set once phase() is finished.
    virtual const std::optional<AttemptOutcome>& outcome() const = 0;
};

class ReplayMoment;

/// What the window's attempts are made with.
inline constexpr DeviceClass window_device = DeviceClass::mouse_keyboard;

struct AttemptRequest {
    database::Session session;  ///< whose attempt it is
    std::string task_id;
    bool assessed = false;
    std::uint64_t seed = 0;  ///< 0: the program draws one outside 1000-1999
    /// The hands. Called on the haptic thread once a tick: must neither lock nor allocate. Pause, abandon and
    /// loss flags are added by the session. Device class and name are stored with the attempt.
    std::shared_ptr<Rig> rig;
    DeviceClass device_class = window_device;
    std::string device = "mouse and keyboard";
    /// Never assessed with this device (ui/services/device_service.h).
    bool practice_only = false;
    /// Where it begins; null: at the beginning. Then `task_id` and `seed` are the moment's, and it is
    /// practice.
    std::shared_ptr<const ReplayMoment> from;
    /// Goal (index) at whose beginning in a demonstration it begins; 0: at the beginning. Then it is
    /// practice.
    int goal = 0;
    /// With the instruments of an expert as a ghost; practice only. The seed is then the demonstration's.
    bool ghost = false;
    std::string variant;  ///< of the task; "": the standard one
};

}  // namespace fulcrum::ui
