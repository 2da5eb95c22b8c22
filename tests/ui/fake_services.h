// SPDX-License-Identifier: GPL-3.0-or-later
// Services for the window's tests: a real store in a temporary folder, and attempts without threads or
// physics. Time advances when the window requests the newest world; record, events and score go through the
// real Recorder.
#pragma once

#include <QTemporaryDir>
#include <atomic>
#include <list>
#include <map>
#include <memory>

#include "database/records/curriculum_publishing.h"
#include "database/records/recorder.h"
#include "database/rows/trace_codec.h"
#include "sim_core/numerics/input_error.h"
#include "ui/services/application_services.h"

namespace fulcrum::ui::window_test {

/// Actions of the test on the running attempt.
struct AttemptControl {
    bool complete = false;     ///< completes it at the next update
    bool drop_device = false;  ///< the device is lost
    Realignment realignment;   ///< after the device was lost
    bool press_hard = false;   ///< the left hand presses with 9 N: over-force
    int ticks_per_update = 200;
    std::string last_attempt_id;
};

class FakeServices : public ApplicationServices {
  public:
    FakeServices();
    database::Store* store() override { return store_.get(); }
    std::string store_path(bool demo) const override;
    void open_store(bool demo) override;
    void close_store() override { store_.reset(); }
    void choose_store(const std::string& path) override { chosen_store = path; }
    bool demo_is_built() const override { return database::Store::exists(store_path(true)); }
    bool unpack_demo(const Progress& progress) override;
    const std::vector<TaskDefinition>& tasks() const override { return tasks_; }
    const Curriculum& curriculum() const override {
        return published_.empty() ? curriculum_ : published_.back();
    }
    /// In that folder; nowhere until somebody has published.
    void look_for_curriculum() override;
    /// Into a folder of the test's own.
    void publish_curriculum(const database::Session& session, const Curriculum& follows,
                            const std::string& text, const std::string& reason) override;
    /// The version in force there with this change, as another window publishes it: this one has to look for
    /// it.
    void publish_elsewhere(const database::Session& session, const std::function<void(Curriculum&)>& change);
    std::vector<ObserverForm> forms() const override;
    void set_curriculum(Curriculum curriculum) { curriculum_ = std::move(curriculum); }
    Scene scene_for(const TaskDefinition& task, const std::string& variant) const override;
    std::string scene_text(const TaskDefinition& task, const std::string& variant) const override;
    WorldSnapshot world_at_start(const TaskDefinition& task, const std::string& variant) const override;
    std::vector<JudgedLimit> judged_limits(const database::Session&, const std::string& task_id, DeviceClass,
                                           const std::string& variant) override;
    std::unique_ptr<AttemptSession> start_attempt(const AttemptRequest& request) override;
    Statement why_not_comparable(const database::Session&, const std::string&, DeviceClass,
                                 const std::string&) override {
        return {};
    }
    std::vector<database::AssetFile> unknown_assets(const database::Session&, const std::string&, DeviceClass,
                                                    const std::string& variant) override {
        if (!unknown_variant.empty() && variant != unknown_variant) return {};
        return unknown;
    }
    std::unique_ptr<AttemptSession> start_demonstration(const database::Session& session,
                                                        const std::string& task_id,
                                                        const std::string& variant) override;
    std::vector<InterruptedScore> score_interrupted(const database::Session&, const Progress&) override {
        return {};
    }
    std::vector<database::StaleScore> stale_scores(const database::Session&) override { return {}; }
    std::vector<RecomputedScore> recompute_scores(const database::Session&, const Progress&) override {
        return {};
    }
    /// Nothing is simulated here.
    database::CheckReport check_store(const database::Session& session, const Progress& progress) override {
        database::StoreOptions options;
        options.read_only = true;
        return database::Store::open(store_path(session.is_demo()), options).check(session, progress);
    }
    std::unique_ptr<ReplaySource> open_replay(const database::Session& session,
                                              const database::AttemptSummary& attempt,
                                              std::shared_ptr<const database::Trace> trace) override;
    void prepare_replays(const database::Session& session) override {
        prepared.push_back(session.person_id());
    }
    void stop_preparing_replays() override { ++stopped_preparing; }
    std::function<std::optional<ExpertAttempt>(const Progress&)> expert_attempt(
        const database::Session& session, const database::AttemptSummary& attempt) override;
    std::unique_ptr<ReplaySource> open_expert_replay(const database::Session& session,
                                                     const database::AttemptSummary& attempt,
                                                     const ExpertAttempt& expert) override {
        return open_replay(session, attempt, expert.trace);
    }
    Scene scene_of(const database::Session& session, const database::AttemptSummary& attempt) const override;
    SiteTissues site_tissues(const database::Session&, const std::string&) override { return {}; }
    void set_site_tissues(const database::Session&, const std::string& task_id, int,
                          const database::TissueValues&, const std::string&) override;
    std::function<std::vector<ListedDevice>()> list_devices() override {
        return [listed = devices] { return listed; };
    }
    DeviceInUse device_in_use() const override { return in_use; }
    std::shared_ptr<Rig> hands(const Scene&, std::shared_ptr<Rig> others) override {
        return device_rig != nullptr ? device_rig : others;
    }
    Sentence device_trouble() override { return trouble; }
    std::optional<DeviceReadings> device_readings() override { return readings; }
    double force_scale(const std::string& kind) const override {
        const auto found = scales.find(kind);
        return found != scales.end() ? found->second : 1;
    }
    void set_force_scale(const std::string& kind, double scale) override { scales[kind] = scale; }
    void open_device() override {
        if (refuses) throw *refuses;
        if (!readings) readings = readings_when_open;
    }
    void choose_device(const std::string& kind) override {
        chosen = kind;
        in_use.kind = kind == "mouse-keyboard" ? "" : kind;
    }
    bool device_can_be_chosen() const override { return can_choose; }
    std::function<SceneReach()> scene_reach(const std::string&) override {
        return [found = reach] { return found; };
    }
    bool begins_at_ring(const std::string&) const override { return at_ring; }
    void set_begins_at_ring(const std::string&, bool wanted) override { at_ring = wanted; }
    bool can_calibrate(const std::string& kind) const override {
        return kind == "joystick" || kind == "touch";
    }
    std::string calibrated_at(const std::string&) const override { return calibrated; }
    void start_calibration(int hand) override {
        calibrating.runs = true;
        calibrating.step = 1 + hand;
    }
    CalibrationState calibration() override { return calibrating; }
    void calibration_next() override { ++calibrating.step; }
    void calibration_skip() override { calibrating.step += 10; }
    void stop_calibration() override { calibrating = {}; }
    double motion_scale(const std::string& kind) const override {
        const auto found = motions.find(kind);
        return found != motions.end() ? found->second : 1;
    }
    void set_motion_scale(const std::string& kind, double scale) override { motions[kind] = scale; }
    SlotChoice slot_choice(const std::string&) const override { return parts; }
    void set_slot_choice(const std::string&, const SlotChoice& choice) override { parts = choice; }
    bool rumble_wanted() const override { return rumbles; }
    void set_rumble_wanted(bool wanted) override { rumbles = wanted; }
    SoundChoice sound_choice() const override { return sound; }
    void choose_sound(const SoundChoice& choice) override { sound = choice; }
    void play_sound(const SoundState& state) override { heard = state; }
    void test_sound() override { ++heard.tests; }
    Sentence sound_trouble() override { return sound.wanted ? no_sound : Sentence(); }
    bool start_force_test() override {
        tested.runs = true;
        return true;
    }
    void stop_force_test() override { tested.runs = false; }
    ForceTestState force_test() override { return tested; }
    std::string program_version() const override { return "0.1.0-test"; }

    std::optional<ExpertAttempt> expert;  ///< what expert_attempt() makes; none: the attempt itself
    bool expert_waits = false;            ///< it works until it is stopped
    std::vector<std::string> prepared;    ///< people for whom prepare_replays() was called
    int stopped_preparing = 0;
    std::vector<database::AssetFile> unknown;   ///< what unknown_assets() answers
    std::string unknown_variant;                ///< for this variant only; empty: for all
    std::optional<std::string> judged_variant;  ///< of the last call of judged_limits()
    std::vector<ListedDevice> devices;
    DeviceInUse in_use;
    std::shared_ptr<Rig> device_rig;  ///< moves the hands; null: mouse and keyboard
    std::string chosen_store;         ///< in place of the one in the test's folder
    Sentence trouble;                 ///< of the device in use
    std::optional<DeviceReadings> readings;
    std::map<std::string, double> scales, motions;
    SceneReach reach;
    std::string calibrated;
    bool at_ring = false;
    CalibrationState calibrating;
    std::optional<DeviceReadings> readings_when_open;
    std::optional<InputError> refuses;       ///< what open_device() says instead
    std::optional<InputError> broken_scene;  ///< what scene_text() and open_replay() say instead
    std::string chosen;
    bool can_choose = false, rumbles = true;
    SlotChoice parts;
    SoundChoice sound;
    SoundState heard;   ///< newest
    Sentence no_sound;  ///< why there is none
    ForceTestState tested;
    AttemptControl control;
    mutable std::atomic<int> worlds_built{0};  ///< calls of world_at_start()

  private:
    database::CurriculumPublishing curricula_place();
    QTemporaryDir folder_;
    std::vector<TaskDefinition> tasks_;
    Curriculum curriculum_;
    std::list<Curriculum> published_;  ///< that were published, the newest last
    std::unique_ptr<database::Store> store_;
};

}  // namespace fulcrum::ui::window_test
